# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve skeletons of triangle meshes and point sets.

    import cscd
    shape = cscd.read("elephant.off")
    skeleton = cscd.skeletonize(shape.vertices, shape.faces)      # without faces for points
    skeleton.nodes, skeleton.edges, skeleton.radius, skeleton.vertex_to_node

All algorithms are those of the C++ library CSCD; doc/python.md is a tutorial.
"""

from __future__ import annotations

import html
import json
import os
import pathlib
import tempfile
import typing
import webbrowser

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import FileError, InputError, __version__

if typing.TYPE_CHECKING:
    import networkx  # type: ignore[import]

__all__ = [
    "Branch",
    "FileError",
    "InputError",
    "Loop",
    "Shape",
    "Skeleton",
    "find_loops",
    "read",
    "skeletonize",
    "__version__",
]

FileError.__doc__ = "A file cannot be read or written. The message names the file and the remedy."
InputError.__doc__ = "The input cannot be skeletonized. The message names the offending element and the remedy."

FloatArray = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.int32]

Progress = typing.Callable[[str, float], object]
"""Called with the name of a stage and the part of it that is done, from 0 to 1."""


class Shape(typing.NamedTuple):
    """The content of a file. None stands for arrays that the file does not have."""

    vertices: FloatArray
    """Vertices, points or nodes, shape (n, 3)."""
    faces: npt.NDArray[np.int64] | None
    """The vertices of each face, shape (m, 3) for triangles. Rows of faces with fewer vertices than others end with -1."""
    normals: FloatArray | None
    """Normals at the points, shape (n, 3)."""
    edges: npt.NDArray[np.int64] | None
    """The two ends of each edge of a skeleton or graph, shape (k, 2)."""
    radius: FloatArray | None
    """The radii of the nodes of a skeleton, shape (n,)."""


class Branch(typing.NamedTuple):
    """A path between nodes of degree other than two, or a cycle."""

    nodes: IndexArray
    """The nodes from end to end; a branch that returns to its first node has it at both ends."""
    ends: tuple[str, str]
    """The kinds of both end nodes: "tip", "opening" (a tip at a border), "junction", "isolated" or "closed"."""
    length: float
    """Length along the edges, in the unit of the input."""
    chord: float
    """The distance between both ends, in the unit of the input."""
    min_radius: float
    """The least radius of the nodes."""
    mean_radius: float
    """The mean radius over the length."""
    max_radius: float
    """The greatest radius of the nodes."""
    significance: float
    """How far its limb reaches beyond the body it stands on, in radii; infinite if it is never pruned."""
    volume: float
    """Volume of its part of the body, in the cubed unit of the input; nan unless the input is a mesh."""
    surface_area: float
    """Area of its part of the surface, in the squared unit of the input; nan unless the input is a mesh."""
    parent: int | None
    """The number of the branch before it on the way from the root; None at the root, and without `root`."""
    order: int | None
    """The number of branches before it on that way; None without `root`."""


class Loop(typing.NamedTuple):
    """A closed geodesic on a surface."""

    kind: str
    """"handle", "tunnel" or "constriction"."""
    length: float
    """Length, in the unit of the input."""
    depth: float
    """Depth of a constriction: how much longer a loop must become if it is to move away, relative to its length."""
    points: FloatArray
    """Points along the loop, shape (n, 3); the last and the first are neighbors."""


class Skeleton:
    """A curve skeleton, with its input. The arrays are the library's own memory: they cannot be written."""

    def __init__(self, core: _core.Skeleton) -> None:
        """For `skeletonize()` and `simplify()` only."""
        self._core = core

    @property
    def nodes(self) -> FloatArray:
        """The position of each node in the coordinates of the input, shape (n, 3)."""
        return self._core.nodes

    @property
    def edges(self) -> IndexArray:
        """The two nodes of each edge, counted from 0, shape (k, 2)."""
        return self._core.edges

    @property
    def radius(self) -> FloatArray:
        """The mean distance of each node to the surface around it, in the unit of the input, shape (n,)."""
        return self._core.radius

    @property
    def significance(self) -> FloatArray:
        """Of each edge: how far its limb reaches beyond the body it stands on, in radii of the limb, shape (k,); infinite
        if pruning never cuts the edge."""
        return self._core.significance

    @property
    def vertex_to_node(self) -> IndexArray:
        """The node that each row of `V` belongs to, shape (rows of `V`,). It is -1 for vertices without a face, and for
        vertices of components that `min_component` removed. Rows that repairs merged belong to the same node."""
        return self._core.vertex_to_node

    @property
    def warnings(self) -> list[str]:
        """The warnings for the user, a sentence each."""
        return self._core.warnings

    @property
    def repairs(self) -> list[str]:
        """The repairs of `V` and `F`, a sentence each."""
        return self._core.repairs

    @property
    def report(self) -> dict[str, typing.Any]:
        """Counts, times and warnings of the skeletonization, as `cscd skeletonize --report` writes them. A simplified
        skeleton keeps the report of the original skeleton."""
        return typing.cast("dict[str, typing.Any]", json.loads(self._core.report))

    def shape_diameters(self) -> FloatArray:
        """The thickness of the body at each row of `V`, in the unit of the input, as `cscd diameter` writes it. Raises
        ValueError unless `F` is a mesh that needed no repair."""
        return np.array(self._core.shape_diameters())

    def segment(self, *, parts: int = 0) -> IndexArray:
        """The part that each row of `F` belongs to, from 0 on, as `cscd segment` writes it. Raises ValueError unless
        `F` is a mesh that needed no repair.

        parts: the number of parts; 0 lets the shape decide
        """
        return np.array(self._core.segment(_count("parts", parts)), dtype=np.int32)

    def branches(self) -> list[Branch]:
        """The paths between nodes of degree other than two, and cycles: each edge is in one of them. The branches have
        parents and orders if the skeleton was made with `root`."""
        return [Branch(np.array(row[0], dtype=np.int32), *row[1:]) for row in self._core.branches()]

    def to_networkx(self) -> networkx.Graph:
        """The skeleton as a graph: nodes have `position`, shape (3,), and `radius`, edges `length` and `significance`. It
        is a `MultiGraph` if two edges join the same nodes or an edge joins a node with itself.

        Raises ImportError if NetworkX is not installed.
        """
        try:
            import networkx
        except ImportError as error:
            raise ImportError("to_networkx() needs NetworkX; install it, as by pip install networkx") from error
        ends = {frozenset(edge) for edge in self.edges.tolist()}
        is_simple = len(ends) == len(self.edges) and all(len(nodes) == 2 for nodes in ends)
        graph = networkx.Graph() if is_simple else networkx.MultiGraph()
        for node, (position, radius) in enumerate(zip(self.nodes, self.radius.tolist())):
            graph.add_node(node, position=position, radius=radius)
        lengths = np.linalg.norm(self.nodes[self.edges[:, 0]] - self.nodes[self.edges[:, 1]], axis=1)
        for (a, b), length, significance in zip(self.edges.tolist(), lengths.tolist(), self.significance.tolist()):
            graph.add_edge(a, b, length=length, significance=significance)
        return graph

    def simplify(
        self,
        *,
        min_significance: float = 0,
        min_length: float = 0,
        min_length_over_radius: float = 0,
        join: bool = False,
        spacing: float = 0,
        spacing_over_radius: float = 0,
        min_component: int = 0,
        root: npt.ArrayLike | str | None = None,
        stays_inside: bool = True,
    ) -> Skeleton:
        """A simpler skeleton; this one stays as it is. Options mean what they mean for `cscd simplify`; steps with 0 are
        not done.

        OPTIONS
        stays_inside: whether nodes inside of a mesh stay inside

        Raises ValueError if an option is out of its range, InputError if a spacing asks for too many nodes.
        """
        given = locals()
        options = {name: given[name] for name, *_ in _core.simplify_options}
        options["root"] = _root(root)
        return Skeleton(self._core.simplify(options, stays_inside))

    def evaluate(self, *, radii: str = "estimated", resolution: int = 200) -> dict[str, typing.Any]:
        """The quality of the skeleton for its input: the output of `cscd evaluate --json`; `None` if not defined.

        OPTIONS

        Raises ValueError if an option is out of its range.
        """
        options = {"radii": radii, "resolution": resolution}
        return typing.cast("dict[str, typing.Any]", json.loads(self._core.evaluate(options)))

    def save(self, filename: str | os.PathLike[str]) -> None:
        """Writes the skeleton in the format that the ending names: .graph .json .obj .ply .polylines.txt .swc .vtp
        .html for the viewer page, or .glb for a rig of a mesh. The file appears when it is complete. `root`
        decides where .swc and .glb begin.

        Raises FileError if the ending is not known or the file cannot be written, InputError if there is no mesh for a
        rig.
        """
        self._core.save(os.fspath(filename))

    def show(self) -> str:
        """Opens the viewer page in a web browser; in a notebook, end a cell with the skeleton to see it there.

        Returns the name of the page, a temporary file that stays.
        """
        handle, name = tempfile.mkstemp(prefix="cscd_", suffix=".html")
        os.close(handle)
        self.save(name)
        webbrowser.open(pathlib.Path(name).as_uri())
        return name

    def _repr_html_(self) -> str:
        """The viewer page, for notebooks: in a frame of its own, as it has scripts."""
        page = html.escape(self._core.page("skeleton"), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 600px; border: 0"></iframe>'

    def __repr__(self) -> str:
        return f"<cscd.Skeleton: {len(self.nodes)} nodes, {len(self.edges)} edges>"


def _root(value: npt.ArrayLike | str | None) -> str | None:
    """The root as the program takes it: the name of a rule, or coordinates."""
    if value is None or isinstance(value, str):
        return value
    return ",".join(map(repr, np.asarray(value, dtype=np.float64).reshape(3).tolist()))


def _count(name: str, value: int) -> int:
    if value < 0:
        raise ValueError(f"{name}: must be an integer that is at least 0, not {value}")
    return value


def _rows(name: str, values: npt.ArrayLike) -> FloatArray:
    """`values` as rows of three doubles; without a copy if they are that."""
    rows = np.ascontiguousarray(values, dtype=np.float64)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise ValueError(f"{name}: has the shape {rows.shape}; rows of three coordinates are needed")
    return rows


def _indices(name: str, values: npt.ArrayLike, least: int, most: float, wanted: str) -> npt.NDArray[np.int64]:
    """`values` as rows of `least` to `most` indices of vertices."""
    rows = np.asarray(values)
    if rows.ndim != 2 or not least <= rows.shape[1] <= most:
        raise ValueError(f"{name}: has the shape {rows.shape}; rows of {wanted} indices of vertices are needed")
    if rows.dtype.kind not in "iu":
        raise ValueError(f"{name}: holds {rows.dtype}; indices of vertices are integers")
    return np.ascontiguousarray(rows, dtype=np.int64)


def _faces(values: npt.ArrayLike) -> npt.NDArray[np.int64]:
    if np.asarray(values).shape[:1] == (0,) and np.ndim(values) == 2:
        raise ValueError("F: has no rows; leave it out for points")
    return _indices("F", values, 3, np.inf, "three or more")


def skeletonize(
    V: npt.ArrayLike,
    F: npt.ArrayLike | None = None,
    *,
    normals: npt.ArrayLike | None = None,
    edges: npt.ArrayLike | None = None,
    domain: str | None = None,
    neighbors: int = 0,
    shape: str = "auto",
    borders: str | None = "auto",
    wrap: float | None = None,
    root: npt.ArrayLike | str | None = None,
    detail: float | None = 0.5,
    spacing: float = 0,
    min_component: int = 0,
    join: bool = False,
    method: str = "local",
    literal: bool = False,
    seed: int = 0,
    threads: int = 0,
    separators: int = 0,
    progress: Progress | None = None,
) -> Skeleton:
    """The curve skeleton of a mesh or, without `F`, of points. The options are those of `cscd skeletonize`. For
    `neighbors`, `threads` and `separators`, 0 lets the program decide.

    V: vertices or points, shape (n, 3), in any unit
    F: the vertices of each face, shape (m, 3) or more, counterclockwise seen from outside; rows may end with -1. Faces
        that are not an oriented manifold are repaired: `repairs` says how
    normals: of the points, shape (n, 3); estimated if not given
    edges: of a graph, shape (k, 2); implies domain="graph"
    OPTIONS
    progress: called with the name of a stage and the part of it that is done, from 0 to 1; an exception that it raises
        ends the work

    The global interpreter lock is released while this runs: threads of Python skeletonize in parallel. Ctrl-C ends the
    work with KeyboardInterrupt, except while a surface is made of points and in scans of trees.

    Raises ValueError if an argument cannot be obeyed, and InputError if the input cannot be skeletonized.
    """
    given = locals()
    points = _rows("V", V)
    faces = None if F is None else _faces(F)
    ends = None if edges is None else _indices("edges", edges, 2, 2, "two")
    options = {name: given[name] for name, *_ in _core.skeletonize_options}
    options["root"] = _root(root)
    if ends is not None:
        options["domain"] = "graph"
    directions = None
    if normals is not None:
        directions = _rows("normals", normals)
        if options["domain"] is not None:
            raise ValueError("normals: graphs have none; leave out normals")
        if faces is not None:
            raise ValueError("normals: the normals of a mesh are those of its faces; leave out normals")
        if len(directions) != len(points):
            raise ValueError(f"normals: has {len(directions)} rows, and V {len(points)}")
    return Skeleton(_core.skeletonize(points, faces, directions, ends, options, progress))


def read(filename: str | os.PathLike[str]) -> Shape:
    """Reads a mesh, points, a skeleton or a graph, in the format that the ending names: .off .obj .ply .stl .vtp .vtk .glb
    .gltf, points as .xyz .pwn .pts .txt .csv .asc .pcd .las, skeletons as .graph .json .swc .polylines.txt; each also with
    .gz behind. Nothing is repaired. Linear in the size of the file.

    Raises FileError if the file cannot be read or is malformed. The message names the place and the remedy.
    """
    return Shape(*_core.read(os.fspath(filename)))


def find_loops(V: npt.ArrayLike, F: npt.ArrayLike, *, seed: int = 0, min_depth: float = 0.3) -> list[Loop]:
    """Closed geodesics around the handles, tunnels and constrictions of a body, as `cscd loops` writes them.

    V: vertices, shape (n, 3), in any unit
    F: the vertices of each face, shape (m, 3) or more; repaired where they are not an oriented manifold
    seed: seed of the random choice of sources
    min_depth: constrictions that are less deep are left out

    Raises InputError if the faces do not form a surface.
    """
    if not min_depth >= 0:
        raise ValueError(f"min_depth: is {min_depth}; depths are not negative")
    loops = _core.find_loops(_rows("V", V), _faces(F), _count("seed", seed), float(min_depth))
    return [Loop(kind, length, depth, np.array(points)) for kind, length, depth, points in loops]


def _describe(options: list[tuple[str, str, str, str]], indent: str) -> str:
    """Lines of a docstring, from the table of options of the program."""
    lines = []
    for name, default, values, text in options:
        notes = [values] if values else []
        if default not in ("", "0", "false"):
            notes.append(f"by default {default}")
        lines.append(f"{name}: {text}" + (f" ({'; '.join(notes)})" if notes else ""))
    return f"\n{indent}".join(lines)


for _function, _options, _indent in (
    (skeletonize, _core.skeletonize_options, "    "),
    (Skeleton.simplify, _core.simplify_options, "        "),
    (Skeleton.evaluate, _core.evaluate_options, "        "),
):
    _function.__doc__ = (_function.__doc__ or "").replace("OPTIONS", _describe(_options, _indent))
