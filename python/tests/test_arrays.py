# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in and out: the results of the module for shapes whose skeletons are known."""

import gc
import inspect
import re
import signal
import sys
import threading
import time

import numpy as np
import pytest

import cscd
import shapes
from cscd import _core


@pytest.fixture(scope="module")
def ring():
    return cscd.skeletonize(*shapes.torus())


@pytest.fixture(scope="module")
def crossing():
    return cscd.skeletonize(*shapes.cross())


def test_the_skeleton_of_a_torus_is_its_circle(ring):
    assert len(ring.nodes) == len(ring.edges) > 10
    np.testing.assert_allclose(np.hypot(ring.nodes[:, 0], ring.nodes[:, 1]), 3, atol=0.1)
    np.testing.assert_allclose(ring.nodes[:, 2], 0, atol=0.1)
    np.testing.assert_allclose(ring.radius, 1, atol=0.1)
    assert np.all(np.isinf(ring.significance)), "a handle is never pruned"
    assert ring.warnings == [] and ring.repairs == []
    assert ring.report["genus"] == ring.report["betti_number"] == 1


def test_every_vertex_belongs_to_a_node_nearby(ring):
    V, _ = shapes.torus()
    assert ring.vertex_to_node.shape == (len(V),)
    assert ring.vertex_to_node.min() >= 0
    distances = np.linalg.norm(V - ring.nodes[ring.vertex_to_node], axis=1)
    assert np.all(distances < 1.5)


def test_a_torus_is_as_thick_as_its_tube_and_has_two_loops(ring):
    V, F = shapes.torus()
    np.testing.assert_allclose(ring.shape_diameters(), 2, atol=0.2)
    parts = ring.segment(parts=3)
    assert parts.shape == (len(F),) and set(parts) == {0, 1, 2}
    loops = cscd.find_loops(V, F)
    assert [loop.kind for loop in loops] == ["handle", "tunnel"]
    np.testing.assert_allclose([loop.length for loop in loops], [2 * np.pi, 4 * np.pi], rtol=0.02)
    for loop in loops:
        sides = np.linalg.norm(np.roll(loop.points, -1, axis=0) - loop.points, axis=1)
        assert np.isclose(sides.sum(), loop.length)


def test_applications_refuse_what_has_no_rows(ring):
    V, F = shapes.torus()
    for skeleton in (cscd.skeletonize(V), cscd.skeletonize(V[F].reshape(-1, 3), np.arange(3 * len(F)).reshape(-1, 3))):
        for call in (skeleton.shape_diameters, skeleton.segment):
            with pytest.raises(ValueError, match="repaired"):
                call()
    with pytest.raises(ValueError, match="min_depth"):
        cscd.find_loops(V, F, min_depth=-1)
    with pytest.raises(cscd.InputError):
        cscd.find_loops(np.zeros((3, 3)), [[0, 1, 2]])


def test_types_of_arrays(ring):
    assert ring.nodes.dtype == ring.radius.dtype == ring.significance.dtype == np.float64
    assert ring.edges.dtype == ring.vertex_to_node.dtype == np.int32
    assert ring.nodes.shape == (len(ring.radius), 3) and ring.edges.shape == (len(ring.significance), 2)


def test_arrays_are_no_copies_and_keep_the_skeleton_alive():
    skeleton = cscd.skeletonize(*shapes.torus())
    for name in ("nodes", "radius", "edges", "significance", "vertex_to_node"):
        array = getattr(skeleton, name)
        assert np.shares_memory(array, getattr(skeleton, name)), name
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    nodes, expected = skeleton.nodes, skeleton.nodes.copy()
    del skeleton, array
    gc.collect()
    churn = [np.full_like(expected, np.nan) for _ in range(100)]
    assert len(churn) == 100 and np.array_equal(nodes, expected)


def test_integers_lists_and_columns_are_taken(ring):
    V, F = shapes.torus()
    same = cscd.skeletonize(np.asfortranarray(V), F.astype(np.uint32).tolist())
    assert np.array_equal(same.nodes, ring.nodes)


