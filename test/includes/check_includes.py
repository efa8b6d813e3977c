# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: check_includes.py INCLUDE_DIR
# Fails unless the headers of the library include each other in one direction only: a folder includes only folders
# before it in the order below. No header includes itself through others, except X.h and the X_impl.h at its end.

import pathlib
import re
import sys

# The order of the data flow; doc/architecture.md has a paragraph for each.
FOLDERS = ["internal", "Surface", "Separator", "Packing", "Local", "Skeleton", "Points", "Volume", "Published", "Graph",
           "Traits", "", "Measure", "Tree", "Application", "IO"]
# Headers of the top level that every folder may include. They include nothing but each other and `internal`.
LEAVES = {"Named_parameters.h", "Options.h", "Skeleton.h", "Skeleton_graph.h", "Skeletonization_report.h",
          "Skeletonization_visitor.h", "Vector3.h", "exceptions.h", "input_concepts.h", "version.h"}
INCLUDE = re.compile(r"^#\s*include <CSCD/([\w/.]+)>", re.MULTILINE)


def rank(header):
    """The place of a header in the order; `internal` and leaves come first."""
    if header in LEAVES:
        return 0
    folder = header.split("/")[0] if "/" in header else ""
    return FOLDERS.index(folder) if folder in FOLDERS else None


def is_own_implementation(header, included):
    """Whether one of the two is X.h and the other X_impl.h."""
    return included.removesuffix(".h") + "_impl.h" == header or header.removesuffix(".h") + "_impl.h" == included


def cycles(includes):
    """One cycle for each include that closes one, as a list of headers; found by depth-first search."""
    state = {}
    path = []
    found = []

    def visit(header):
        state[header] = "open"
        path.append(header)
        for included in includes[header]:
            if included not in includes or is_own_implementation(header, included):
                continue
            if state.get(included) == "open":
                found.append([*path[path.index(included):], included])
            elif included not in state:
                visit(included)
        path.pop()
        state[header] = "done"

    for header in sorted(includes):
        if header not in state:
            visit(header)
    return found


def main():
    root = pathlib.Path(sys.argv[1]) / "CSCD"
    includes = {}
    for file in sorted(root.rglob("*.h")):
        includes[file.relative_to(root).as_posix()] = INCLUDE.findall(file.read_text(encoding="utf-8"))
    if not includes:
        sys.exit(f"{root}: no headers there")

    complaints = []
    for header, included_headers in includes.items():
        if rank(header) is None:
            complaints.append(f"{header}: its folder is not in the order of folders")
            continue
        for included in included_headers:
            if included not in includes:
                complaints.append(f"{header} includes {included}, which is not there")
            elif rank(included) is not None and rank(included) > rank(header):
                complaints.append(f"{header} includes {included}, of a later folder")
    for cycle in cycles(includes):
        complaints.append("a cycle: " + " -> ".join(cycle))
    if complaints:
        sys.exit("\n".join(complaints))
    print(f"{len(includes)} headers, {sum(map(len, includes.values()))} includes")


main()
