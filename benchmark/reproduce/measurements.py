# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Reads the output of Google Benchmark, and describes the machine and the build."""

import json
import math
import pathlib
import re
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPTIONS_IN_NAMES = re.compile(r"/(process_time|real_time|manual_time|repeats:\d+|iterations:\d+|min_time:[\d.]+)\b")


def read_runs(path):
    """Returns the context of a JSON file of Google Benchmark and, by benchmark, its runs: one for each repetition."""
    content = json.loads(pathlib.Path(path).read_text())
    runs = {}
    for run in content["benchmarks"]:
        if run.get("run_type", "iteration") == "iteration" and not run.get("error_occurred"):
            name = OPTIONS_IN_NAMES.sub("", run.get("run_name", run["name"]))
            runs.setdefault(name, []).append(run)
    return content["context"], runs


def read_medians(path):
    """Returns the context and, by benchmark, the median over the repetitions of every number."""
    context, runs = read_runs(path)
    medians = {}
    for name, repetitions in runs.items():
        numbers = [key for key, value in repetitions[0].items() if isinstance(value, (int, float))]
        medians[name] = {key: statistics.median(run[key] for run in repetitions) for key in numbers}
    return context, medians


def number_of_repetitions(path):
    """The largest number of repetitions of any benchmark."""
    return max(map(len, read_runs(path)[1].values()))


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=True).stdout.strip()


def processor():
    """The model's name, on Linux."""
    information = pathlib.Path("/proc/cpuinfo")
    text = information.read_text() if information.exists() else ""
    found = re.search(r"^model name\s*:\s*(.*)$", text, re.MULTILINE)
    return found.group(1) if found else "unknown processor"


def commit():
    """The commit that is checked out, and whether the measured code was changed since."""
    name = output("git", "rev-parse", "--short", "HEAD")
    changes = output("git", "status", "--porcelain", "--", "include", "src", "benchmark", "test/support",
                     ":!benchmark/*.py", ":!benchmark/*.sh", ":!benchmark/*.md")
    return name + (" with local changes" if changes else "")


def cache_of(build_dir):
    """The entries of CMake's cache."""
    text = (pathlib.Path(build_dir) / "CMakeCache.txt").read_text()
    return dict(re.findall(r"^([^#/\n][^:=\n]*):[^=\n]*=(.*)$", text, re.MULTILINE))


def compiler(build_dir):
    """The name and version of the compiler, and the flags that the cache of CMake holds."""
    cache = cache_of(build_dir)
    version = output(cache["CMAKE_CXX_COMPILER"], "--version").splitlines()[0]
    build_type = cache.get("CMAKE_BUILD_TYPE", "")
    flags = [cache.get("CMAKE_CXX_FLAGS", ""), cache.get(f"CMAKE_CXX_FLAGS_{build_type.upper()}", "")]
    return version, " ".join(filter(None, flags))


def circumstances(context, command, repetitions, build_dir):
    """A sentence on the time, the machine and the build of the measurements."""
    version, flags = compiler(build_dir)
    load = context.get("load_avg") or [math.nan]
    runs = "one run" if repetitions == 1 else f"medians of {repetitions} runs"
    return (f"Made by `{command}` on {context['date'][:10]} at commit {commit()}: {runs}, {version}, `{flags}`, "
            f"{processor()}, {context['num_cpus']} cores, load average {load[0]:.1f} at the start.")
