# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Functions for tables in Markdown."""

import math
import re
import statistics


def growth_exponent(points):
    """The slope of log(cost) over log(size), by least squares."""
    logarithms = [(math.log(size), math.log(cost)) for size, cost in points]
    mean_x = statistics.fmean(x for x, _ in logarithms)
    mean_y = statistics.fmean(y for _, y in logarithms)
    covariance = sum((x - mean_x) * (y - mean_y) for x, y in logarithms)
    return covariance / sum((x - mean_x) ** 2 for x, _ in logarithms)


def markdown(head, rows):
    """A table; the first column is text, the others are numbers."""
    lines = [head, ["---"] + ["--:"] * (len(head) - 1)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def seconds(run, key="cpu_time"):
    return run[key] / 1000  # the benchmarks count in milliseconds


def count(number):
    return f"{round(number):,}"


def is_right(run):
    """Whether a skeleton has the components and cycles of the surface."""
    return run["betti_number"] == run["genus"] and run["components"] == run["surface_components"]


def runs_of(medians, kind):
    """The runs named `kind`/mesh/variant, by mesh and variant."""
    runs = {}
    for name, run in medians.items():
        if name.startswith(kind + "/"):
            _, mesh, variant = name.split("/", 2)
            runs.setdefault(mesh, {})[variant] = run
    return runs


def topology(run):
    cells = f"{count(run['components'])}, {count(run['betti_number'])}"
    return f"{cells if is_right(run) else f'**{cells}**'}; {count(run['tips'])}"


def replace_between_markers(path, tables):
    """Writes the tables that the page has a place for. Returns whether the page has changed."""
    old = text = path.read_text()
    for name, table in tables.items():
        pattern = re.compile(rf"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)", re.DOTALL)
        text = pattern.sub(lambda match, body=table: f"{match[1]}\n{body}\n\n{match[2]}", text)
    path.write_text(text)
    return text != old
