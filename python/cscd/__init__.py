# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve skeletons of triangle meshes and point sets.

    import cscd
    skeleton = cscd.skeletonize(V, F)      # or cscd.skeletonize(V) for points
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
    "Skeleton",
    "find_loops",
    "skeletonize",
    "__version__",
]

FileError.__doc__ = "A file cannot be written. The message names the file and the remedy."
InputError.__doc__ = "The input cannot be skeletonized. The message names the offending element and the remedy."

FloatArray = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.int32]


class Branch(typing.NamedTuple):
    """A path between nodes of degree other than two, or a cycle."""

    nodes: IndexArray
    """From end to end; one that returns to its first node has it at both ends."""
    ends: tuple[str, str]
    """What the first and the last node are: "tip", "opening" (a tip at a border), "junction", "isolated" or "closed"."""
    length: float
    """Along the edges, in the unit of the input."""
    chord: float
    """The distance of both ends."""
    min_radius: float
    """Over the nodes."""
    mean_radius: float
    """Over the length."""
    max_radius: float
    """Over the nodes."""
    significance: float
    """How far its limb reaches beyond the body it stands on, in radii; infinite if it is never pruned."""


class Loop(typing.NamedTuple):
    """A closed geodesic on a surface."""

    kind: str
    """"handle", "tunnel" or "constriction"."""
    length: float
    """In the unit of the input."""
    depth: float
    """Of a constriction: how much longer a loop must become if it is to move away, relative to its length."""
    points: FloatArray
    """Along the loop, a row of three coordinates each; the last and the first are neighbors."""


class Skeleton:
    """A curve skeleton, with what it was made of. The arrays are the library's own memory: they cannot be written."""

    def __init__(self, core: _core.Skeleton) -> None:
        """For `skeletonize()` and `simplify()` only."""
        self._core = core

    @property
    def nodes(self) -> FloatArray:
        """The positions, one row of three coordinates for each node, in the coordinates of the input."""
        return self._core.nodes

    @property
    def edges(self) -> IndexArray:
        """The two nodes of each edge."""
        return self._core.edges

    @property
    def radius(self) -> FloatArray:
        """The mean distance from the curve to the surface around each node."""
        return self._core.radius

    @property
    def significance(self) -> FloatArray:
        """Of each edge: how far its limb reaches beyond the body it stands on, in radii of the limb; infinite if
        pruning never cuts the edge."""
        return self._core.significance

    @property
    def vertex_to_node(self) -> IndexArray:
        """The node that each row of `V` belongs to, -1 where there is none: for vertices without a face, and those of
        components that `min_component` removed. Rows that repairs merged belong to the same node."""
        return self._core.vertex_to_node

    @property
    def warnings(self) -> list[str]:
        """What the user should know, a sentence each."""
        return self._core.warnings

    @property
    def repairs(self) -> list[str]:
        """What was repaired in `V` and `F`, a sentence each."""
        return self._core.repairs

    @property
    def report(self) -> dict[str, typing.Any]:
        """Counts, times and warnings of the skeletonization: what `cscd skeletonize --report` writes. That of a
        simplified skeleton is the report of the skeleton that it was."""
        return typing.cast("dict[str, typing.Any]", json.loads(self._core.report))

    def shape_diameters(self) -> FloatArray:
        """How thick the body is at each row of `V`: what `cscd diameter` writes. Raises ValueError unless `F` is a mesh
        that needed no repair."""
        return np.array(self._core.shape_diameters())

    def segment(self, *, parts: int = 0) -> IndexArray:
        """The part that each row of `F` belongs to, from 0 on: what `cscd segment` writes. Raises ValueError unless `F`
        is a mesh that needed no repair.

        parts: how many there should be; 0 lets the shape decide
        """
        return np.array(self._core.segment(_count("parts", parts)), dtype=np.int32)

    def branches(self) -> list[Branch]:
        """The paths between nodes of degree other than two, and cycles: each edge is in one of them."""
        return [Branch(np.array(row[0], dtype=np.int32), *row[1:]) for row in self._core.branches()]

    def to_networkx(self) -> networkx.Graph:
        """A graph of which the nodes have `position` and `radius`, and the edges `length` and `significance`; a
        `MultiGraph` if two edges join the same nodes or an edge a node with itself. Needs NetworkX."""
        import networkx

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
        merge_junctions: float = 0,
        join: bool = False,
        spacing: float = 0,
        spacing_over_radius: float = 0,
        smooth: int = 0,
        min_component: int = 0,
        stays_inside: bool = True,
    ) -> Skeleton:
        """A simpler skeleton; this one stays as it is. Options mean what they mean for `cscd simplify`; what is 0 is
        not done.

        min_significance: prune limbs that reach less than this beyond the body they stand on, in their radii
        min_length, min_length_over_radius: prune limbs that are shorter, in the unit of the input or in their radii
        merge_junctions: merge junctions that are nearer to each other along a branch, in radii
        join: join components by the shortest straight edges
        spacing, spacing_over_radius: distance of nodes along branches, in the unit of the input or in local radii
        smooth: number of steps of smoothing
        min_component: leave out components to which fewer vertices or points belong, but for the largest
        stays_inside: whether what is inside of a mesh stays inside

        Raises InputError if an option is negative or not finite, or a spacing asks for too many nodes.
        """
        options = _core.SimplifyOptions()
        options.min_significance = min_significance
        options.min_length = min_length
        options.min_length_over_radius = min_length_over_radius
        options.merge_junctions = merge_junctions
        options.join = join
        options.spacing = spacing
        options.spacing_over_radius = spacing_over_radius
        options.smooth = _count("smooth", smooth)
        options.min_component = _count("min_component", min_component)
        return Skeleton(self._core.simplify(options, stays_inside))

    def evaluate(self, *, radii: str = "estimated", resolution: int = 200) -> dict[str, typing.Any]:
        """How good the skeleton is for its input: what `cscd evaluate --json` writes; `None` for what is not defined.

        radii: of the reconstructed surfaces, "estimated" from the input or the skeleton's "own"
        resolution: cells of the reconstructed surfaces along the diagonal of the bounding box, up to 10000
        """
        _check_choice("radii", radii, ("estimated", "own"))
        if not 1 <= resolution <= 10000:
            raise ValueError(f"resolution: {resolution} is not in [1, 10000]")
        return typing.cast("dict[str, typing.Any]", json.loads(self._core.evaluate(radii, resolution)))

    def save(self, filename: str | os.PathLike[str]) -> None:
        """Writes the skeleton in the format that the ending names: .graph .json .obj .ply .polylines.txt .swc .vtp
        .graphml, or .html for the viewer page. The file appears when it is complete.

        Raises FileError if the ending is not known or the file cannot be written.
        """
        path = pathlib.Path(filename)
        if path.suffix != ".html":
            self._core.save(os.fspath(path))
            return
        try:
            partial = path.with_name(f"{path.name}.{os.getpid()}.part")
            try:
                partial.write_text(self._core.page(path.stem), encoding="utf-8")
                partial.replace(path)
            finally:
                partial.unlink(missing_ok=True)
        except OSError as error:
            raise FileError(
                f"{path}: cannot be written ({error.strerror}); check the folder, its permissions and the disk"
            ) from error

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


