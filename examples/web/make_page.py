# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: make_page.py TEMPLATE GLUE WASM WORKER THREE_JS PAGE
# Puts the files of Emscripten, the script of the worker, and three.js into the template of the page.

import base64
import pathlib
import re
import sys


def escaped(script):
    """`script` such that it neither ends its element, nor begins a comment there."""
    return re.sub("</(?=script)", r"<\\/", script, flags=re.IGNORECASE).replace("<!--", "<\\!--")


def main():
    template, glue, wasm, worker, three_js, page = map(pathlib.Path, sys.argv[1:])
    text = template.read_text(encoding="utf-8")
    contents = {
        "@THREE_JS@": three_js.read_text(encoding="utf-8"),
        "@GLUE@": escaped(glue.read_text(encoding="utf-8")),
        "@WORKER@": escaped(worker.read_text(encoding="utf-8")),
        "@WASM@": base64.b64encode(wasm.read_bytes()).decode(),
    }
    for name, content in contents.items():
        text = text.replace(name, content)
    page.write_text(text, encoding="utf-8")
    print(f"{page}: {page.stat().st_size:,} bytes, WebAssembly {wasm.stat().st_size:,} bytes")


main()
