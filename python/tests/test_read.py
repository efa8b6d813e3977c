# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files in: meshes, points, skeletons and graphs as arrays."""

import gzip

import numpy as np
import pytest

import cscd
import shapes

SQUARE_AND_TRIANGLE = """OFF
5 2 0
0 0 0
1 0 0
1 1 0
0 1 0
2 0 0
4 0 1 2 3
3 1 4 2
"""


def test_a_mesh_is_read(tmp_path):
    (tmp_path / "two.off").write_text(SQUARE_AND_TRIANGLE)
    shape = cscd.read(tmp_path / "two.off")
    assert shape.vertices.dtype == np.float64 and shape.vertices.shape == (5, 3)
    assert shape.faces.dtype == np.int64
    assert shape.faces.tolist() == [[0, 1, 2, 3], [1, 4, 2, -1]]
    assert shape.normals is None and shape.edges is None and shape.radius is None
    (tmp_path / "two.off.gz").write_bytes(gzip.compress(SQUARE_AND_TRIANGLE.encode()))
    assert np.array_equal(cscd.read(str(tmp_path / "two.off.gz")).faces, shape.faces)


def test_points_are_read_with_their_normals(tmp_path):
    (tmp_path / "two.xyz").write_text("0 0 0 0 0 1\n1 2 3 0 1 0\n")
    shape = cscd.read(tmp_path / "two.xyz")
    assert shape.vertices.tolist() == [[0, 0, 0], [1, 2, 3]]
    assert shape.normals.tolist() == [[0, 0, 1], [0, 1, 0]]
    assert shape.faces is None and shape.edges is None


@pytest.mark.parametrize("ending", ["graph", "json", "obj", "ply", "polylines.txt", "swc", "vtp"])
def test_skeletons_are_read_back(ending, tmp_path):
    skeleton = cscd.skeletonize(*shapes.torus())
    skeleton.save(tmp_path / f"ring.{ending}")
    shape = cscd.read(tmp_path / f"ring.{ending}")
    assert shape.faces is None
    assert sorted(map(tuple, shape.vertices)) == sorted(map(tuple, skeleton.nodes))
    assert shape.edges.shape == skeleton.edges.shape and shape.edges.dtype == np.int64
    lengths = np.linalg.norm(shape.vertices[shape.edges[:, 0]] - shape.vertices[shape.edges[:, 1]], axis=1)
    expected = np.linalg.norm(skeleton.nodes[skeleton.edges[:, 0]] - skeleton.nodes[skeleton.edges[:, 1]], axis=1)
    np.testing.assert_allclose(np.sort(lengths), np.sort(expected), rtol=1e-12)
    if ending in ("json", "ply", "swc", "vtp"):
        np.testing.assert_allclose(np.sort(shape.radius), np.sort(skeleton.radius), rtol=1e-12)
    else:
        assert shape.radius is None


def test_faces_and_lines_of_one_file_are_both_read(tmp_path):
    (tmp_path / "both.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 1 4\nf 1 2 3\n")
    shape = cscd.read(tmp_path / "both.obj")
    assert shape.faces.tolist() == [[0, 1, 2]] and shape.edges.tolist() == [[0, 3]]


@pytest.mark.parametrize(
    "name, words",
    [("none.off", "cannot be opened"), ("short.off", "short.off"), ("shape.dxf", "names no known format")],
)
def test_files_that_cannot_be_read_are_refused(name, words, tmp_path):
    (tmp_path / "short.off").write_text("OFF\n3 1 0\n0 0 0\n")
    (tmp_path / "shape.dxf").write_text("0")
    with pytest.raises(cscd.FileError, match=words):
        cscd.read(tmp_path / name)
