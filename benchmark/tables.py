# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tables in Markdown: functions to make them, and the tables of benchmark_meshes.

Usage: tables.py FILE prints the table that compares skeletonizers; FILE is the JSON output of benchmark_meshes.
"""

import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
OPTIONS_IN_NAMES = re.compile(r"/(process_time|real_time|manual_time|repeats:\d+|iterations:\d+|min_time:[\d.]+)\b")
NOTHING = "–"


def markdown(head, rows):
    """A table; the first column is text, the others are numbers."""
    lines = [head, ["---"] + ["--:"] * (len(head) - 1)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def count(number):
    return f"{round(number):,}"


def replace_between_markers(path, tables):
    """Writes the tables that the page has a place for, by name: `<!-- begin NAME -->` to `<!-- end NAME -->`."""
    old = text = path.read_text()
    for name, table in tables.items():
        pattern = re.compile(rf"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)", re.DOTALL)
        text = pattern.sub(lambda match, body=table: f"{match[1]}\n{body}\n\n{match[2]}", text)
    if text != old:
        path.write_text(text)
        print(path, file=sys.stderr)


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=True).stdout.strip()


def circumstances(command, build_dir=None, repetitions=1):
    """A sentence on the command, the time, the machine and, if its folder is given, the build of measurements."""
    parts = ["one run" if repetitions == 1 else f"medians of {repetitions} runs"]
    if build_dir:
        text = (build_dir / "CMakeCache.txt").read_text()
        cache = dict(re.findall(r"^([^#/\n][^:=\n]*):[^=\n]*=(.*)$", text, re.MULTILINE))
        of_type = cache[f"CMAKE_CXX_FLAGS_{cache['CMAKE_BUILD_TYPE'].upper()}"]
        flags = f"{cache.get('CMAKE_CXX_FLAGS', '')} {of_type}".strip()
        parts += [output(cache["CMAKE_CXX_COMPILER"], "--version").splitlines()[0], f"`{flags}`"]
    processor = re.search(r"^model name\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    parts.append(processor.group(1) if processor else "unknown processor")
    commit = output("git", "rev-parse", "--short", "HEAD")
    if output("git", "status", "--porcelain", "--", "include", "src", "benchmark/**.cpp", "test/support"):
        commit += " with local changes"
    return (f"Made by `{command}` on {time.strftime('%Y-%m-%d')} at commit {commit}: {', '.join(parts)}, "
            f"{os.cpu_count()} cores, load average {os.getloadavg()[0]:.1f} at the end.")


def read_medians(path):
    """By benchmark, the medians over the repetitions of every number of a JSON file of Google Benchmark; `seconds` are
    of the processor, or those that the benchmark has set itself, and `wall_seconds` are of the clock."""
    repetitions = {}
    for run in json.loads(pathlib.Path(path).read_text())["benchmarks"]:
        if run.get("run_type", "iteration") == "iteration" and not run.get("error_occurred"):
            name = run.get("run_name", run["name"])
            run["seconds"] = run["real_time" if "/manual_time" in name else "cpu_time"] / 1000
            run["wall_seconds"] = run["real_time"] / 1000
            repetitions.setdefault(OPTIONS_IN_NAMES.sub("", name), []).append(run)
    return {name: {key: statistics.median(run[key] for run in runs) for key, value in runs[0].items()
                   if isinstance(value, (int, float))} for name, runs in repetitions.items()}


def runs_of(medians, kind):
    """The runs named `kind`/case/variant, by case and variant."""
    runs = {}
    for name, run in medians.items():
        if name.startswith(kind + "/"):
            _, case, variant = name.split("/", 2)
            runs.setdefault(case, {})[variant] = run
    return runs


def summary_table(medians):
    """All skeletonizers on each mesh."""
    meshes = runs_of(medians, "mesh")
    names = [name for name in dict.fromkeys(name for runs in meshes.values() for name in runs) if "threads" not in name]
    rows = []
    for mesh, runs in meshes.items():
        def cells(form, runs=runs):
            return [form(runs[name]) if name in runs else NOTHING for name in names]

        ours = runs["CSCD"]["seconds"]
        inside = cells(lambda run: f"{run['percent_inside']:.0f}" if "percent_inside" in run else NOTHING)
        tips = cells(lambda run: count(run["tips"]) if "tips" in run else NOTHING)
        rows.append([mesh, count(runs["CSCD"]["vertices"]), f"{ours:.3f}",
                     *cells(lambda run, ours=ours: f"{run['seconds']:.2f} ({run['seconds'] / ours:.0f})")[1:],
                     " / ".join(inside), " / ".join(tips)])
    return markdown(["mesh", "vertices", "CSCD, s", *(f"{name}, s (times as long)" for name in names[1:]),
                     "% inside: " + " / ".join(names), "tips"], rows)


def wall_times(runs):
    return " / ".join(f"{runs[name]['wall_seconds']:.3f}" for name in ("CSCD", "CSCD_2_threads"))


def mesh_table(medians):
    """Times and memory of CSCD and MCF."""
    rows = [[mesh, count(runs["CSCD"]["vertices"]), f"{runs['CSCD']['seconds']:.3f}", wall_times(runs),
             f"{runs['MCF']['seconds']:.2f}", f"{runs['CSCD']['seconds'] / runs['MCF']['seconds']:.3f}",
             " / ".join(count(runs[name]["megabytes"]) for name in ("CSCD", "MCF"))]
            for mesh, runs in runs_of(medians, "mesh").items()]
    return markdown(["mesh", "vertices", "CSCD CPU s", "wall s, 1 / 2 threads", "MCF CPU s", "CSCD : MCF",
                     "MB, CSCD / MCF"], rows)


def growth_table(medians):
    def exponent(first, last):
        return math.log(last["seconds"] / first["seconds"]) / math.log(last["vertices"] / first["vertices"])

    sizes = list(runs_of(medians, "growing").values())
    rows = [[count(runs["CSCD"]["vertices"]), f"{runs['CSCD']['seconds']:.3f}",
             f"{1e6 * runs['CSCD']['seconds'] / runs['CSCD']['vertices']:.2f}", wall_times(runs),
             count(runs["CSCD"]["megabytes"])] for runs in sizes]
    table = markdown(["vertices", "CPU s", "µs a vertex", "wall s, 1 / 2 threads", "MB"], rows)
    ours = [runs["CSCD"] for runs in sizes]
    steps = ", ".join(f"{exponent(first, last):.2f}" for first, last in zip(ours, ours[1:]))
    return (f"{table}\n\nOver the whole range, CPU time grows as the number of vertices to the power "
            f"{exponent(ours[0], ours[-1]):.2f};\nfrom one size to the next, {steps}.")


if __name__ == "__main__":
    print(summary_table(read_medians(sys.argv[1])))
