# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tables and plots of benchmark_published."""

import json
import pathlib
import statistics

from markdown_tables import count, markdown, runs_of, seconds, topology
from plot import draw

NOTHING = "–"
METHODS = ("local", "published", "geodesic target", "flips, 500 sources", "variational, 500 sources")
LIVE = ("local", "published", "MCF")
QUOTED = json.loads((pathlib.Path(__file__).parent / "quoted_results.json").read_text())
# The source and the method of quoted results; the method names the column.
QUOTED_ERRORS = [("GEL", "LS"), ("GEL", "MSLS"), ("paper", "LS"), ("paper", "MSLS"), ("paper", "MCF"),
                 ("paper", "CSCD-M")]
QUOTED_TIMES = [("GEL", "LS"), ("GEL", "MSLS"), ("paper", "LS"), ("paper", "MSLS"), ("paper", "CSCD-M")]


def thousandths(run, key="error"):
    return 1000 * run[key]


def error_and_topology(run):
    """A cell; a run that has failed is None."""
    return f"{thousandths(run):.2f}: {topology(run)}" if run else "fails"


def method_quality_table(medians):
    """One row for each mesh: error and topology of the skeletons of all methods; then the means."""
    meshes = runs_of(medians, "method")
    rows = [[mesh, *(error_and_topology(runs.get(method)) for method in METHODS)] for mesh, runs in meshes.items()]
    whole = [runs for runs in meshes.values() if all(method in runs for method in METHODS)]
    if whole:
        rows.append(["mean error"] + [f"{statistics.fmean(thousandths(runs[method]) for runs in whole):.2f}"
                                      for method in METHODS])
    return markdown(["mesh", *METHODS], rows)


def method_time_table(medians):
    rows = [[mesh, count(next(iter(runs.values()))["vertices"]),
             *(f"{seconds(runs[method]):.2f}" if method in runs else "fails" for method in METHODS)]
            for mesh, runs in runs_of(medians, "method").items()]
    return markdown(["mesh", "vertices", *METHODS], rows)


def quoted(source, mesh, run, key):
    """The results of `source` for a mesh with as many vertices and faces, or with its name and nearly as many."""
    name = mesh.lower().replace("_", "-")
    for row in QUOTED[source]["rows"]:
        differences = [abs(row[counted] / run[counted] - 1) for counted in ("vertices", "faces")]
        is_same_body = name.startswith(row["mesh"].lower()) and max(differences) < 0.001
        if max(differences) == 0 or is_same_body:
            return row.get(key)
    return None


def median_row(title, rows, width):
    """The medians of the first `width` columns, over the meshes that have a value in all of them."""
    whole = [numbers[:width] for _, _, numbers in rows if None not in numbers[:width]]
    medians = [statistics.median(column) for column in zip(*whole)] or [None] * width
    nothing = [None] * (len(rows[0][2]) - width)
    return [f"{title} {len(whole)}", "", *map(cell, medians + nothing)]


def side_by_side(medians, quantity, measured, columns):
    """One row for each mesh: measured values, then quoted values of others; then medians over different meshes."""
    rows = []
    different = {}
    for mesh, runs in runs_of(medians, "method").items():
        run = next(iter(runs.values()))
        ours = [measured(runs[method]) if method in runs else None for method in LIVE]
        theirs = [quoted(source, mesh, run, f"{method} {quantity}") for source, method in columns]
        rows.append((mesh, run["vertices"], ours + theirs))
        different.setdefault((run["vertices"], run["faces"]), rows[-1])
    cells = [[mesh, count(vertices), *map(cell, numbers)] for mesh, vertices, numbers in rows]
    cells.append(median_row("median of", list(different.values()), len(LIVE)))
    cells.append(median_row("median of the quoted", list(different.values()), len(LIVE) + 2))
    return markdown(["mesh", "vertices", *LIVE, *(f"{method}, {source}" for source, method in columns)], cells)


def cell(number):
    return NOTHING if number is None else f"{number:.2f}"


def error_table(medians):
    return side_by_side(medians, "error", lambda run: thousandths(run, "convolution_error"), QUOTED_ERRORS)


def time_table(medians):
    return side_by_side(medians, "seconds", seconds, QUOTED_TIMES)


