# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The module compared with the program: same skeletons, same messages. The variable CSCD_PROGRAM names the program."""

import json
import os
import subprocess

import numpy as np
import pytest

import cscd
import shapes

PROGRAM = os.environ.get("CSCD_PROGRAM")
pytestmark = pytest.mark.skipif(PROGRAM is None, reason="CSCD_PROGRAM is not set")


def write_off(path, V, F):
    with open(path, "w", encoding="ascii") as out:
        print("OFF", len(V), len(F), 0, file=out)
        np.savetxt(out, V, fmt="%.17g")
        np.savetxt(out, np.column_stack([np.full(len(F), F.shape[1]), F]), fmt="%d")


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=100, check=False)


@pytest.mark.parametrize("shape", [shapes.torus, shapes.torus_of_quads, shapes.cross])
def test_skeletons_are_the_same(shape, tmp_path):
    V, F = shape()
    write_off(tmp_path / "shape.off", V, F)
    outcome = run("skeletonize", tmp_path / "shape.off", "-o", tmp_path / "shape.json", "--report", tmp_path / "r.json")
    skeleton = cscd.skeletonize(V, F)
    document = json.loads((tmp_path / "shape.json").read_text())
    assert np.array_equal([node["point"] for node in document["nodes"]], skeleton.nodes)
    assert np.array_equal([node["radius"] for node in document["nodes"]], skeleton.radius)
    assert [branch["nodes"] for branch in document["branches"]] == [b.nodes.tolist() for b in skeleton.branches()]
    report = json.loads((tmp_path / "r.json").read_text())
    ours = skeleton.report
    for document in (report, ours):
        del document["seconds"], document["input"]
    assert ours == report
    assert outcome.stderr.splitlines() == [f"cscd: {tmp_path}/shape.off: {s}" for s in skeleton.repairs]


def test_messages_on_data_are_the_same(tmp_path):
    V, F = np.zeros((3, 3)), np.array([[0, 1, 2]])
    write_off(tmp_path / "bad.off", V, F)
    outcome = run("skeletonize", tmp_path / "bad.off")
    with pytest.raises(cscd.InputError) as refusal:
        cscd.skeletonize(V, F)
    message = str(refusal.value).replace("mesh: ", f"cscd: {tmp_path}/bad.off: ", 1)
    # The program adds a hint to an option of its own.
    assert outcome.stderr == message + "; or skeletonize its edges: --as graph\n"


def test_messages_on_arguments_are_the_same(tmp_path):
    outcome = run("skeletonize", tmp_path / "none.off", "--literal")
    with pytest.raises(ValueError) as refusal:
        cscd.skeletonize(*shapes.torus(), literal=True)
    message = outcome.stderr.removeprefix("cscd: ").removesuffix("; see cscd --help\n")
    for old, new in (("--literal", "literal"), ("--method published", 'method="published"')):
        message = message.replace(old, new)
    assert str(refusal.value) == message
