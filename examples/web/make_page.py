# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: make_page.py TEMPLATE GLUE WASM NOTICE THREE_JS ORBIT_CONTROLS PAGE
# Puts what Emscripten made, and three.js with the notice of its license, into the template of the page.

import base64
import pathlib
import re
import sys


def escaped(script):
    """As `escape_script()` of the library: does not end the element that it stands in, nor begins a comment there."""
    return re.sub("</(?=script)", r"<\\/", script, flags=re.IGNORECASE).replace("<!--", "<\\!--")


def main():
    template, glue, wasm, *three_js, page = map(pathlib.Path, sys.argv[1:])
    text = template.read_text(encoding="utf-8")
    notice, *scripts = (path.read_text(encoding="utf-8") for path in three_js)
    contents = {
        "@THREE_JS@": escaped(notice + "".join(script + "\n" for script in scripts)),
        "@GLUE@": escaped(glue.read_text(encoding="utf-8")),
        "@WASM@": base64.b64encode(wasm.read_bytes()).decode(),
    }
    for name, content in contents.items():
        text = text.replace(name, content)
    page.write_text(text, encoding="utf-8")
    print(f"{page}: {page.stat().st_size:,} bytes, WebAssembly {wasm.stat().st_size:,} bytes")


main()
