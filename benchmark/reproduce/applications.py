# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Prints the tables of applications in doc/results.md.

Usage: applications.py BUILD PRINCETON [TOSCA [FAUST]] [OPTION...]
PRINCETON is the Princeton segmentation benchmark: off/N.off and seg/Benchmark/N/N_*.seg. TOSCA and FAUST, remeshed, are
off/NAME.off with correspondences vts/NAME.vts (J. Ren et al., 2018). All tables take about an hour, most of it for
CGAL's rays. Each mesh is measured in a process of its own, with a time limit.
"""

import argparse
import collections
import json
import math
import pathlib
import re
import statistics
import sys
import tempfile

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

import tables
from programs import Failure, Laboratory, read_off, run
from tables import markdown

PRINCETON_CLASSES = ("human", "cup", "glasses", "airplane", "ant", "chair", "octopus", "table", "teddy", "hand",
                     "pliers", "fish", "bird", "", "armadillo", "bust", "mechanical part", "bearing", "vase",
                     "four-legged")
MESHES_IN_A_CLASS = 20  # with consecutive numbers
ERRORS = ("rand_error", "cut_discrepancy", "hamming_distance", "global_consistency_error", "local_consistency_error")
TITLES = ("1 - Rand index", "cut discrepancy", "Hamming", "global consistency", "local consistency")


def measure(lab, options, mesh, method):
    """What measure_applications writes of a mesh, or None."""
    try:
        return json.loads(run(lab.benchmarks / "measure_applications", mesh, method, timeout=options.timeout)[0])
    except Failure as failure:
        print(f"{mesh} {method}: {failure}", file=sys.stderr)
        return None


# Segmentations.

def compare_segmentations(points, faces, first, second):
    """The measures of the Princeton segmentation benchmark (X. Chen, A. Golovinskiy, T. Funkhouser, "A benchmark for 3D
    mesh segmentation", 2009) in the order of ERRORS: each face counts once, and all are 0 for equal segmentations. The
    cut discrepancy is not a number if just one of the segmentations has boundaries, or some lie in components where the
    other has none."""
    first, second = (np.unique(labels, return_inverse=True)[1] for labels in (first, second))
    common = np.zeros((first.max() + 1, second.max() + 1))
    np.add.at(common, (first, second), 1)
    of_first, of_second, number = common.sum(axis=1), common.sum(axis=0), len(faces)

    def pairs(sizes):
        return (sizes * (sizes - 1) / 2).sum()

    beyond_first = common * (1 - common / of_first[:, None])  # faces, by the part of their part that is not common
    beyond_second = common * (1 - common / of_second)
    rand_error = (pairs(of_first) + pairs(of_second) - 2 * pairs(common)) / max(pairs(np.array(number)), 1)
    hamming = 1 - (common.max(axis=0).sum() + common.max(axis=1).sum()) / (2 * number)
    global_error = min(beyond_first.sum(), beyond_second.sum()) / number
    local_error = np.minimum(beyond_first, beyond_second).sum() / number

    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    face_of_side = np.tile(np.arange(number), 3)
    order = np.lexsort(sides.T)
    pairs_of_sides = np.stack([order[:-1], order[1:]])[:, (sides[order[:-1]] == sides[order[1:]]).all(axis=1)]
    edges = np.unique(sides, axis=0)
    lengths = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    graph = coo_array((lengths, edges.T), shape=(len(points),) * 2).tocsr()

    def boundary(labels):
        is_between = labels[face_of_side[pairs_of_sides[0]]] != labels[face_of_side[pairs_of_sides[1]]]
        return np.unique(sides[pairs_of_sides[0, is_between]])

    def mean_distance(start, end):
        """From the vertices `start` to the nearest one of `end`, along edges."""
        if len(start) == 0 or len(end) == 0:
            return 0 if len(start) == 0 else math.nan
        distances = dijkstra(graph, directed=False, indices=end, min_only=True)[start]
        return distances.mean() if np.isfinite(distances).all() else math.nan

    cuts = [boundary(labels) for labels in (first, second)]
    corners = points[faces]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    centers = corners.mean(axis=1)
    radius = np.average(np.linalg.norm(centers - np.average(centers, axis=0, weights=areas), axis=1), weights=areas)
    discrepancy = (mean_distance(*cuts) + mean_distance(*reversed(cuts))) / radius
    return rand_error, discrepancy, hamming, global_error, local_error


def measure_segmentation(lab, options, number, method):
    """What measure_applications writes of a mesh, with its mean errors over the segmentations by people, or None."""
    mesh = options.princeton / f"off/{number}.off"
    result = measure(lab, options, mesh, method)
    if result:
        points, faces = map(np.array, read_off(mesh))
        errors = np.array([compare_segmentations(points, faces, result["labels"], np.loadtxt(people, dtype=int))
                           for people in (options.princeton / f"seg/Benchmark/{number}").iterdir()])
        is_known = np.isfinite(errors)
        result.update(zip(ERRORS, (column[known].mean() if known.any() else None
                                   for column, known in zip(errors.T, is_known.T))))
    return result


def mean_cells(runs):
    def mean(key):
        values = [run[key] for run in runs if run[key] is not None]
        return statistics.fmean(values) if values else math.nan

    seconds = sum(map(mean, ("skeleton_seconds", "diameter_seconds", "segmentation_seconds")))
    return [f"{mean(key):.3f}" for key in ERRORS] + [f"{mean('parts'):.1f}", f"{seconds:.2f}", str(len(runs))]


def segmentation_table(lab, options, method, parity):
    """A row for each class, and one for all meshes whose number is even (0) or odd (1)."""
    numbers = [number for number in range(2 - parity, MESHES_IN_A_CLASS * len(PRINCETON_CLASSES) + 1, 2 * options.step)
               if (options.princeton / f"off/{number}.off").exists()]
    runs = [measure_segmentation(lab, options, number, method) for number in numbers]
    of_class = collections.defaultdict(list)
    for number, run_of_mesh in zip(numbers, runs):
        if run_of_mesh:
            of_class[PRINCETON_CLASSES[(number - 1) // MESHES_IN_A_CLASS]].append(run_of_mesh)
    rows = [[name, *mean_cells(found)] for name, found in of_class.items()]
    rows.append([f"**all {'odd' if parity else 'even'}-numbered**", *mean_cells(list(filter(None, runs)))])
    return f"Method `{method}`:\n\n" + markdown(["meshes", *TITLES, "parts", "CPU s", "meshes"], rows)


# Shape diameters.

def noisy(points, faces, random):
    """Moves vertices along their normals by one percent of the diagonal of the bounding box (standard deviation)."""
    corners = points[faces]
    normals = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normals, faces[:, corner], np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    steps = random.normal(0, 0.01 * np.linalg.norm(np.ptp(points, axis=0)), (len(points), 1))
    return points + steps * normals, faces, np.arange(len(points))


def with_holes(points, faces, random):
    """Removes the faces around ten vertices, and those around these."""
    removed = random.choice(len(points), 10, replace=False)
    removed = faces[np.isin(faces, removed).any(axis=1)]
    faces = faces[~np.isin(faces, removed).any(axis=1)]
    kept, faces = np.unique(faces, return_inverse=True)
    return points[kept], faces.reshape(-1, 3), kept


def divided(points, faces, _):
    """Divides each face into four."""
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    edges, middle = np.unique(sides, axis=0, return_inverse=True)
    d, e, f = (len(points) + middle.reshape(3, -1))
    a, b, c = faces.T
    faces = np.concatenate([np.stack(face, axis=1) for face in ((a, d, f), (d, b, e), (f, e, c), (d, e, f))])
    return np.concatenate([points, points[edges].mean(axis=1)]), faces, np.arange(len(points))


def write_off(path, points, faces):
    with path.open("w") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        np.savetxt(file, points, "%.17g")
        np.savetxt(file, np.insert(faces, 0, 3, axis=1), "%d")


def agreement(first, second):
    """The rank correlation of two lists of diameters, and their mean difference relative to the mean of both."""
    has_faces = (first > 0) & (second > 0)  # other vertices have no diameter
    first, second = first[has_faces], second[has_faces]
    ranks = [np.argsort(np.argsort(values)) for values in (first, second)]
    return np.corrcoef(*ranks)[0, 1], 2 * np.abs(first - second).sum() / (first + second).sum()


def diameters_table(lab, options, bodies):
    """Agreement of shape diameters by skeletons and by rays, their stability, and their cost."""
    methods = ("skeleton", "rays")
    rows, costs = collections.defaultdict(lambda: collections.defaultdict(list)), collections.defaultdict(list)

    def diameters(mesh, method):
        found = measure(lab, options, mesh, method)
        if not found:
            return None
        costs[method].append((found["vertices"], found["skeleton_seconds"], found["diameter_seconds"]))
        return np.array(found["diameters"])

    def compare(name, method, first, second):
        if first is not None and second is not None:
            rows[name][method].append(agreement(first, second))

    for files in bodies:
        points, faces = map(np.array, read_off(files[0]))
        first = {method: diameters(files[0], method) for method in methods}
        compare("by the other method", "skeleton", first["skeleton"], first["rays"])
        for name, change in (("noise of 1 % of the diagonal", noisy), ("ten holes", with_holes),
                             ("faces divided into four", divided)):
            changed = lab.folder / "changed.off"
            *shape, kept = change(points, faces, np.random.default_rng(1))
            write_off(changed, *shape)
            for method in methods:
                second = diameters(changed, method)
                if first[method] is not None and second is not None:
                    compare(name, method, first[method][kept], second[:len(kept)])
        vertices = [read_correspondence(file) for file in (files[0], files[2])]
        for method in methods:
            second = diameters(files[2], method)
            if first[method] is not None and second is not None:
                compare("another pose", method, first[method][vertices[0]], second[vertices[1]])
    cells = [[name] + [f"{value:.3f}" for method in methods
                       for value in np.mean(found[method] or [[math.nan] * 2], axis=0)]
             for name, found in rows.items()]
    seconds = {method: 1e5 * np.array(found)[:, 1:].sum(axis=0) / np.array(found)[:, 0].sum()
               for method, found in costs.items()}
    return (markdown(["the same vertices", "skeleton: rank correlation", "difference", "rays: rank correlation",
                      "difference"], cells)
            + "\n\nCPU seconds for 100 000 vertices: " + ", ".join(
                f"{method} {own:.2f} and {diameter:.2f} for its diameters"
                for method, (own, diameter) in seconds.items()) + ".")


def read_correspondence(mesh):
    """The vertices of a mesh, in the order of the common numbering of its body."""
    return np.loadtxt(mesh.parent.parent / f"vts/{mesh.stem}.vts", dtype=int) - 1


def poses_of(folder):
    """The meshes of each body that have a correspondence, in order."""
    bodies = collections.defaultdict(list)
    for mesh in folder.glob("off/*.off"):
        if (folder / f"vts/{mesh.stem}.vts").exists():
            name, number = re.fullmatch(r"(.*?)_?(\d+)", mesh.stem).groups()
            if name == "tr_reg":  # FAUST: ten poses of each body
                name = number[:-1]
            bodies[name].append((int(number), mesh))
    return [[mesh for _, mesh in sorted(meshes)] for _, meshes in sorted(bodies.items())]


# Constrictions.

def constrictions_table(lab, options):
    """The number of poses of all bodies that have the constrictions of the first pose, by the correspondence."""
    poses = [mesh for body in poses_of(options.faust) for mesh in body][::options.step]

    def loops_of(mesh):
        loops = json.loads(run(lab.cscd, "loops", mesh, "-o", "-", timeout=options.timeout)[0])
        return [loop for loop in loops if loop["kind"] == "constriction"]

    found = [loops_of(mesh) for mesh in poses]
    first_points = np.array(read_off(poses[0])[0])
    near = np.ptp(first_points[:, 1]) / 15  # of the height of the body
    to_first = read_correspondence(poses[0])
    middles = []
    for mesh, loops in zip(poses, found):
        points = np.array(read_off(mesh)[0])
        known, place = np.unique(read_correspondence(mesh), return_index=True)
        middles.append([])
        for loop in loops:
            distances = np.linalg.norm(points[known][:, None] - np.array(loop["points"]), axis=2)
            middles[-1].append(first_points[to_first[place[np.unique(distances.argmin(axis=0))]]].mean(axis=0))
    rows = [[" ".join(f"{x:.2f}" for x in middle), f"{loop['length']:.3f}", f"{loop['depth']:.2f}",
             str(sum(any(np.linalg.norm(middle - other) < near for other in others) for others in middles))]
            for loop, middle in zip(found[0], middles[0])]
    return (markdown(["middle of a constriction in the first pose", "length", "depth", f"found in {len(poses)} poses"],
                     rows)
            + f"\n\n{statistics.fmean(map(len, found)):.1f} constrictions a pose.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("princeton", type=pathlib.Path)
    parser.add_argument("tosca", type=pathlib.Path, nargs="?")
    parser.add_argument("faust", type=pathlib.Path, nargs="?")
    parser.add_argument("--tables", nargs="+", default=["segmentation", "diameters", "constrictions"])
    parser.add_argument("--methods", nargs="+", default=["skeleton", "diameter", "rays"], help="of segmentation")
    parser.add_argument("--parities", nargs="+", type=int, default=[0, 1], help="of numbers: 0 is even; 1 was tuned on")
    parser.add_argument("--timeout", type=float, default=60, help="seconds for each mesh and method")
    parser.add_argument("--step", type=int, default=1, help="take one in so many shapes, for a quick look")
    options = parser.parse_args()
    print(tables.circumstances("benchmark/reproduce/run.sh applications", options.build))
    with tempfile.TemporaryDirectory() as folder:
        lab = Laboratory(options.build / "bin", folder)
        if "segmentation" in options.tables:
            for method in options.methods:
                for parity in options.parities:
                    print("\n" + segmentation_table(lab, options, method, parity), flush=True)
        bodies = [files for folder in (options.tosca, options.faust) if folder for files in poses_of(folder)]
        if bodies and "diameters" in options.tables:
            print("\n" + diameters_table(lab, options, [files for files in bodies[::options.step] if len(files) > 2]))
        if options.faust and "constrictions" in options.tables:
            print("\n" + constrictions_table(lab, options))


if __name__ == "__main__":
    main()
