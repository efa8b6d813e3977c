# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Compares skeletons with truths that others have made, and prints the tables. Nothing is fetched.

Usage: truths.py BUILD connectomics VOLUME | rigs FOLDER | vessels FOLDER
VOLUME is benchmarks/connectomics.npy.ckl.gz of seung-lab/kimimaro, decoded to NRRD. Of the folders, all files are read:
.glb of public/glb in trebeljahr/quaternius-showcase, skinned models; .xml of OpenCCO-team/OpenCCO, trees of vessels.
"""

import collections
import json
import pathlib
import statistics
import sys
import tempfile
import xml.etree.ElementTree

import numpy as np
from scipy.spatial import cKDTree

import tables
from programs import Failure, Laboratory, run
from tables import count, markdown
from volumes import Tube, write_nrrd


def samples(points, edges, spacing):
    """Points along edges, both ends among them."""
    parts = [np.atleast_2d(points)]
    for a, b in edges:
        number = max(2, int(np.linalg.norm(points[a] - points[b]) / spacing) + 1)
        parts.append(points[a] + np.linspace(0, 1, number)[:, None] * (points[b] - points[a]))
    return np.concatenate(parts)


def distances(points, others):
    return cKDTree(others).query(points)[0]


# Rigs.

COMPONENTS = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Model:
    """The arrays of a binary glTF file."""

    def __init__(self, path):
        data = path.read_bytes()
        length = int.from_bytes(data[12:16], "little")
        self.json, self.binary = json.loads(data[20:20 + length]), data[28 + length:]
        self.parents = {child: i for i, node in enumerate(self.json["nodes"]) for child in node.get("children", [])}

    def array(self, accessor):
        accessor = self.json["accessors"][accessor]
        view = self.json["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype(COMPONENTS[accessor["componentType"]]), WIDTHS[accessor["type"]]
        values = np.ndarray((accessor["count"], width), kind, self.binary,
                            view.get("byteOffset", 0) + accessor.get("byteOffset", 0),
                            (view.get("byteStride", kind.itemsize * width), kind.itemsize)).astype(float)
        return values / np.iinfo(kind).max if accessor.get("normalized") else values

    def primitives(self):
        """The nodes with a skin, and each primitive of their meshes."""
        return [(node, primitive) for node in self.json["nodes"] if "mesh" in node and "skin" in node
                for primitive in self.json["meshes"][node["mesh"]]["primitives"]]

    def points(self):
        return np.concatenate([self.array(primitive["attributes"]["POSITION"]) for _, primitive in self.primitives()])

    def matrix(self, node):
        """From the coordinates of a node to those of the scene."""
        its, own = self.json["nodes"][node], np.eye(4)
        *axis, cosine = its.get("rotation", (0, 0, 0, 1))
        turn = np.cross(axis, np.eye(3)).T
        own[:3, :3] = (np.eye(3) + 2 * cosine * turn + 2 * turn @ turn) * its.get("scale", (1, 1, 1))
        own[:3, 3] = its.get("translation", (0, 0, 0))
        own = np.array(its["matrix"], float).reshape(4, 4).T if "matrix" in its else own
        return self.matrix(self.parents[node]) @ own if node in self.parents else own

    def joints(self, least_weight):
        """The places of joints that move a vertex by at least this weight, and the pairs of a parent and a joint."""
        weights = collections.defaultdict(float)
        for node, primitive in self.primitives():
            joints, attributes = self.json["skins"][node["skin"]]["joints"], primitive["attributes"]
            numbers = self.array(attributes["JOINTS_0"]).astype(int).ravel()
            for number, weight in zip(numbers, self.array(attributes["WEIGHTS_0"]).ravel()):
                weights[joints[number]] = max(weights[joints[number]], weight)
        places = {joint: self.matrix(joint)[:3, 3] for skin in self.json["skins"] for joint in skin["joints"]
                  if weights[joint] >= least_weight}
        bones = []
        for joint in places:
            parent = self.parents.get(joint)
            while parent is not None and parent not in places:
                parent = self.parents.get(parent)
            if parent is not None:
                bones.append((list(places).index(parent), list(places).index(joint)))
        return np.array(list(places.values())), bones


def rig_errors(first, second, size):
    """Joints to joints, joints to bones, bones to bones: means of both ways, relative to the size."""
    bones = [samples(*rig, 0.01 * size) for rig in (first, second)]

    def mean(*pairs):
        return statistics.fmean(distances(*pair).mean() for pair in pairs) / size

    return (mean((first[0], second[0]), (second[0], first[0])), mean((first[0], bones[1]), (second[0], bones[0])),
            mean(bones, bones[::-1]))


def rigs(lab, folder):
    """Our joints next to those of artists. Constants were chosen on odd-numbered models."""
    rows, number = {1: [], 0: []}, 0
    for path in sorted(pathlib.Path(folder).rglob("*.glb")):
        model, ours = Model(path), lab.folder / "rig.glb"
        if not model.json.get("skins") or "extensionsRequired" in model.json:
            continue
        truth = model.joints(0.05)
        try:
            run(lab.cscd, path, "-o", ours, "--quiet")
        except Failure as failure:
            print(f"{path}: {failure}", file=sys.stderr)
            continue
        found = Model(ours)
        low, high = found.points().min(axis=0), found.points().max(axis=0)
        size = (high - low).max()
        apart = np.linalg.norm(np.maximum(low - truth[0], 0) + np.maximum(truth[0] - high, 0), axis=1) > 0.05 * size
        if len(truth[0]) < 2 or apart.mean() > 0.5:
            print(f"{path}: its joints are not in the body", file=sys.stderr)
            continue
        number += 1
        own = found.joints(0)
        rows[number % 2].append([*rig_errors(truth, own, size), len(truth[0]), len(own[0])])
    table = [[f"{name} models, {len(of)}", *(f"{mean:.3f}" for mean in np.mean(of, axis=0)[:3]),
              *(count(mean) for mean in np.mean(of, axis=0)[3:])] for name, of in (("odd", rows[1]), ("even", rows[0]))]
    print(markdown(["", "joints to joints", "joints to bones", "bones to bones", "joints of artists", "ours"], table))


# Vessels.

MIN_RADIUS = 0.25  # of vessels that are left, in the unit of the trees
SIZES = (400, 600)  # voxels along each side of the volumes


def read_tree(path):
    """Points, edges and their radii of the vessels that are at least so thick."""
    graph = xml.etree.ElementTree.parse(path).getroot().find("graph")
    number = {node.get("id"): i for i, node in enumerate(graph.iter("node"))}
    points = np.array([[float(value.text) for value in node.iter("float")] for node in graph.iter("node")])
    edges, radii = [], []
    for edge in graph.iter("edge"):
        radius = next(float(value.find("float").text) for value in edge.iter("attr")
                      if value.get("name").strip() == "radius")
        if radius >= MIN_RADIUS:
            edges.append((number[edge.get("from")], number[edge.get("to")]))
            radii.append(radius)
    return points, np.array(edges), np.array(radii)


def vessels(lab, folder):
    """Skeletons of trees of vessels next to the trees. The body is the union of balls along the vessels, as voxels."""
    rows = []
    for path, size in ((path, size) for path in sorted(pathlib.Path(folder).rglob("*tree_3D.xml")) for size in SIZES):
        points, edges, radii = read_tree(path)
        low, unit = points.min(axis=0) - 2 * radii.max(), np.ptp(points, axis=0).max() + 4 * radii.max()
        volume, ours = lab.folder / "vessels.nrrd", lab.folder / "vessels.json"
        write_nrrd(volume, Tube([(*(points[edge] - low) / unit, radius / unit)
                                 for edge, radius in zip(edges, radii)]).fill(size))
        _, cost = lab.skeletonize(volume, skeleton=ours)
        skeleton = json.loads(ours.read_text())
        nodes = low + unit * (np.array([node["point"] for node in skeleton["nodes"]]) + 0.5) / size
        node_radii = unit / size * np.array([node["radius"] for node in skeleton["nodes"]])
        degree = np.bincount(np.ravel(skeleton["edges"]).astype(int), minlength=len(nodes))
        true_degree = np.bincount(edges.ravel(), minlength=len(points))
        thickest = np.zeros(len(points))
        np.maximum.at(thickest, edges.ravel(), np.repeat(radii, 2))
        ends, forks = np.flatnonzero(true_degree == 1), np.flatnonzero(true_degree > 2)
        tips = nodes[degree == 1]
        to_end, end = cKDTree(points[ends]).query(tips)
        # Where vessels are not within a thicker one: in their middle.
        middles = np.array([points[edge].mean(axis=0) for edge in edges])
        to_skeleton = distances(middles, samples(nodes, skeleton["edges"], unit / size)) / radii
        between, vessel = cKDTree(middles).query(nodes)
        is_middle = (degree == 2) & (between < radii[vessel] / 2)
        rows.append([f"{path.parent.name}, {size}³", f"{radii.min() * size / unit:.1f}", count(len(ends)),
                     f"{(distances(points[ends], tips) < 2 * thickest[ends]).mean():.3f}",
                     f"{(to_end < 2 * thickest[ends][end]).mean():.3f}",
                     f"{(distances(points[forks], nodes[degree > 2]) < thickest[forks]).mean():.3f}",
                     f"{np.mean(to_skeleton):.2f}",
                     f"{100 * np.mean(np.abs(node_radii / radii[vessel] - 1)[is_middle]):.1f}", f"{cost.cpu:.1f}"])
    print(markdown(["tree", "least radius, voxels", "ends", "recall of ends", "precision", "forks within a radius",
                    "middles of vessels to skeleton, radii", "error of radii, %", "CPU s"], rows))


# A volume.

def connectomics(lab, volume):
    """All labels of a volume, one file each."""
    report = lab.folder / "report.json"
    _, cost = run(lab.cscd, "skeletonize", volume, "--all-labels", "-o", lab.folder / "label.swc", "--report", report,
                  "--quiet", "--threads", "1", timeout=7200)
    bodies = [json.loads(path.read_text()) for path in lab.folder.glob("report_*.json")]
    nodes, outside = (sum(body[key] for body in bodies) for key in ("number_of_nodes", "number_of_nodes_outside"))
    right = sum(body["betti_number"] == body["genus"] for body in bodies)
    print(markdown(["labels", "as many cycles as handles", "nodes", "nodes outside", "CPU s", "MB"],
                   [[count(len(bodies)), count(right), count(nodes), count(outside), f"{cost.cpu:.0f}",
                     count(cost.megabytes)]]))


def main():
    if len(sys.argv) != 4 or sys.argv[2] not in ("connectomics", "rigs", "vessels"):
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        print(tables.circumstances(f"benchmark/reproduce/run.sh {sys.argv[2]} PATH", build), end="\n\n")
        {"connectomics": connectomics, "rigs": rigs, "vessels": vessels}[sys.argv[2]](
            Laboratory(build / "bin", folder), sys.argv[3])


if __name__ == "__main__":
    main()
