# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Prints the tables of README.md and of pages in doc, and writes them there.

Usage: experiments.py BUILD COMMAND NAME [--quick] [--write] [PATH...]
BUILD is the folder of the build, COMMAND is what the pages name as the command, NAME is that of a function below, and
PATH... are its further data. With --quick little is measured, as a test of the scripts. With --write the tables replace
those in the pages.
"""

import argparse
import json
import pathlib
import statistics
import sys
import tempfile

import tables
from programs import Failure, Laboratory, read_off, run
from tables import NOTHING, ROOT, count, markdown

QUOTED = json.loads((pathlib.Path(__file__).parent / "quoted_results.json").read_text())


# Google Benchmark: experiments that are timed.

def benchmark(lab, program, options, *arguments):
    """The medians of the benchmarks of a program."""
    path = lab.folder / "benchmark.json"
    repetitions = 1 if options.quick else options.repetitions
    run(lab.benchmarks / program, f"--benchmark_repetitions={repetitions}", "--benchmark_min_time=0.1",
        f"--benchmark_out={path}", "--benchmark_out_format=json", *arguments, timeout=7200)
    return tables.read_medians(path)


def performance(lab, options):
    names = ["elephant", "knot1", "homer", "camel", "armadillo", "refined_elephant"][:2 if options.quick else None]
    medians = benchmark(lab, "benchmark_meshes", options, f"--growing={1 if options.quick else 5}",
                        *map(lab.mesh, names))
    return {"meshes": tables.mesh_table(medians), "growth": tables.growth_table(medians)}


def geodesics(lab, options):
    filters = ["--benchmark_filter=/elephant$"] if options.quick else []
    medians = benchmark(lab, "benchmark_geodesics", options, *filters)
    sources = 8  # that each run computes distances from
    errors, times = [], []
    for mesh in [name.split("/")[1] for name in medians if name.startswith("prepare/")]:
        def milliseconds(name, mesh=mesh):
            return 1000 * medians[f"{name}/{mesh}"]["seconds"]

        ours, theirs = medians[f"together/{mesh}"], medians[f"cgal_one_by_one/{mesh}"]
        errors.append([mesh, count(ours["vertices"]), count(ours["diameter"])]
                      + [f"{ours[key]:.2f} / {theirs[key]:.2f}"
                         for key in ("mean_error", "max_error", "percent_error")])
        alone, together, cgal = (milliseconds(name) / sources for name in ("one_by_one", "together", "cgal_one_by_one"))
        times.append([mesh, f"{milliseconds('prepare'):.0f} / {milliseconds('prepare_cgal'):.0f}", f"{alone:.2f}",
                      f"{together:.2f}", f"{alone / together:.1f}", f"{cgal:.2f}", f"{cgal / together:.0f}"])

    return {"errors": markdown(["mesh", "vertices", "eccentricity, edges", "mean error, CSCD / CGAL", "largest error",
                                "relative error, %"], errors),
            "times": markdown(["mesh", "prepare, CSCD / CGAL", "CSCD, alone", "CSCD, of eight", "alone : of eight",
                               "CGAL", "CGAL : of eight"], times)}


# Skeletons by the program cscd: experiments that are measured once.

def is_right(run):
    """Whether a skeleton has the components and cycles of the surface."""
    return (run["components"], run["betti_number"]) == (run["surface_components"], run["genus"])


def topology(run):
    cells = f"{run['components']}, {run['betti_number']}"
    return f"{cells if is_right(run) else f'**{cells}**'}; {run['tips']}"


def facts(measures, position=None):
    """What the tables show of a skeleton; the position may be that in another mesh than errors are measured against."""
    counts, position = measures["counts"], (position or measures)["position"]
    return {"genus": position["genus"], "surface_components": position["number_of_surface_components"],
            "percent_inside": 100 * position["fraction_of_length_inside"], "betti_number": counts["betti_number"],
            "components": counts["number_of_components"], "tips": counts["number_of_tips"],
            "error": 1000 * measures["round_cones"]["mean"], "convolution": 1000 * measures["convolution"]["mean"]}


def measured(lab, mesh, *options, altered=None, resolution=100):
    """The facts of the skeleton of a mesh, or of an altered one, compared with the mesh; None if it fails."""
    try:
        report, cost = lab.skeletonize(altered or mesh, *options)
        position = lab.evaluate(altered, resolution=1) if altered else None
        return {**facts(lab.evaluate(mesh, resolution=resolution), position), "seconds": cost.cpu,
                "packed": report["number_of_packed_separators"]}
    except Failure as failure:
        print(f"{altered or mesh} {' '.join(options)}: {failure}", file=sys.stderr)
        return None


def mean_curvature_flow(lab, mesh, resolution):
    try:
        _, cost = run(lab.benchmarks / "mcf_skeleton", mesh, lab.skeleton)
        return {**facts(lab.evaluate(mesh, resolution=resolution)), "seconds": cost.cpu}
    except Failure:
        return None


def error_and_topology(run):
    return f"{run['error']:.2f}: {topology(run)}" if run else "fails"


def number(value):
    return NOTHING if value is None else f"{value:.2f}"


def models(options):
    """The OFF files of the folders that were given."""
    return sorted(file for folder in options.paths for file in pathlib.Path(folder).glob("*.off"))


PUBLISHED = ("--method", "published")


def quoted(source, mesh, vertices, faces, key):
    """The results of `source` for a mesh with as many vertices and faces, or with its name and nearly as many."""
    name = mesh.lower().replace("_", "-")
    for row in QUOTED[source]["rows"]:
        difference = max(abs(row["vertices"] / vertices - 1), abs(row["faces"] / faces - 1))
        if difference == 0 or name.startswith(row["mesh"].lower()) and difference < 0.001:
            return row.get(key)
    return None


def side_by_side(rows, quantity, columns):
    """Measured and quoted values for each mesh, then medians over different meshes."""
    def median_row(title, width):
        whole = [row["values"][:width] for row in different.values() if None not in row["values"][:width]]
        medians = [statistics.median(column) for column in zip(*whole)] or [None] * width
        return [f"{title} {len(whole)}", "", *map(number, medians + [None] * (3 + len(columns) - width))]

    different, cells = {}, []
    for mesh, vertices, faces, runs in rows:
        values = [run[quantity] if run else None for run in runs]
        key = {"convolution": "error", "seconds": "seconds"}[quantity]
        values += [quoted(source, mesh, vertices, faces, f"{method} {key}") for source, method in columns]
        different.setdefault((vertices, faces), {"values": values})
        cells.append([mesh, count(vertices), *map(number, values)])
    return markdown(["mesh", "vertices", "local", "published", "MCF",
                     *(f"{method}, {source}" for source, method in columns)],
                    cells + [median_row("median of", 3), median_row("median of the quoted", 5)])


def published(lab, options):
    """Compares the methods: errors, times, sources, noise, resolution, holes. Data: folders of closed meshes."""
    names = ["armadillo", "camel", "cow", "dino", "elephant", "femur", "hand", "homer", "knot1", "triceratops"]
    shapes = [lab.make(f"{name}.off", "shape", name) for name in ("torus", "knot", "star")]
    others = [path for path in models(options) if path.stem not in names]
    if options.quick:
        shapes, names, others = shapes[:1], ["elephant"], others[:1]
    methods, errors = [], []
    for mesh in [*shapes, *map(lab.mesh, names), *others]:
        points, faces = read_off(mesh)
        runs = [measured(lab, mesh, resolution=200), measured(lab, mesh, *PUBLISHED, resolution=200),
                mean_curvature_flow(lab, mesh, resolution=200)]
        few = measured(lab, mesh, *PUBLISHED, "--separators", "500")
        methods.append([mesh.stem, *map(error_and_topology, (*runs[:2], few))])
        errors.append((mesh.stem, len(points), len(faces), runs))
    result = {"methods": markdown(["mesh", "local", "published", "published, 500 sources"], methods),
              "paper_errors": side_by_side(errors, "convolution", [
                  ("GEL", "LS"), ("GEL", "MSLS"), ("paper", "LS"), ("paper", "MSLS"), ("paper", "MCF"),
                  ("paper", "CSCD-M")]),
              "paper_times": side_by_side(errors, "seconds", [("GEL", "LS"), ("GEL", "MSLS"), ("paper", "LS"),
                                                              ("paper", "MSLS"), ("paper", "CSCD-M")])}

    rows = []
    pair = list(map(lab.mesh, ["elephant"] if options.quick else ["camel", "elephant"]))
    for sources in [2 ** n for n in range(3, 6 if options.quick else 14)]:
        runs = [measured(lab, mesh, *PUBLISHED, "--separators", str(sources)) for mesh in pair]
        rows.append([count(sources)] + [cell for run in runs for cell in (
            count(run["packed"]), error_and_topology(run), f"{run['seconds']:.2f}")])
    result["numbers_of_sources"] = markdown(["sources"] + [cell for mesh in pair for cell in (
        f"{mesh.stem}: packed", "error", "CPU s")], rows)

    meshes = pair if options.quick else [lab.mesh("armadillo"), *pair]
    meshes += [path for path in others if path.stem == "fertility_4494"]
    for name, kind, label, strengths in [
            ("noise", "noise", "{} edges", ["0.0", "0.1", "0.2", "0.3", "0.5"]),
            ("resolution", "simplified", "{} of the edges", ["1", "0.5", "0.25", "0.125"]),
            ("holes", "holes", "{} holes", ["0", "10", "30", "100"])]:
        rows = []
        for strength in strengths[:2 if options.quick else None]:
            row = [label.format(strength)]
            for mesh in meshes:
                altered = lab.make("altered.off", kind, mesh, strength)
                row += [error_and_topology(measured(lab, mesh, *method, altered=altered)) for method in ((), PUBLISHED)]
            rows.append(row)
        head = [f"{mesh.stem}: {method}" for mesh in meshes for method in ("local", "published")]
        result[name] = markdown(["", *head], rows)
    rows = []
    for label, altered in [("whole", None), ("two holes", lab.make("holes.off", "ring", "0")),
                           ("two holes and a break", lab.make("break.off", "ring", "1"))]:
        runs = [measured(lab, shapes[0], *method, altered=altered) for method in ((), PUBLISHED)]
        rows.append([label, str(runs[0]["genus"]), *map(error_and_topology, runs)])
    result["broken_ring"] = markdown(["ring", "genus", "local", "published"], rows)
    return result


SAMPLINGS = {"uniform, 5,000": ("5000", "0", "0"), "uniform, 20,000": ("20000", "0", "0"),
             "noise, 20,000": ("20000", "0.3", "0"), "holes, 20,000": ("20000", "0", "10")}


def sampling_table(clouds):
    """One row for each way to draw points, over all meshes."""
    rows = []
    for sampling in next(iter(clouds.values()))[1]:
        pairs = [(mesh, runs[sampling]) for mesh, runs in clouds.values()]

        def means(key, digits, pairs=pairs):
            return " / ".join(f"{statistics.fmean(pair[of][key] for pair in pairs):.{digits}f}" for of in (1, 0))

        seconds = [run["seconds"] for _, run in pairs]
        rows.append([sampling, f"{sum(is_right(run) for _, run in pairs)} of {len(pairs)}",
                     f"{sum(abs(run['tips'] - mesh['tips']) <= 2 for mesh, run in pairs)} of {len(pairs)}",
                     means("percent_inside", 1), means("error", 2), f"{statistics.fmean(seconds):.2f}",
                     f"{max(seconds):.2f}"])
    return markdown(["points", "topology right", "tips within 2 of the mesh's", "length inside, %: points / mesh",
                     "error: points / mesh", "CPU s", "largest"], rows)


def points(lab, options):
    """Skeletons of points drawn from meshes, by default and as published. Data: folders of closed meshes."""
    names = ["armadillo", "bear", "bull", "cactus", "camel", "cow", "dino", "elephant", "elk", "femur", "hand", "homer",
             "knot1", "knot2", "man", "triceratops"]
    meshes = [lab.mesh("knot1")] if options.quick else [*map(lab.mesh, names), *models(options)]
    result = {}
    # Fewer sources than in the published experiments: more make little difference.
    for kind, method in [("", ()), ("published_", (*PUBLISHED, "--separators", "1000"))]:
        clouds = {}
        for mesh in meshes:
            of_mesh, of_clouds = measured(lab, mesh), {}
            for sampling, arguments in SAMPLINGS.items():
                cloud = lab.make("points.xyz", "points", mesh, *arguments)
                _, cost = lab.skeletonize(cloud, "--shape", "surface", *method)
                of_clouds[sampling] = {**facts(lab.evaluate(mesh)), "seconds": cost.cpu}
            clouds[mesh.stem] = of_mesh, of_clouds
        result[kind + "samplings"] = sampling_table(clouds)
    rows = []
    for size in [5000, 20000] if options.quick else [5000, 20000, 100000, 300000, 1000000]:
        cloud = lab.make("points.xyz", "points", lab.mesh("armadillo"), str(size), "0.3", "0")
        _, cost = lab.skeletonize(cloud, "--shape", "surface")
        rows.append([count(size), f"{cost.cpu:.2f}", count(cost.megabytes)])
    result["growing_cloud"] = markdown(["points", "CPU s", "MB"], rows)
    return result


def graphs(lab, options):
    """Skeletons of graphs: of edges of meshes next to quoted ones, and of points. Data: folders of closed meshes."""
    edges, clouds = [], []
    for mesh in models(options)[:2 if options.quick else None]:
        report, _ = lab.skeletonize(mesh)
        surface = {"surface_components": report["number_of_surface_components"], "genus": report["genus"]}

        def of_graph(graph, *more, surface=surface):
            report, cost = lab.skeletonize(graph, "--as", "graph", *more)
            return {**surface, "components": report["number_of_skeleton_components"], "seconds": cost.cpu,
                    "betti_number": report["betti_number"], "tips": report["number_of_tips"]}

        vertices, faces = map(len, read_off(mesh))
        row = next((row for row in QUOTED["GEL"]["rows"]
                    if (row["vertices"], row["faces"]) == (vertices, faces) and "LS error" in row), None)
        if row:
            graph = of_graph(mesh)
            errors = facts(lab.evaluate(mesh, resolution=200))
            edges.append({**graph, "mesh": mesh.stem, "LS tips": row["LS tips"],
                          "ratio": row["LS seconds"] / graph["seconds"],
                          "cones": errors["error"] / row["LS cone error"],
                          "convolution": errors["convolution"] / row["LS error"]})
        cloud = lab.make("points.xyz", "points", mesh, "5000", "0", "0")
        clouds.append(of_graph(cloud, "--neighbors", "24"))
    rows = [[row["mesh"], "yes" if is_right(row) else "no", f"{row['tips']}, {row['LS tips']}", f"{row['cones']:.2f}",
             f"{row['convolution']:.2f}", f"{row['seconds']:.2f}", f"{row['ratio']:.0f}"] for row in edges]
    if edges:
        means = [statistics.geometric_mean(row[key] for row in edges) for key in ("cones", "convolution", "seconds")]
        rows.append(["geometric mean", f"{sum(map(is_right, edges))} of {len(edges)}", "", *map("{:.2f}".format, means),
                     f"{statistics.geometric_mean(row['ratio'] for row in edges):.0f}"])
    return {"graphs_of_edges": markdown(["edges of", "topology right", "tips, LS", "cone error / LS",
                                         "convolution error / LS", "s", "times as fast as LS"], rows),
            "graphs_of_points": f"{sum(map(is_right, clouds))} of {len(clouds)} have the right topology."}


def trees(lab, options):
    """Skeletons of scans of trees. Data: XYZ files of scans."""
    chosen, other = ([1], [11]) if options.quick else ([1, 2, 3, 4], [11, 12, 13, 14, 15, 16])
    text, _ = run(lab.benchmarks / "measure_trees", ",".join(map(str, chosen + other)), *options.paths)
    runs = list(map(json.loads, text.splitlines()))
    known = [run for run in runs if run["kind"] == "tree"]
    rows = []
    for scan in dict.fromkeys(run["name"] for run in known):
        groups = [[run for run in known if run["name"] == scan and run["seed"] in seeds] for seeds in (chosen, other)]

        def percent(key, whole, groups=groups):
            return " / ".join(f"{100 * sum(run[key] for run in group) / sum(run[whole] for run in group):.0f}"
                              for group in groups)

        def mean(key, factor, digits, groups=groups):
            return " / ".join(f"{factor * statistics.fmean(run[key] for run in group):.{digits}f}"
                              for group in groups)

        rows.append([scan, percent("found", "limbs"), percent("superfluous", "limbs"),
                     percent("right_parents", "found"), percent("right_orders", "found"),
                     mean("length_error", 100, 1), mean("radius_error", 100, 1),
                     mean("distance", 100, 0), mean("objects", 1, 1),
                     f"{statistics.fmean(run['seconds'] for group in groups for run in group):.2f}"])
    result = {"trees": markdown(["scan", "limbs found, %", "superfluous branches, % of the limbs", "right parent, %",
                                 "right order, %", "length error, %", "radius error, %",
                                 "distance from the axis, % of the radius", "components", "CPU s"], rows),
              "growing_tree": markdown(["points", "branches", "CPU s", "MB"],
                                       [[count(run["points"]), count(run["branches"]), f"{run['seconds']:.2f}",
                                         count(run["megabytes"])] for run in runs if run["kind"] == "growing"])}
    if options.paths:
        result["scans"] = markdown(["scan", "points", "components", "nodes", "branches", "length",
                                    "radius of the trunk", "gaps", "CPU s"],
                                   [[run["name"],
                                     *(count(run[key]) for key in ("points", "objects", "nodes", "branches")),
                                     f"{run['length']:.0f}", f"{run['radius_at_base']:.2f}", count(run["gaps"]),
                                     f"{run['seconds']:.2f}"] for run in runs if run["kind"] == "scan"])
    return result


EXPERIMENTS = {function.__name__: function for function in
               (performance, geodesics, published, points, graphs, trees)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("command")
    parser.add_argument("name", choices=EXPERIMENTS)
    parser.add_argument("paths", nargs="*", metavar="PATH")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--repetitions", type=int, default=3, metavar="N", help="number of timed runs; by default 3")
    options = parser.parse_intermixed_args()  # paths may follow options
    with tempfile.TemporaryDirectory() as folder:
        found = EXPERIMENTS[options.name](Laboratory(options.build / "bin", folder), options)
    is_timed = options.name in ("performance", "geodesics")
    sentence = tables.circumstances(options.command, options.build, options.repetitions if is_timed else 1)
    print(sentence, *(f"{name}:\n\n{table}" for name, table in found.items()), sep="\n\n")
    found[f"circumstances_of_{options.name}"] = sentence
    if options.write:
        for path in [*sorted((ROOT / "doc").glob("*.md")), ROOT / "README.md"]:
            tables.replace_between_markers(path, found)


if __name__ == "__main__":
    main()
