# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletons of volumes: Betti numbers of generated shapes at three resolutions, center lines and radii of a generated
vessel tree, time and memory of a volume with many labels, beside the thinning of scikit-image where it is installed.

Usage: volumes.py PROGRAM FOLDER [SIZE_OF_LABELS]
"""

import json
import math
import os
import subprocess
import sys
import time

import numpy as np

RESOLUTIONS = (48, 96, 160)  # voxels along each side
RNG_SEED = 7


def write_nrrd(filename, labels, spacing=(1.0, 1.0, 1.0), origin=(0.0, 0.0, 0.0)):
    """Writes an array indexed by z, y, x."""
    names = {np.dtype(np.uint8): "uint8", np.dtype(np.uint16): "uint16"}
    directions = " ".join(f"({','.join(str(spacing[i] if i == j else 0) for j in range(3))})" for i in range(3))
    header = (
        f"NRRD0004\ntype: {names[labels.dtype]}\ndimension: 3\nspace dimension: 3\n"
        f"sizes: {' '.join(str(n) for n in labels.shape[::-1])}\nspace directions: {directions}\n"
        f"space origin: ({','.join(str(x) for x in origin)})\nendian: little\nencoding: raw\n\n"
    )
    with open(filename, "wb") as out:
        out.write(header.encode())
        out.write(labels.tobytes())


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
    """Segments of a tree whose radii follow Murray's law, and the points where it forks or ends."""
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
    """Names, segments, components and handles."""
    half = np.array([0.5, 0.5, 0.5])
    rng = np.random.default_rng(RNG_SEED)
    ball = [(half, half, 0.3)]
    result = [("ball", ball, 1, 0)]
    result += [(f"genus{g}", chain_of_tori(g), 1, g) for g in (1, 2, 3, 4)]
    result.append(("linked", ring(half - [0.1, 0, 0], 0.22, 2, 0.05) + ring(half + [0.1, 0, 0], 0.22, 1, 0.05), 2, 2))
    result.append(("trefoil", curve(trefoil, 0.05, 240), 1, 1))
    corners = [np.array([x, y, z]) for x in (0.2, 0.8) for y in (0.2, 0.8) for z in (0.2, 0.8)]
    edges = [(a, b, 0.05) for i, a in enumerate(corners) for b in corners[:i] if np.isclose(np.abs(a - b).sum(), 0.6)]
    result.append(("cube_frame", edges, 1, 5))
    result.append(("vessels3", vessel_tree(3, rng), 1, 0))
    result.append(("vessels4", vessel_tree(4, rng), 1, 0))
    return result


def euler_number(image):
    """The Euler number of the union of the voxels: vertices less edges plus faces less voxels."""
    padded = np.pad(image.astype(bool), 1)
    total = 0
    for dims in np.ndindex(2, 2, 2):  # along which axes the cells extend
        cells = padded
        for axis, extends in enumerate(dims):
            if not extends:
                lower = [slice(None)] * 3
                upper = [slice(None)] * 3
                lower[axis], upper[axis] = slice(0, -1), slice(1, None)
                cells = cells[tuple(lower)] | cells[tuple(upper)]
        total += (-1) ** sum(dims) * int(cells.sum())
    return total


def run(program, arguments):
    """Runs the program. Returns seconds, seconds of CPU, and the greatest memory in MB."""
    start = time.monotonic()
    process = subprocess.Popen([program, "skeletonize", *arguments, "-q"])
    memory = 0
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid != 0:
            break
        # wait4() reports at least the memory of this script.
        with open(f"/proc/{process.pid}/status", encoding="ascii") as file:
            peaks = [int(line.split()[1]) for line in file if line.startswith("VmHWM")]
        memory = max([memory, *peaks])
        time.sleep(0.01)
    if status != 0:
        raise RuntimeError(f"failed: {arguments}")
    return time.monotonic() - start, usage.ru_utime + usage.ru_stime, memory / 1024


def thin(image):
    """Time, components and handles of the thinning of scikit-image, as those of its voxels."""
    try:
        from scipy import ndimage
        from skimage.morphology import skeletonize, skeletonize_3d
    except ImportError:
        return None
    start = time.monotonic()
    try:
        thinned = skeletonize_3d(image) > 0
    except Exception:  # newer versions have one function for both
        thinned = skeletonize(image) > 0
    seconds = time.monotonic() - start
    components = ndimage.label(thinned, np.ones((3, 3, 3)))[1]
    return seconds, components, components - euler_number(thinned)


def distances_to_segments(points, segments):
    """The distance of each point to the nearest segment, and the radius of that."""
    best = np.full(len(points), np.inf)
    radius = np.zeros(len(points))
    for a, b, r in segments:
        t = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        distance = np.linalg.norm(points - a - t[:, None] * (b - a), axis=1)
        nearer = distance < best
        best[nearer], radius[nearer] = distance[nearer], r
    return best, radius


