# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Measures the quality of the skeletons of all meshes of some folders, and prints a table of each folder.

Shapes are numbered by the last digits in their file names, or, where there are none, by their position among the sorted
names. Constants are chosen on odd-numbered shapes alone, so that even-numbered ones tell what holds for any shape.
Seconds are those of the processor; errors are in thousandths of the diagonal of the bounding box.
"""

import argparse
import concurrent.futures
import csv
import os
import pathlib
import re
import shlex
import statistics
import tempfile

from programs import Failure, Laboratory, turns
from tables import markdown

ENDINGS = (".off", ".obj", ".ply", ".stl")
HALVES = ("all", "odd", "even")


def number_of(name, position):
    digits = re.findall(r"\d+", name)
    return int(digits[-1]) if digits else position


def measure(options, name_of_set, mesh, number):
    """The row of a shape."""
    row = {"set": name_of_set, "shape": mesh.stem, "half": "odd" if number % 2 else "even"}
    with tempfile.TemporaryDirectory() as folder:
        lab = Laboratory(options.build / "bin", folder)
        evaluator, lab.cscd = lab.cscd, options.program or lab.cscd
        try:
            report, cost = lab.skeletonize(mesh, *shlex.split(options.args), timeout=options.timeout)
            lab.cscd = evaluator
            measures = lab.evaluate(mesh, resolution=1 if options.fast else 100, timeout=options.timeout)
            angles = turns(lab.skeleton)
        except Failure as failure:
            return {**row, "failure": str(failure)}
    counts, position, limbs = measures["counts"], measures["position"], measures.get("limbs") or {}
    if position["number_of_surface_components"] == 0:
        return {**row, "failure": "points"}
    if not options.fast:
        row.update(cone=1000 * measures["round_cones"]["mean"], convolution=1000 * measures["convolution"]["mean"])
    return {**row, "vertices": measures["number_of_points"],
            "surface_components": position["number_of_surface_components"],
            "components": counts["number_of_components"], "genus": position["genus"],
            "betti_number": counts["betti_number"], "borders": position["number_of_borders"],
            "nodes": counts["number_of_nodes"], "edges": counts["number_of_edges"],
            "nodes_outside": report.get("number_of_nodes_outside"),
            "edges_outside": report.get("number_of_edges_outside"),
            "inside": position["fraction_of_length_inside"], "offset": position["offset_by_length"],
            "deviation": position["deviation_by_length"],
            "turns_above_90": sum(angle > 90 for angle in angles), "tips": counts["number_of_tips"],
            "limbs": limbs.get("number_of_limbs"), "limbs_without_tip": limbs.get("number_of_limbs_without_tip"),
            "tips_without_limb": limbs.get("number_of_tips_without_limb"), "seconds": cost.cpu}


def write_rows(path, rows):
    with pathlib.Path(path).open("w", newline="") as file:
        writer = csv.DictWriter(file, dict.fromkeys(key for row in rows for key in row), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def with_all(rows, *columns):
    """The rows that have a value in all columns."""
    return [row for row in rows if all(row.get(column) is not None for column in columns)]


def closed(rows):
    return [row for row in rows if row.get("borders") == 0]


def equal(rows, first, second):
    known = with_all(rows, first, second)
    return f"{sum(row[first] == row[second] for row in known)} of {len(known)}" if known else "-"


def part(rows, column, of):
    """The sum of one column and the sum of another one that includes it."""
    known = with_all(rows, column, of)
    return f"{sum(row[column] for row in known):.0f} of {sum(row[of] for row in known):.0f}" if known else "-"


def rate(rows, missing, of):
    """The fraction of the sum of `of` that is not `missing`."""
    known = with_all(rows, missing, of)
    total = sum(row[of] for row in known)
    return f"{1 - sum(row[missing] for row in known) / total:.3f}" if total else "-"


def folded(function, rows, column, digits):
    known = [row[column] for row in with_all(rows, column)]
    return f"{function(known):.{digits}f}" if known else "-"


# Each line of a table: its label, and the function that makes its text from rows.
MEASURES = (
    ("components right", lambda rows: equal(rows, "components", "surface_components")),
    ("Betti number = genus, closed", lambda rows: equal(closed(rows), "betti_number", "genus")),
    ("nodes outside", lambda rows: part(rows, "nodes_outside", "nodes")),
    ("edges outside", lambda rows: part(rows, "edges_outside", "edges")),
    ("length inside, closed", lambda rows: folded(statistics.fmean, closed(rows), "inside", 4)),
    ("cone error, 1/1000", lambda rows: folded(statistics.fmean, rows, "cone", 2)),
    ("convolution error, 1/1000", lambda rows: folded(statistics.fmean, rows, "convolution", 2)),
    ("offset from center", lambda rows: folded(statistics.fmean, rows, "offset", 3)),
    ("deviation", lambda rows: folded(statistics.fmean, rows, "deviation", 3)),
    ("turns above 90 degrees", lambda rows: folded(sum, rows, "turns_above_90", 0)),
    ("tips", lambda rows: folded(sum, rows, "tips", 0)),
    ("limbs without a tip", lambda rows: part(rows, "limbs_without_tip", "limbs")),
    ("tips without a limb", lambda rows: part(rows, "tips_without_limb", "tips")),
    ("tip recall", lambda rows: rate(rows, "limbs_without_tip", "limbs")),
    ("tip precision", lambda rows: rate(rows, "tips_without_limb", "tips")),
    ("CPU seconds, mean", lambda rows: folded(statistics.fmean, rows, "seconds", 3)),
)


def table(title, rows):
    """A column for all rows, and one for each half."""
    by_half = [[row for row in rows if half in ("all", row["half"])] for half in HALVES]
    return markdown([title, *HALVES], [["shapes", *(str(len(half)) for half in by_half)],
                                       *([label, *map(text_of, by_half)] for label, text_of in MEASURES)])


def table_of_set(name, rows):
    failures = [f"not measured: {row['shape']}: {row['failure']}" for row in rows if row.get("failure")]
    rows = [row for row in rows if not row.get("failure")]
    wrong = [row["shape"] for row in closed(rows) if row["betti_number"] != row["genus"]]
    return "\n\n".join([table(name, rows), *failures,
                        *[f"Betti number is not the genus: {' '.join(wrong)}"] * bool(wrong)])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("folders", nargs="*", type=pathlib.Path, help="of meshes: " + " ".join(ENDINGS))
    parser.add_argument("--program", type=pathlib.Path, help="another build of cscd, which makes the skeletons")
    parser.add_argument("--args", default="", help="more arguments of its command skeletonize, as in --args='--seed 1'")
    parser.add_argument("--fast", action="store_true", help="leave the reconstruction errors out")
    parser.add_argument("--half", choices=HALVES, default="all")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="only shapes whose number N divides")
    parser.add_argument("--timeout", type=float, default=120, metavar="SECONDS", help="of each program; by default 120")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="shapes at once")
    parser.add_argument("--output", metavar="CSV", help="where the measures of each shape are written")
    options = parser.parse_args()
    tasks = []
    for folder in options.folders or [options.build / "cgal_data/data/meshes"]:
        name = "/".join(folder.resolve().parts[-2:])
        for position, mesh in enumerate(sorted(file for file in folder.iterdir() if file.suffix.lower() in ENDINGS), 1):
            number = number_of(mesh.stem, position)
            if options.half in ("all", "odd" if number % 2 else "even") and number % options.every == 0:
                tasks.append((name, mesh, number))
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as executor:
        rows = list(executor.map(lambda task: measure(options, *task), tasks))
    if options.output:
        write_rows(options.output, rows)
    for name in dict.fromkeys(row["set"] for row in rows):
        print(table_of_set(name, [row for row in rows if row["set"] == name]), end="\n\n")


if __name__ == "__main__":
    main()
