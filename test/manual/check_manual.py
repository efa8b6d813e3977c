# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: check_manual.py SOURCE_DIR DOCUMENTATION_DIR
# Fails unless the reference lists all names that Doxygen found to be public, by headers that exist, and all examples;
# names in pages exist, and links of pages and of the manual lead to files and headings; CITATION.cff and the recipes
# name the version of the library.

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

FOLDERS = ("doc", "integrations", "npm", "packaging")  # of pages


def names_of(compound):
    """The names of the members and of the classes of a namespace or group."""
    members = {member.findtext("name") for member in compound.findall("member")}
    return members | {inner.text.removeprefix("CSCD::") for inner in compound.findall("class")}


def public_names(tag_file):
    """The names of the namespace CSCD, and the subset of concepts and checks of concepts."""
    compounds = {}
    for compound in ElementTree.parse(tag_file).getroot().findall("compound"):
        compounds[compound.findtext("name")] = compound
    concepts = names_of(compounds["PkgCSCDConcepts"]) | names_of(compounds["PkgCSCDConceptChecks"])
    return names_of(compounds["CSCD"]) | concepts, concepts


def dead_links(html):
    """The links of the pages in a folder to files that are not there, each with the name of its page."""
    for page in sorted(html.glob("*.html")):
        for link in re.findall(r'(?:href|src)="([^"#:]+)(?:#[^"]*)?"', page.read_text(encoding="utf-8")):
            if not (html / link).exists():
                yield f"{page.name}: {link} is not there"


def headings(page):
    """The headings of a page, as links name them."""
    for heading in re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE):
        yield re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def dead_links_of_markdown(source):
    """The links of all pages to files or headings that are not there."""
    for page in sorted([*source.glob("*.md"), *(page for name in FOLDERS for page in (source / name).rglob("*.md"))]):
        text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
        for link in re.findall(r"\]\(([^)\s:]+)\)", text):
            name, _, heading = link.partition("#")
            target = page.parent / name if name else page
            if not target.exists() or (heading and heading not in headings(target)):
                yield f"{page}: {link} is not there"


def main():
    source, documentation = map(pathlib.Path, sys.argv[1:])
    reference = (source / "doc/manual/reference.dox").read_text(encoding="utf-8")
    complaints = [*dead_links(documentation / "html"), *dead_links_of_markdown(source)]

    names, concepts = public_names(documentation / "CSCD.tag")
    listed = set(re.findall(r"`CSCD::(\w+)(?:\(\))?`", reference))
    for name in sorted(names - concepts - listed):
        complaints.append(f"doc/manual/reference.dox: {name} is public and not listed")
    for page in [source / "README.md", *sorted(source.glob("doc/*.md")), *sorted(source.glob("doc/manual/*.dox"))]:
        for name in sorted(set(re.findall(r"CSCD::(\w+)", page.read_text(encoding="utf-8"))) - names):
            # Targets of CMake, and a namespace.
            if name not in ("CSCD", "application", "compiled", "io", "measure", "parallel", "parameters", "published",
                            "tree"):
                complaints.append(f"{page}: there is no CSCD::{name}, or it is not public")
    for header in re.findall(r"`(CSCD/[\w/]+\.h)`", reference):
        if not (source / "include" / header).is_file():
            complaints.append(f"doc/manual/reference.dox: there is no header {header}")
    for example in sorted((source / "examples").glob("*_example.cpp")):
        if f"\\example {example.name}\n" not in reference:
            complaints.append(f"doc/manual/reference.dox: {example.name} is not listed")

    version = re.search(r'CSCD_VERSION "(.*)"', (source / "include/CSCD/version.h").read_text(encoding="utf-8")).group(1)
    if f"version: {version}" not in (source / "CITATION.cff").read_text(encoding="utf-8").splitlines():
        complaints.append(f"CITATION.cff: the version is {version}")

    if complaints:
        sys.exit("\n".join(complaints))


main()
