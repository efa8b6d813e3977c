# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes whose skeletons are known."""

import numpy as np


def torus_of_quads(around=60, across=24):
    """A torus of radii 3 and 1 around the z axis, its skeleton the circle of radius 3."""
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * u / around, 2 * np.pi * v / across
    V = np.stack([(3 + np.cos(b)) * np.cos(a), (3 + np.cos(b)) * np.sin(a), np.sin(b)], axis=-1).reshape(-1, 3)

    def corner(i, j):
        return (u + i) % around * across + (v + j) % across

    F = np.stack([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)], axis=-1).reshape(-1, 4)
    return V, F


def torus(around=60, across=24):
    """The same of triangles."""
    V, F = torus_of_quads(around, across)
    return V, np.concatenate([F[:, [0, 1, 2]], F[:, [0, 2, 3]]])


def cross(length=4.0):
    """Two bars of the width 1 along x and y, each of twice this length; their skeleton has four tips."""
    half = 0.5
    step = 1.0 / 6
    reach = int(round(length / step))
    inner = int(round(half / step))

    def is_solid(i, j):
        return -reach <= i < reach and -reach <= j < reach and (-inner <= i < inner or -inner <= j < inner)

    numbers = {}
    quads = []

    def vertex(i, j, k):
        return numbers.setdefault((i, j, k), len(numbers))

    def quad(*corners):
        quads.append([vertex(*corner) for corner in corners])

    for i in range(-reach, reach):
        for j in range(-reach, reach):
            if not is_solid(i, j):
                continue
            quad((i, j, inner), (i + 1, j, inner), (i + 1, j + 1, inner), (i, j + 1, inner))
            quad((i, j, -inner), (i, j + 1, -inner), (i + 1, j + 1, -inner), (i + 1, j, -inner))
            for k in range(-inner, inner):
                if not is_solid(i + 1, j):
                    quad((i + 1, j, k), (i + 1, j + 1, k), (i + 1, j + 1, k + 1), (i + 1, j, k + 1))
                if not is_solid(i - 1, j):
                    quad((i, j, k), (i, j, k + 1), (i, j + 1, k + 1), (i, j + 1, k))
                if not is_solid(i, j + 1):
                    quad((i, j + 1, k), (i, j + 1, k + 1), (i + 1, j + 1, k + 1), (i + 1, j + 1, k))
                if not is_solid(i, j - 1):
                    quad((i, j, k), (i + 1, j, k), (i + 1, j, k + 1), (i, j, k + 1))
    V = step * np.array(list(numbers), dtype=float)
    F = np.array(quads)
    return V, np.concatenate([F[:, [0, 1, 2]], F[:, [0, 2, 3]]])
