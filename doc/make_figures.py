#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Makes the pictures of README.md and the pages of doc anew, in one style: see drawing.py.

Usage: make_figures.py --program build/bin/cscd [--mcf build/bin/benchmark/mcf_skeleton] [--msls COMMAND] [--output FOLDER]
[NAME...]: by default all pictures that the given programs allow, into doc/fig. COMMAND, MESH and SKELETON.graph behind it,
writes GEL's skeleton. Shapes come from Debian's libcgal-demo or are generated here. Needs Debian's python3-numpy,
python3-matplotlib and python3-pil.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tarfile
import tempfile

import numpy as np

from drawing import (BODY, BRANCHES, OUTSIDE, Animation, Picture, Scene, colors_of_radii, view)

BENCHMARK = pathlib.Path(__file__).resolve().parent.parent / "benchmark"
sys.path += [str(BENCHMARK), str(BENCHMARK / "reproduce")]
import volumes  # noqa: E402

ARCHIVE = "/usr/share/doc/libcgal-dev/data.tar.gz"
PLAIN = np.array([0.05, 0.25, 0.62])  # skeletons that are compared
SEED = 7
# How the shapes of CGAL stand upright, seen from the side that shows most.
POSES = {"armadillo": ("y", 90, 4), "bear": ("y", 100, 8), "bull": ("y", 65, 8), "camel": ("y", -10, 8),
         "cow": ("y", 110, 10), "dino": ("z", 50, 8), "elephant": ("y", 75, 8), "elk": ("y", 40, 10),
         "femur": ("-z", 0, 0), "hand": ("y", 0, 0), "homer": ("y", 245, 4), "kitten": ("y", 0, 6),
         "knot1": ("z", 0, 30), "man": ("z", 0, 4), "triceratops": ("y", 120, 14)}


# Inputs


class Shapes:
    """The shapes of CGAL's data, unpacked to a folder where they are needed."""

    def __init__(self, folder):
        self.folder = folder
        with tarfile.open(ARCHIVE) as archive:
            archive.extractall(folder, [m for m in archive.getmembers() if m.name.startswith(("data/meshes", "data/points_3"))])

    def mesh(self, name):
        return self.folder / "data" / "meshes" / f"{name}.off"

    def points(self, name):
        return self.folder / "data" / "points_3" / name


def read_off(path):
    lines = [line for line in (line.split("#")[0].strip() for line in path.read_text().splitlines()) if line]
    head = lines[0].split()[1:]
    begin = 1 if head else 2
    number_of_points, number_of_faces = map(int, (head or lines[1].split())[:2])
    points = np.array([line.split()[:3] for line in lines[begin : begin + number_of_points]], float)
    faces = []
    for line in lines[begin + number_of_points : begin + number_of_points + number_of_faces]:
        count, *corners = map(int, line.split()[: int(line.split()[0]) + 1])
        faces += [(corners[0], corners[i], corners[i + 1]) for i in range(1, count - 1)]
    return points, np.array(faces)


