#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tables of the applications, see applications.sh. Each mesh is measured in a process of its own, with a time limit."""

import argparse
import collections
import concurrent.futures
import json
import math
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile
import time

import measurements
from markdown_tables import markdown

PRINCETON_CLASSES = ("human", "cup", "glasses", "airplane", "ant", "chair", "octopus", "table", "teddy", "hand", "pliers",
                     "fish", "bird", "", "armadillo", "bust", "mechanical part", "bearing", "vase", "four-legged")
MESHES_IN_A_CLASS = 20  # with consecutive numbers
ERRORS = ("rand_error", "cut_discrepancy", "hamming_distance", "global_consistency_error", "local_consistency_error")
TITLES = ("1 - Rand index", "cut discrepancy", "Hamming", "global consistency", "local consistency")


class Runner:
    """Runs the programs, keeps the measurements of the first, and reports runs that failed or took too long."""

    def __init__(self, folder, timeout, jobs):
        self.folder, self.timeout, self.jobs, self.kept, self.failed = pathlib.Path(folder), timeout, jobs, {}, []

    def run(self, *command):
        """The output of a program, or None."""
        try:
            return subprocess.run(command, capture_output=True, text=True, timeout=self.timeout, check=True).stdout
        except (subprocess.TimeoutExpired, subprocess.CalledProcessError) as error:
            reason = "time" if isinstance(error, subprocess.TimeoutExpired) else "error"
            self.failed.append(f"{' '.join(map(str, command[1:3]))}: {reason}")
            return None

    def measure(self, mesh, method, people=None):
        key = (str(mesh), method)
        if key not in self.kept:
            program = self.folder / "benchmark/benchmark_applications"
            text = self.run(program, mesh, method, *([people] if people else []))
            self.kept[key] = json.loads(text) if text else None
            print(mesh.name, method, self.kept[key] and self.kept[key].get("rand_error"), file=sys.stderr, flush=True)
        return self.kept[key]

    def measure_all(self, arguments):
        """Measures several at once; the cost of a run is CPU time."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for _ in pool.map(lambda one: self.measure(*one), arguments):
                pass


def princeton_meshes(folder, parity, step):
    """Numbers and files of meshes whose number is even (0) or odd (1); one in `step` of them."""
    for number in range(2 - parity, MESHES_IN_A_CLASS * len(PRINCETON_CLASSES) + 1, 2 * step):
        mesh = folder / "off" / f"{number}.off"
        if mesh.exists():
            yield number, mesh


def class_of(number):
    return PRINCETON_CLASSES[(number - 1) // MESHES_IN_A_CLASS]


def mean_cells(runs):
    def mean(key):
        values = [run[key] for run in runs if run.get(key) is not None]
        return statistics.fmean(values) if values else math.nan

    seconds = mean("skeleton_seconds") + mean("diameter_seconds") + mean("segmentation_seconds")
    return [f"{mean(key):.3f}" for key in ERRORS] + [f"{mean('parts'):.1f}", f"{seconds:.2f}", str(len(runs))]


def segmentation_table(runner, folder, method, parities, step):
    rows = []
    runner.measure_all([(mesh, method, folder / "seg/Benchmark" / str(number)) for parity in parities
                        for number, mesh in princeton_meshes(folder, parity, step)])
    for parity in parities:
        runs = collections.defaultdict(list)
        for number, mesh in princeton_meshes(folder, parity, step):
            run = runner.measure(mesh, method, folder / "seg/Benchmark" / str(number))
            if run:
                runs[class_of(number)].append(run)
        if parity == 0:
            rows += [[name] + mean_cells(runs[name]) for name in PRINCETON_CLASSES if runs[name]]
        name = "all odd-numbered" if parity else "**all even-numbered**"
        rows.append([name] + mean_cells([run for group in runs.values() for run in group]))
    return f"Method `{method}`:\n\n" + markdown(["meshes", *TITLES, "parts", "CPU s", "meshes"], rows)


def read_off(path):
    words = path.read_text().split()
    number, faces = int(words[1]), int(words[2])
    points = [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(number)]
    at = 4 + 3 * number
    return points, [tuple(map(int, words[at + 4 * i + 1:at + 4 * i + 4])) for i in range(faces)]


def write_off(path, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"] + [f"{x} {y} {z}" for x, y, z in points]
    path.write_text("\n".join(lines + [f"3 {a} {b} {c}" for a, b, c in faces]) + "\n")


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def face_normals(points, faces):
    """As long as twice the areas."""
    result = []
    for a, b, c in faces:
        p, q, r = points[a], points[b], points[c]
        result.append(cross([q[k] - p[k] for k in range(3)], [r[k] - p[k] for k in range(3)]))
    return result


def rank_correlation(first, second):
    def ranks(values):
        result = [0] * len(values)
        for rank, i in enumerate(sorted(range(len(values)), key=values.__getitem__)):
            result[i] = rank
        return result

    n = len(first)
    return 1 - 6 * sum((a - b) ** 2 for a, b in zip(ranks(first), ranks(second))) / (n * (n * n - 1))


def difference(first, second):
    """The mean difference of two lists of diameters, relative to the mean of both."""
    return 2 * sum(abs(a - b) for a, b in zip(first, second)) / (sum(first) + sum(second))


def same_vertices(points):
    return [(v, v) for v in range(len(points))]


def noisy(points, faces, rng):
    """Moves vertices along their normals by one percent of the diagonal of the bounding box (standard deviation)."""
    normals = [[0., 0., 0.] for _ in points]
    for face, normal in zip(faces, face_normals(points, faces)):
        for vertex in face:
            normals[vertex] = [a + b for a, b in zip(normals[vertex], normal)]
    diagonal = math.dist(*[[choose(p[k] for p in points) for k in range(3)] for choose in (min, max)])
    result = []
    for point, normal in zip(points, normals):
        step = rng.gauss(0, .01 * diagonal) / (math.hypot(*normal) or 1)
        result.append(tuple(p + step * n for p, n in zip(point, normal)))
    return result, faces, same_vertices(points)


def with_holes(points, faces, rng):
    """Removes the faces around ten vertices, and those around these."""
    removed = set(rng.sample(range(len(points)), 10))
    removed |= {v for face in faces if removed & set(face) for v in face}
    faces = [face for face in faces if not removed & set(face)]
    kept = sorted({v for face in faces for v in face})
    number = {v: i for i, v in enumerate(kept)}
    return [points[v] for v in kept], [tuple(number[v] for v in face) for face in faces], list(zip(kept, range(len(kept))))


def divided(points, faces, _):
    """Divides each face into four."""
    same, points, middle, result = same_vertices(points), list(points), {}, []

    def between(a, b):
        key = (min(a, b), max(a, b))
        if key not in middle:
            middle[key] = len(points)
            points.append(tuple((p + q) / 2 for p, q in zip(points[a], points[b])))
        return middle[key]

    for a, b, c in faces:
        d, e, f = between(a, b), between(b, c), between(c, a)
        result += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
    return points, result, same


def diameters_table(runner, meshes, poses):
    """Agreement of shape diameters by skeletons and by rays, their stability, and their cost."""
    columns = collections.defaultdict(lambda: collections.defaultdict(list))

    def compare(row, method, first, second, vertices):
        """`vertices`: pairs of the same place."""
        if first and second:
            a, b = ([run["diameters"][pair[k]] for pair in vertices] for k, run in ((0, first), (1, second)))
            # Vertices without a face have no diameter.
            a, b = zip(*[(x, y) for x, y in zip(a, b) if x > 0 and y > 0])
            columns[row][method].append((rank_correlation(a, b), difference(a, b)))

    with tempfile.TemporaryDirectory() as folder:
        for mesh in meshes:
            points, faces = read_off(mesh)
            runs = {method: runner.measure(mesh, method) for method in ("skeleton", "rays")}
            compare("by the other method", "skeleton", runs["skeleton"], runs["rays"], same_vertices(points))
            for name, change in (("noise of 1 % of the diagonal", noisy), ("ten holes", with_holes),
                                 ("faces divided into four", divided)):
                changed = pathlib.Path(folder) / f"{mesh.stem}_{change.__name__}.off"
                *shape, same = change(points, faces, random.Random(1))
                write_off(changed, *shape)
                for method, run in runs.items():
                    compare(name, method, run, runner.measure(changed, method), same)
    for first, second, same in poses:
        for method in ("skeleton", "rays"):
            compare("pose", method, runner.measure(first, method), runner.measure(second, method), same)
    rows = []
    for name, methods in columns.items():
        cells = []
        for method in ("skeleton", "rays"):
            values = list(zip(*methods[method])) or [[math.nan]] * 2
            cells += [f"{statistics.fmean(value):.3f}" for value in values]
        rows.append([name] + cells)
    times = []
    for method in ("skeleton", "rays"):
        runs = [run for (_, kept), run in runner.kept.items() if kept == method and run]
        for key in ("skeleton_seconds", "diameter_seconds"):
            times.append(f"{1e5 * sum(run[key] for run in runs) / sum(run['vertices'] for run in runs):.2f}")
    table = markdown(["compared with", "skeleton: rank correlation", "difference", "rays: rank correlation", "difference"],
                     rows)
    return (f"{table}\n\nCPU seconds for 100 000 vertices: skeleton {times[0]} and {times[1]} for its diameters, "
            f"rays {times[3]}.")


def read_numbers(path):
    return [int(word) - 1 for word in path.read_text().split()]


def pose_files(folder):
    """The meshes of each body that have a correspondence, in order: FOLDER/off and FOLDER/vts."""
    bodies = collections.defaultdict(list)
    for mesh in folder.glob("off/*.off"):
        if (folder / "vts" / f"{mesh.stem}.vts").exists():
            name, number = re.fullmatch(r"(.*?)_?(\d+)", mesh.stem).groups()
            if name == "tr_reg":  # FAUST: ten poses of each body
                name = number[:-1]
            bodies[name].append((int(number), mesh))
    return {name: [mesh for _, mesh in sorted(meshes)] for name, meshes in sorted(bodies.items())}


def center(points):
    return [statistics.fmean(point[k] for point in points) for k in range(3)]


def nearest_vertices(loop, points):
    """Numbers of the vertices that are nearest to the points of a loop."""
    return {min(range(len(points)), key=lambda v, at=at: math.dist(points[v], at)) for at in loop}


def constrictions_table(runner, folder):
    """The number of poses of all bodies that have the constrictions of the first pose, by the correspondence."""
    program = runner.folder / "cscd"
    (first, *others), *bodies = pose_files(folder).values()
    poses = [first] + others + [mesh for body in bodies for mesh in body]

    def constrictions(mesh):
        loops = json.loads(runner.run(program, "loops", mesh, "-o", "-") or "[]")
        return [loop for loop in loops if loop["kind"] == "constriction"]

    with concurrent.futures.ThreadPoolExecutor(runner.jobs) as pool:
        found = dict(zip(poses, pool.map(constrictions, poses)))
    points_of_first, _ = read_off(first)
    near = (max(p[1] for p in points_of_first) - min(p[1] for p in points_of_first)) / 15  # of the height of the body
    to_first = read_numbers(folder / "vts" / f"{first.stem}.vts")
    centers = {}
    for mesh in poses:
        points, _ = read_off(mesh)
        place = {}
        for v, w in zip(read_numbers(folder / "vts" / f"{mesh.stem}.vts"), to_first):
            place.setdefault(v, points_of_first[w])
        centers[mesh] = []
        for loop in found[mesh]:
            vertices = nearest_vertices(loop["points"], points) & place.keys()
            if vertices:
                centers[mesh].append(center([place[v] for v in vertices]))
    rows = []
    for loop, middle in zip(found[first], centers[first]):
        number = sum(any(math.dist(middle, other) < near for other in centers[mesh]) for mesh in poses)
        rows.append([" ".join(f"{x:.2f}" for x in middle), f"{loop['length']:.3f}", f"{loop['depth']:.2f}", str(number)])
    number = statistics.fmean(len(loops) for loops in found.values())
    return (markdown(["middle of a constriction in the first pose", "length", "depth", f"found in {len(poses)} poses"], rows)
            + f"\n\n{number:.1f} constrictions a pose.")


def boundaries_text(runner, folder, step):
    """The lengths of boundaries of parts, compared with the separators that they follow."""
    meshes = [mesh for _, mesh in princeton_meshes(folder, 0, step)]
    runner.measure_all([(mesh, "skeleton", folder / "seg/Benchmark" / mesh.stem) for mesh in meshes])
    runs = [run for run in (runner.measure(mesh, "skeleton") for mesh in meshes) if run]
    boundaries = [boundary for run in runs for boundary in run["closed_boundaries"]]
    in_closed = sum(b["edges"] for b in boundaries) / sum(run["boundary_edges"] for run in runs)
    ratios = statistics.quantiles([b["length_ratio"] for b in boundaries], n=10)
    distances = statistics.quantiles([b["distance"] for b in boundaries], n=10)
    return (f"{len(boundaries)} boundaries that are closed curves, {in_closed:.2f} of all edges between parts. Length, "
            f"relative to that of the nearest packed separator: median {ratios[4]:.2f}, deciles {ratios[0]:.2f} and "
            f"{ratios[8]:.2f}. Mean distance from it, relative to its radius: median {distances[4]:.2f}, deciles "
            f"{distances[0]:.2f} and {distances[8]:.2f}.")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="folder bin of the build")
    parser.add_argument("--princeton", type=pathlib.Path, help="off/N.off and seg/Benchmark/N/N_*.seg")
    parser.add_argument("--tosca", type=pathlib.Path, help="off/NAME.off, vts/NAME.vts")
    parser.add_argument("--faust", type=pathlib.Path, help="likewise")
    parser.add_argument("--tables", nargs="+", default=["segmentation", "boundaries", "diameters", "constrictions"])
    parser.add_argument("--methods", nargs="+", default=["skeleton", "diameter", "rays"], help="of segmentation")
    parser.add_argument("--parities", nargs="+", type=int, default=[0, 1], help="of numbers: 0 is even; 1 was tuned on")
    parser.add_argument("--timeout", type=float, default=60, help="seconds for each mesh and method")
    parser.add_argument("--step", type=int, default=1, help="take one in so many shapes, for a quick look")
    parser.add_argument("--jobs", type=int, default=1, help="meshes at once")
    options = parser.parse_args()
    runner = Runner(options.programs.resolve(), options.timeout, options.jobs)
    print(f"Made by `benchmark/reproduce/applications.sh` on {time.strftime('%Y-%m-%d')} at commit {measurements.commit()}, "
          f"{measurements.processor()}, one thread; time limit {options.timeout:g} s a mesh.")
    if options.princeton and "segmentation" in options.tables:
        for method in options.methods:
            print("\n" + segmentation_table(runner, options.princeton, method, options.parities, options.step), flush=True)
    if options.princeton and "boundaries" in options.tables:
        print("\n" + boundaries_text(runner, options.princeton, options.step), flush=True)
    poses = [files for folder in (options.tosca, options.faust) if folder for files in pose_files(folder).values()]
    if poses and "diameters" in options.tables:
        correspondences = [
            (files[0], files[2], list(zip(*(read_numbers(m.parent.parent / "vts" / f"{m.stem}.vts") for m in files[:3:2]))))
            for files in poses[::options.step] if len(files) > 2]
        print("\n" + diameters_table(runner, [first for first, _, _ in correspondences], correspondences), flush=True)
    if options.faust and "constrictions" in options.tables:
        print("\n" + constrictions_table(runner, options.faust), flush=True)
    if runner.failed:
        print("\nWithout an answer: " + "; ".join(runner.failed) + ".")


if __name__ == "__main__":
    main()
