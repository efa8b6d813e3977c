# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Writes the tables of README.md and of the pages in doc, and plots to doc/fig.

Usage: write_tables.py COMMAND BUILD_FOLDER FOLDER FILE...: COMMAND is what the pages name as the command that
made the files, each named after the program that wrote it; FOLDER is that of README.md and doc.
Tables stand between lines `<!-- begin NAME -->` and `<!-- end NAME -->`; what is between them is replaced.
"""

import json
import pathlib
import statistics
import sys

import geodesics_tables
import published_tables
import tree_tables
from markdown_tables import (count, growth_exponent, is_right, markdown, replace_between_markers, runs_of, seconds,
                             topology)
from measurements import circumstances, number_of_repetitions, read_medians


QUOTED = json.loads((pathlib.Path(__file__).parent / "quoted_results.json").read_text())


def meshes_of(medians):
    names = dict.fromkeys(name.split("/")[1] for name in medians if name.startswith("mesh/"))
    return [(mesh, *(medians.get(f"mesh/{mesh}/{who}") for who in ("CSCD", "CSCD_2_threads", "MCF"))) for mesh in names]


def both(ours, mcf, key, form):
    return f"{form(ours[key])} / {form(mcf[key]) if mcf else '–'}"


def wall_times(one, two):
    return " / ".join(f"{seconds(run, 'real_time'):.3f}" if run else "–" for run in (one, two))


def mesh_table(medians):
    rows = []
    for mesh, ours, two, mcf in meshes_of(medians):
        rows.append([
            mesh,
            count(ours["vertices"]),
            f"{seconds(ours):.3f}",
            wall_times(ours, two),
            f"{seconds(mcf):.2f}" if mcf else "–",
            f"{seconds(ours) / seconds(mcf):.3f}" if mcf else "–",
            both(ours, mcf, "megabytes", count),
        ])
    return markdown(["mesh", "vertices", "CSCD CPU s", "wall s, 1 / 2 threads", "MCF CPU s", "CSCD : MCF",
                     "MB, CSCD / MCF"], rows)


def times_as_fast(slow, fast):
    return f"{slow / fast:.0f}"


def summary_table(medians):
    """CSCD, MCF and the quoted results of MSLS, on the meshes that have all three."""
    quoted = {row["mesh"]: row for row in QUOTED["MSLS"]["rows"]}
    rows = []
    for mesh, ours, _, mcf in meshes_of(medians):
        msls = quoted.get(mesh)
        if msls and mcf:
            rows.append([
                mesh,
                count(ours["vertices"]),
                f"{seconds(ours):.3f}",
                f"{seconds(mcf):.2f} ({times_as_fast(seconds(mcf), seconds(ours))})",
                f"{msls['seconds']:.1f} ({times_as_fast(msls['seconds'], seconds(ours))})",
                " / ".join(f"{run['percent_inside']:.0f}" for run in (ours, mcf, msls)),
                " / ".join(count(run["tips"]) for run in (ours, mcf, msls)),
            ])
    return markdown(["mesh", "vertices", "CSCD, s", "MCF, s (times as long)", "MSLS, s (times as long)",
                     "% inside: CSCD / MCF / MSLS", "tips"], rows)


def quality_table(medians):
    rows = []
    for mesh, ours, _, mcf in meshes_of(medians):
        if "genus" in ours:
            rows.append([
                mesh,
                count(ours["genus"]),
                both(ours, mcf, "betti_number", count),
                both(ours, mcf, "percent_inside", "{:.1f}".format),
                both(ours, mcf, "nodes", count),
                both(ours, mcf, "tips", count),
            ])
    return markdown(["mesh", "genus", "cycles, CSCD / MCF", "length inside, %", "nodes", "tips"], rows)


def growth_table(medians):
    names = [name for name in medians if name.startswith("growing/") and name.endswith("/CSCD")]
    if not names:
        return None
    rows = []
    for name in names:
        one, two = medians[name], medians.get(name + "_2_threads")
        rows.append([
            count(one["vertices"]),
            f"{seconds(one):.3f}",
            f"{1e6 * seconds(one) / one['vertices']:.2f}",
            wall_times(one, two),
            count(one["megabytes"]),
        ])
    points = [(medians[name]["vertices"], seconds(medians[name])) for name in names]
    exponent = growth_exponent(points)
    table = markdown(["vertices", "CPU s", "µs a vertex", "wall s, 1 / 2 threads", "MB"], rows)
    steps = ", ".join(f"{growth_exponent(pair):.2f}" for pair in zip(points, points[1:]))
    return (f"{table}\n\nOver the whole range, CPU time grows as the number of vertices to the power {exponent:.2f};\n"
            f"from one size to the next, {steps}.")


def sampling_table(medians, kind):
    """One row for each way to draw points, over all meshes; none if nothing of the kind was run."""
    clouds = runs_of(medians, kind)
    if not clouds:
        return None
    rows = []
    for sampling in next(iter(clouds.values())):
        runs = [runs[sampling] for runs in clouds.values()]

        def mean(number, runs=runs):
            return statistics.fmean(number(run) for run in runs)

        rows.append([
            sampling,
            f"{sum(map(is_right, runs))} of {len(runs)}",
            f"{sum(abs(run['tips'] - run['tips_of_mesh']) <= 2 for run in runs)} of {len(runs)}",
            f"{mean(lambda run: run['percent_inside']):.1f} / {mean(lambda run: run['percent_inside_of_mesh']):.1f}",
            f"{1000 * mean(lambda run: run['error']):.2f} / {1000 * mean(lambda run: run['error_of_mesh']):.2f}",
            f"{mean(seconds):.2f}",
            f"{max(map(seconds, runs)):.2f}",
        ])
    return markdown(["points", "topology right", "tips within 2 of the mesh's", "length inside, %: points / mesh",
                     "error: points / mesh", "CPU s", "largest"], rows)


def cloud_table(medians, kind):
    """One row for each mesh: the topology of the skeletons of its clouds; none if nothing of the kind was run."""
    clouds = runs_of(medians, kind)
    if not clouds:
        return None
    rows = []
    for mesh, runs in clouds.items():
        run = next(iter(runs.values()))
        rows.append([mesh, f"{count(run['surface_components'])}, {count(run['genus'])}; {count(run['tips_of_mesh'])}"]
                    + [topology(run) for run in runs.values()])
    return markdown(["mesh", "of the mesh", *next(iter(clouds.values()))], rows)


def growing_cloud_table(medians):
    rows = []
    for name, run in medians.items():
        if name.startswith("growing/"):
            rows.append([count(run["points"]), f"{seconds(run):.2f}", count(run["megabytes"])])
    if not rows:
        return None
    return markdown(["points", "CPU s", "MB"], rows)


# By program, the tables by name: functions of the medians, which return None if they have no rows; None in the place of
# a function stands for the sentence on the conditions of the measurement.
TABLES_OF_PROGRAM = {
    "benchmark_skeletonization": {
        "circumstances": None,
        "summary": summary_table,
        "meshes": mesh_table,
        "quality": quality_table,
        "growth": growth_table,
    },
    "benchmark_points": {
        "samplings": lambda medians: sampling_table(medians, "cloud"),
        "clouds": lambda medians: cloud_table(medians, "cloud"),
        "published_samplings": lambda medians: sampling_table(medians, "published"),
        "published_clouds": lambda medians: cloud_table(medians, "published"),
        "growing_cloud": growing_cloud_table,
    },
    "benchmark_geodesics": {"circumstances_of_geodesics": None, **geodesics_tables.TABLES},
    "benchmark_published": published_tables.TABLES,
    "benchmark_trees": {"circumstances_of_trees": None, **tree_tables.TABLES},
}

# By program, the sentences on when, where and how runs of one kind were measured, for programs whose kinds are run apart.
CIRCUMSTANCES_OF_KINDS = {
    "benchmark_skeletonization": {"circumstances_of_summary": "mesh"},
    "benchmark_points": {"circumstances_of_clouds": "cloud", "circumstances_of_published_clouds": "published"},
    "benchmark_published": published_tables.CIRCUMSTANCES,
}


def main():
    command, build_dir, folder, *files = sys.argv[1:]
    folder = pathlib.Path(folder)
    tables = {}
    for file in files:
        program = pathlib.Path(file).stem
        context, medians = read_medians(file)
        sentence = circumstances(context, command, number_of_repetitions(file), build_dir)
        for name, table in TABLES_OF_PROGRAM[program].items():
            text = table(medians) if table else sentence
            if text is not None:
                tables[name] = text
        for name, kind in CIRCUMSTANCES_OF_KINDS.get(program, {}).items():
            if runs_of(medians, kind):
                tables[name] = sentence
        if program == "benchmark_published":
            published_tables.plot(medians, folder / "doc" / "fig")
    for path in [*sorted((folder / "doc").glob("*.md")), folder / "README.md"]:
        if replace_between_markers(path, tables):
            print(path)


if __name__ == "__main__":
    main()