def tree_scan(rng, number=30000):
    """Points on the bark of a generated tree of 10 meters."""
    limbs = []  # points of the axis, radii

    def grow(base, direction, length, radius, order):
        axis = [base]
        for _ in range(16):
            bend = rng.normal(size=3) * (0.03 if order == 0 else 0.07)
            direction = direction + bend + np.array([0, 0, 0 if order == 0 else 0.05])
            direction /= np.linalg.norm(direction)
            axis.append(axis[-1] + length / 16 * direction)
        radii = radius * (1 - 0.85 * np.linspace(0, 1, 17))
        limbs.append((np.array(axis), radii))
        if order == 2:
            return
        azimuth = rng.uniform(0, 2 * math.pi)
        for k in range(10 if order == 0 else 5):
            place = 0.3 + 0.62 * (k + rng.uniform(0, 0.6)) / (10 if order == 0 else 5)
            at = int(place * 16)
            along = axis[at + 1] - axis[at]
            along /= np.linalg.norm(along)
            u = np.cross(along, [1, 0, 0] if abs(along[0]) < 0.9 else [0, 1, 0])
            u /= np.linalg.norm(u)
            azimuth += 2.4
            across = math.cos(azimuth) * u + math.sin(azimuth) * np.cross(along, u)
            grow(axis[at], 0.55 * along + 0.83 * across, (0.5 if order == 0 else 0.55) * (1.2 - place) * length,
                 0.55 * radii[at], order + 1)

    grow(np.zeros(3), np.array([0.0, 0.0, 1.0]), 10.0, 0.22, 0)
    pieces = [(limb, i) for limb, (axis, _) in enumerate(limbs) for i in range(len(axis) - 1)]
    areas = np.array([np.linalg.norm(limbs[l][0][i + 1] - limbs[l][0][i]) * (limbs[l][1][i] + 0.02) for l, i in pieces])
    points = []
    for piece in rng.choice(len(pieces), number, p=areas / areas.sum()):
        (axis, radii), i = limbs[pieces[piece][0]], pieces[piece][1]
        along = axis[i + 1] - axis[i]
        t, angle = rng.uniform(), rng.uniform(0, 2 * math.pi)
        unit = along / np.linalg.norm(along)
        u = np.cross(unit, [1, 0, 0] if abs(unit[0]) < 0.9 else [0, 1, 0])
        u /= np.linalg.norm(u)
        radius = (1 - t) * radii[i] + t * radii[i + 1]
        points.append(axis[i] + t * along + radius * (math.cos(angle) * u + math.sin(angle) * np.cross(unit, u)))
    return np.array(points)


def voxel_faces(image):
    """The faces of voxels between body and background, as triangles without common vertices; coordinates x, y, z."""
    padded = np.pad(image, 1).transpose(2, 1, 0)
    points, faces = [], []
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    for axis in range(3):
        for sign in (-1, 1):
            border = np.argwhere((padded == 1) & (np.roll(padded, -sign, axis) == 0)) - 1
            corners = np.zeros((len(border), 4, 3))
            others = [(axis + 1) % 3, (axis + 2) % 3]
            corners[:, :, axis] = border[:, None, axis] + (sign > 0)
            for k, other in enumerate(others):
                corners[:, :, other] = border[:, None, other] + square[:, k]
            if sign < 0:
                corners = corners[:, ::-1]
            first = 4 * np.arange(len(border))[:, None] + sum(len(p) for p in points)
            faces += [first + [0, 1, 2], first + [0, 2, 3]]
            points.append(corners.reshape(-1, 3))
    return np.concatenate(points), np.concatenate(faces)


# Skeletons


class Skeleton:
    def __init__(self, points, edges, radii=None, branches=()):
        self.points, self.edges = np.array(points, float).reshape(-1, 3), [tuple(edge) for edge in edges]
        self.radii, self.branches = radii, branches

    def colors_of_branches(self):
        branch_of = {}
        order = sorted(self.branches, key=lambda branch: -branch["length"])
        for number, branch in enumerate(order):
            for pair in zip(branch["nodes"], branch["nodes"][1:]):
                branch_of[frozenset(pair)] = number
        return [BRANCHES[branch_of.get(frozenset(edge), 0) % len(BRANCHES)] for edge in self.edges]

    def colors_of_radii(self):
        low, high = np.quantile(self.radii, [0.02, 0.98])
        nodes = colors_of_radii(self.radii, low, high)
        return [(nodes[i] + nodes[j]) / 2 for i, j in self.edges]


def skeletonize(program, path, *options):
    with tempfile.TemporaryDirectory() as folder:
        name = pathlib.Path(folder) / "skeleton.json"
        subprocess.run([program, "skeletonize", path, "-o", name, "--quiet", *options], check=True)
        found = json.loads(name.read_text())
    nodes = found["nodes"]
    return Skeleton([n["point"] for n in nodes], found["edges"], np.array([n["radius"] for n in nodes]), found["branches"])


