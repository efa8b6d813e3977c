#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Draws what the applications find on meshes, the pictures of doc/applications.md. Needs NumPy.
# Usage: make_application_pictures.py diameter|segment|loops OUT.png PROGRAM MESH.off...

import json
import os
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy as np

CELL = 200  # width and height of one shape, in pixels
COLUMNS = 5
SAMPLES = 3  # a pixel is the mean of so many squared
MARGIN = 0.92
MAX_POINTS_PER_FACE = 4000
LIGHT = np.array([0.3, 0.45, 0.85])  # to the right, up, towards the viewer
PART_COLORS = np.array([[230, 25, 75], [60, 180, 75], [255, 200, 25], [67, 99, 216], [245, 130, 49], [145, 30, 180],
                        [70, 220, 220], [240, 50, 230], [150, 200, 50], [250, 160, 190], [0, 128, 128], [200, 170, 255],
                        [154, 99, 36], [128, 0, 0], [120, 210, 160], [128, 128, 0], [255, 190, 150], [0, 0, 117],
                        [110, 110, 110], [40, 100, 40]], float)
LOOP_COLORS = {"handle": (220, 0, 0), "tunnel": (0, 60, 220), "constriction": (0, 130, 0)}
BLANK = np.array([205., 205., 205.])


def read_off(name):
    with open(name, encoding="ascii", errors="replace") as file:
        words = file.read().split()
    number, faces = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * number], float).reshape(-1, 3)
    return points, np.array(words[4 + 3 * number:4 + 3 * number + 4 * faces], int).reshape(-1, 4)[:, 1:]


def write_png(name, image):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width, _ = image.shape
    rows = b"".join(b"\0" + row.tobytes() for row in image)
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def draw(points, faces, colors, loops):
    """One shape, seen from the side where it is wider. `colors` of the faces; `loops`: points and color of each."""
    low, high = points.min(axis=0), points.max(axis=0)
    up = 1  # as most data sets have it
    across, deep = (0, 2) if (high - low)[0] >= (high - low)[2] else (2, 0)
    axes = np.eye(3)[[across, up, deep]]
    if np.linalg.det(axes) < 0:
        axes[2] = -axes[2]
    size = CELL * SAMPLES
    scale = size * MARGIN / max((high - low)[across], (high - low)[up])
    corners = ((points - (low + high) / 2) @ axes.T * scale)[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(normals, axis=1) / 2
    normals /= np.maximum(2 * areas, 1e-30)[:, None]
    # Random points on the faces, some for each pixel, are drawn from behind to the front.
    number = np.clip((3 * areas).astype(int), 1, MAX_POINTS_PER_FACE)
    face = np.repeat(np.arange(len(faces)), number)
    weights = np.random.default_rng(1).random((len(face), 2))
    weights = np.where(weights.sum(axis=1, keepdims=True) > 1, 1 - weights, weights)
    places = (corners[face, 0] + weights[:, :1] * (corners[face, 1] - corners[face, 0]) +
              weights[:, 1:] * (corners[face, 2] - corners[face, 0]))
    shade = 0.45 + 0.55 * np.clip(np.abs(normals @ (LIGHT / np.linalg.norm(LIGHT))), 0, 1)
    shown = [(places, colors[face] * shade[face, None])]
    for loop, color in loops:
        ends = ((np.array(loop) - (low + high) / 2) @ axes.T) * scale
        steps = np.linspace(0, 1, 40)[:, None, None]
        line = (ends * (1 - steps) + np.roll(ends, -1, axis=0) * steps).reshape(-1, 3)
        disc = [(x, y, size / 60) for x in range(-4, 5) for y in range(-4, 5) if x * x + y * y < 18]
        line = (line[:, None, :] + np.array(disc)[None]).reshape(-1, 3)
        shown.append((line, np.tile(np.array(color, float), (len(line), 1))))
    places, values = (np.concatenate(part) for part in zip(*shown))
    image = np.full((size, size, 3), 255.)
    order = np.argsort(places[:, 2], kind="stable")
    x = np.clip((size / 2 + places[order, 0]).astype(int), 0, size - 1)
    y = np.clip((size / 2 - places[order, 1]).astype(int), 0, size - 1)
    image[y, x] = values[order]
    return image.reshape(CELL, SAMPLES, CELL, SAMPLES, 3).mean(axis=(1, 3))


def run(program, *arguments):
    """What a command of the program writes into a file."""
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "result.json" if arguments[0] == "loops" else "result.txt")
        subprocess.run([program, *arguments, "-q", "-o", name], check=True)
        with open(name, encoding="ascii") as file:
            return file.read()


def diameter_colors(values, faces):
    """Blue where the body is thinnest, then green, yellow, and red where it is thickest."""
    values = np.log(np.maximum(values, 1e-9 * values.max()))
    low, high = np.quantile(values, [0.02, 0.98])
    place = np.clip((values[faces].mean(axis=1) - low) / max(high - low, 1e-9), 0, 1)
    stops = np.array([[60, 80, 220], [60, 200, 200], [110, 200, 60], [250, 210, 40], [220, 40, 30]], float)
    return np.stack([np.interp(place, np.linspace(0, 1, len(stops)), stops[:, k]) for k in range(3)], axis=1)


def picture(task, program, mesh):
    points, faces = read_off(mesh)
    if task == "diameter":
        return draw(points, faces, diameter_colors(np.array(run(program, task, mesh).split(), float), faces), [])
    blank = np.tile(BLANK, (len(faces), 1))
    if task == "loops":
        loops = json.loads(run(program, task, mesh))
        return draw(points, faces, blank, [(loop["points"], LOOP_COLORS[loop["kind"]]) for loop in loops])
    labels = np.array(run(program, "segment", mesh).split(), int)
    return draw(points, faces, PART_COLORS[labels % len(PART_COLORS)], [])


def main():
    task, output, program, *meshes = sys.argv[1:]
    cells = [picture(task, program, mesh) for mesh in meshes]
    cells += [np.full((CELL, CELL, 3), 255.)] * (-len(cells) % COLUMNS)
    rows = [np.concatenate(cells[i:i + COLUMNS], axis=1) for i in range(0, len(cells), COLUMNS)]
    # Few shades compress better, and look the same.
    write_png(output, (np.concatenate(rows) // 8 * 8 + 7).clip(0, 255).astype(np.uint8))


if __name__ == "__main__":
    main()