def sources_table(medians):
    meshes = runs_of(medians, "sources")
    rows = []
    for number in next(iter(meshes.values())):
        cells = []
        for runs in meshes.values():
            run = runs[number]
            cells += [count(run["packed"]), error_and_topology(run), f"{seconds(run):.2f}"]
        rows.append([count(int(number)), *cells])
    head = ["sources"]
    for mesh in meshes:
        head += [f"{mesh}: packed", "error", "CPU s"]
    return markdown(head, rows)


def two_methods_table(medians, kind, label):
    """One row for each strength of the change of the mesh: errors and topology of both methods on every mesh."""
    meshes = runs_of(medians, kind)
    rows = []
    for strength in dict.fromkeys(variant.split("/")[0] for runs in meshes.values() for variant in runs):
        row = [label(strength)]
        for runs in meshes.values():
            row += [error_and_topology(runs.get(f"{strength}/{method}")) for method in ("local", "published")]
        rows.append(row)
    head = [""]
    for mesh in meshes:
        head += [f"{mesh}: local", f"{mesh}: published"]
    return markdown(head, rows)


def noise_table(medians):
    return two_methods_table(medians, "noise", lambda percent: f"{int(percent) / 100:.1f} edges")


def resolution_table(medians):
    return two_methods_table(medians, "resolution", lambda part: "all edges" if part == "1" else f"1/{part} of them")


def hole_table(medians):
    return two_methods_table(medians, "holes", lambda number: f"{number} holes")


def broken_ring_table(medians):
    """One row for each state of the ring: genus and cycles of the skeletons."""
    rows = []
    for state, runs in runs_of(medians, "ring").items():
        local, published = runs["local"], runs.get("published")
        rows.append([state, count(local["genus"]), error_and_topology(local), error_and_topology(published)])
    return markdown(["ring", "genus", "local", "published"], rows)


def thread_table(medians):
    rows = []
    for mesh, runs in runs_of(medians, "threads").items():
        for variant, run in runs.items():
            threads, method = variant.split("/")
            alone = runs[f"1/{method}"]
            rows.append([f"{mesh}, {method}", threads, f"{seconds(run, 'real_time'):.3f}",
                         f"{seconds(alone, 'real_time') / seconds(run, 'real_time'):.2f}", f"{seconds(run):.3f}"])
    return markdown(["mesh, method", "threads", "wall s", "times as fast", "CPU s"], rows)


def about(kind, table):
    """The table, or None if benchmarks of that kind have not been run."""
    return lambda medians: table(medians) if runs_of(medians, kind) else None


# By the name of a sentence on the conditions of benchmarks: the kind of these benchmarks.
CIRCUMSTANCES = {f"circumstances_of_{kind}": kind
                 for kind in ("method", "sources", "noise", "resolution", "holes", "ring", "threads")}
TABLES = {
    "methods": about("method", method_quality_table),
    "method_times": about("method", method_time_table),
    "paper_errors": about("method", error_table),
    "paper_times": about("method", time_table),
    "numbers_of_sources": about("sources", sources_table),
    "noise": about("noise", noise_table),
    "resolution": about("resolution", resolution_table),
    "holes": about("holes", hole_table),
    "broken_ring": about("ring", broken_ring_table),
    "threads": about("threads", thread_table),
}


def plot(medians, figures):
    """Draws the errors of the tables about the published method."""
    label = "mean error, 1/1000 of the diagonal"
    curves = {mesh: [(int(number), thousandths(run)) for number, run in runs.items()]
              for mesh, runs in runs_of(medians, "sources").items()}
    if curves:
        draw(figures / "error_against_sources.png", "sources", label, curves, logarithmic=True)
    for kind, x_label, unit in (("noise", "noise, mean edge lengths", 0.01), ("resolution", "one edge of", 1),
                                ("holes", "holes", 1)):
        curves = {}
        for mesh, runs in runs_of(medians, kind).items():
            for variant, run in runs.items():
                strength, method = variant.split("/")
                curves.setdefault(f"{mesh}, {method}", []).append((unit * int(strength), thousandths(run)))
        if curves:
            draw(figures / f"error_against_{kind}.png", x_label, label, curves, logarithmic=kind == "resolution")