def test_a_mesh_taken_for_a_graph_keeps_its_cycle():
    V, F = shapes.torus()
    sides = np.unique(np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)), axis=0)
    of_faces = cscd.skeletonize(V, F, domain="graph")
    of_edges = cscd.skeletonize(V, edges=sides)
    for skeleton in (of_faces, of_edges):
        assert len(skeleton.nodes) == len(skeleton.edges) > 10
        np.testing.assert_allclose(np.hypot(skeleton.nodes[:, 0], skeleton.nodes[:, 1]), 3, atol=0.3)
        assert skeleton.vertex_to_node.shape == (len(V),) and skeleton.vertex_to_node.min() >= 0
        assert skeleton.report["method"] == "graph"


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"edges": [[0, 1, 2]]}, "edges: has the shape"),
        ({"edges": [[0.0, 1.0]]}, "edges: holds float64"),
        ({"edges": [[0, 7]]}, "edges: row 0 names vertex 7"),
        ({"domain": "volume"}, "domain: must be graph, not volume"),
        ({"neighbors": 5}, 'neighbors: does not apply to points; leave it out or add domain="graph"'),
        ({"domain": "graph", "normals": np.zeros((3, 3))}, "normals: graphs have none"),
        ({"domain": "graph", "method": "published"}, "method: does not apply to graphs; leave it out"),
    ],
)
def test_what_is_wrong_with_a_graph_is_said(arguments, message):
    with pytest.raises(ValueError, match=re.escape(message)):
        cscd.skeletonize(np.eye(3), **arguments)


def test_a_soup_is_repaired_and_numbered_as_it_came(ring):
    V, F = shapes.torus()
    soup = cscd.skeletonize(V[F].reshape(-1, 3), np.arange(3 * len(F)).reshape(-1, 3))
    assert soup.repairs == [f"{3 * len(F) - len(V)} duplicate points merged"]
    assert len(soup.nodes) == len(ring.nodes)
    places = soup.nodes[soup.vertex_to_node]
    expected = ring.nodes[ring.vertex_to_node[F.ravel()]]
    np.testing.assert_allclose(places, expected, atol=1e-9)


def test_faces_that_are_turned_and_doubled_do_not_change_the_numbering(ring):
    V, F = shapes.torus()
    V = np.vstack([V, [[9, 9, 9]]])
    F = np.vstack([F[:, ::-1], F[:5]])
    repaired = cscd.skeletonize(V, F)
    assert "5 degenerate or duplicate faces removed" in repaired.repairs
    assert "1 point without faces removed" in repaired.repairs
    assert repaired.vertex_to_node[-1] == -1
    np.testing.assert_allclose(
        repaired.nodes[repaired.vertex_to_node[:-1]], ring.nodes[ring.vertex_to_node], atol=1e-9
    )


def test_a_strip_has_its_middle_as_skeleton():
    x, y = np.meshgrid(np.linspace(0, 10, 41), np.linspace(-1, 1, 9), indexing="ij")
    V = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    corner = (np.arange(40)[:, None] * 9 + np.arange(8)).reshape(-1)
    F = np.stack([corner, corner + 9, corner + 10, corner + 1], axis=-1)
    skeleton = cscd.skeletonize(V, F)
    assert np.abs(skeleton.nodes[:, 1:]).max() < 0.05
    assert np.ptp(skeleton.nodes[:, 0]) > 7
    bridged = cscd.skeletonize(V, F, borders="bridge")
    assert len(bridged.nodes) != len(skeleton.nodes)


def test_points_get_the_skeleton_of_their_surface():
    V, _ = shapes.torus(120, 48)
    skeleton = cscd.skeletonize(V)
    assert len(skeleton.nodes) == len(skeleton.edges)
    np.testing.assert_allclose(np.hypot(skeleton.nodes[:, 0], skeleton.nodes[:, 1]), 3, atol=0.2)
    assert skeleton.vertex_to_node.shape == (len(V),) and skeleton.vertex_to_node.min() >= 0
    center = 3 * V * [1, 1, 0] / np.hypot(V[:, 0], V[:, 1])[:, None]
    same = cscd.skeletonize(V, normals=V - center)
    assert len(same.nodes) == len(same.edges)


def test_a_tree_has_a_root():
    rng = np.random.default_rng(1)
    height = np.sort(rng.uniform(0, 10, 4000))
    angle = rng.uniform(0, 2 * np.pi, 4000)
    V = np.stack([0.2 * np.cos(angle), 0.2 * np.sin(angle), height], axis=1)
    skeleton = cscd.skeletonize(V, shape="tree", root=(0, 0, 10))
    assert skeleton.report["method"] == "tree"
    assert skeleton.nodes[0, 2] > 5, "the trunk begins at the root"


def test_python_goes_on_meanwhile():
    V, F = shapes.torus(400, 160)
    begin_and_end = []

    def work():
        begin_and_end.append(time.perf_counter())
        cscd.skeletonize(V, F, threads=1)
        begin_and_end.append(time.perf_counter())

    thread = threading.Thread(target=work)
    thread.start()
    ticks = []
    while thread.is_alive():
        ticks.append(time.perf_counter())
        time.sleep(0)
    begin, end = begin_and_end
    longest_pause = np.diff([begin, *(t for t in ticks if begin < t < end), end]).max()
    assert longest_pause < 0.5 * (end - begin)


def test_detail(crossing):
    assert len(cscd.skeletonize(*shapes.cross(), detail=0).nodes) < len(crossing.nodes)


