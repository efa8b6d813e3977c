# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletons of graphs: of the edges of meshes, beside what is quoted of local separators (LS) on the same meshes, and of
points drawn at random on them and joined to their neighbors.

Usage: graphs.py PROGRAM FOLDER [--points N] [--neighbors K]
FOLDER has closed meshes in OFF format. Errors are the mean distances of the vertices of the mesh from the convolution
surface of the skeleton and from its round cones, in thousandths of the diagonal; seconds are those of the processor on
one thread, of the whole program. Components and Betti number are right if they are those of the mesh.
"""

import argparse
import json
import math
import pathlib
import random
import statistics
import tempfile

from markdown_tables import markdown
from measure_quality import Failure, run

QUOTED = json.loads((pathlib.Path(__file__).parent / "quoted_results.json").read_text())
SEED = 11  # of the random points


def read_off(path):
    """The points and triangles of a mesh in OFF format."""
    numbers = path.read_text().split("OFF", 1)[1].split()
    n, m = int(numbers[0]), int(numbers[1])
    points = [tuple(map(float, numbers[3 + 3 * i : 6 + 3 * i])) for i in range(n)]
    faces = [tuple(map(int, numbers[4 + 3 * n + 4 * i : 7 + 3 * n + 4 * i])) for i in range(m)]
    return points, faces


def random_points(points, faces, count):
    """Points that are evenly distributed on the surface."""
    generator = random.Random(SEED)

    def side(a, b):
        return [points[b][k] - points[a][k] for k in range(3)]

    def area(a, b, c):
        (ux, uy, uz), (vx, vy, vz) = side(a, b), side(a, c)
        return math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)

    result = []
    for a, b, c in generator.choices(faces, weights=[area(*face) for face in faces], k=count):
        s, t = math.sqrt(generator.random()), generator.random()
        result.append([(1 - s) * points[a][k] + s * (1 - t) * points[b][k] + s * t * points[c][k] for k in range(3)])
    return result


def skeletonize(program, graph, folder, *options):
    """The report on the skeleton of a graph, and the seconds that it took."""
    report = folder / "report.json"
    _, seconds = run([program, "skeletonize", graph, "--as", "graph", "-o", folder / "skeleton.graph", "--report", report,
                      "--quiet", "--threads", "1", *options], timeout=900)
    return json.loads(report.read_text()), seconds


def is_right(report, mesh):
    return (report["number_of_skeleton_components"], report["betti_number"]) == (mesh["components"], mesh["genus"])


def quoted_row(vertices, faces):
    return next((row for row in QUOTED["GEL"]["rows"]
                 if (row["vertices"], row["faces"]) == (vertices, faces) and "LS error" in row), None)


def measure(program, path, folder, options):
    """One row of each table; the first is None where nothing is quoted of the mesh."""
    points, faces = read_off(path)
    run([program, "skeletonize", path, "-o", folder / "mesh.graph", "--report", folder / "mesh.json", "--quiet"],
        timeout=900)
    report = json.loads((folder / "mesh.json").read_text())
    mesh = {"components": report["number_of_surface_components"], "genus": report["genus"]}
    edges = None
    quoted = quoted_row(len(points), len(faces))
    if quoted:
        report, seconds = skeletonize(program, path, folder)
        measured = json.loads(run([program, "evaluate", path, folder / "skeleton.graph", "--json"], timeout=900)[0])
        edges = {"mesh": path.stem, "right": is_right(report, mesh), "tips": report["number_of_tips"],
                 "LS tips": quoted["LS tips"],
                 "cones": 1000 * measured["round_cones"]["mean"] / quoted["LS cone error"],
                 "convolution": 1000 * measured["convolution"]["mean"] / quoted["LS error"],
                 "seconds": seconds, "ratio": quoted["LS seconds"] / seconds}
    cloud = folder / "points.xyz"
    cloud.write_text("".join("%.9g %.9g %.9g\n" % tuple(p) for p in random_points(points, faces, options.points)))
    report, seconds = skeletonize(program, cloud, folder, "--neighbors", str(options.neighbors))
    excess = report["betti_number"] - mesh["genus"]
    return edges, [path.stem, str(report["number_of_skeleton_components"] - mesh["components"]), str(excess),
                   str(report["number_of_tips"]), f"{seconds:.2f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=5000)
    parser.add_argument("--neighbors", type=int, default=24)
    options = parser.parse_args()
    rows, clouds = [], []
    with tempfile.TemporaryDirectory() as folder:
        for path in sorted(options.folder.glob("*.off")):
            try:
                edges, cloud = measure(options.program, path, pathlib.Path(folder), options)
            except Failure as failure:
                print(f"{path.name}: {failure}")
                continue
            rows += [edges] if edges else []
            clouds.append(cloud)
    table = [[row["mesh"], "yes" if row["right"] else "no", f"{row['tips']}, {row['LS tips']}", f"{row['cones']:.2f}",
              f"{row['convolution']:.2f}", f"{row['seconds']:.2f}", f"{row['ratio']:.0f}"] for row in rows]
    if rows:
        table.append(["geometric mean", f"{sum(row['right'] for row in rows)} of {len(rows)}", "",
                      *(f"{statistics.geometric_mean(row[key] for row in rows):.2f}"
                        for key in ("cones", "convolution", "seconds")),
                      f"{statistics.geometric_mean(row['ratio'] for row in rows):.0f}"])
    print(markdown(["edges of", "topology right", "tips, LS", "cone error / LS", "convolution error / LS", "s",
                    "times as fast as LS"], table))
    print()
    print(markdown([f"{options.points} points on", "components too many", "cycles too many", "tips", "s"], clouds))
    right = sum(row[1] == row[2] == "0" for row in clouds)
    print(f"\n{right} of {len(clouds)} clouds right, with {options.neighbors} neighbors.")


if __name__ == "__main__":
    main()
