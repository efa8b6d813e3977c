# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Sums up the results of measure_quality.py over sets of shapes, and compares two measurements.

A row is a dictionary: one shape, its values by column; None stands for an unknown or undefined value.
"""

import csv
import math
import pathlib
import re
import statistics

# Columns that are text; all others are numbers.
TEXT_COLUMNS = ("set", "shape", "half", "group", "failure")
COLUMNS = TEXT_COLUMNS[:2] + ("number",) + TEXT_COLUMNS[2:] + (
    "vertices", "surface_components", "components", "genus", "betti_number", "borders", "nodes", "edges", "nodes_outside",
    "edges_outside", "inside", "cone", "convolution", "offset", "deviation", "largest_turn", "turns_above_90", "tips",
    "limbs", "limbs_without_tip", "tips_without_limb", "seconds", "mcf_cone", "mcf_convolution", "mcf_offset",
    "mcf_deviation", "mcf_inside", "mcf_betti_number", "mcf_seconds", "mcf_failure")
CLASS_SIZE = 20  # consecutive numbers in the Princeton segmentation benchmark
LEAST_GROUP = 4  # shapes; the spread of tips of fewer shapes has no meaning
SPREAD = 3  # of tips; most poses of a body should stay within it
HALVES = ("all", "odd", "even")


def number_of(name):
    """The number that the last digits in `name` stand for; None without digits."""
    digits = re.findall(r"\d+", name)
    return int(digits[-1]) if digits else None


def group_of(name):
    """Shapes of a group should have equally many tips. The names of poses differ only in the number at their end. If
    a name is only a number, as in the Princeton set, classes are consecutive."""
    if name.isdigit():
        first = (int(name) - 1) // CLASS_SIZE * CLASS_SIZE + 1
        return f"{first} to {first + CLASS_SIZE - 1}"
    return re.sub(r"[_-]?\d+$", "", name)


def identity(name, position):
    """The first columns of the row of shape `name`, at `position`, from 1, among the sorted names of its set."""
    number = number_of(name)
    number = position if number is None else number
    return {"shape": name, "number": number, "half": "odd" if number % 2 else "even", "group": group_of(name)}


def write_rows(path, rows):
    """Writes each of `rows` as soon as it is known, and returns them all."""
    result = []
    with pathlib.Path(path).open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            result.append(row)
            writer.writerow({key: "" if value is None else value for key, value in row.items()})
            file.flush()
    return result


def read_rows(path):
    def value(key, text):
        if key in TEXT_COLUMNS or key == "mcf_failure":
            return text or None
        return float(text) if text else None

    with pathlib.Path(path).open(newline="") as file:
        return [{key: value(key, text) for key, text in row.items()} for row in csv.DictReader(file)]


def values(rows, column):
    return [row[column] for row in rows if row.get(column) is not None]


def is_closed(row):
    return row.get("borders") == 0


def geometric_mean(ratios):
    return math.exp(statistics.fmean(map(math.log, ratios)))


def ratios(rows, before, after):
    """The quotients of two columns, by shape, where both are positive."""
    return {row["shape"]: row[after] / row[before] for row in rows
            if (row.get(before) or 0) > 0 and (row.get(after) or 0) > 0}


def text_of_ratios(by_shape):
    """Geometric mean and worst of ratios."""
    if not by_shape:
        return "-"
    return f"{geometric_mean(by_shape.values()):.3f}, {max(by_shape.values()):.2f}"


def right(rows, columns):
    """The number of `rows` with the same value in two columns."""
    known = [row for row in rows if all(row.get(column) is not None for column in columns)]
    return f"{sum(row[columns[0]] == row[columns[1]] for row in known)} of {len(known)}" if known else "-"


def mean(rows, column, digits=2):
    known = values(rows, column)
    return f"{statistics.fmean(known):.{digits}f}" if known else "-"


def total(rows, column):
    known = values(rows, column)
    return f"{sum(known):.0f}" if known else "-"


def greatest(rows, column):
    known = values(rows, column)
    return f"{max(known):.0f}" if known else "-"


def part(rows, column, of):
    """The sum of one column and the sum of another one that includes it."""
    known = [row for row in rows if row.get(column) is not None and row.get(of) is not None]
    return f"{sum(row[column] for row in known):.0f} of {sum(row[of] for row in known):.0f}" if known else "-"


def recall(rows, missing, of):
    """The fraction of the sum of `of` that is not `missing`."""
    known = [row for row in rows if row.get(missing) is not None and row.get(of) is not None]
    number = sum(row[of] for row in known)
    return f"{1 - sum(row[missing] for row in known) / number:.3f}" if number else "-"


# Each line of a table: its label, and the function that makes its text from rows.
MEASURES = (
    ("components right", lambda rows: right(rows, ("components", "surface_components"))),
    ("Betti number = genus, closed", lambda rows: right(list(filter(is_closed, rows)), ("betti_number", "genus"))),
    ("nodes outside", lambda rows: part(rows, "nodes_outside", "nodes")),
    ("edges outside", lambda rows: part(rows, "edges_outside", "edges")),
    ("length inside, closed", lambda rows: mean(list(filter(is_closed, rows)), "inside", 4)),
    ("cone error, 1/1000", lambda rows: mean(rows, "cone")),
    ("  of MCF", lambda rows: mean(rows, "mcf_cone")),
    ("  over MCF: mean, worst", lambda rows: text_of_ratios(ratios(rows, "mcf_cone", "cone"))),
    ("convolution error, 1/1000", lambda rows: mean(rows, "convolution")),
    ("  of MCF", lambda rows: mean(rows, "mcf_convolution")),
    ("  over MCF: mean, worst", lambda rows: text_of_ratios(ratios(rows, "mcf_convolution", "convolution"))),
    ("offset from center", lambda rows: mean(rows, "offset", 3)),
    ("  of MCF", lambda rows: mean(rows, "mcf_offset", 3)),
    ("deviation", lambda rows: mean(rows, "deviation", 3)),
    ("  of MCF", lambda rows: mean(rows, "mcf_deviation", 3)),
    ("greatest turn, degrees", lambda rows: greatest(rows, "largest_turn")),
    ("turns above 90 degrees", lambda rows: total(rows, "turns_above_90")),
    ("tips", lambda rows: total(rows, "tips")),
    ("limbs without a tip", lambda rows: part(rows, "limbs_without_tip", "limbs")),
    ("tips without a limb", lambda rows: part(rows, "tips_without_limb", "tips")),
    ("tip recall", lambda rows: recall(rows, "limbs_without_tip", "limbs")),
    ("tip precision", lambda rows: recall(rows, "tips_without_limb", "tips")),
    ("CPU seconds, mean", lambda rows: mean(rows, "seconds", 3)),
    ("  of MCF", lambda rows: mean(rows, "mcf_seconds", 3)),
    ("  MCF over ours: mean, worst", lambda rows: text_of_ratios(ratios(rows, "seconds", "mcf_seconds"))),
)


def halves(rows):
    """The rows that count, all of them and apart, by half."""
    measured = [row for row in rows if not row.get("failure")]
    return {half: [row for row in measured if half in ("all", row["half"])] for half in HALVES}


def aligned(lines):
    """Lines of a table: the first column flush left, the others flush right."""
    widths = [max(map(len, column)) for column in zip(*lines)]
    return ["  ".join([line[0].ljust(widths[0]), *(text.rjust(width) for text, width in zip(line[1:], widths[1:]))])
            for line in lines]


def table_of_set(name, rows):
    """The table of a set: lines of text."""
    by_half = halves(rows)
    lines = [[name, *HALVES], ["shapes", *(str(len(by_half[half])) for half in HALVES)]]
    for label, text_of in MEASURES:
        texts = [text_of(by_half[half]) for half in HALVES]
        if any(text != "-" for text in texts):
            lines.append([label, *texts])
    failures = [f"not measured: {row['shape']}: {row['failure']}" for row in rows if row.get("failure")]
    no_mcf = [row["shape"] for row in rows if row.get("mcf_failure")]
    if no_mcf:
        failures.append(f"MCF fails on {len(no_mcf)}: {' '.join(no_mcf)}")
    wrong = [row["shape"] for row in by_half["all"] if is_closed(row) and row["betti_number"] != row["genus"]]
    if wrong:
        failures.append(f"Betti number is not the genus: {' '.join(wrong)}")
    return aligned(lines) + failures


def most_within(numbers, width):
    """The greatest number of `numbers` that are in an interval of this width."""
    return max(sum(low <= number <= low + width for number in numbers) for low in numbers)


def table_of_groups(rows):
    """Tips of each group: lines of text; none without groups."""
    groups = {}
    for row in rows:
        if not row.get("failure") and row.get("tips") is not None:
            groups.setdefault(row["group"], []).append(row)
    lines = [["tips by class", "shapes", "fewest", "median", "most", f"within {SPREAD}", "limbs, median", "recall",
              "precision"]]
    for name, members in groups.items():
        if len(members) >= LEAST_GROUP:
            tips = values(members, "tips")
            limbs = values(members, "limbs")
            lines.append([name, f"{len(tips)}", f"{min(tips):.0f}", f"{statistics.median(tips):g}", f"{max(tips):.0f}",
                          f"{most_within(tips, SPREAD)}", f"{statistics.median(limbs):g}" if limbs else "-",
                          recall(members, "limbs_without_tip", "limbs"), recall(members, "tips_without_limb", "tips")])
    return aligned(lines) if len(lines) > 1 else []


COMPARED_BY_RATIO = ("cone", "convolution", "offset", "deviation", "seconds")
COMPARED_BY_SUM = ("nodes_outside", "edges_outside", "turns_above_90", "tips", "limbs", "limbs_without_tip",
                   "tips_without_limb")


def table_of_comparison(before, after):
    """The changes on the shapes of a set that are in both measurements: lines of text."""
    old = {row["shape"]: row for row in before if not row.get("failure")}
    pairs = [{"half": row["half"], "shape": row["shape"], "before": old[row["shape"]], "after": row} for row in after
             if not row.get("failure") and row["shape"] in old]
    by_half = halves(pairs)
    lines = [["after / before: geometric mean, worst", *HALVES],
             ["shapes", *(str(len(by_half[half])) for half in HALVES)]]
    for column in COMPARED_BY_RATIO:
        texts = []
        for half in HALVES:
            joined = [{"shape": pair["shape"], "before": pair["before"].get(column), "after": pair["after"].get(column)}
                      for pair in by_half[half]]
            texts.append(text_of_ratios(ratios(joined, "before", "after")))
        if any(text != "-" for text in texts):
            lines.append([column, *texts])
    lines.append(["before -> after, sums", "", "", ""])
    for column in COMPARED_BY_SUM:
        known = {half: [pair for pair in by_half[half]
                        if pair["before"].get(column) is not None and pair["after"].get(column) is not None]
                 for half in HALVES}
        if known["all"]:
            lines.append([column, *(" -> ".join(f"{sum(pair[side][column] for pair in known[half]):.0f}"
                                                for side in ("before", "after")) for half in HALVES)])
    return aligned(lines) + worst_changes(pairs, "cone")


def worst_changes(pairs, column, number=10):
    """The shapes with the greatest increase and the greatest decrease of `column`."""
    joined = [{"shape": pair["shape"], "before": pair["before"].get(column), "after": pair["after"].get(column)}
              for pair in pairs]
    ordered = sorted(ratios(joined, "before", "after").items(), key=lambda item: item[1])
    if not ordered:
        return []

    def text(items):
        return " ".join(f"{shape} {ratio:.2f}" for shape, ratio in items)

    return [f"{column}, most grown: {text(ordered[::-1][:number])}", f"{column}, most shrunk: {text(ordered[:number])}"]


def report(rows, before=None):
    """All tables of the rows of any number of sets, compared with the rows of another measurement if given."""
    blocks = []
    for name in dict.fromkeys(row["set"] for row in rows):
        of_set = [row for row in rows if row["set"] == name]
        blocks += [table_of_set(name, of_set), table_of_groups(of_set)]
        if before is not None:
            blocks.append(table_of_comparison([row for row in before if row["set"] == name], of_set))
    return "\n\n".join("\n".join(block) for block in blocks if block)