def skeleton_of(command, path):
    with tempfile.TemporaryDirectory() as folder:
        name = pathlib.Path(folder) / "skeleton.graph"
        subprocess.run([*command, path, name], check=True, stdout=subprocess.DEVNULL)
        lines = [line.split() for line in name.read_text().splitlines()]
    return Skeleton([line[1:4] for line in lines if line[0] == "n"],
                    [(int(line[1]), int(line[2])) for line in lines if line[0] == "c"])


def are_inside(points, mesh_points, faces):
    """By the number of faces above each point; the mesh is closed. Turned first, so that no ray meets an edge."""
    turn = view("z", 23.7, 31.9)
    points, corners = points @ turn.T, (mesh_points @ turn.T)[faces]
    a, b, c = (corners[:, i] for i in range(3))
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    result = []
    for p in points:
        v = ((p[0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (p[1] - a[:, 1]) * (c[:, 0] - a[:, 0])) / area
        w = ((p[1] - a[:, 1]) * (b[:, 0] - a[:, 0]) - (p[0] - a[:, 0]) * (b[:, 1] - a[:, 1])) / area
        hit = (v >= 0) & (w >= 0) & (v + w <= 1)
        depth = a[:, 2] + v * (b[:, 2] - a[:, 2]) + w * (c[:, 2] - a[:, 2])
        result.append(np.count_nonzero(hit & (depth > p[2])) % 2 == 1)
    return np.array(result)


def divided(skeleton, parts=8):
    """The points and edges with each edge divided, so that it can be drawn in several colors."""
    points, edges = list(skeleton.points), []
    for i, j in skeleton.edges:
        last = i
        for k in range(1, parts):
            points.append(skeleton.points[i] + k / parts * (skeleton.points[j] - skeleton.points[i]))
            edges.append((last, len(points) - 1))
            last = len(points) - 1
        edges.append((last, j))
    return np.array(points), edges


# Pictures


def hero(options, shapes):
    """A body and its skeleton twice: by branch, and by radius."""
    path = shapes.mesh("armadillo")
    points, faces = read_off(path)
    skeleton = skeletonize(options.program, path)
    picture = Picture(1800, 880)
    for column, colors in enumerate((skeleton.colors_of_branches(), skeleton.colors_of_radii())):
        scene = Scene(view(*POSES["armadillo"]))
        scene.body(points, faces)
        scene.skeleton(skeleton.points, skeleton.edges, colors)
        picture.place(scene.draw(900, 880), 900 * column, 0)
    return picture


def thick(skeleton):
    """Colors by radius, and the radii of tubes as of nodes, relative to the height; thin tubes are drawn thicker."""
    height = np.ptp(skeleton.points[:, 2])
    return skeleton.colors_of_radii(), np.maximum(skeleton.radii / height, 0.003)


def inputs(options, shapes):
    """Four kinds of inputs above, and their skeletons below."""
    rng = np.random.default_rng(SEED)
    work = shapes.folder
    tree = tree_scan(rng)
    np.savetxt(work / "tree.xyz", tree, "%.5f")
    image = volumes.Tube(volumes.vessel_tree(4, np.random.default_rng(5))).fill(72)
    volumes.write_nrrd(str(work / "vessels.nrrd"), image)
    voxels = voxel_faces(image)
    kitten = np.loadtxt(shapes.points("kitten.xyz"))[:, :3]
    camel = read_off(shapes.mesh("camel"))
    cells = [
        ("a mesh", POSES["camel"], skeletonize(options.program, shapes.mesh("camel")),
         lambda scene, i: scene.body(*camel)),
        ("points", POSES["kitten"], skeletonize(options.program, shapes.points("kitten.xyz")),
         lambda scene, i: scene.cloud(kitten, (0.62, 0.65, 0.70) if i else (0.42, 0.47, 0.55), 0.0035 if i else 0.006)),
        ("a volume", ("z", 30, 12), skeletonize(options.program, work / "vessels.nrrd"),
         lambda scene, i: scene.body(voxels[0] - 0.5, voxels[1])),
        ("a scan of a tree", ("z", 20, 4), skeletonize(options.program, work / "tree.xyz", "--shape", "tree"),
         lambda scene, i: None if i else scene.cloud(tree, (0.42, 0.47, 0.55), 0.0022)),
    ]
    width, height, head = 480, 520, 60
    picture = Picture(width * len(cells), head + 2 * height)
    for column, (name, pose, skeleton, draw) in enumerate(cells):
        box = None
        for row in range(2):
            scene = Scene(view(*pose))
            draw(scene, row)
            if row:
                scene.skeleton(skeleton.points, skeleton.edges, *(thick(skeleton) if "tree" in name else
                                                                  (skeleton.colors_of_branches(), 0.011)))
            box = box or scene.box()
            picture.place(scene.draw(width, height, box), width * column, head + height * row)
        picture.word(name, width * column + width // 2, head // 2, 34)
    return picture


def comparison(options, shapes):
    """CSCD, MCF and MSLS on three meshes; parts outside of the body are red, and a part is enlarged."""
    methods = [("CSCD", lambda path: skeletonize(options.program, path)), ("MCF", lambda path: skeleton_of([options.mcf], path))]
    if options.msls:
        methods.append(("MSLS", lambda path: skeleton_of([options.msls], path)))
    names = ["elephant", "dino", "triceratops"]
    window = (0.29, 0.16, 0.26)  # of the first row: trunk and tusks
    width, height, head, foot = 640, 480, 60, 44
    picture = Picture(width * len(methods), head + height * len(names))
    for row, name in enumerate(names):
        points, faces = read_off(shapes.mesh(name))
        for column, (method, make) in enumerate(methods):
            drawn, edges = divided(make(shapes.mesh(name)))
            middles = np.array([(drawn[i] + drawn[j]) / 2 for i, j in edges])
            inside = are_inside(middles, points, faces)
            scene = Scene(view(*POSES[name]))
            scene.body(points, faces)
            scene.skeleton(drawn, edges, np.where(inside[:, None], PLAIN, OUTSIDE), 0.007)
            x, y, h = width * column, head + height * row, height - foot
            picture.place(scene.draw(width, h), x, y)
            if row == 0:
                picture.word(method, x + width // 2, head // 2, 36, bold=True)
                enlarged = scene.draw(250, 250 * h // width, window=window)
                picture.place(enlarged, x + width - 260, y + 4)
                picture.frame(x + width - 260, y + 4, 250, len(enlarged))
                picture.frame(x + int(window[0] * width), y + int(window[1] * h), int(window[2] * width),
                              int(window[2] * h), (0.5, 0.5, 0.5))
            length = np.array([np.linalg.norm(drawn[i] - drawn[j]) for i, j in edges])
            share = math.floor(1000 * length[inside].sum() / length.sum()) / 10
            degree = np.bincount(np.array(edges).ravel())
            picture.word(f"{share:g} % inside, {np.count_nonzero(degree == 1)} tips", x + width // 2, y + height - 24, 26)
    return picture


def detail(options, shapes):
    """One mesh with three values of detail."""
    path = shapes.mesh("cow")
    points, faces = read_off(path)
    picture = Picture(1920, 560)
    for column, value in enumerate(("0.1", "0.5", "1")):
        skeleton = skeletonize(options.program, path, "--detail", value)
        scene = Scene(view(*POSES["cow"]))
        scene.body(points, faces)
        scene.skeleton(skeleton.points, skeleton.edges, skeleton.colors_of_branches(), 0.008)
        picture.place(scene.draw(640, 500), 640 * column, 60)
        degree = np.bincount(np.array(skeleton.edges).ravel())
        picture.word(f"detail {value}: {np.count_nonzero(degree == 1)} tips", 640 * column + 320, 30, 34)
    return picture


def gallery(options, shapes):
    """Twelve shapes with their skeletons."""
    names = ["bear", "bull", "cow", "dino", "elephant", "elk", "femur", "hand", "homer", "knot1", "man", "triceratops"]
    width, height = 480, 420
    picture = Picture(4 * width, 3 * height)
    for number, name in enumerate(names):
        points, faces = read_off(shapes.mesh(name))
        skeleton = skeletonize(options.program, shapes.mesh(name))
        scene = Scene(view(*POSES[name]))
        scene.body(points, faces)
        scene.skeleton(skeleton.points, skeleton.edges, skeleton.colors_of_branches(), 0.010)
        x, y = width * (number % 4), height * (number // 4)
        picture.place(scene.draw(width, height - 40), x, y)
        picture.word(name, x + width // 2, y + height - 22, 24)
    return picture


APPLICATION_SHAPES = ["armadillo", "bull", "camel", "dino", "elephant", "man"]
LOOPS = {"handle": np.array([0.84, 0.12, 0.12]), "tunnel": np.array([0.05, 0.25, 0.85]),
         "constriction": np.array([0.0, 0.5, 0.15])}


def lines_of(program, command, path, ending):
    """What a command of the program writes to a file, as text."""
    with tempfile.TemporaryDirectory() as folder:
        name = pathlib.Path(folder) / f"result{ending}"
        subprocess.run([program, command, path, "-o", name, "--quiet"], check=True)
        return name.read_text()


def of_shapes(shapes, draw):
    """Six shapes, each drawn by `draw(path, scene, points, faces)`."""
    width, height = 640, 480
    picture = Picture(3 * width, 2 * height)
    for number, name in enumerate(APPLICATION_SHAPES):
        points, faces = read_off(shapes.mesh(name))
        scene = Scene(view(*POSES[name]))
        draw(shapes.mesh(name), scene, points, faces)
        picture.place(scene.draw(width, height), width * (number % 3), height * (number // 3))
    return picture


def application_diameters(options, shapes):
    """How thick bodies are: thin blue, thick red."""

    def draw(path, scene, points, faces):
        diameters = np.log(np.loadtxt(lines_of(options.program, "diameter", path, ".txt").split()))
        scene.body(points, faces, colors_of_radii(diameters, *np.quantile(diameters, [0.02, 0.98])))

    return of_shapes(shapes, draw)


def application_parts(options, shapes):
    """Parts by the skeleton."""

    def draw(path, scene, points, faces):
        parts = np.array(lines_of(options.program, "segment", path, ".seg").split(), int)
        scene.body(points, faces, colors_of_faces=0.25 + 0.75 * BRANCHES[parts % len(BRANCHES)])

    return of_shapes(shapes, draw)


def application_loops(options, shapes):
    """Loops around handles red, tunnels blue, constrictions green."""

    def draw(path, scene, points, faces):
        scene.body(points, faces)
        scene.through = 0.15
        for loop in json.loads(lines_of(options.program, "loops", path, ".json")):
            number = len(loop["points"])
            edges = [(i, (i + 1) % number) for i in range(number)]
            scene.skeleton(np.array(loop["points"]), edges, [LOOPS[loop["kind"]]] * number, 0.006)

    return of_shapes(shapes, draw)


def gutter():
    """A half pipe that bends, as a mesh with a border."""
    along, across = 90, 14
    points, faces = [], []
    for i in range(along):
        t = i / (along - 1)
        middle = np.array([2 * t, 0.35 * math.sin(2 * math.pi * t), 0])
        direction = np.array([2, 0.7 * math.pi * math.cos(2 * math.pi * t), 0])
        direction /= np.linalg.norm(direction)
        side = np.cross([0, 0, 1], direction)
        width = 0.16 + 0.1 * math.sin(math.pi * t)
        for k in range(across):
            angle = math.pi * k / (across - 1)
            points.append(middle + width * (math.cos(angle) * side - np.array([0, 0, math.sin(angle)])))
    for i in range(along - 1):
        for k in range(across - 1):
            a, b = across * i + k, across * (i + 1) + k
            faces += [(a, b, a + 1), (a + 1, b, b + 1)]
    return np.array(points), np.array(faces)


def write_off(path, points, faces):
    lines = [f"OFF {len(points)} {len(faces)} 0", *("{} {} {}".format(*p) for p in points), *("3 {} {} {}".format(*f) for f in faces)]
    path.write_text("\n".join(lines) + "\n")


def others(options, shapes):
    """A sheet and a graph, and their skeletons."""
    sheet = gutter()
    path = shapes.folder / "gutter.off"
    write_off(path, *sheet)
    skeleton = skeletonize(options.program, path)
    picture = Picture(1920, 560)
    scene = Scene(view("z", 0, 50))
    scene.body(*sheet)
    scene.skeleton(skeleton.points, skeleton.edges, skeleton.colors_of_branches(), 0.008)
    picture.place(scene.draw(960, 500), 0, 60)
    picture.word("a sheet", 480, 30, 34)

    path = shapes.mesh("camel")
    points, faces = read_off(shapes.mesh("camel"))
    edges = sorted({tuple(sorted((face[i], face[i - 1]))) for face in faces.tolist() for i in range(3)})
    skeleton = skeletonize(options.program, path, "--as", "graph")
    scene = Scene(view(*POSES["camel"]))
    scene.skeleton(points, edges[::2], [np.array([0.72, 0.75, 0.8])] * len(edges[::2]), 0.0006)
    low, high = scene.box()
    picture.place(scene.draw(960, 500), 960, 60)
    scene = Scene(view(*POSES["camel"]))
    scene.skeleton(skeleton.points, skeleton.edges, skeleton.colors_of_branches(), 0.008)
    over = scene.draw(960, 500, (low, high))
    mask = over.min(2) < 0.97
    picture.pixels[60:560, 960:][mask] = over[mask]
    picture.word("a graph", 1440, 30, 34)
    return picture


def revolved(corners, stretch=1.0, around=64, step=0.04):
    """The surface that a polyline of radii and heights sweeps; radius 0 is a point on the axis."""
    profile = [corners[0]]
    for (r, z), (s, w) in zip(corners, corners[1:]):
        number = max(1, round(math.hypot(s - r, w - z) / step))
        profile += [(r + (s - r) * i / number, z + (w - z) * i / number) for i in range(1, number + 1)]
    points, rings, faces = [], [], []
    for r, z in profile:
        angles = [2 * math.pi * k / around for k in range(around if r > 0 else 1)]
        rings.append([len(points) + k % len(angles) for k in range(around)])
        points += [(stretch * r * math.cos(t), r * math.sin(t), z) for t in angles]
    for low, high in zip(rings, rings[1:]):
        for k in range(around):
            a, b, c, d = low[k], low[(k + 1) % around], high[k], high[(k + 1) % around]
            faces += [face for face in ((a, b, c), (b, d, c)) if len(set(face)) == 3]
    return np.array(points), np.array(faces)


def failures(options, shapes):
    """A cup, a bust and a tub: bodies whose skeletons mean little."""
    cup = revolved([(0, 0), (0.5, 0), (0.5, 1.1), (0.44, 1.1), (0.44, 0.06), (0, 0.06)])
    tub = revolved([(0.08, -1.1), (0.08, -0.3), (0.3, -0.25), (0.62, 0), (0.7, 0.55)], stretch=1.5)
    picture = Picture(1920, 560)
    for column, (name, pose, (points, faces)) in enumerate([
            ("a cup", ("z", 30, 28), cup), ("a bust", ("z", 60, 6), read_off(shapes.mesh("mannequin-devil"))),
            ("a tub with its drain", ("z", 30, 14), tub)]):
        path = shapes.folder / "failure.off"
        write_off(path, points, faces)
        skeleton = skeletonize(options.program, path)
        scene = Scene(view(*pose))
        scene.body(points, faces)
        scene.skeleton(skeleton.points, skeleton.edges, skeleton.colors_of_branches(), 0.009)
        picture.place(scene.draw(640, 500), 640 * column, 60)
        picture.word(name, 640 * column + 320, 30, 34)
    return picture


def vessel(options, shapes):
    """The vessel of doc/python.md and its skeleton, colored by radius."""
    t, angle = np.linspace(0, 1, 240)[:, None, None], np.linspace(0, 2 * np.pi, 24, endpoint=False)[:, None]
    bend = np.concatenate([60 * t, 8 * np.sin(2 * np.pi * t), 0 * t], axis=2)
    along = np.gradient(bend[:, 0], axis=0)
    side = np.cross(along, [0, 0, 1])[:, None] / np.linalg.norm(along, axis=1)[:, None, None]
    lumen = 3 - 1.5 * np.exp(-(((t - 0.5) / 0.08) ** 2))
    points = (bend + lumen * (np.cos(angle) * side + np.sin(angle) * [0, 0, 1])).reshape(-1, 3)
    a, k = 24 * np.arange(239)[:, None] + np.arange(24), np.arange(24)
    b = a - k + (k + 1) % 24
    faces = np.concatenate([np.stack([a, b, b + 24], 2), np.stack([a, b + 24, a + 24], 2)]).reshape(-1, 3)
    path = shapes.folder / "vessel.off"
    write_off(path, points, faces)
    skeleton = skeletonize(options.program, path)
    scene = Scene(view("z", 0, 60))
    scene.body(points, faces)
    scene.skeleton(skeleton.points, skeleton.edges, skeleton.colors_of_radii(), 0.009)
    picture = Picture(1800, 560)
    picture.place(scene.draw(1800, 560), 0, 0)
    return picture


def eased(t):
    """From 0 to 1, slowly at both ends."""
    t = min(max(t, 0), 1)
    return t * t * (3 - 2 * t)


def turning(options, shapes):
    """A mesh that turns once around. Its skeleton appears in it, each vertex moves to its node, and back."""
    path = shapes.mesh("camel")
    points, faces = read_off(path)
    table = shapes.folder / "correspondence.csv"
    skeleton = skeletonize(options.program, path, "--correspondence", table)
    node_of = np.array([row.split(",")[1] for row in table.read_text().splitlines()[1:]], int)
    up, turn, tilt = POSES["camel"]
    reach = np.linalg.norm(points[:, [0, 2]] - (points.min(0) + points.max(0))[[0, 2]] / 2, axis=1).max()
    points, nodes = (p - (points.min(0) + points.max(0)) / 2 for p in (points, skeleton.points))
    number = 60
    frames = []
    for i in range(number):
        shrunk = eased((i - 18) / 18) - eased((i - 48) / 12)
        shown = eased((i - 10) / 8) - eased((i - 50) / 10)
        scene = Scene(view(up, turn + 360 * i / number, tilt))
        scene.through *= shown
        if shrunk < 1:  # the last of it are faces from branch to branch: they fade
            scene.body((1 - shrunk) * points + shrunk * nodes[node_of], faces, BODY + eased(4 * shrunk - 3) * (1.2 - BODY))
        if shown > 0:
            scene.skeleton(nodes, skeleton.edges, skeleton.colors_of_branches(), 0.008)
        half = np.array([reach, np.ptp(points[:, 1]) / 2 + reach * math.sin(math.radians(tilt)), reach])
        frames.append(scene.draw(480, 440, (-half, half)))
    return Animation(frames)


PICTURES = {"turning": turning, "hero": hero, "inputs": inputs, "others": others, "comparison": comparison, "detail": detail, "gallery": gallery,
            "failures": failures, "vessel": vessel,
            "application_diameters": application_diameters, "application_parts": application_parts,
            "application_loops": application_loops}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, type=pathlib.Path, help="the path of a built cscd")
    parser.add_argument("--mcf", type=pathlib.Path, help="the path of a built mcf_skeleton; without it, no comparison")
    parser.add_argument("--msls", type=pathlib.Path, help="a command MESH SKELETON.graph; without it, no column MSLS")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path(__file__).parent / "fig", metavar="FOLDER")
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(PICTURES))
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    names = options.names or [name for name in PICTURES if name != "comparison" or options.mcf]
    with tempfile.TemporaryDirectory() as folder:
        shapes = Shapes(pathlib.Path(folder))
        for name in names:
            picture = PICTURES[name](options, shapes)
            path = options.output / f"{name}{picture.ENDING}"
            picture.save(path)
            print(path)


if __name__ == "__main__":
    main()
