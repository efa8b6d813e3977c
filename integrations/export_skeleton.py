#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: export_skeleton.py SKELETON.json OUTPUT [--scale S] [--segment N]

Writes a skeleton in .json, as cscd writes it, for other tools. OUTPUT is a file .mrk.json for 3D Slicer, with a curve
of markups for each branch, or else a folder of precomputed skeletons for Neuroglancer."""

import argparse
import array
import json
import pathlib
import sys

SCHEMA = ("https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
          "markups-schema-v1.0.3.json#")


def slicer_markup(number, branch, nodes, scale):
    """A curve in the coordinates of files, left, posterior, superior; the radius is a measurement at each point."""
    is_closed = branch["ends"][0] == "closed"
    path = branch["nodes"][: -1 if is_closed else None]
    points = [{"id": str(i + 1), "label": f"branch {number}, node {node}", "positionStatus": "defined",
               "position": [scale * x for x in nodes[node]["point"]]} for i, node in enumerate(path)]
    radii = [scale * nodes[node]["radius"] for node in path]
    return {"type": "ClosedCurve" if is_closed else "Curve", "coordinateSystem": "LPS", "coordinateUnits": "mm",
            "controlPoints": points,
            "measurements": [{"name": "Radius", "enabled": True, "units": "mm", "controlPointValues": radii}]}


def write_slicer(skeleton, output, scale):
    markups = [slicer_markup(number, branch, skeleton["nodes"], scale)
               for number, branch in enumerate(skeleton["branches"])]
    output.write_text(json.dumps({"@schema": SCHEMA, "markups": markups}, indent=1), encoding="utf-8")


def little_endian(letter, rows):
    values = array.array(letter, (value for row in rows for value in row))
    if sys.byteorder == "big":
        values.byteswap()
    return values.tobytes()


def write_neuroglancer(skeleton, folder, scale, segment):
    """Adds the skeleton of a segment to a folder; its file `info` is the same for all segments."""
    nodes, edges = skeleton["nodes"], skeleton["edges"]
    info = {"@type": "neuroglancer_skeletons", "transform": [scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0],
            "vertex_attributes": [{"id": "radius", "data_type": "float32", "num_components": 1}]}
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "info").write_text(json.dumps(info), encoding="utf-8")
    (folder / str(segment)).write_bytes(
        little_endian("I", [(len(nodes), len(edges))]) + little_endian("f", (node["point"] for node in nodes))
        + little_endian("I", edges) + little_endian("f", ((node["radius"],) for node in nodes)))


def main():
    summary, _, description = __doc__.partition("\n\n")
    parser = argparse.ArgumentParser(usage=summary.partition(" ")[2], description=description)
    parser.add_argument("skeleton", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--scale", type=float, default=1, help="millimeters for Slicer, nanometers for Neuroglancer")
    parser.add_argument("--segment", type=int, default=1, help="number of the segment for Neuroglancer")
    given = parser.parse_args()
    try:
        skeleton = json.loads(given.skeleton.read_text(encoding="utf-8"))
        if "branches" not in skeleton:
            raise ValueError("it has no radii; write the file by cscd skeletonize")
        if given.output.name.endswith(".mrk.json"):
            write_slicer(skeleton, given.output, given.scale)
        else:
            write_neuroglancer(skeleton, given.output, given.scale, given.segment)
    except (OSError, ValueError) as error:
        sys.exit(f"{given.skeleton}: {error}")


if __name__ == "__main__":
    main()
