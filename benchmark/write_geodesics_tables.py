# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Writes the tables of doc/geodesics.md from what benchmark_geodesics measured.

Usage: write_geodesics_tables.py GEODESICS.json
"""

import sys

from write_tables import ROOT, count, markdown, read_medians, replace_between_markers

NUMBER_OF_SOURCES = 8  # that each run of the benchmark computes distances from


def error_table(medians, meshes):
    rows = []
    for mesh in meshes:
        ours, theirs = medians[f"together/{mesh}"], medians[f"cgal_one_by_one/{mesh}"]
        rows.append([mesh, count(ours["vertices"]), count(ours["diameter"])]
                    + [f"{ours[key]:.2f} / {theirs[key]:.2f}"
                       for key in ("mean_error", "largest_error", "percent_error")])
    return markdown(["mesh", "vertices", "eccentricity, edges", "mean error, CSCD / CGAL", "largest error",
                     "relative error, %"], rows)


def time_table(medians, meshes):
    rows = []
    for mesh in meshes:
        def milliseconds(name, mesh=mesh):
            return medians[f"{name}/{mesh}"]["cpu_time"]

        alone, together, cgal = (milliseconds(name) / NUMBER_OF_SOURCES
                                 for name in ("one_by_one", "together", "cgal_one_by_one"))
        rows.append([mesh, f"{milliseconds('prepare'):.0f} / {milliseconds('prepare_cgal'):.0f}", f"{alone:.2f}",
                     f"{together:.2f}", f"{alone / together:.1f}", f"{cgal:.2f}", f"{cgal / together:.0f}"])
    return markdown(["mesh", "prepare, CSCD / CGAL", "CSCD, alone", "CSCD, of eight", "alone : of eight", "CGAL",
                     "CGAL : of eight"], rows)


def tube_table(medians):
    def distance(name):
        ratio = medians[name]["relative_distance"]
        return f"{ratio:.4f}" if ratio < 1000 else "not a distance"

    rows = [[count(int(name.split("/")[1])), distance(name), distance(name.replace("tube", "tube_cgal"))]
            for name in medians if name.startswith("tube/")]
    return markdown(["edges along", "CSCD", "CGAL"], rows)


def main():
    context, medians = read_medians(sys.argv[1])
    meshes = [name.split("/")[1] for name in medians if name.startswith("prepare/")]
    path = ROOT / "doc" / "geodesics.md"
    replace_between_markers(path, {
        "tubes": tube_table(medians),
        "errors": error_table(medians, meshes),
        "times": time_table(medians, meshes),
        "geodesics_circumstances": f"Made on {context['date'][:10]}, {context['num_cpus']} cores, load average "
                                   f"{context['load_avg'][0]:.1f} at the start.",
    })
    print(path)


main()
