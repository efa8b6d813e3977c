# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Draws bodies and skeletons without a graphics card: matte body, white background, skeletons as tubes seen through it.

A scene collects what is drawn of one shape; a picture places scenes and words in cells. Needs NumPy, and Pillow with the
font of matplotlib for words.
"""

import numpy as np

SAMPLES = 2  # a pixel has so many samples in each direction
BODY = np.array([0.80, 0.82, 0.85])
OUTSIDE = np.array([0.86, 0.05, 0.05])  # of faults
# Colors of branches: Okabe and Ito's, told apart by the color-blind, and darker ones of the same hues.
BRANCHES = np.array([[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233],
                     [120, 60, 150], [150, 70, 0], [0, 100, 80], [90, 90, 90]]) / 255
KEY_LIGHT = np.array([-0.45, 0.65, 0.62])
SIDES_OF_TUBE = 14
THROUGH_BODY = 0.9  # how much of a skeleton's color is seen through the body

# Stations of the color map of radii, thin to thick.
RADII = np.array([[0.16, 0.27, 0.61], [0.13, 0.57, 0.55], [0.47, 0.75, 0.26], [0.98, 0.75, 0.15], [0.84, 0.24, 0.14]])


def view(up="y", turn=0.0, tilt=10.0):
    """The rotation that has the axis `up`, such as "z" or "-y", upwards, turned by `turn` degrees, seen from `tilt` above."""
    axis = "xyz".index(up[-1])
    sign = -1.0 if up[0] == "-" else 1.0
    base = np.zeros((3, 3))
    base[1, axis] = sign
    base[0, (axis + 1) % 3] = 1
    base[2] = np.cross(base[0], base[1])
    t, e = np.radians(turn), np.radians(tilt)
    around = np.array([[np.cos(t), 0, np.sin(t)], [0, 1, 0], [-np.sin(t), 0, np.cos(t)]])
    down = np.array([[1, 0, 0], [0, np.cos(e), -np.sin(e)], [0, np.sin(e), np.cos(e)]])
    return down @ around @ base


def normals_of(points, faces):
    """Unit normals of vertices, means of their faces by area; points of skew long triangles included."""
    a, b, c = (points[faces[:, i]] for i in range(3))
    across = np.cross(b - a, c - a)
    normals = np.zeros_like(points)
    for i in range(3):
        np.add.at(normals, faces[:, i], across)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)


def tubes(points, edges, radii, colors, sides=SIDES_OF_TUBE):
    """Triangles of the cylinders around edges and the balls around nodes, with normals and colors of vertices.

    An edge has the color of its own; a ball that of one of its edges."""
    parts_p, parts_n, parts_c, parts_f = [], [], [], []
    count = 0
    angles = 2 * np.pi * np.arange(sides) / sides
    circle = np.stack([np.cos(angles), np.sin(angles)], 1)
    k = np.arange(sides)
    strip = np.concatenate([np.stack([2 * k, 2 * ((k + 1) % sides), 2 * k + 1], 1),
                            np.stack([2 * ((k + 1) % sides), 2 * ((k + 1) % sides) + 1, 2 * k + 1], 1)])
    for (i, j), color in zip(edges, colors):
        direction = points[j] - points[i]
        length = np.linalg.norm(direction)
        if length == 0:
            continue
        direction = direction / length
        u = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))])
        u /= np.linalg.norm(u)
        ring = circle[:, :1] * u + circle[:, 1:] * np.cross(direction, u)
        p = np.stack([points[i] + radii[i] * ring, points[j] + radii[j] * ring], 1).reshape(-1, 3)
        parts_p.append(p)
        parts_n.append(np.repeat(ring, 2, axis=0))
        parts_c.append(np.tile(color, (len(p), 1)))
        parts_f.append(strip + count)
        count += len(p)
    sphere_n, sphere_f = ball()
    color_of_node = {}
    for edge, color in zip(edges, colors):
        for node in edge:
            color_of_node.setdefault(node, color)
    for node, color in color_of_node.items():
        parts_p.append(points[node] + radii[node] * sphere_n)
        parts_n.append(sphere_n)
        parts_c.append(np.tile(color, (len(sphere_n), 1)))
        parts_f.append(sphere_f + count)
        count += len(sphere_n)
    return tuple(np.concatenate(part) for part in (parts_p, parts_n, parts_c, parts_f))


def ball(rows=8, columns=SIDES_OF_TUBE):
    latitude = np.pi * np.arange(rows + 1) / rows
    longitude = 2 * np.pi * np.arange(columns) / columns
    normals = np.stack([np.outer(np.sin(latitude), np.cos(longitude)), np.outer(np.sin(latitude), np.sin(longitude)),
                        np.outer(np.cos(latitude), np.ones(columns))], -1).reshape(-1, 3)
    faces = []
    for i in range(rows):
        for j in range(columns):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            faces += [[a, a + columns, b], [b, a + columns, b + columns]]
    return normals, np.array(faces)


class Layer:
    """The front of the scene at each sample: depth (greater is nearer), normal and color."""

    def __init__(self, height, width):
        self.depth = np.full(height * width, -np.inf)
        self.normal = np.zeros((height * width, 3))
        self.color = np.zeros((height * width, 3))
        self.shape = height, width

    def triangles(self, points, normals, colors, faces):
        """Draws triangles whose points have x and y in samples."""
        height, width = self.shape
        corners = points[faces]
        low = np.floor(corners[:, :, :2].min(1)).astype(int)
        side = (np.ceil(corners[:, :, :2].max(1)).astype(int) - low).max(1) + 1
        size = 4
        while True:
            chosen = np.flatnonzero((side <= size) & (side > (size // 2 if size > 4 else 0)))
            step = max(1, 2_000_000 // size**2)
            for begin in range(0, len(chosen), step):
                self._some(chosen[begin : begin + step], size, low, points, normals, colors, faces)
            if size >= side.max() or size > 2 * max(height, width):
                break
            size *= 2

    def _some(self, chosen, size, low, points, normals, colors, faces):
        height, width = self.shape
        y, x = np.divmod(np.arange(size * size), size)
        px = low[chosen, 0][:, None] + x
        py = low[chosen, 1][:, None] + y
        a, b, c = (points[faces[chosen, i]] for i in range(3))
        area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
        area = np.where(np.abs(area) < 1e-12, np.nan, area)[:, None]
        dx, dy = px - a[:, :1], py - a[:, 1:2]
        v = (dx * (c[:, 1:2] - a[:, 1:2]) - dy * (c[:, :1] - a[:, :1])) / area
        w = (dy * (b[:, :1] - a[:, :1]) - dx * (b[:, 1:2] - a[:, 1:2])) / area
        inside = (v >= 0) & (w >= 0) & (v + w <= 1) & (px >= 0) & (py >= 0) & (px < width) & (py < height)
        t, s = np.nonzero(inside)
        v, w = v[t, s], w[t, s]
        u = 1 - v - w
        depth = u * a[t, 2] + v * b[t, 2] + w * c[t, 2]
        place = py[t, s] * width + px[t, s]
        order = np.argsort(depth, kind="stable")
        order = order[depth[order] > self.depth[place[order]]]
        place, weights, face = place[order], np.stack([u, v, w], 1)[order], faces[chosen[t[order]]]
        self.depth[place] = depth[order]  # of equal places the last counts, which is the nearest
        self.normal[place] = np.einsum("ij,ijk->ik", weights, normals[face])
        self.color[place] = np.einsum("ij,ijk->ik", weights, colors[face])

    def covered(self):
        return np.isfinite(self.depth)

    def shaded(self, matte):
        """The colors under a key light from the upper left, and a sky."""
        n = self.normal / np.maximum(np.linalg.norm(self.normal, axis=1, keepdims=True), 1e-30)
        n = np.where(n[:, 2:] < 0, -n, n)
        key = np.clip((n @ (KEY_LIGHT / np.linalg.norm(KEY_LIGHT)) + 0.25) / 1.25, 0, 1)
        sky = 0.5 + 0.5 * n[:, 1]
        facing = np.clip(n[:, 2], 0, 1)
        if matte:
            light = (0.52 + 0.46 * key + 0.20 * sky) * (0.80 + 0.20 * facing**0.6)
        else:
            light = (0.50 + 0.55 * key + 0.10 * sky) * (0.55 + 0.45 * facing)
        return np.clip(self.color * light[:, None], 0, 1)


def blurred(image, radius):
    """The mean over squares."""
    for axis in (0, 1):
        sums = np.cumsum(np.pad(image, [(radius + 1, radius) if i == axis else (0, 0) for i in range(2)], mode="edge"), axis)
        n = image.shape[axis]
        image = (np.take(sums, np.arange(2 * radius + 1, n + 2 * radius + 1), axis)
                 - np.take(sums, np.arange(n), axis)) / (2 * radius + 1)
    return image


def hollows(depth, covered, scale):
    """How dark hollows are: by how much the surface is behind its surroundings, from 0 to 0.5."""
    if not covered.any():
        return np.zeros_like(depth)
    weight = covered.astype(float)
    height = np.where(covered, depth, 0)
    dark = np.zeros_like(depth)
    for radius in (max(2, scale // 70), max(3, scale // 30)):
        around, share = height, weight
        for _ in range(3):  # nearly a bell
            around, share = blurred(around, radius), blurred(share, radius)
        behind = (around / np.maximum(share, 1e-6) - height) / radius
        dark += 0.25 * np.clip(behind, 0, 1) / (1 + np.clip(behind - 1, 0, None))
    return np.where(covered, dark, 0)


class Scene:
    """One shape and its skeleton in one view; coordinates are those of the input."""

    def __init__(self, rotation):
        self.rotation = rotation
        self.through = THROUGH_BODY
        self.bodies, self.lines, self.clouds = [], [], []

    def body(self, points, faces, color=BODY, colors_of_faces=None):
        """A mesh; `color` is one color or one for each vertex."""
        points = points @ self.rotation.T
        normals = normals_of(points, faces)
        colors = np.broadcast_to(np.asarray(color), (len(points), 3))
        if colors_of_faces is not None:  # each face gets vertices of its own
            points, normals, colors = points[faces.ravel()], normals[faces.ravel()], np.repeat(colors_of_faces, 3, axis=0)
            faces = np.arange(len(points)).reshape(-1, 3)
        self.bodies.append((points, faces, normals, colors))

    def cloud(self, points, color=(0.45, 0.48, 0.52), size=0.004):
        """Points as balls of a radius relative to the extent of the scene."""
        self.clouds.append((points @ self.rotation.T, np.asarray(color), size))

    def skeleton(self, points, edges, colors, radius=0.007):
        """Edges as tubes of a radius relative to the extent of the scene, a number or one for each node. All skeletons of a
        scene are seen through its bodies by `through`."""
        self.lines.append((points @ self.rotation.T, edges, colors, radius))

    def box(self):
        clouds = [part[0] for part in (*self.bodies, *self.clouds)] or [part[0] for part in self.lines]
        points = np.concatenate(clouds)
        return points.min(0), points.max(0)

    def draw(self, width, height, box=None, margin=0.94, window=None):
        """An array of `height` times `width` colors. `window` is the part of the cell to draw enlarged: x, y from the upper
        left and the size, all relative to the cell."""
        low, high = box if box is not None else self.box()
        w, h = width * SAMPLES, height * SAMPLES
        scale = margin * min(w / (high[0] - low[0]), h / (high[1] - low[1]))
        shift = np.array([w / 2 - scale * (low[0] + high[0]) / 2, h / 2 + scale * (low[1] + high[1]) / 2])
        zoom, corner = 1.0, np.zeros(2)
        if window is not None:
            zoom = 1 / window[2]
            corner = np.array([window[0] * w, window[1] * h])
        extent = scale * max(high[0] - low[0], high[1] - low[1])

        def place(points):
            xy = np.stack([shift[0] + scale * points[:, 0], shift[1] - scale * points[:, 1]], 1)
            return np.column_stack([(xy - corner) * zoom, scale * zoom * points[:, 2]])

        body, line, cloud = (Layer(h, w) for _ in range(3))
        for points, faces, normals, colors in self.bodies:
            body.triangles(place(points), normals, colors, faces)
        for points, edges, colors, radius in self.lines:
            radii = np.broadcast_to(np.asarray(radius, float) * extent / scale, len(points))
            p, n, c, f = tubes(points, edges, radii, colors)
            line.triangles(place(p), n, c, f)
        sphere_n, sphere_f = ball(4, 8)
        for points, color, size in self.clouds:
            p = (points[:, None] + size * extent / scale * sphere_n).reshape(-1, 3)
            f = (np.arange(len(points))[:, None, None] * len(sphere_n) + sphere_f).reshape(-1, 3)
            cloud.triangles(place(p), np.tile(sphere_n, (len(points), 1)), np.tile(color, (len(p), 1)), f)

        image = np.ones((h * w, 3))
        covered = body.covered()
        shade = body.shaded(True)
        dark = hollows(body.depth.reshape(h, w), covered.reshape(h, w), int(extent * zoom)).ravel()
        image[covered] = (shade * (1 - dark[:, None]))[covered]
        image = self._with(image, cloud, body, 1.0)
        image = self._with(image, line, body, self.through)
        image = image.reshape(height, SAMPLES, width, SAMPLES, 3).mean((1, 3))
        return image

    @staticmethod
    def _with(image, layer, body, through):
        drawn = layer.covered()
        share = np.where(layer.depth >= body.depth, 1.0, through)[drawn, None]
        image[drawn] = share * layer.shaded(False)[drawn] + (1 - share) * image[drawn]
        return image


def colors_of_radii(values, low=None, high=None):
    low = np.min(values) if low is None else low
    high = np.max(values) if high is None else high
    t = np.clip((np.asarray(values) - low) / max(high - low, 1e-30), 0, 1) * (len(RADII) - 1)
    i = np.minimum(t.astype(int), len(RADII) - 2)
    return RADII[i] + (t - i)[:, None] * (RADII[i + 1] - RADII[i])


def as_image(pixels):
    from PIL import Image

    return Image.fromarray((255 * np.clip(pixels, 0, 1) + 0.5).astype(np.uint8))


class Animation:
    """Frames that follow each other without end."""

    ENDING = ".gif"
    MILLISECONDS = 70  # of a frame
    COLORS = 48  # of all frames together, so that none flickers

    def __init__(self, frames):
        self.frames = frames

    def save(self, name):
        from PIL import Image

        some = np.concatenate(self.frames[:: max(1, len(self.frames) // 8)])
        palette = as_image(some).quantize(self.COLORS, method=Image.Quantize.MEDIANCUT, kmeans=8)
        first, *others = (as_image(f).quantize(palette=palette, dither=Image.Dither.NONE) for f in self.frames)
        first.save(name, save_all=True, append_images=others, duration=self.MILLISECONDS, loop=0, optimize=True)


class Picture:
    """A white picture that holds scenes and words, in pixels."""

    ENDING = ".png"

    def __init__(self, width, height):
        self.pixels = np.ones((height, width, 3))
        self.words = []

    def place(self, image, x, y):
        h, w = image.shape[:2]
        self.pixels[y : y + h, x : x + w] = image

    def frame(self, x, y, width, height, color=(0.3, 0.3, 0.3), thickness=2):
        for part in (np.s_[y : y + thickness, x : x + width], np.s_[y + height - thickness : y + height, x : x + width],
                     np.s_[y : y + height, x : x + thickness], np.s_[y : y + height, x + width - thickness : x + width]):
            self.pixels[part] = color

    def word(self, text, x, y, size=30, color=(40, 40, 40), anchor="mm", bold=False):
        self.words.append((text, x, y, size, color, anchor, bold))

    def save(self, name):
        from matplotlib import font_manager
        from PIL import Image, ImageDraw, ImageFont

        image = as_image(self.pixels)
        draw = ImageDraw.Draw(image)
        for text, x, y, size, color, anchor, bold in self.words:
            font = font_manager.findfont(font_manager.FontProperties(family="DejaVu Sans", weight="bold" if bold else 400))
            draw.text((x, y), text, fill=color, font=ImageFont.truetype(font, size), anchor=anchor)
        # A palette is a third of the size; the pictures have few hues.
        image.quantize(256, method=Image.Quantize.MEDIANCUT, kmeans=8, dither=Image.Dither.NONE).save(name, optimize=True)
