# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Writes the tables of doc/performance.md, doc/points.md, doc/published.md, doc/trees.md and README.md, and plots.

Usage: write_tables.py REPETITIONS FILE..., of benchmark_skeletonization.json, benchmark_stages.json,
benchmark_points.json, benchmark_published.json and benchmark_trees.json.
Tables stand between lines `<!-- begin NAME -->` and `<!-- end NAME -->`; what is between them is replaced.
"""

import json
import math
import pathlib
import re
import statistics
import subprocess
import sys

from plot import draw

ROOT = pathlib.Path(__file__).resolve().parent.parent


def read_medians(path):
    """Returns the load at the start and, by benchmark, the median over the repetitions of every number."""
    content = json.loads(pathlib.Path(path).read_text())
    runs = {}
    for run in content["benchmarks"]:
        if run["run_type"] == "iteration":
            name = re.sub(r"/(process_time|real_time|repeats:\d+|iterations:\d+)\b", "", run["run_name"])
            runs.setdefault(name, []).append(run)
    medians = {}
    for name, repetitions in runs.items():
        numbers = [key for key, value in repetitions[0].items() if isinstance(value, (int, float))]
        medians[name] = {key: statistics.median(run[key] for run in repetitions) for key in numbers}
    return content["context"], medians


def growth_exponent(points):
    """The slope of log(cost) over log(size), by least squares."""
    logarithms = [(math.log(size), math.log(cost)) for size, cost in points]
    mean_x = statistics.fmean(x for x, _ in logarithms)
    mean_y = statistics.fmean(y for _, y in logarithms)
    covariance = sum((x - mean_x) * (y - mean_y) for x, y in logarithms)
    return covariance / sum((x - mean_x) ** 2 for x, _ in logarithms)


def markdown(head, rows):
    """A table; the first column is text, the others are numbers."""
    lines = [head, ["---"] + ["--:"] * (len(head) - 1)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def seconds(run, key="cpu_time"):
    return run[key] / 1000  # the benchmarks count in milliseconds


def count(number):
    return f"{round(number):,}"


def meshes_of(medians):
    names = dict.fromkeys(name.split("/")[1] for name in medians if name.startswith("mesh/"))
    return [(mesh, *(medians.get(f"mesh/{mesh}/{who}") for who in ("CSCD", "CSCD_2_threads", "MCF"))) for mesh in names]


def both(ours, mcf, key, form):
    return f"{form(ours[key])} / {form(mcf[key]) if mcf else '–'}"


def wall_times(one, two):
    return " / ".join(f"{seconds(run, 'real_time'):.3f}" if run else "–" for run in (one, two))


def mesh_table(medians):
    rows = []
    for mesh, ours, two, mcf in meshes_of(medians):
        rows.append([
            mesh,
            count(ours["vertices"]),
            f"{seconds(ours):.3f}",
            wall_times(ours, two),
            f"{seconds(mcf):.2f}" if mcf else "–",
            f"{seconds(ours) / seconds(mcf):.3f}" if mcf else "–",
            both(ours, mcf, "megabytes", count),
        ])
    return markdown(["mesh", "vertices", "CSCD CPU s", "wall s, 1 / 2 threads", "MCF CPU s", "CSCD : MCF",
                     "MB, CSCD / MCF"], rows)


def quality_table(medians):
    rows = []
    for mesh, ours, _, mcf in meshes_of(medians):
        if "genus" in ours:
            rows.append([
                mesh,
                count(ours["genus"]),
                both(ours, mcf, "betti_number", count),
                both(ours, mcf, "percent_inside", "{:.1f}".format),
                both(ours, mcf, "nodes", count),
                both(ours, mcf, "tips", count),
            ])
    return markdown(["mesh", "genus", "cycles, CSCD / MCF", "length inside, %", "nodes", "tips"], rows)


def growth_table(medians):
    names = [name for name in medians if name.startswith("growing/") and name.endswith("/CSCD")]
    rows = []
    for name in names:
        one, two = medians[name], medians.get(name + "_2_threads")
        rows.append([
            count(one["vertices"]),
            f"{seconds(one):.3f}",
            f"{1e6 * seconds(one) / one['vertices']:.2f}",
            wall_times(one, two),
            count(one["megabytes"]),
        ])
    points = [(medians[name]["vertices"], seconds(medians[name])) for name in names]
    exponent = growth_exponent(points)
    table = markdown(["vertices", "CPU s", "µs a vertex", "wall s, 1 / 2 threads", "MB"], rows)
    steps = ", ".join(f"{growth_exponent(pair):.2f}" for pair in zip(points, points[1:]))
    return (f"{table}\n\nOver the whole range, CPU time grows as the number of vertices to the power {exponent:.2f};\n"
            f"from one size to the next, {steps}.")


def stage_table(medians):
    stages, sizes = {}, {}
    for name, run in medians.items():
        stage, shape, size = name.split("/")
        sizes.setdefault(size, f"about {count(int(size))}")
        stages.setdefault((stage, shape), []).append((run["vertices"], run["cpu_time"]))
    rows = [[f"{stage}, {shape}"] + [f"{milliseconds:.1f}" for _, milliseconds in points]
            + [f"{growth_exponent(points):.2f}"] for (stage, shape), points in stages.items()]
    return markdown(["stage, shape", *sizes.values(), "exponent"], rows)


def is_right(run):
    """Whether a skeleton has the components and cycles of the surface."""
    return run["betti_number"] == run["genus"] and run["components"] == run["surface_components"]


def clouds_of(medians):
    """The runs by mesh and sampling."""
    clouds = {}
    for name, run in medians.items():
        if name.startswith("cloud/"):
            _, mesh, sampling = name.split("/")
            clouds.setdefault(mesh, {})[sampling] = run
    return clouds


def sampling_table(medians):
    """One row for each way in which points are drawn, over all meshes."""
    clouds = clouds_of(medians)
    rows = []
    for sampling in next(iter(clouds.values())):
        runs = [runs[sampling] for runs in clouds.values()]

        def mean(number, runs=runs):
            return statistics.fmean(number(run) for run in runs)

        rows.append([
            sampling,
            f"{sum(map(is_right, runs))} of {len(runs)}",
            f"{sum(abs(run['tips'] - run['tips_of_mesh']) <= 2 for run in runs)} of {len(runs)}",
            f"{mean(lambda run: run['percent_inside']):.1f} / {mean(lambda run: run['percent_inside_of_mesh']):.1f}",
            f"{1000 * mean(lambda run: run['error']):.2f} / {1000 * mean(lambda run: run['error_of_mesh']):.2f}",
            f"{mean(seconds):.2f}",
            f"{max(map(seconds, runs)):.2f}",
        ])
    return markdown(["points", "topology right", "tips within 2 of the mesh's", "length inside, %: points / mesh",
                     "error: points / mesh", "CPU s", "largest"], rows)


def cloud_table(medians):
    """One row for each mesh: the topology of the skeletons of its clouds."""
    clouds = clouds_of(medians)
    rows = []
    for mesh, runs in clouds.items():
        cells = []
        for run in runs.values():
            topology = f"{count(run['components'])}, {count(run['betti_number'])}"
            cells.append(f"{topology if is_right(run) else f'**{topology}**'}; {count(run['tips'])}")
        run = next(iter(runs.values()))
        rows.append([mesh, f"{count(run['surface_components'])}, {count(run['genus'])}; {count(run['tips_of_mesh'])}"]
                    + cells)
    return markdown(["mesh", "of the mesh", *next(iter(clouds.values()))], rows)


def growing_cloud_table(medians):
    rows = []
    for name, run in medians.items():
        if name.startswith("growing/"):
            rows.append([count(run["points"]), f"{seconds(run):.2f}", count(run["megabytes"])])
    return markdown(["points", "CPU s", "MB"], rows)


def runs_of(medians, kind):
    """The runs named `kind`/mesh/variant, by mesh and variant."""
    runs = {}
    for name, run in medians.items():
        if name.startswith(kind + "/"):
            _, mesh, variant = name.split("/", 2)
            runs.setdefault(mesh, {})[variant] = run
    return runs


def topology(run):
    cells = f"{count(run['components'])}, {count(run['betti_number'])}"
    return f"{cells if is_right(run) else f'**{cells}**'}; {count(run['tips'])}"


def method_quality_table(medians):
    """One row for each mesh: error and topology of the skeletons of all methods; then the means."""
    meshes = runs_of(medians, "method")
    methods = list(next(iter(meshes.values())))
    rows = [[mesh, *(f"{1000 * runs[method]['error']:.2f}: {topology(runs[method])}" for method in methods)]
            for mesh, runs in meshes.items()]
    rows.append(["mean error"] + [f"{1000 * statistics.fmean(runs[method]['error'] for runs in meshes.values()):.2f}"
                                  for method in methods])
    return markdown(["mesh", *methods], rows)


def method_time_table(medians):
    meshes = runs_of(medians, "method")
    methods = list(next(iter(meshes.values())))
    rows = [[mesh, count(next(iter(runs.values()))["vertices"]), *(f"{seconds(runs[method]):.2f}" for method in methods)]
            for mesh, runs in meshes.items()]
    return markdown(["mesh", "vertices", *methods], rows)


def sources_table(medians):
    meshes = runs_of(medians, "sources")
    rows = []
    for number in next(iter(meshes.values())):
        cells = []
        for runs in meshes.values():
            run = runs[number]
            cells += [count(run["packed"]), f"{1000 * run['error']:.2f}: {topology(run)}", f"{seconds(run):.2f}"]
        rows.append([count(int(number)), *cells])
    head = ["sources"]
    for mesh in meshes:
        head += [f"{mesh}: packed", "error", "CPU s"]
    return markdown(head, rows)


def two_methods_table(medians, kind, label):
    """One row for each strength of what is done to the mesh: errors and topology of both methods on every mesh."""
    meshes = runs_of(medians, kind)
    rows = []
    for strength in dict.fromkeys(variant.split("/")[0] for variant in next(iter(meshes.values()))):
        row = [label(strength)]
        for runs in meshes.values():
            row += [f"{1000 * runs[f'{strength}/{method}']['error']:.2f}: {topology(runs[f'{strength}/{method}'])}"
                    for method in ("local", "published")]
        rows.append(row)
    head = [""]
    for mesh in meshes:
        head += [f"{mesh}: local", f"{mesh}: published"]
    return markdown(head, rows)


def tree_table(medians):
    """One row for each way to scan a tree, over all seeds: those by which constants were chosen, then others."""
    rows = []
    scans = dict.fromkeys(name.split("/")[2] for name in medians if name.startswith("tree/"))
    for scan in scans:
        row = [scan]
        groups = [[run for name, run in medians.items() if name.startswith(f"tree/{kind}/{scan}/")]
                  for kind in ("chosen", "other")]

        def both(number, form, groups=groups):
            return " / ".join(form(number(runs)) for runs in groups)

        def mean(key):
            return lambda runs: statistics.fmean(run[key] for run in runs)

        def percent(key, whole):
            return lambda runs: 100 * sum(run[key] for run in runs) / sum(run[whole] for run in runs)

        row += [
            both(percent("found", "limbs"), "{:.0f}".format),
            both(percent("superfluous", "limbs"), "{:.0f}".format),
            both(percent("right_parents", "found"), "{:.0f}".format),
            both(percent("right_orders", "found"), "{:.0f}".format),
            both(lambda runs: 100 * mean("length_error")(runs), "{:.1f}".format),
            both(lambda runs: 100 * mean("radius_error")(runs), "{:.1f}".format),
            both(lambda runs: 100 * mean("distance")(runs), "{:.0f}".format),
            both(mean("objects"), "{:.1f}".format),
            f"{statistics.fmean(seconds(run) for runs in groups for run in runs):.2f}",
        ]
        rows.append(row)
    return markdown(["scan", "limbs found, %", "superfluous branches, % of the limbs", "right parent, %",
                     "right order, %", "length error, %", "radius error, %", "distance from the axis, % of the radius",
                     "components", "CPU s"], rows)


def scan_table(medians):
    rows = []
    for name, run in medians.items():
        if name.startswith("scan/"):
            rows.append([name.split("/")[1], count(run["points"]), count(run["objects"]), count(run["nodes"]),
                         count(run["branches"]), f"{run['length']:.0f}", f"{run['radius_at_base']:.2f}",
                         count(run["gaps"]), f"{seconds(run):.2f}"])
    return markdown(["scan", "points", "components", "nodes", "branches", "length", "radius of the trunk", "gaps",
                     "CPU s"], rows)


def growing_tree_table(medians):
    rows = [[count(run["points"]), count(run["branches"]), f"{seconds(run):.2f}", count(run["megabytes"])]
            for name, run in medians.items() if name.startswith("growing_tree/")]
    return markdown(["points", "branches", "CPU s", "MB"], rows)


def plot_published(medians):
    """Draws the errors of the tables about the published method."""
    def thousandths(run):
        return 1000 * run["error"]

    label = "mean error, 1/1000 of the diagonal"
    figures = ROOT / "doc" / "fig"
    draw(figures / "error_against_sources.png", "sources", label, {
        mesh: [(int(number), thousandths(run)) for number, run in runs.items()]
        for mesh, runs in runs_of(medians, "sources").items()}, logarithmic=True)
    for kind, x_label, unit in (("noise", "noise, mean edge lengths", 0.01), ("resolution", "one vertex of", 1)):
        curves = {}
        for mesh, runs in runs_of(medians, kind).items():
            for variant, run in runs.items():
                strength, method = variant.split("/")
                curves.setdefault(f"{mesh}, {method}", []).append((unit * int(strength), thousandths(run)))
        draw(figures / f"error_against_{kind}.png", x_label, label, curves, logarithmic=kind == "resolution")


def circumstances(context, repetitions):
    """When, where and how the numbers were made."""
    def output(*command):
        return subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=True).stdout.strip()

    processor = re.search(r"^model name\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    commit = output("git", "rev-parse", "--short", "HEAD")
    if output("git", "status", "--porcelain", "--", "include", "benchmark"):
        commit += " with local changes"
    load = context.get("load_avg") or [math.nan]
    runs = "one run" if repetitions == "1" else f"medians of {repetitions} runs"
    return (f"Made by `benchmark/run.sh {repetitions}` on {context['date'][:10]} at commit {commit}: {runs}, "
            f"Release build, {output('c++', '--version').splitlines()[0]}, "
            f"{processor.group(1) if processor else 'unknown processor'}, {context['num_cpus']} cores, "
            f"load average {load[0]:.1f} at the start.")


def replace_between_markers(path, tables):
    text = path.read_text()
    for name, table in tables.items():
        pattern = re.compile(rf"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)", re.DOTALL)
        if pattern.search(text):
            text = pattern.sub(lambda match, body=table: f"{match[1]}\n{body}\n\n{match[2]}", text)
    path.write_text(text)


TABLES_OF_PROGRAM = {
    "benchmark_skeletonization": lambda made, medians: {
        "circumstances": made,
        "meshes": mesh_table(medians),
        "quality": quality_table(medians),
        "growth": growth_table(medians),
    },
    "benchmark_stages": lambda made, medians: {"stages": stage_table(medians)},
    "benchmark_points": lambda made, medians: {
        "circumstances_of_clouds": made,
        "samplings": sampling_table(medians),
        "clouds": cloud_table(medians),
        "growing_cloud": growing_cloud_table(medians),
    },
    "benchmark_trees": lambda made, medians: {
        "circumstances_of_trees": made,
        "trees": tree_table(medians),
        **({"scans": scan_table(medians)} if any(name.startswith("scan/") for name in medians) else {}),
        "growing_tree": growing_tree_table(medians),
    },
    "benchmark_published": lambda made, medians: {
        "circumstances_of_methods": made,
        "methods": method_quality_table(medians),
        "method_times": method_time_table(medians),
        "numbers_of_sources": sources_table(medians),
        "noise": two_methods_table(medians, "noise", lambda percent: f"{int(percent) / 100:.1f} edges"),
        "resolution": two_methods_table(medians, "resolution",
                                        lambda part: "all vertices" if part == "1" else f"1/{part} of them"),
    },
}


def main():
    repetitions, *files = sys.argv[1:]
    tables = {}
    for file in files:
        context, medians = read_medians(file)
        program = pathlib.Path(file).stem
        tables.update(TABLES_OF_PROGRAM[program](circumstances(context, repetitions), medians))
        if program == "benchmark_published":
            plot_published(medians)
    documents = [ROOT / "doc" / name for name in ("performance.md", "points.md", "published.md", "trees.md")]
    for path in [*documents, ROOT / "README.md"]:
        replace_between_markers(path, tables)
        print(path)


if __name__ == "__main__":
    main()