def test_branches_and_networkx(crossing):
    networkx = pytest.importorskip("networkx")
    branches = crossing.branches()
    assert sum(len(branch.nodes) - 1 for branch in branches) == len(crossing.edges)
    graph = crossing.to_networkx()
    assert type(graph) is networkx.Graph
    assert sum(degree == 1 for _, degree in graph.degree) == 4
    assert graph.size(weight="length") == pytest.approx(sum(branch.length for branch in branches))
    assert networkx.is_tree(graph)
    for a, b in crossing.edges[:5]:
        assert graph.edges[a, b]["significance"] > 0
    assert np.array_equal(graph.nodes[3]["position"], crossing.nodes[3])
    for branch in branches:
        assert 0 < branch.min_radius <= branch.mean_radius <= branch.max_radius < 1
        assert set(branch.ends) <= {"tip", "junction"}
        assert 0 < branch.chord <= branch.length * (1 + 1e-12)
        assert branch.length == pytest.approx(
            np.linalg.norm(np.diff(crossing.nodes[branch.nodes], axis=0), axis=1).sum()
        )


def test_simplify(crossing):
    before = crossing.nodes.copy()
    finite = crossing.significance[np.isfinite(crossing.significance)]
    path = crossing.simplify(min_significance=2 * finite.max())
    assert (np.bincount(path.edges.ravel()) == 1).sum() == 2, "the last branch of a tree stays"
    assert path.vertex_to_node.min() >= 0 and path.vertex_to_node.max() < len(path.nodes)
    sparse = crossing.simplify(spacing=1.0)
    assert len(sparse.nodes) < len(crossing.nodes)
    assert np.array_equal(crossing.nodes, before)
    with pytest.raises(ValueError, match="^min_length: must be a number that is at least 0, not -1"):
        crossing.simplify(min_length=-1)
    with pytest.raises(ValueError, match="^spacing_over_radius: must be"):
        crossing.simplify(spacing_over_radius=np.nan)


def test_evaluate(ring):
    measures = ring.evaluate(resolution=50)
    assert measures["has_topology_of_surface"] is True
    assert measures["position"]["fraction_of_nodes_inside"] == 1
    assert measures["limbs"]["number_of_limbs"] == 0 and measures["tip_recall"] is None
    assert ring.evaluate(resolution=50, radii="own")["radii"] == "own"


def test_save(ring, tmp_path):
    ring.save(tmp_path / "ring.graph")
    lines = (tmp_path / "ring.graph").read_text().split("\n")
    positions = np.array([line.split()[1:] for line in lines if line.startswith("n ")], dtype=float)
    assert np.array_equal(positions, ring.nodes)
    ring.save(str(tmp_path / "ring.html"))
    assert "THREE" in (tmp_path / "ring.html").read_text()
    ring.save(tmp_path / "ring.glb")
    assert (tmp_path / "ring.glb").read_bytes()[:4] == b"glTF"
    with pytest.raises(cscd.FileError, match="ring.xyz"):
        ring.save(tmp_path / "ring.xyz")
    for name in ("ring.json", "ring.html"):
        with pytest.raises(cscd.FileError, match="cannot be written"):
            ring.save(tmp_path / "nowhere" / name)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["ring.glb", "ring.graph", "ring.html"]


