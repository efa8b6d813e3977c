# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: write_shapes.py FOLDER NUMBER

Writes so many tori of different sizes; one file in a thousand is not a mesh."""

import pathlib
import sys

from math import cos, pi, sin


def write_torus(path, around, across, scale):
    lines = [f"OFF\n{around * across} {around * across} 0"]
    for a, b in ((2 * pi * i / around, 2 * pi * j / across) for i in range(around) for j in range(across)):
        lines.append(" ".join(f"{scale * x:.6g}" for x in ((3 + cos(b)) * cos(a), (3 + cos(b)) * sin(a), sin(b))))
    for i, j in ((i, j) for i in range(around) for j in range(across)):
        lines.append("4 " + " ".join(str((i + di) % around * across + (j + dj) % across)
                                     for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))))
    path.write_text("\n".join(lines) + "\n")


folder, number = pathlib.Path(sys.argv[1]), int(sys.argv[2])
for n in range(number):
    file = folder / f"{n // 1000:02}" / f"{n % 1000:03}.off"
    file.parent.mkdir(parents=True, exist_ok=True)
    if n % 1000 == 500:
        file.write_text("OFF\nbroken\n")
    else:
        write_torus(file, 10 + n % 7, 4 + n % 3, 1 + n / number)
