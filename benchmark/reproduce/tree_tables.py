# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tables of benchmark_trees."""

import statistics

from markdown_tables import count, markdown, seconds


def tree_table(medians):
    """One row for each way to scan a tree, over all seeds: seeds used to choose constants, then others."""
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


TABLES = {
    "trees": tree_table,
    # The table needs a folder of scans.
    "scans": lambda medians: scan_table(medians) if any(name.startswith("scan/") for name in medians) else None,
    "growing_tree": growing_tree_table,
}
