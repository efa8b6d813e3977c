# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Runs several skeletonizers on the same meshes and prints one table, a line for each mesh and skeletonizer.

Seconds are those of the processor, memory is the largest resident size, both of the whole command with reading and
writing; memory below what Python itself has, about 17 MB, cannot be told. Cycles stand beside the genus; errors are the
mean distances of the round cones' and the convolution surface from the mesh, in thousandths of the diagonal of the
bounding box, by cscd evaluate.
"""

import argparse
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import threading

from measure_quality import Failure, evaluate

COLUMNS = ("mesh", "vertices", "skeletonizer", "CPU s", "MB", "cycles : genus", "components", "nodes", "inside, %",
           "cone error", "convolution error")


def run_measured(command, timeout):
    """Runs a command of the shell; returns its seconds of the processor and its memory in MB."""
    process = subprocess.Popen(["sh", "-c", "exec " + command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    timer = threading.Timer(timeout, process.kill)
    timer.start()
    _, status, usage = os.wait4(process.pid, 0)
    is_late = timer.finished.is_set()
    timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)  # it has been waited for
    if is_late:
        raise Failure(f"more than {timeout:g} s")
    if process.returncode != 0:
        raise Failure(f"exit status {process.returncode}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def cells(options, mesh, peer, command, folder):
    """The line of a mesh and a skeletonizer."""
    name, _, ending = peer.partition(".")
    skeleton = folder / f"{name}.{ending or 'graph'}"
    try:
        seconds, megabytes = run_measured(
            command.replace("{mesh}", shlex.quote(str(mesh))).replace("{skeleton}", shlex.quote(str(skeleton))),
            options.timeout)
        measures, row = evaluate(options, mesh, skeleton)
    except Failure as failure:
        return [mesh.stem, "", name, str(failure)] + [""] * (len(COLUMNS) - 4)
    counts, position = measures["counts"], measures["position"]
    return [mesh.stem, f"{measures['number_of_points']:,}", name, f"{seconds:.2f}", f"{megabytes:.0f}",
            f"{counts['betti_number']} : {position['genus']}", str(counts["number_of_components"]),
            str(counts["number_of_nodes"]), f"{100 * row['inside']:.1f}", f"{row['cone']:.2f}",
            f"{row['convolution']:.2f}"]


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="*", metavar="MESH")
    parser.add_argument("--default", action="append", default=[], metavar="MESH", help="measured if no other is named")
    parser.add_argument("--peer", action="append", default=[], metavar="NAME[.ENDING]=COMMAND",
                        help="a skeletonizer, with {mesh} and {skeleton} for the names of files")
    parser.add_argument("--evaluator", required=True, metavar="CSCD", help="measures the skeletons")
    parser.add_argument("--resolution", type=int, default=100, help="cells along the diagonal; by default 100")
    parser.add_argument("--timeout", type=float, default=300, metavar="SECONDS", help="of each; by default 300")
    options = parser.parse_args(arguments)
    options.fast = False
    for peer in options.peer:
        if "=" not in peer or "{mesh}" not in peer or "{skeleton}" not in peer:
            parser.error(f"--peer {peer}: is not NAME=COMMAND with {{mesh}} and {{skeleton}}")
    return options


def main(arguments):
    options = parse(arguments)
    print("| " + " | ".join(COLUMNS) + " |")
    print("| --- |" + " --: |" * (len(COLUMNS) - 1))
    with tempfile.TemporaryDirectory() as folder:
        for mesh in options.meshes or options.default:
            for peer in options.peer:
                name, _, command = peer.partition("=")
                print("| " + " | ".join(cells(options, pathlib.Path(mesh), name, command, pathlib.Path(folder))) + " |",
                      flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
