# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tutorial runs as it stands, the reference has the docstrings, annotations and stubs are those of the module."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

TUTORIAL = pathlib.Path(__file__).parents[2] / "doc" / "python.md"
MESHES = os.environ.get("CSCD_CGAL_DATA_DIR")


@pytest.mark.skipif(MESHES is None, reason="CSCD_CGAL_DATA_DIR is not set")
def test_the_tutorial_runs(tmp_path, monkeypatch, capsys):
    shutil.copy(pathlib.Path(MESHES) / "elephant.off", tmp_path)
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", TUTORIAL.read_text(encoding="utf-8"), re.DOTALL)
    names = {}
    for block in blocks:
        exec(block, names)
    assert names["measures"]["has_topology_of_surface"] is True
    assert names["soup"].nodes.shape == names["skeleton"].nodes.shape
    assert len(names["coarse"].branches()) < len(names["skeleton"].branches())
    assert {path.name for path in tmp_path.iterdir()} == {"elephant.off", "elephant.html", "elephant.swc", "elephant.glb"}
    assert "F: has the shape" in capsys.readouterr().out


def test_the_reference_is_up_to_date():
    script = TUTORIAL.with_name("write_python_reference.py")
    command = [sys.executable, script, "--check"]
    outcome = subprocess.run(command, capture_output=True, text=True, timeout=100, check=False)
    assert outcome.returncode == 0, outcome.stderr


# Members that pybind11 adds to its classes, and a module that is imported for annotations only.
NOT_COMPARED = ["cscd.networkx", "cscd._core.Skeleton", "cscd._core.Skeleton.__init__"]


@pytest.mark.parametrize(
    "arguments", [["mypy", "--strict", "-p", "cscd"], ["mypy.stubtest", "--allowlist", "not_compared", "cscd"]]
)
def test_types(arguments, tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "not_compared").write_text("\n".join(NOT_COMPARED))
    outcome = subprocess.run(
        [sys.executable, "-m", *arguments],
        env={**os.environ, "MYPYPATH": os.environ.get("PYTHONPATH", "")},
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr
