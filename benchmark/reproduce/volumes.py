# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletons of volumes: Betti numbers of generated shapes at three resolutions, next to the thinning of scikit-image
where it is installed.

Usage: volumes.py BUILD FOLDER, which gets the volumes
"""

import math
import pathlib
import statistics
import sys
import time

import numpy as np

from programs import Laboratory
from tables import markdown

RESOLUTIONS = (48, 96, 160)  # voxels along each side
RNG_SEED = 7


def write_nrrd(filename, labels):
    """Writes an array indexed by z, y, x."""
    header = (f"NRRD0004\ntype: {labels.dtype.name}\ndimension: 3\nspace dimension: 3\n"
              f"sizes: {' '.join(map(str, labels.shape[::-1]))}\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
              "space origin: (0,0,0)\nendian: little\nencoding: raw\n\n")
    pathlib.Path(filename).write_bytes(header.encode() + labels.tobytes())


class Tube:
    """The union of balls along polylines, in the unit cube; exact, as each voxel is compared with each segment."""

    def __init__(self, segments):
        self.segments = segments  # (a, b, radius)

    def fill(self, size):
        grid = (np.arange(size) + 0.5) / size
        image = np.zeros((size, size, size), np.uint8)
        for a, b, radius in self.segments:
            low = np.maximum(np.floor((np.minimum(a, b) - radius) * size).astype(int) - 1, 0)
            high = np.minimum(np.ceil((np.maximum(a, b) + radius) * size).astype(int) + 1, size)
            x, y, z = (grid[low[i] : high[i]] for i in range(3))
            p = np.stack(np.meshgrid(x, y, z, indexing="ij"), -1) - a
            t = np.clip(p @ (b - a) / max(float((b - a) @ (b - a)), 1e-12), 0, 1)
            inside = ((p - t[..., None] * (b - a)) ** 2).sum(-1) <= radius**2
            part = image[low[2] : high[2], low[1] : high[1], low[0] : high[0]]
            part |= inside.transpose(2, 1, 0).astype(np.uint8)
        return image


def curve(function, radius, count=120):
    points = [np.array(function(2 * math.pi * i / count)) for i in range(count)]
    return [(points[i], points[(i + 1) % count], radius) for i in range(count)]


def ring(center, radius, axis, tube):
    u, v = [np.eye(3)[i] for i in range(3) if i != axis]
    return curve(lambda t: center + radius * (math.cos(t) * u + math.sin(t) * v), tube)


def chain_of_tori(genus):
    step = 0.19
    first = 0.5 - step * (genus - 1) / 2
    return [s for i in range(genus) for s in ring(np.array([first + step * i, 0.5, 0.5]), 0.1, 2, 0.035)]


def trefoil(t):
    return (
        0.5 + 0.12 * (math.sin(t) + 2 * math.sin(2 * t)),
        0.5 + 0.12 * (math.cos(t) - 2 * math.cos(2 * t)),
        0.5 - 0.17 * math.sin(3 * t),
    )


def vessel_tree(depth, rng):
    """Segments of a tree whose radii follow Murray's law."""
    segments = []

    def grow(start, direction, length, radius, level):
        end = start + length * direction
        segments.append((start, end, radius))
        if level == depth:
            return
        side = np.cross(direction, rng.normal(size=3))
        side /= np.linalg.norm(side)
        for sign in (1, -1):
            angle = 0.62
            grow(end, math.cos(angle) * direction + sign * math.sin(angle) * side, length * 0.78,
                 radius * 2 ** (-1 / 3), level + 1)

    grow(np.array([0.5, 0.5, 0.08]), np.array([0.0, 0.0, 1.0]), 0.24, 0.045, 1)
    return segments