def _check_choice(name: str, value: str, choices: typing.Collection[str]) -> None:
    if value not in choices:
        raise ValueError(f"{name}: {value} not in {{{','.join(choices)}}}")


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


def _edges(values: npt.ArrayLike) -> npt.NDArray[np.int64]:
    edges = np.asarray(values)
    if edges.ndim != 2 or edges.shape[1] != 2:
        raise ValueError(f"edges: has the shape {edges.shape}; rows of two indices of vertices are needed")
    if edges.dtype.kind not in "iu":
        raise ValueError(f"edges: holds {edges.dtype}; indices of vertices are integers")
    return np.ascontiguousarray(edges, dtype=np.int64)


def _faces(values: npt.ArrayLike) -> npt.NDArray[np.int64]:
    faces = np.asarray(values)
    if faces.ndim != 2 or faces.shape[1] < 3:
        raise ValueError(f"F: has the shape {faces.shape}; rows of three or more indices of vertices are needed")
    if len(faces) == 0:
        raise ValueError("F: has no rows; leave it out for points")
    if faces.dtype.kind not in "iu":
        raise ValueError(f"F: holds {faces.dtype}; indices of vertices are integers")
    return np.ascontiguousarray(faces, dtype=np.int64)


def skeletonize(
    V: npt.ArrayLike,
    F: npt.ArrayLike | None = None,
    *,
    normals: npt.ArrayLike | None = None,
    edges: npt.ArrayLike | None = None,
    domain: str | None = None,
    neighbors: int = 0,
    method: str = "local",
    detail: float | None = None,
    seed: int = 0,
    threads: int = 0,
    shape: str = "auto",
    borders: str | None = None,
    wrap: float | None = None,
    root: npt.ArrayLike | str | None = None,
    literal: bool = False,
    separators: int = 0,
    min_component: int = 0,
    join: bool = False,
) -> Skeleton:
    """The curve skeleton of a mesh or, without `F`, of points. Options mean what they mean for `cscd skeletonize`.

    V: vertices or points, a row of three coordinates each
    F: faces, a row of three or more indices of vertices each, counterclockwise seen from outside. What is no oriented
        manifold is repaired: `repairs` says how
    normals: of the points, a row each; estimated if not given
    edges: of a graph, a row of two indices of vertices each
    domain: "graph" to take the input for a graph, which edges do by themselves: of the sides of faces too, or of each
        point and its neighbors. What is no manifold, or no surface at all, gets a skeleton so
    neighbors: of a graph of points: to how many of its neighbors each is joined; 0 lets the program decide
    method: the algorithms, "local", those of CSCD, or "published", those of the paper, much slower
    detail: how small a limb may be to get a branch, from 0 (none) to 1 (every bump); by default 0.5
    seed: of the random choice of sources
    threads: their number, 0 for all that the machine has; the skeleton does not depend on it
    shape: what points sample: "surface" of a body, "tree" for trees and other thin shapes; "auto" decides by the points
    borders: of a mesh: "bridge" them all, take components with borders for sheets whose skeleton runs along their middle,
        "open", or let their shape decide, "auto"
    wrap: of a mesh: wrap it first by a closed surface, which joins parts that touch or cut each other and closes holes,
        gaps and hollows narrower than this, relative to the diagonal, such as 0.01
    root: where the skeleton begins, three coordinates or "thickest", "lowest", "longest": the parents of branches in
        `report` follow from it, and of a scan of a tree the trunk begins there; by default, trees begin at their lowest
        points
    literal: published method: as printed where the default differs
    separators: greatest number of points from which separators are sought; 0 lets the method decide
    min_component: leave out components of fewer vertices or points, but for the largest
    join: join components into one by the shortest straight edges

    The global interpreter lock is released while this runs: threads of Python skeletonize in parallel.

    Raises ValueError if an argument cannot be obeyed, InputError, a ValueError, if the input cannot be skeletonized.
    """
    points = _rows("V", V)
    faces = None if F is None else _faces(F)
    options = _core.SkeletonizeOptions()
    for name, value, choices in (
        ("method", method, ("local", "published")),
        ("shape", shape, ("auto", "surface", "tree")),
        ("borders", borders, ("auto", "bridge", "open")),
    ):
        if value is not None:
            _check_choice(name, value, choices)
            setattr(options, name, value)
    ends = None if edges is None else _edges(edges)
    if domain is not None:
        _check_choice("domain", domain, ("graph",))
    if domain is not None or ends is not None:
        options.domain = "graph"
    options.neighbors = _count("neighbors", neighbors)
    directions = None
    if normals is not None:
        directions = _rows("normals", normals)
        if options.domain:
            raise ValueError("normals: graphs have none; leave out normals")
        if faces is not None:
            raise ValueError("normals: the normals of a mesh are those of its faces; leave out normals")
        if len(directions) != len(points):
            raise ValueError(f"normals: has {len(directions)} rows, and V {len(points)}")
    if root is not None:
        is_rule = isinstance(root, str)
        options.root = str(root) if is_rule else ",".join(map(repr, np.asarray(root, dtype=np.float64).reshape(3).tolist()))
    options.literal = literal
    options.detail = detail
    options.wrap = wrap
    options.seed = _count("seed", seed)
    options.threads = _count("threads", threads)
    options.separators = _count("separators", separators)
    options.min_component = _count("min_component", min_component)
    options.join = join
    return Skeleton(_core.skeletonize(points, faces, directions, ends, options))


def find_loops(V: npt.ArrayLike, F: npt.ArrayLike, *, seed: int = 0, min_depth: float = 0.3) -> list[Loop]:
    """Closed geodesics around the handles, tunnels and constrictions of a body: what `cscd loops` writes.

    V: vertices, a row of three coordinates each
    F: faces, a row of three or more indices of vertices each; repaired where they are no oriented manifold
    seed: of the random choice of sources
    min_depth: constrictions that are less deep are left out

    Raises InputError if this is no surface.
    """
    if not min_depth >= 0:
        raise ValueError(f"min_depth: is {min_depth}; depths are not negative")
    loops = _core.find_loops(_rows("V", V), _faces(F), _count("seed", seed), float(min_depth))
    return [Loop(kind, length, depth, np.array(points)) for kind, length, depth, points in loops]
