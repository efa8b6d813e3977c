#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the reference in doc/python.md from the docstrings of the module cscd.

Usage: PYTHONPATH=build/python doc/write_python_reference.py [--check]. With --check, the page stays as it is; the exit
status is 1 if it is not up to date.
"""

import ast
import inspect
import pathlib
import re
import sys
import textwrap

import cscd

PAGE = pathlib.Path(__file__).resolve().parent / "python.md"
BEGIN, END = "<!-- begin reference -->\n", "<!-- end reference -->\n"
WIDTH = 120


def in_cell(text):
    """`text` as a cell of a table: one line, without bars."""
    return " ".join(text.split()).replace("|", ", ")


def table(head, rows):
    return "\n".join(f"| {' | '.join(row)} |" for row in [head, ["---"] * len(head), *rows])


def shown(default):
    """A default as code; in single quotes, Doxygen would not see its end."""
    return f'"{default}"' if isinstance(default, str) else repr(default)


def paragraphs(docstring):
    """The paragraphs of a docstring, wrapped, and its arguments: name and text of each."""
    texts, arguments = [], []
    for paragraph in inspect.cleandoc(docstring).split("\n\n"):
        if re.match(r"\w+: ", paragraph):
            arguments += [item.split(": ", 1) for item in re.split(r"\n(?=\w)", paragraph)]
        else:
            texts.append(textwrap.fill(paragraph, WIDTH, break_on_hyphens=False))
    return texts, arguments


def described(name, function):
    """The section of a function: its text, and its arguments with their defaults."""
    (first, *others), arguments = paragraphs(function.__doc__)
    parameters = dict(inspect.signature(function).parameters)
    rows = []
    for argument, text in arguments:
        default = parameters.pop(argument).default
        cell = "" if default is inspect.Parameter.empty else f"`{shown(default)}`"
        text = re.sub(rf"(; | \()by default {re.escape(str(default))}\)", lambda m: ")" * (m[1] == "; "), text)
        rows.append([f"`{argument}`", cell, in_cell(text)])
    if rows:
        others.insert(0, table(["argument", "default", "meaning"], rows))
    return [f"### `{name}({'' if rows else ', '.join(parameters)})`", first, *others]


def fields(cls):
    """Name, type and text of the fields of a named tuple: a string behind each."""
    body = ast.parse(inspect.getsource(cls)).body[0].body
    for field, text in zip(body, body[1:]):
        if isinstance(field, ast.AnnAssign):
            yield field.target.id, ast.unparse(field.annotation), text.value.value


def properties(cls):
    for name, member in vars(cls).items():
        if isinstance(member, property):
            yield name, member.fget.__annotations__["return"], member.__doc__


def attributes(cls):
    """The section of a class: its text and its attributes."""
    members = properties(cls) if cls is cscd.Skeleton else fields(cls)
    types = ((name, re.sub(r"(.*) \| None", r"\1` or `None", of), text) for name, of, text in members)
    rows = [[f"`{name}`", f"`{of}`", in_cell(text)] for name, of, text in types]
    return [f"### `cscd.{cls.__name__}`", inspect.cleandoc(cls.__doc__), table(["attribute", "type", "content"], rows)]


def methods(cls):
    """Those with few options as a table, then a section for each of the others."""
    rows, sections = [], []
    for name, member in vars(cls).items():
        if inspect.isfunction(member) and not name.startswith("_"):
            texts, arguments = paragraphs(member.__doc__)
            if len(arguments) > 2:
                sections += described(f"skeleton.{name}", member)
                continue
            parameters = [p.name if p.default is p.empty else f"{p.name}={shown(p.default)}"
                          for p in list(inspect.signature(member).parameters.values())[1:]]
            options = [f"`{argument}`: {text}." for argument, text in arguments]
            rows.append([f"`{name}({', '.join(parameters)})`", in_cell(" ".join([texts[0], *options, *texts[1:]]))])
    return [table(["method", "meaning"], rows), *sections]


def reference():
    texts = []
    for function in (cscd.skeletonize, cscd.read, cscd.find_loops):
        texts += described(f"cscd.{function.__name__}", function)
    texts += [*attributes(cscd.Skeleton), *methods(cscd.Skeleton)]
    for cls in (cscd.Branch, cscd.Loop, cscd.Shape):
        texts += attributes(cls)
    errors = [[f"`cscd.{error.__name__}`", f"`{error.__base__.__name__}`", error.__doc__]
              for error in (cscd.InputError, cscd.FileError)]
    return "\n\n".join([*texts, table(["exception", "base", "meaning"], errors)])


def main():
    page = PAGE.read_text(encoding="utf-8")
    head, rest = page.split(BEGIN)
    written = f"{head}{BEGIN}\n{reference()}\n\n{END}{rest.split(END)[1]}"
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(written, encoding="utf-8")
    elif written != page:
        sys.exit(f"{PAGE}: the reference is not up to date; run doc/write_python_reference.py")


if __name__ == "__main__":
    main()
