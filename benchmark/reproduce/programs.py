# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Runs the program cscd and those of the benchmarks, and measures what they cost and what their skeletons are worth."""

import json
import math
import os
import pathlib
import resource
import subprocess
import tempfile
import time


class Failure(Exception):
    """A program that fails; the text says why."""


class Cost:
    """Seconds of the clock and of the processor, and the greatest memory in MB, of a program."""

    def __init__(self, wall, cpu, megabytes):
        self.wall, self.cpu, self.megabytes = wall, cpu, megabytes


MEGABYTES_PER_KIBIBYTE = 1.024e-3


def peak_of(process):
    """The greatest memory until now in MB."""
    try:
        text = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    except OSError:
        return 0
    peaks = [int(line.split()[1]) for line in text.splitlines() if line.startswith("VmHWM")]
    return MEGABYTES_PER_KIBIBYTE * max(peaks, default=0)


def run(*command, timeout=900):
    """Runs a program. Returns its standard output, and its cost."""
    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as errors:
        begin, megabytes, pid = time.monotonic(), 0, 0
        process = subprocess.Popen(list(map(str, command)), stdout=output, stderr=errors)
        while pid == 0:
            megabytes = max(megabytes, peak_of(process))
            if time.monotonic() - begin > timeout:
                process.kill()
            time.sleep(0.003)
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        wall = time.monotonic() - begin
        # Of a process that took less than this script, wait4() reports the memory of this script.
        if usage.ru_maxrss > resource.getrusage(resource.RUSAGE_SELF).ru_maxrss:
            megabytes = MEGABYTES_PER_KIBIBYTE * usage.ru_maxrss
        process.returncode = os.waitstatus_to_exitcode(status)  # it has been waited for
        output.seek(0)
        errors.seek(0)
        if wall > timeout:
            raise Failure(f"more than {timeout:g} s")
        if process.returncode != 0:
            raise Failure(" ".join([f"exit status {process.returncode}", *errors.read().strip().splitlines()[-1:]]))
        return output.read(), Cost(wall, usage.ru_utime + usage.ru_stime, megabytes)


class Laboratory:
    """The programs in the folder bin of a build, and a folder for their files."""

    def __init__(self, bin_folder, folder):
        self.cscd, self.benchmarks = bin_folder / "cscd", bin_folder / "benchmark"
        self.meshes = bin_folder.parent / "cgal_data/data/meshes"
        self.folder = pathlib.Path(folder)
        self.skeleton = self.folder / "skeleton.graph"

    def mesh(self, name):
        return self.meshes / f"{name}.off"

    def skeletonize(self, shape, *options, skeleton=None, **keywords):
        """Writes the skeleton of a file by cscd on one thread. Returns the report and the cost."""
        report = self.folder / "report.json"
        _, cost = run(self.cscd, "skeletonize", shape, "-o", skeleton or self.skeleton, "--report", report, "--quiet",
                      "--threads", "1", *options, **keywords)
        return json.loads(report.read_text()), cost

    def evaluate(self, mesh, skeleton=None, resolution=100, **keywords):
        """The measures of a skeleton. The errors of reconstructed surfaces need a resolution of 100 or more."""
        return json.loads(run(self.cscd, "evaluate", mesh, skeleton or self.skeleton, "--json", "--quiet",
                              "--resolution", resolution, **keywords)[0])

    def make(self, name, *arguments):
        """A file that make_input writes."""
        path = self.folder / name
        run(self.benchmarks / "make_input", path, *arguments)
        return path


def read_off(path):
    """The points and triangles of a mesh in OFF format, without colors."""
    lines = [line.split() for line in path.read_text().split("OFF", 1)[1].splitlines() if line.strip()]
    n, m = map(int, lines[0][:2])
    return ([tuple(map(float, line[:3])) for line in lines[1:n + 1]],
            [tuple(map(int, line[1:4])) for line in lines[n + 1:n + m + 1]])


def turns(path):
    """The turning angles in degrees of a skeleton in GEL's format, at its nodes of degree two."""
    points, neighbors = [], {}
    for line in path.read_text().splitlines():
        fields = line.split()
        if fields[:1] == ["n"]:
            points.append(tuple(map(float, fields[1:4])))
        elif fields[:1] == ["c"]:
            a, b = map(int, fields[1:3])
            neighbors.setdefault(a, []).append(b)
            neighbors.setdefault(b, []).append(a)
    result = []
    for node, around in neighbors.items():
        if len(around) == 2:
            into, out = ([b - a for a, b in zip(points[p], points[q])] for p, q in
                         ((around[0], node), (node, around[1])))
            lengths = math.hypot(*into) * math.hypot(*out)
            if lengths > 0:
                cosine = sum(a * b for a, b in zip(into, out)) / lengths
                result.append(math.degrees(math.acos(max(-1, min(1, cosine)))))
    return result