def shapes():
    """By kind, the shapes: segments, components and handles."""
    half = np.array([0.5, 0.5, 0.5])
    rng = np.random.default_rng(RNG_SEED)
    rings = ring(half - [0.1, 0, 0], 0.22, 2, 0.05) + ring(half + [0.1, 0, 0], 0.22, 1, 0.05)
    corners = [np.array([x, y, z]) for x in (0.2, 0.8) for y in (0.2, 0.8) for z in (0.2, 0.8)]
    edges = [(a, b, 0.05) for i, a in enumerate(corners) for b in corners[:i] if np.isclose(np.abs(a - b).sum(), 0.6)]
    return {"ball": [([(half, half, 0.3)], 1, 0)],
            "chains of 1 to 4 tori": [(chain_of_tori(genus), 1, genus) for genus in (1, 2, 3, 4)],
            "two linked rings": [(rings, 2, 2)],
            "trefoil knot": [(curve(trefoil, 0.05, 240), 1, 1)],
            "edges of a cube": [(edges, 1, 5)],
            "two trees of vessels": [(vessel_tree(depth, rng), 1, 0) for depth in (3, 4)]}


def euler_number(image):
    """The Euler number of the union of the voxels: vertices less edges plus faces less voxels."""
    padded = np.pad(image.astype(bool), 1)
    total = 0
    for dims in np.ndindex(2, 2, 2):  # along which axes the cells extend
        cells = padded
        for axis, extends in enumerate(dims):
            if not extends:
                cells = cells | np.roll(cells, 1, axis)  # the last layer is empty
        total += (-1) ** sum(dims) * int(cells.sum())
    return total


def thin(image):
    """Time, components and handles of the thinning of scikit-image, as those of its voxels."""
    try:
        from scipy import ndimage
        from skimage import morphology
    except ImportError:
        return None
    thinning = getattr(morphology, "skeletonize_3d", morphology.skeletonize)  # newer versions have one for both
    start = time.monotonic()
    thinned = thinning(image) > 0
    seconds = time.monotonic() - start
    components = ndimage.label(thinned, np.ones((3, 3, 3)))[1]
    return seconds, components, components - euler_number(thinned)


def measure_shapes(lab, folder):
    rows, right, thinned_right, total = [], 0, 0, 0
    for kind, bodies in shapes().items():
        seconds, thin_seconds = ({size: [] for size in RESOLUTIONS} for _ in range(2))
        of_kind = thinned_of_kind = 0
        for number, (segments, components, handles) in enumerate(bodies):
            for size in RESOLUTIONS:
                image = Tube(segments).fill(size)
                volume = folder / f"{kind}_{number}_{size}.nrrd"
                write_nrrd(volume, image)
                report, cost = lab.skeletonize(volume)
                seconds[size].append(cost.wall)
                found = (report["number_of_skeleton_components"], report["betti_number"])
                # The topology of the voxels may differ from that of the shape where it is thinner than a voxel.
                of_kind += found == (components, handles) and found[0] - found[1] == euler_number(image)
                thinned = thin(image)
                if thinned:
                    thin_seconds[size].append(thinned[0])
                    thinned_of_kind += thinned[1:] == (components, handles)
        number = len(bodies) * len(RESOLUTIONS)
        right, thinned_right, total = right + of_kind, thinned_right + thinned_of_kind, total + number
        means = [[f"{statistics.fmean(times):.2f}" if times else "" for times in kept.values()]
                 for kept in (seconds, thin_seconds)]
        rows.append([kind, f"{of_kind} of {number}", *means[0],
                     f"{thinned_of_kind} of {number}" if any(means[1]) else "", *means[1]])
    rows.append(["**all**", f"**{right} of {total}**", "", "", "", f"{thinned_right} of {total}", "", "", ""])
    sizes = [f"{'s at ' if size == RESOLUTIONS[0] else ''}{size}³" for size in RESOLUTIONS]
    print(markdown(["shapes at " + ", ".join(f"{size}³" for size in RESOLUTIONS), "components and handles right",
                    *sizes, "thinning right", *sizes], rows))


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    measure_shapes(Laboratory(pathlib.Path(sys.argv[1]) / "bin", folder), folder)


if __name__ == "__main__":
    main()
