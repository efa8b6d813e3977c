# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Measures a small fixed set of benchmarks into a new file of benchmark/results, as Google Benchmark writes them.

Usage: record_results.py BUILD_FOLDER ROUNDS; or record_results.py --programs, which prints the programs to build.
Each round runs every benchmark once, so that a machine that is busy for a while slows all of them alike. To the context
are added commit, processor, compiler, flags and the load at the end; what names the machine or its folders is left out.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

from measurements import ROOT, commit, compiler, processor

# What is measured of each program. Of CGAL's code there is some as a control, since it does not change with ours.
SET = {
    "benchmark_skeletonization": "^mesh/(elephant|knot1|homer|camel|armadillo)/CSCD/|^mesh/(elephant|camel)/MCF/"
                                 "|^growing/elephant_3/CSCD/",
    "benchmark_stages": "/50000$",
    "benchmark_geodesics": "^(prepare|one_by_one|together|prepare_cgal|cgal_one_by_one)/elephant$",
    "benchmark_points": "^growing/armadillo/20000/",
    "benchmark_published": "^method/elephant/published/|^method/camel/flips, 500 sources/",
}
LEFT_OUT = ("executable", "host_name")  # of the context


def measure(program, build_dir):
    """Runs the benchmarks of one program once. Returns the context and the runs."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "results.json"
        subprocess.run([build_dir / "bin" / "benchmark" / program, f"--benchmark_filter={SET[program]}",
                        "--benchmark_min_time=0.1", f"--benchmark_out={path}", "--benchmark_out_format=json"],
                       stdout=subprocess.DEVNULL, check=True)
        content = json.loads(path.read_text())
    runs = [run for run in content["benchmarks"] if run["run_type"] == "iteration"]
    if not runs:
        sys.exit(f"{program} has no benchmark called {SET[program]}")
    for run in runs:
        run["name"] = run["run_name"] = f"{program.removeprefix('benchmark_')}/{run['run_name']}"
    return content["context"], runs


def record(build_dir, rounds):
    context, runs = None, []
    for repetition in range(rounds):
        print(f"round {repetition + 1} of {rounds}", flush=True)
        for program in SET:
            own_context, own_runs = measure(program, build_dir)
            context = context or own_context
            for run in own_runs:
                run.update(repetitions=rounds, repetition_index=repetition)
            runs += own_runs
    for key in LEFT_OUT:
        context.pop(key, None)
    version, flags = compiler(build_dir)
    context.update(commit=commit(), processor=processor(), compiler=version, flags=flags,
                   load_avg_at_end=os.getloadavg())
    return context, runs


def write(path, context, runs):
    """One line a run."""
    lines = ",\n".join(json.dumps(run) for run in sorted(runs, key=lambda run: run["name"]))
    path.parent.mkdir(exist_ok=True)
    path.write_text(f'{{"context": {json.dumps(context, indent=2)},\n"benchmarks": [\n{lines}\n]}}\n')


def main():
    if sys.argv[1:] == ["--programs"]:
        print(*SET)
        return
    build_dir, rounds = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    context, runs = record(build_dir, rounds)
    name = f"{context['date'][:10]}_{context['commit'].replace(' with local changes', '_changed')}.json"
    path = ROOT / "benchmark" / "results" / name
    write(path, context, runs)
    print(path)


if __name__ == "__main__":
    main()
