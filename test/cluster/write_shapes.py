# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: write_shapes.py FOLDER NUMBER

Writes so many tori of different sizes; one file in a thousand is not a mesh."""

import pathlib
import sys

import numpy as np


def torus(around, across):
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * u / around, 2 * np.pi * v / across
    points = np.stack([(3 + np.cos(b)) * np.cos(a), (3 + np.cos(b)) * np.sin(a), np.sin(b)], axis=-1).reshape(-1, 3)

    def corner(i, j):
        return (u + i) % around * across + (v + j) % across

    quads = np.stack([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)], axis=-1).reshape(-1, 4)
    return points, quads


def write_off(path, points, quads):
    lines = [f"OFF\n{len(points)} {len(quads)} 0"]
    lines += [f"{x:.6g} {y:.6g} {z:.6g}" for x, y, z in points.tolist()]
    lines += [f"4 {a} {b} {c} {d}" for a, b, c, d in quads.tolist()]
    path.write_text("\n".join(lines) + "\n")


def main():
    folder, number = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    for i in range(number):
        path = folder / f"{i // 1000:02}" / f"{i % 1000:03}.off"
        path.parent.mkdir(parents=True, exist_ok=True)
        if i % 1000 == 500:
            path.write_text("OFF\nbroken\n")
        else:
            points, quads = torus(10 + i % 7, 4 + i % 3)
            write_off(path, points * (1 + i / number), quads)


if __name__ == "__main__":
    main()