def test_show(ring, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    name = ring.show()
    assert opened == ["file://" + name]
    with open(name, encoding="utf-8") as page:
        assert page.read().startswith("<!doctype html>")
    assert ring._repr_html_().startswith('<iframe srcdoc="&lt;!doctype html&gt;')


@pytest.mark.parametrize(
    "V, F, words",
    [
        ([[0, 0, 0]], None, "points"),
        ([[0, 0], [1, 0]], None, "V: has the shape"),
        ([[0, 0, np.nan]], None, "V: row 0: a coordinate is not finite"),
        (np.eye(3), [[0, 1, 3]], "F: row 0 names vertex 3, and V has rows 0 to 2"),
        (np.eye(3), [[0, 1, -1]], "F: row 0 names vertex -1"),
        (np.eye(3), [[0, 1]], "F: has the shape"),
        (np.eye(3), [[0.0, 1.0, 2.0]], "F: holds float64"),
        (np.eye(3), np.zeros((0, 3), dtype=int), "F: has no rows; leave it out for points"),
        (np.zeros((3, 3)), [[0, 1, 2]], "mesh: "),
        (np.zeros((0, 3)), None, "points: "),
    ],
)
def test_what_cannot_be_skeletonized_is_refused(V, F, words):
    with pytest.raises(ValueError) as refusal:
        cscd.skeletonize(V, F)
    assert words in str(refusal.value)


@pytest.mark.parametrize(
    "arguments, words",
    [
        ({"method": "best"}, "method: must be local or published, not best"),
        ({"detail": 2}, "detail: must be a number from 0 to 1, not 2"),
        ({"detail": 0.4, "method": "published"}, "detail: does not apply to the published method; leave it out"),
        ({"shape": "tree"}, 'shape="tree": does not apply to meshes; leave it out'),
        ({"seed": -1}, "seed: must be an integer that is at least 0, not -1"),
        ({"seed": 0.5}, "seed: must be an integer that is at least 0, not 0.5"),
        ({"root": (1, 2)}, "cannot reshape"),
        ({"root": "deepest"}, "root: must be X,Y,Z, thickest, lowest or longest, not deepest"),
        ({"normals": np.eye(3)}, "leave out normals"),
    ],
)
def test_arguments_that_cannot_be_obeyed_are_refused(arguments, words):
    with pytest.raises(ValueError) as refusal:
        cscd.skeletonize(*shapes.torus(), **arguments)
    assert words in str(refusal.value) and "--" not in str(refusal.value)


def test_signatures_are_those_of_the_program():
    arrays = {"V", "F", "normals", "edges", "progress", "self", "stays_inside"}
    for function, table in (
        (cscd.skeletonize, _core.skeletonize_options),
        (cscd.Skeleton.simplify, _core.simplify_options),
        (cscd.Skeleton.evaluate, _core.evaluate_options),
    ):
        parameters = inspect.signature(function).parameters
        defaults = {
            name: "" if parameter.default is None else str(parameter.default).lower()
            for name, parameter in parameters.items()
            if name not in arrays
        }
        assert defaults == {name: default for name, default, *_ in table}
        for name, _, _, text in table:
            assert f" {name}: {text}" in function.__doc__


def test_branches_have_parents_orders_and_volumes():
    V, F = shapes.cross()
    rooted = cscd.skeletonize(V, F, root=(-4, 0, 0))
    branches = rooted.branches()
    assert [branch.parent for branch in branches].count(None) == 1
    for number, branch in enumerate(branches):
        assert branch.parent is None or branch.order == branches[branch.parent].order + 1, number
    # Two bars of the length 8 and the section 1 x 1 share a cube.
    assert sum(branch.volume for branch in branches) == pytest.approx(15)
    assert sum(branch.surface_area for branch in branches) == pytest.approx(4 * 3.5 * 4 + 4 + 2)
    coarse = rooted.simplify(spacing=1.0)
    assert sum(branch.volume for branch in coarse.branches()) == pytest.approx(15)
    assert {branch.order for branch in coarse.branches()} == {branch.order for branch in branches}
    lowest = rooted.simplify(root=(0, -4, 0)).branches()
    root = next(branch for branch in lowest if branch.order == 0)
    assert min(rooted.nodes[root.nodes][:, 1]) < -3
    bare = cscd.skeletonize(V, F).branches()
    assert all(branch.parent is None and branch.order is None for branch in bare)
    assert all(np.isnan(branch.volume) for branch in cscd.skeletonize(V, F, domain="graph").branches())


def test_networkx_is_asked_for(ring, monkeypatch):
    monkeypatch.setitem(sys.modules, "networkx", None)
    with pytest.raises(ImportError, match="install it"):
        ring.to_networkx()


def test_faces_of_different_sizes_end_with_minus_one(ring):
    V, quads = shapes.torus_of_quads()
    triangles = np.concatenate([quads[:9, [0, 1, 2]], quads[:9, [0, 2, 3]]])
    mixed = np.concatenate([np.column_stack([triangles, np.full(18, -1)]), quads[9:]])
    skeleton = cscd.skeletonize(V, mixed)
    assert skeleton.repairs == ["1431 polygons triangulated"]
    assert len(skeleton.nodes) == len(skeleton.edges)


def test_progress_is_reported_and_can_end_the_work():
    calls = []
    cscd.skeletonize(*shapes.torus(), progress=lambda *call: calls.append(call))
    stages = list(dict.fromkeys(stage for stage, _ in calls))
    assert stages == ["compile surface", "find separators", "pack separators", "build skeleton"]
    assert all(0 <= fraction <= 1 for _, fraction in calls) and calls[-1][1] == 1

    def stop(stage, fraction):
        if stage == "find separators":
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        cscd.skeletonize(*shapes.torus(), progress=stop)


def test_ctrl_c_ends_the_work():
    V, F = shapes.torus(400, 160)
    timer = threading.Timer(0.1, signal.raise_signal, [signal.SIGINT])
    begin = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        cscd.skeletonize(V, F, threads=1)
    interrupted = time.perf_counter() - begin
    begin = time.perf_counter()
    cscd.skeletonize(V, F, threads=1)
    assert interrupted < time.perf_counter() - begin
