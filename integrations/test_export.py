# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_export.py SKELETON.json FOLDER: exports a skeleton, and reads it again."""

import json
import pathlib
import struct
import subprocess
import sys

SKELETON, FOLDER = map(pathlib.Path, sys.argv[1:])


def export(*arguments):
    script = pathlib.Path(__file__).parent / "export_skeleton.py"
    return subprocess.run([sys.executable, script, *map(str, arguments)], capture_output=True, text=True, check=False)


def main():
    skeleton = json.loads(SKELETON.read_text(encoding="utf-8"))
    nodes, edges, branches = (skeleton[name] for name in ("nodes", "edges", "branches"))
    output = FOLDER / "skeleton.mrk.json"
    assert export(SKELETON, output, "--scale", 2).returncode == 0, "Slicer: written"
    curves = json.loads(output.read_text(encoding="utf-8"))["markups"]
    pairs = [(curve, branch) for curve, branch in zip(curves, branches) if curve["type"] == "Curve"]
    assert len(curves) == len(branches) and pairs, f"Slicer: {len(curves)} curves"
    for curve, branch in pairs:
        places = [[2 * x for x in nodes[node]["point"]] for node in branch["nodes"]]
        radii = [2 * nodes[node]["radius"] for node in branch["nodes"]]
        assert [point["position"] for point in curve["controlPoints"]] == places, "Slicer: positions"
        assert curve["measurements"][0]["controlPointValues"] == radii, "Slicer: radii"
    assert export(SKELETON, FOLDER / "precomputed", "--segment", 7).returncode == 0, "Neuroglancer: written"
    content = (FOLDER / "precomputed/7").read_bytes()
    n, m = struct.unpack_from("<2I", content)
    assert (n, m) == (len(nodes), len(edges)) and len(content) == 8 + 16 * n + 8 * m, f"Neuroglancer: {n} nodes"
    ends = list(struct.unpack_from(f"<{2 * m}I", content, 8 + 12 * n))
    assert ends == [end for edge in edges for end in edge], "edges"
    radii = struct.unpack_from(f"<{n}f", content, 8 + 12 * n + 8 * m)
    assert all(abs(a - node["radius"]) < 1e-6 * a for a, node in zip(radii, nodes)), "radii"
    refused = export(output, FOLDER / "other")
    assert refused.returncode == 1 and "no radii" in refused.stderr, f"refused: {refused.stderr.strip()}"


main()
