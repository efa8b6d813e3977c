# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: check_headers.py INCLUDE_DIR COMPILER OPTION...
# Fails unless each public header compiles on its own, and twice in one file.

import concurrent.futures
import functools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# Folders of headers that users include, in addition to the top level.
FOLDERS = ["Application", "IO", "Measure", "Tree"]

# The headers that others begin with, and that take seconds: each is precompiled. The greatest is the last.
BASES = ["Named_parameters.h", "Skeleton_graph.h", "Measure/Skeleton_branches.h", "Curve_skeletonization.h"]


def public_headers(root):
    files = [*root.glob("*.h"), *(file for name in FOLDERS for file in (root / name).glob("*.h"))]
    return sorted(str(file.relative_to(root)) for file in files if not file.name.endswith("_impl.h"))


def included(root, header, found):
    """Adds the headers of the library that the compiler reads with a header, in its order, where that is compiled."""
    text = (root / header).read_text(encoding="utf-8")
    text = re.sub(r"^#ifndef CSCD_COMPILED$.*?^#endif", "", text, flags=re.DOTALL | re.MULTILINE)
    for other in re.findall(r"^#include <CSCD/(.*)>", text, re.MULTILINE):
        if other not in found:
            found.append(other)
            included(root, other, found)
    return found


def compile_alone(root, headers, command, folder, header):
    source = folder / header.replace("/", "_")
    source.write_text(f"#include <CSCD/{header}>\n" * 2, encoding="utf-8")
    options = ["-x", "c++-header", "-o", f"{source}.gch"] if header in BASES else ["-x", "c++", "-fsyntax-only"]
    found = [] if header in BASES else included(root, header, [])
    # The greatest base that stands before all headers that are not public: it hides nothing that these miss.
    for base in [base for base in BASES if base in found and set(headers).issuperset(found[:found.index(base)])][-1:]:
        options += ["-include", folder / base.replace("/", "_")]
    return subprocess.run([*command, *options, source], check=False, capture_output=True, text=True)


def main():
    root = pathlib.Path(sys.argv[1]) / "CSCD"
    headers = public_headers(root)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        compile_one = functools.partial(compile_alone, root, headers, sys.argv[2:], pathlib.Path(folder))
        results = [*pool.map(compile_one, BASES), *pool.map(compile_one, sorted({*headers} - {*BASES}))]
    failures = [result.stderr for result in results if result.returncode != 0]
    if failures or not headers:
        sys.exit("\n".join(failures) or "no headers found")


main()
