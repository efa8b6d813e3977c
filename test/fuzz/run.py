#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""One slice of the fuzz campaign: builds the fuzz targets with clang, runs each in turn from its corpus and from the
inputs that earlier slices in the same folder found, and adds what was run to the table of doc/reliability.md.

Usage: test/fuzz/run.py FOLDER [--minutes M] [--print]
An input that makes a target fail is left in FOLDER, as found_TARGET_crash-* or the like; the exit status is 1 then.
"""

import argparse
import os
import pathlib
import re
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))

from tables import markdown, replace_between_markers  # noqa: E402

PAGE = ROOT / "doc/reliability.md"
# Share of the time; the whole pipeline takes a thousand times as long for an input as a reader.
SHARES = {"read_triangle_mesh": 2, "read_points": 4, "read_skeleton": 2, "read_volume": 1,
          "use_skeleton": 3, "extract_curve_skeleton": 10}
HEAD = ["target", "executions", "edges of the code covered", "CPU minutes", "found"]


def build(folder):
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
                    "-DCMAKE_CXX_COMPILER=clang++", "-DCSCD_FUZZ=ON", "--log-level=WARNING"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", *(f"fuzz_{target}" for target in SHARES)], check=True)


def run(target, folder, build_folder, seconds):
    """Executions, edges covered, CPU minutes, and the inputs that made the target fail."""
    found = folder / f"inputs_{target}"
    found.mkdir(parents=True, exist_ok=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run([build_folder / f"bin/test/fuzz_{target}", f"-max_total_time={round(seconds)}",
                             "-print_final_stats=1", "-timeout=120", "-rss_limit_mb=4096",
                             f"-artifact_prefix={folder}/found_{target}_", found, ROOT / "test/fuzz/corpus" / target],
                            env={**os.environ, "ASAN_OPTIONS": "allocator_may_return_null=1"}, check=False,
                            stderr=subprocess.PIPE, text=True, errors="replace")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    (folder / f"log_{target}").write_text(result.stderr)
    executions = re.search(r"stat::number_of_executed_units: (\d+)", result.stderr)
    edges = re.findall(r"cov: (\d+)", result.stderr)
    minutes = (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) / 60
    failures = [path for kind in ("crash", "timeout", "oom", "leak") for path in folder.glob(f"found_{target}_{kind}-*")]
    return int(executions[1]) if executions else 0, int(edges[-1]) if edges else 0, minutes, len(failures)


def earlier_rows():
    """Executions, edges, CPU minutes and findings of each target in the page."""
    rows = {}
    for name, executions, edges, minutes, found in re.findall(
            r"^\| `fuzz_(\w+)` \| ([\d,]+) \| ([\d,]+) \| ([\d.,]+) \| (.*) \|$", PAGE.read_text(), re.MULTILINE):
        number = [float(text.replace(",", "")) for text in (executions, edges, minutes)]
        rows[name] = (int(number[0]), int(number[1]), number[2], found)
    return rows


def found(old, failed):
    """The entry of a slice with so many failing inputs, until someone replaces it by a description."""
    if failed == 0:
        return old
    new = f"{failed} failing inputs, not looked at yet"
    return new if old == "nothing" or old.endswith("not looked at yet") else f"{old}; {new}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path, help="for the build, the inputs and the logs")
    parser.add_argument("--minutes", type=float, default=20, help="of all targets together; by default 20")
    parser.add_argument("--print", action="store_true", help="leave the page as it is")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    build(folder / "build")

    rows, failures = earlier_rows(), 0
    for target, share in SHARES.items():
        seconds = 60 * arguments.minutes * share / sum(SHARES.values())
        executions, edges, minutes, failed = run(target, folder, folder / "build", seconds)
        print(f"{target}: {executions} executions, {edges} edges, {minutes:.1f} CPU minutes, {failed} failures")
        failures += failed
        old = rows.get(target, (0, 0, 0, "nothing"))
        rows[target] = (old[0] + executions, max(old[1], edges), old[2] + minutes, found(old[3], failed))
    table = markdown(HEAD, [[f"`fuzz_{target}`", f"{row[0]:,}", f"{row[1]:,}", f"{row[2]:,.1f}", row[3]]
                            for target, row in rows.items()])
    print(table)
    if not arguments.print:
        replace_between_markers(PAGE, {"fuzz": table})
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
