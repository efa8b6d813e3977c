# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: write_code_blocks.py PAGES PRELUDE OUT -- COMPILER [OPTION...]
# Writes all blocks of C++ in the files that PAGES lists, after the file PRELUDE, to OUT, and compiles that: includes
# first, then each block in a namespace of its own; a whole program as it stands, a fragment as the body of a function.

import pathlib
import re
import subprocess
import sys

MARKDOWN_BLOCK = re.compile(r"^```cpp\n(.*?)^```$", re.MULTILINE | re.DOTALL)
DOXYGEN_BLOCK = re.compile(r"\\code(?:\{\.cpp\})?\s*\n(.*?)\\endcode", re.DOTALL)
COMMENT = re.compile(r"^\s*///? ?", re.MULTILINE)


def blocks_of(path):
    """The blocks of a file, each with the number of its first line."""
    text = path.read_text(encoding="utf-8")
    pattern = MARKDOWN_BLOCK if path.suffix == ".md" else DOXYGEN_BLOCK
    for match in pattern.finditer(text):
        code = match.group(1)
        if path.suffix == ".h":
            code = COMMENT.sub("", code)
        yield text.count("\n", 0, match.start(1)) + 1, code


def main():
    separator = sys.argv.index("--")
    pages, prelude, out = (pathlib.Path(name) for name in sys.argv[1:separator])
    includes = []
    bodies = []
    for path in map(pathlib.Path, pages.read_text(encoding="utf-8").split("\n")):
        if not path.is_file():
            continue
        for first_line, code in blocks_of(path):
            lines = code.split("\n")
            includes += [line for line in lines if line.startswith("#include")]
            # Blank in their place, so that the compiler names the line of the page.
            body = "\n".join("" if line.startswith("#include") else line for line in lines)
            if not re.search(r"^int main\(", body, re.MULTILINE):
                body = f"void fragment()\n{{\n#line {first_line} \"{path}\"\n{body}\n}}"
            bodies.append(f"namespace block_{len(bodies)} {{\n#line {first_line} \"{path}\"\n{body}\n}}\n")
    if not bodies:
        sys.exit("no block of C++ was found in the pages")
    prelude_text = prelude.read_text(encoding="utf-8")
    out.write_text("\n".join([*sorted(set(includes)), prelude_text, *bodies]), encoding="utf-8")
    print(f"{len(bodies)} blocks")
    sys.exit(subprocess.run([*sys.argv[separator + 1:], str(out)], check=False).returncode)


main()
