#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""compare_programs.py MESHES REFERENCE PROGRAM: skeletonizes meshes of CGAL's data, in the folder MESHES, by two builds
of the program cscd. Fails unless the graphs are the same and the nodes are equal within TOLERANCE. PROGRAM
may be a command of several words, such as "wine64 cscd.exe"."""

import math
import pathlib
import shlex
import subprocess
import sys
import tempfile

TOLERANCE = 1e-9  # of the diagonal of the box of all nodes
# Animals, machine parts, sheets and knots of 300 to 10,000 vertices; with borders, handles and several components.
NAMES = """pig anchor rotor spool pinion cactus handle hand head elk bones knot1 mushroom elephant-with-holes elephant
triceratops cow femur dino camel""".split()


def skeletonize(program, mesh, folder, name):
    subprocess.run([*shlex.split(program), mesh, "-o", name, "--quiet", "--threads", "1"], cwd=folder, check=True)
    return (folder / name).read_bytes()


def parse(graph):
    lines = [line.split() for line in graph.decode("ascii").splitlines()]
    return [tuple(map(float, words[1:4])) for words in lines if words[0] == "n"], [w for w in lines if w[0] == "c"]


def main():
    meshes, reference, program = pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:]
    number_of_equal, largest = 0, 0.0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for mesh in NAMES:
            (folder / "mesh.off").write_bytes((meshes / f"{mesh}.off").read_bytes())
            expected = skeletonize(reference, "mesh.off", folder, "reference.graph")
            found = skeletonize(program, "mesh.off", folder, "found.graph")
            number_of_equal += expected == found
            (nodes, edges), (other_nodes, other_edges) = parse(expected), parse(found)
            if edges != other_edges or len(nodes) != len(other_nodes):
                sys.exit(f"{mesh}: {len(nodes)} nodes and {len(edges)} edges; {program}: {len(other_nodes)} and "
                         f"{len(other_edges)}, or other edges")
            diagonal = math.dist(*([limit(axis) for axis in zip(*nodes)] for limit in (min, max)))
            difference = max(map(math.dist, nodes, other_nodes)) / diagonal
            largest = max(largest, difference)
            if difference > TOLERANCE:
                sys.exit(f"{mesh}: a node of {program} is {difference:.2g} of the diagonal away")
    print(f"{len(NAMES)} meshes, {number_of_equal} with equal bytes, nodes within {largest:.2g} of the diagonal")


main()
