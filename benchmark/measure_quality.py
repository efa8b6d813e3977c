# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Measures what the skeletons of all meshes of some folders are worth, and prints it by folder.

Shapes are numbered by the last digits in their file names, or, where there are none, by their position among the sorted
names. Even-numbered shapes are never used to choose constants: what holds for them should hold for any shape.
Seconds are those of the processor; errors are in thousandths of the diagonal of the bounding box.

What is not measured, because a mesh cannot be read, a program fails or takes too long, is told after the table.
"""

import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import resource
import shlex
import subprocess
import sys
import tempfile

import quality_tables

ENDINGS = (".off", ".obj", ".ply", ".stl")
NOT_A_MESH = "points"


class Failure(Exception):
    """A program that fails; the text says why."""


def run(command, timeout):
    """Runs a program; returns its standard output and how many seconds of the processor it took."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=timeout, check=False)
    except subprocess.TimeoutExpired:
        raise Failure(f"more than {timeout:g} s") from None
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        last_lines = done.stderr.strip().splitlines()[-1:]
        raise Failure(" ".join([f"exit status {done.returncode}", *last_lines]))
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def read_graph(path):
    """The points of the nodes and the edges of a skeleton in GEL's format."""
    points, edges = [], []
    for line in pathlib.Path(path).read_text().splitlines():
        fields = line.split()
        if fields[:1] == ["n"]:
            points.append(tuple(map(float, fields[1:4])))
        elif fields[:1] == ["c"]:
            edges.append((int(fields[1]), int(fields[2])))
    return points, edges


def turns(points, edges):
    """The turning angles of a skeleton in degrees, at its nodes of degree two."""
    neighbors = [[] for _ in points]
    for a, b in edges:
        neighbors[a].append(b)
        neighbors[b].append(a)
    result = []
    for node, around in enumerate(neighbors):
        if len(around) == 2:
            into, out = ([b - a for a, b in zip(points[p], points[q])] for p, q in
                         ((around[0], node), (node, around[1])))
            lengths = math.hypot(*into) * math.hypot(*out)
            if lengths > 0:
                cosine = sum(a * b for a, b in zip(into, out)) / lengths
                result.append(math.degrees(math.acos(max(-1, min(1, cosine)))))
    return result


def thousandths(value):
    return None if value is None else 1000 * value


def evaluate(options, mesh, skeleton):
    """The measures of a skeleton that do not depend on the program that made it."""
    command = [options.evaluator, "evaluate", mesh, skeleton, "--json", "--quiet", "--resolution",
               str(1 if options.fast else options.resolution)]
    measures = json.loads(run(command, options.timeout)[0])
    position = measures["position"]
    if position["number_of_surface_components"] == 0:
        raise Failure(NOT_A_MESH)
    result = {"betti_number": measures["counts"]["betti_number"], "inside": position["fraction_of_length_inside"],
              "offset": position["offset_by_length"], "deviation": position["deviation_by_length"]}
    if not options.fast:
        result["cone"] = thousandths(measures["round_cones"]["mean"])
        result["convolution"] = thousandths(measures["convolution"]["mean"])
    return measures, result


def measure_own(options, mesh, folder):
    """The row of a shape, except the columns that name it and the columns of MCF."""
    skeleton, report = folder / "skeleton.graph", folder / "report.json"
    command = [options.program, "skeletonize", mesh, "--output", skeleton, "--report", report, "--quiet", "--threads",
               "1", *shlex.split(options.args)]
    _, seconds = run(command, options.timeout)
    measures, row = evaluate(options, mesh, skeleton)
    told = json.loads(report.read_text())
    counts, position, limbs = measures["counts"], measures["position"], measures.get("limbs") or {}
    angles = turns(*read_graph(skeleton))
    return {
        **row,
        "vertices": measures["number_of_points"],
        "surface_components": position["number_of_surface_components"],
        "components": counts["number_of_components"],
        "genus": position["genus"],
        "borders": position["number_of_borders"],
        "nodes": counts["number_of_nodes"],
        "edges": counts["number_of_edges"],
        "nodes_outside": told.get("number_of_nodes_outside"),
        "edges_outside": told.get("number_of_edges_outside"),
        "largest_turn": max(angles, default=0),
        "turns_above_90": sum(angle > 90 for angle in angles),
        "tips": counts["number_of_tips"],
        "limbs": limbs.get("number_of_limbs"),
        "limbs_without_tip": limbs.get("number_of_limbs_without_tip"),
        "tips_without_limb": limbs.get("number_of_tips_without_limb"),
        "seconds": seconds,
    }


