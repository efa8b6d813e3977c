# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Draws curves with gnuplot."""

import subprocess


def draw(path, x_label, y_label, curves, logarithmic=False):
    """Writes a picture of `curves`, lists of points (x, y) by name, to `path`, a PNG file."""
    script = ["set terminal pngcairo noenhanced size 800,480", f"set output '{path}'", f"set xlabel '{x_label}'",
              f"set ylabel '{y_label}'", "set key outside right", "set grid", "set yrange [0:*]"]
    if logarithmic:
        script.append("set logscale x 2")
    for number, points in enumerate(curves.values()):
        script += [f"$curve{number} << end", *(f"{x} {y}" for x, y in points), "end"]
    script.append("plot " + ", ".join(f"$curve{number} with linespoints title '{name}'"
                                      for number, name in enumerate(curves)))
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
