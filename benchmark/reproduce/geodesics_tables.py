# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tables of benchmark_geodesics."""

from markdown_tables import count, markdown

NUMBER_OF_SOURCES = 8  # that each run of the benchmark computes distances from


def meshes_of(medians):
    return [name.split("/")[1] for name in medians if name.startswith("prepare/")]


def error_table(medians):
    rows = []
    for mesh in meshes_of(medians):
        ours, theirs = medians[f"together/{mesh}"], medians[f"cgal_one_by_one/{mesh}"]
        rows.append([mesh, count(ours["vertices"]), count(ours["diameter"])]
                    + [f"{ours[key]:.2f} / {theirs[key]:.2f}"
                       for key in ("mean_error", "max_error", "percent_error")])
    return markdown(["mesh", "vertices", "eccentricity, edges", "mean error, CSCD / CGAL", "largest error",
                     "relative error, %"], rows)


def time_table(medians):
    rows = []
    for mesh in meshes_of(medians):
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


TABLES = {"tubes": tube_table, "errors": error_table, "times": time_table}
