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


def cross():
    """Two bars of the width 1 along x and y, each of the length 8; their skeleton has four tips."""
    width, length = 6, 48  # voxels
    bar = np.zeros((length + 2, length + 2, width + 2), dtype=bool)  # empty at its borders
    bar[1:-1, (length - width) // 2 + 1 : (length + width) // 2 + 1, 1:-1] = True
    solid = bar | bar.swapaxes(0, 1)
    quads = []
    for axis, (u, v) in enumerate(((1, 2), (2, 0), (0, 1))):
        step, side_u, side_v = np.eye(3, dtype=int)[[axis, u, v]]
        around = np.array([0 * step, side_u, side_u + side_v, side_v])  # counterclockwise seen from the end of the axis
        above = np.argwhere(solid & ~np.roll(solid, -1, axis)) + step
        below = np.argwhere(solid & ~np.roll(solid, 1, axis))
        quads += [above[:, None] + around, below[:, None] + around[::-1]]
    corners, F = np.unique(np.concatenate(quads).reshape(-1, 3), axis=0, return_inverse=True)
    V = (corners - corners.mean(axis=0)) / width
    F = F.reshape(-1, 4)
    return V, np.concatenate([F[:, [0, 1, 2]], F[:, [0, 2, 3]]])