def measure_shapes(program, folder):
    print("| shape | size | components, handles | right | s | thinning s | thinning right |")
    print("|---|---|---|---|---|---|---|")
    right = thinned_right = 0
    for name, segments, components, handles in shapes():
        for size in RESOLUTIONS:
            image = Tube(segments).fill(size)
            volume = os.path.join(folder, f"{name}_{size}.nrrd")
            report_file = os.path.join(folder, f"{name}_{size}.json")
            write_nrrd(volume, image)
            seconds, _, _ = run(program, [volume, "--report", report_file, "-o", volume.replace(".nrrd", ".swc"),
                                       "-o", volume.replace(".nrrd", ".graph"), "--threads", "1"])
            with open(report_file, encoding="utf-8") as file:
                report = json.load(file)
            found = (report["number_of_skeleton_components"], report["betti_number"])
            # The topology of the voxels may differ from that of the shape where it is thinner than a voxel.
            euler = euler_number(image)
            is_right = found == (components, handles) and found[0] - found[1] == euler
            right += is_right
            thinned = thin(image)
            thinned_right += bool(thinned and thinned[1:] == (components, handles))
            print(f"| {name} | {size} | {found[0]}, {found[1]} | {'yes' if is_right else 'no'} | {seconds:.2f} | "
                  + (f"{thinned[0]:.2f} | {'yes' if thinned[1:] == (components, handles) else 'no'} |" if thinned else "| |"))
    print(f"\nright: {right} of {len(shapes()) * len(RESOLUTIONS)}; thinning: {thinned_right}\n")


def read_nodes(filename):
    rows = [line.split() for line in open(filename, encoding="utf-8") if line.strip() and not line.startswith("#")]
    table = np.array(rows, float)
    return table[:, 2:5], table[:, 5], table[:, 6].astype(int)


def measure_vessels(program, folder):
    print("| vessel tree | size | offset, mean | offset, 95 % | radius error, mean | radius error, 95 % |")
    print("|---|---|---|---|---|---|")
    for name, segments, _, _ in shapes():
        if not name.startswith("vessels"):
            continue
        for size in RESOLUTIONS:
            points, radii, parents = read_nodes(os.path.join(folder, f"{name}_{size}.swc"))
            degree = np.bincount(parents[parents > 0] - 1, minlength=len(points)) + (parents > 0)
            places = (points + 0.5) / size
            # Within 1.5 radii of forks and tips, center and radius differ from those of a segment.
            ends = np.array([end for a, b, r in segments for end in (a, b)])
            to_end = np.linalg.norm(places[:, None] - ends, axis=2) / np.repeat([r for _, _, r in segments], 2)
            in_limb = (degree == 2) & (to_end.min(axis=1) > 1.5)
            offset, radius = distances_to_segments(places[in_limb], segments)
            error = np.abs(radii[in_limb] - radius * size)
            print(f"| {name} | {size} | {offset.mean() * size:.2f} | {np.quantile(offset, 0.95) * size:.2f} | "
                  f"{error.mean():.2f} | {np.quantile(error, 0.95):.2f} |")
    print()


def lattice_of_vessels(size, rng):
    """A hundred trees of vessels in the cells of a lattice, which overlap: the first label that comes stays."""
    image = np.zeros((size, size, size), np.uint16)
    cell = size // 4
    for label in range(1, 101):
        place = np.array([(label - 1) % 5 / 5, (label - 1) // 5 % 5 / 5, (label - 1) // 25 / 4])
        part = Tube([(a, b, 1.6 * r) for a, b, r in vessel_tree(3, rng)]).fill(cell)
        x, y, z = (place * size).astype(int)
        target = image[z : z + cell, y : y + cell, x : x + cell]
        source = part[: target.shape[0], : target.shape[1], : target.shape[2]]
        target[(source > 0) & (target == 0)] = label
    return image


def ellipsoids(size, rng):
    """A hundred ellipsoids at random places."""
    image = np.zeros((size, size, size), np.uint16)
    reach = int(0.088 * size)
    for label in range(1, 101):
        center = rng.uniform(reach, size - reach, 3)
        axes = rng.uniform(0.04, 0.082, 3) * size
        low = (center - reach).astype(int)
        indices = np.meshgrid(*(np.arange(i, i + 2 * reach) for i in low), indexing="ij")
        inside = sum(((indices[i] - center[i]) / axes[i]) ** 2 for i in range(3)) < 1
        target = image[tuple(slice(i, i + 2 * reach) for i in low)]
        target[inside & (target == 0)] = label
    return image


def measure_labels(program, folder, size):
    print("| a hundred labels | voxels in bodies | s | CPU s | MB |")
    print("|---|---|---|---|---|")
    volume = os.path.join(folder, "labels.nrrd")
    for name, make in (("trees of vessels", lattice_of_vessels), ("ellipsoids", ellipsoids)):
        image = make(size, np.random.default_rng(RNG_SEED))
        write_nrrd(volume, image)
        number = int((image > 0).sum())
        del image
        seconds, cpu, memory = run(program, [volume, "--all-labels", "-o", os.path.join(folder, "label.graph")])
        print(f"| {name}, {size}^3 | {number} | {seconds:.1f} | {cpu:.1f} | {memory:.0f} |")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    os.makedirs(sys.argv[2], exist_ok=True)
    measure_shapes(sys.argv[1], sys.argv[2])
    measure_vessels(sys.argv[1], sys.argv[2])
    measure_labels(sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 512)
