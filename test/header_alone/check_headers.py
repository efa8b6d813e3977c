# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: check_headers.py INCLUDE_DIR COMPILER OPTION...
# Fails unless each public header compiles on its own, and twice in one file.
#
# One file holds a chain of headers, where each header includes the header before it: so a header is preceded only by
# headers that it includes itself. Each is thus alone, and shared headers are compiled less often.

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# Folders of headers that users include, in addition to the top level.
FOLDERS = ["Application", "IO", "Measure", "Tree"]


def public_headers(root):
    files = [*(root / "CSCD").glob("*.h"), *(file for name in FOLDERS for file in (root / "CSCD" / name).glob("*.h"))]
    return sorted(str(file.relative_to(root)) for file in files if not file.name.endswith("_impl.h"))


def included(root, header, known):
    """The headers of the library that a header includes, directly or not, where the library is compiled."""
    if header not in known:
        known[header] = []
        text = (root / header).read_text(encoding="utf-8")
        text = re.sub(r"^#ifndef CSCD_COMPILED$.*?^#endif", "", text, flags=re.DOTALL | re.MULTILINE)
        for other in re.findall(r"^#include <(CSCD/.*)>", text, re.MULTILINE):
            known[header] += [*included(root, other, known), other]
    return known[header]


def chains(root, headers):
    known, ends = {}, {}
    for header in sorted(headers, key=lambda header: len(set(included(root, header, known)))):
        end = next((other for other in reversed(included(root, header, known)) if other in ends), None)
        ends[header] = [*ends.pop(end, []), header]
    return ends.values()


def compile_chain(command, folder, chain):
    source = pathlib.Path(folder) / (chain[-1].replace("/", "_") + ".cpp")
    source.write_text("".join(f"#include <{header}>\n" for header in [*chain, *chain]), encoding="utf-8")
    return subprocess.run([*command, "-fsyntax-only", source], check=False, capture_output=True, text=True)


def main():
    root, command = pathlib.Path(sys.argv[1]), sys.argv[2:]
    headers = public_headers(root)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda chain: compile_chain(command, folder, chain), chains(root, headers)))
    print(f"{len(headers)} headers in {len(results)} files")
    failures = [result.stderr for result in results if result.returncode != 0]
    if failures or not headers:
        sys.exit("\n".join(failures) or "no headers found")


main()
