# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: check_manual.py SOURCE_DIR TAG_FILE
# Fails unless the reference lists whatever Doxygen found to be public, by headers that exist, the examples are listed,
# and CITATION.cff names the version of the library.

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree


def names_of(compound):
    """The names of the members and of the classes of a namespace or group."""
    members = {member.findtext("name") for member in compound.findall("member")}
    return members | {inner.text.removeprefix("CSCD::") for inner in compound.findall("class")}


def public_names(tag_file):
    """The names of the namespace CSCD that are neither concepts nor checks of them."""
    compounds = {}
    for compound in ElementTree.parse(tag_file).getroot().findall("compound"):
        compounds[compound.findtext("name")] = compound
    names = names_of(compounds["CSCD"])
    for group in ("PkgCSCDConcepts", "PkgCSCDConceptChecks"):
        names -= names_of(compounds[group])
    return names


def main():
    source = pathlib.Path(sys.argv[1])
    reference = (source / "doc/manual/reference.dox").read_text(encoding="utf-8")
    complaints = []

    listed = set(re.findall(r"`CSCD::(\w+)(?:\(\))?`", reference))
    for name in sorted(public_names(sys.argv[2]) - listed):
        complaints.append(f"doc/manual/reference.dox: {name} is public and not listed")
    for header in re.findall(r"`(CSCD/[\w/]+\.h)`", reference):
        if not (source / "include" / header).is_file():
            complaints.append(f"doc/manual/reference.dox: there is no header {header}")
    for example in sorted((source / "examples").glob("*_example.cpp")):
        if f"\\example {example.name}\n" not in reference:
            complaints.append(f"doc/manual/reference.dox: {example.name} is not listed")

    version = re.search(r'CSCD_VERSION "(.*)"', (source / "include/CSCD/version.h").read_text(encoding="utf-8"))
    if f"\nversion: {version.group(1)}\n" not in (source / "CITATION.cff").read_text(encoding="utf-8"):
        complaints.append(f"CITATION.cff: the version is {version.group(1)}")

    if complaints:
        sys.exit("\n".join(complaints))


main()
