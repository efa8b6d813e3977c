# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Measures what it costs to compile programs that use the library, and writes the table of doc/performance.md.

Usage: compile_time.py [--rounds N] [--revision REVISION] [--parts] [--print]
Each file is compiled N times, by default 1, by $CXX or g++, one at a time, header-only and with the macro CSCD_COMPILED
that the target CSCD::compiled defines. With --revision, header-only columns of that revision of the repository stand
beside them for one call and for the program of the README. With --parts the files of src/ follow, which take as long as
all others together. With --print the table goes to standard output only.
"""

import argparse
import datetime
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

from markdown_tables import markdown, replace_between_markers
from measurements import ROOT, commit, output, processor

COMPILER = os.environ.get("CXX", "g++")
# The options of the target CSCD::CSCD with oneTBB; -frounding-math comes from the target CGAL::CGAL.
FLAGS = ["-std=c++17", "-O2", "-frounding-math", "-DCGAL_LINKED_WITH_TBB"]
EIGEN = pathlib.Path("/usr/include/eigen3")
COMPILED = "-DCSCD_COMPILED"
CALL = "benchmark/compile_time/call.cpp"
ONE_CALL = "one call, of a `Surface_mesh`"
README_PROGRAM = "the program of the README"
COMPARED = [ONE_CALL, README_PROGRAM]
# The compiled programs, by the name in the table: the file, its macros, and whether it uses the library.
PROGRAMS = {
    "`CGAL/Surface_mesh.h` alone": (CALL, ["NUMBER_OF_MESH_TYPES=0"], False),
    ONE_CALL: (CALL, ["NUMBER_OF_MESH_TYPES=1"], True),
    "… with `CGAL/Polyhedron_3.h` included": (CALL, ["NUMBER_OF_MESH_TYPES=1", "WITH_POLYHEDRON"], True),
    "… and a call of a `Polyhedron_3`": (CALL, ["NUMBER_OF_MESH_TYPES=2", "WITH_POLYHEDRON"], True),
    "… and a call with a point map of another type": (CALL, ["NUMBER_OF_MESH_TYPES=3", "WITH_POLYHEDRON"], True),
    README_PROGRAM: ("examples/readme_example.cpp", [], True),
}


def compile_once(source, macros, root):
    """Returns the CPU seconds and the megabytes (10^6 bytes) of one compilation, without those of the linker."""
    command = [COMPILER, *FLAGS, *(f"-D{macro}" for macro in macros), f"-I{root / 'include'}", f"-I{root / 'src'}",
               "-isystem", str(EIGEN), "-c", "-o", os.devnull, str(source)]
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit("compile_time.py: this failed: " + " ".join(command))
    return usage.ru_utime, usage.ru_maxrss / 1000


def measure(jobs, rounds):
    """The median of the seconds, and the largest memory, of each job. Rounds go through all jobs."""
    results = {job: [] for job in jobs}
    for _ in range(rounds):
        for job, arguments in jobs.items():
            results[job].append(compile_once(*arguments))
    return {job: (statistics.median(seconds for seconds, _ in runs), max(memory for _, memory in runs))
            for job, runs in results.items()}


def cells(result):
    return [f"{result[0]:.1f}", f"{result[1]:,.0f}"] if result else ["–", "–"]


def jobs_of(root, revision_root, with_parts):
    """The compilations, by the name of the row and the column."""
    jobs = {}
    for name, (source, macros, uses_library) in PROGRAMS.items():
        jobs[name, "header-only"] = (root / source, macros, root)
        if uses_library:
            jobs[name, "compiled"] = (root / source, [*macros, COMPILED.removeprefix("-D")], root)
            if revision_root and name in COMPARED:
                jobs[name, "revision"] = (root / source, macros, revision_root)
    for source in sorted((root / "src").rglob("*.cpp")) if with_parts else []:
        jobs[f"`{source.relative_to(root)}`, once", "compiled"] = (source, [COMPILED.removeprefix("-D")], root)
    return jobs


def table(results, revision):
    head = ["what is compiled", "header-only: CPU s", "MB", "`CSCD::compiled`: CPU s", "MB"]
    columns = ["header-only", "compiled"]
    if revision:
        head += [f"header-only at {revision}: CPU s", "MB"]
        columns.append("revision")
    names = dict.fromkeys(name for name, _ in results)
    return markdown(head, [[name] + [cell for column in columns for cell in cells(results.get((name, column)))]
                           for name in names])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--revision")
    parser.add_argument("--parts", action="store_true")
    parser.add_argument("--print", action="store_true")
    arguments = parser.parse_args()

    load = os.getloadavg()[0]
    revision = output("git", "rev-parse", "--short", arguments.revision) if arguments.revision else None
    with tempfile.TemporaryDirectory() as folder:
        revision_root = None
        if revision:
            revision_root = pathlib.Path(folder) / "revision"
            output("git", "worktree", "add", "--detach", str(revision_root), revision)
        try:
            results = measure(jobs_of(ROOT, revision_root, arguments.parts), arguments.rounds)
        finally:
            if revision_root:
                shutil.rmtree(revision_root)
                output("git", "worktree", "prune")
    text = table(results, revision)
    version = output(COMPILER, "--version").splitlines()[0]
    circumstances = (f"Made by `benchmark/reproduce/compile_time.sh` on {datetime.date.today()} at commit {commit()}: medians of "
                     f"{arguments.rounds} runs, {version}, `{' '.join(FLAGS)}`, {processor()}, {os.cpu_count()} cores, "
                     f"load average {load:.1f} at the start.")
    print(circumstances, text, sep="\n\n")
    if not arguments.print:
        replace_between_markers(ROOT / "doc/performance.md",
                                {"circumstances_of_compile_time": circumstances, "compile_time": text})


if __name__ == "__main__":
    main()
