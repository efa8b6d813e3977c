#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Draws the skeletons that two builds of the program make of the same meshes side by side, in one picture.
# Usage: make_gallery.py OUT.svg PROGRAM_BEFORE PROGRAM_AFTER MESH.off...

import os
import random
import subprocess
import sys
import tempfile

CELL = 210  # width and height of one skeleton, in pixels
PAIRS_IN_A_ROW = 4
MAX_POINTS = 6000  # drawn of each mesh
MARGIN = 0.92


def read_off_points(name):
    with open(name, encoding="ascii", errors="replace") as file:
        words = file.read().split()
    number = int(words[1])
    return [tuple(map(float, words[4 + 3 * i : 7 + 3 * i])) for i in range(number)]


def skeleton(program, mesh):
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "skeleton.graph")
        subprocess.run([program, "skeletonize", mesh, "-q", "-o", name], check=True)
        with open(name, encoding="ascii") as file:
            lines = [line.split() for line in file]
    nodes = [tuple(map(float, words[1:4])) for words in lines if words[0] == "n"]
    edges = [(int(words[1]), int(words[2])) for words in lines if words[0] == "c"]
    return nodes, edges


def draw(svg, left, top, points, nodes, edges):
    low = [min(p[k] for p in points) for k in range(3)]
    high = [max(p[k] for p in points) for k in range(3)]
    across, up = sorted(range(3), key=lambda k: low[k] - high[k])[:2]
    scale = CELL * MARGIN / max(high[across] - low[across], high[up] - low[up])

    def place(p):
        return (left + CELL / 2 + scale * (p[across] - (low[across] + high[across]) / 2),
                top + CELL / 2 - scale * (p[up] - (low[up] + high[up]) / 2))

    dots = random.Random(1).sample(points, min(len(points), MAX_POINTS))
    path = "".join("M{:.1f} {:.1f}h.9".format(*place(p)) for p in dots)
    svg.append(f'<path d="{path}" stroke="#ccc" fill="none"/>')
    path = "".join("M{:.1f} {:.1f}L{:.1f} {:.1f}".format(*place(nodes[a]), *place(nodes[b])) for a, b in edges)
    svg.append(f'<path d="{path}" stroke="#00c" stroke-width="1.4" fill="none"/>')
    degree = [0] * len(nodes)
    for edge in edges:
        for node in edge:
            degree[node] += 1
    for node, number in enumerate(degree):
        if number != 2:
            x, y = place(nodes[node])
            svg.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" fill="{"#d00" if number < 2 else "#080"}"/>')


def main():
    output, before, after, *meshes = sys.argv[1:]
    rows = (len(meshes) + PAIRS_IN_A_ROW - 1) // PAIRS_IN_A_ROW
    width, height = 2 * CELL * PAIRS_IN_A_ROW, CELL * rows
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}">'
           '<rect width="100%" height="100%" fill="white"/>']
    for i, mesh in enumerate(meshes):
        left, top = 2 * CELL * (i % PAIRS_IN_A_ROW), CELL * (i // PAIRS_IN_A_ROW)
        points = read_off_points(mesh)
        for k, program in enumerate((before, after)):
            draw(svg, left + k * CELL, top, points, *skeleton(program, mesh))
        svg.append(f'<rect x="{left + 1}" y="{top + 1}" width="{2 * CELL - 2}" height="{CELL - 2}" fill="none" '
                   'stroke="#888"/>')
        name = os.path.splitext(os.path.basename(mesh))[0]
        svg.append(f'<text x="{left + 6}" y="{top + 15}" font-size="12" font-family="sans-serif">{name}</text>')
    svg.append("</svg>")
    with open(output, "w", encoding="utf-8") as file:
        file.write("\n".join(svg))


main()