def measure_mcf(options, mesh, folder):
    """The columns of CGAL's mean curvature flow skeletonization."""
    skeleton = folder / "mcf.graph"
    try:
        _, seconds = run([options.mcf, mesh, skeleton], options.mcf_timeout)
        _, row = evaluate(options, mesh, skeleton)
    except Failure as failure:
        return {"mcf_failure": str(failure)}
    return {"mcf_seconds": seconds, **{"mcf_" + key: value for key, value in row.items()}}


def measure(options, name_of_set, mesh, position):
    """The row of a shape."""
    row = {"set": name_of_set, **quality_tables.identity(mesh.stem, position)}
    with tempfile.TemporaryDirectory() as folder:
        try:
            row.update(measure_own(options, mesh, pathlib.Path(folder)))
            if options.mcf and row["borders"] == 0 and row["surface_components"] == 1:  # it knows no others
                row.update(measure_mcf(options, mesh, pathlib.Path(folder)))
        except Failure as failure:
            row["failure"] = str(failure)
        if options.keep and (pathlib.Path(folder) / "skeleton.graph").exists():
            kept = pathlib.Path(options.keep) / name_of_set / (mesh.stem + ".graph")
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_bytes((pathlib.Path(folder) / "skeleton.graph").read_bytes())
    return row


def meshes_of(folder):
    """The meshes in a folder with their positions, sorted by number, then by name."""
    meshes = sorted(path for path in pathlib.Path(folder).iterdir() if path.suffix.lower() in ENDINGS)
    return sorted(((mesh, position) for position, mesh in enumerate(meshes, 1)),
                  key=lambda item: (quality_tables.number_of(item[0].stem) or 0, item[0].name))


def names_of_sets(folders):
    """The names of folders, with enough parent folders to be different: the last name alone is often 'meshes'."""
    parts = [pathlib.Path(folder).resolve().parts for folder in folders]
    for length in range(2, max(map(len, parts))):
        names = ["/".join(part[-length:]) for part in parts]
        if len(set(names)) == len(set(parts)):
            return names
    return list(map(str, folders))


def chosen(options, mesh, position):
    identity = quality_tables.identity(mesh.stem, position)
    return options.half in ("all", identity["half"]) and identity["number"] % options.every == 0


def with_columns_of_mcf(rows, path):
    """Each row with the results of MCF from an earlier measurement."""
    old = {(row["set"], row["shape"]): row for row in quality_tables.read_rows(path)}
    for row in rows:
        of_mcf = {key: value for key, value in old.get((row["set"], row["shape"]), {}).items()
                  if key.startswith("mcf_")}
        yield {**row, **of_mcf}


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="of meshes: " + " ".join(ENDINGS))
    parser.add_argument("--program", required=True, help="cscd that makes the skeletons")
    parser.add_argument("--args", default="", help="more arguments of its command skeletonize, as in --args='--seed 1'")
    parser.add_argument("--evaluator", help="cscd that measures them; by default the program")
    parser.add_argument("--fast", action="store_true", help="leave the reconstruction errors out")
    parser.add_argument("--resolution", type=int, default=100,
                        help="cells along the diagonal, for the reconstruction errors: these can only be compared if "
                             "it is the same; by default 100")
    parser.add_argument("--half", choices=quality_tables.HALVES, default="all")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="only shapes whose number N divides")
    parser.add_argument("--mcf", metavar="PROGRAM", help="also measure CGAL's mean curvature flow, by this program")
    parser.add_argument("--mcf-of", metavar="CSV", help="take what was measured of it from this file")
    parser.add_argument("--timeout", type=float, default=120, metavar="SECONDS", help="of each program; by default 120")
    parser.add_argument("--mcf-timeout", type=float, default=60, metavar="SECONDS", help="by default 60")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="shapes at once")
    parser.add_argument("--output", metavar="CSV", help="where the measures of each shape are written")
    parser.add_argument("--keep", metavar="FOLDER", help="where the skeletons are written")
    parser.add_argument("--compare", metavar="CSV", help="what --output has written, to be compared with")
    options = parser.parse_args(arguments)
    options.evaluator = options.evaluator or options.program
    return options


def main(arguments):
    options = parse(arguments)
    before = quality_tables.read_rows(options.compare) if options.compare else None
    tasks = [(name, mesh, position) for name, folder in zip(names_of_sets(options.folders), options.folders)
             for mesh, position in meshes_of(folder) if chosen(options, mesh, position)]
    # A process for each, because the seconds of children are counted by process.
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as executor:
        rows = executor.map(measure, *zip(*((options, *task) for task in tasks))) if tasks else ()
        if options.mcf_of:
            rows = with_columns_of_mcf(rows, options.mcf_of)
        rows = quality_tables.write_rows(options.output, rows) if options.output else list(rows)
    print(quality_tables.report(rows, before))


if __name__ == "__main__":
    main(sys.argv[1:])
