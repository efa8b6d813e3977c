# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tests the sums over shapes of quality.py, the turns of programs.py, and the tables of tables.py."""

import pathlib
import tempfile
import unittest

import programs
import quality
import tables


def row(name, half, **columns):
    return {"set": "s", "shape": name, "half": half, "genus": 0, "betti_number": 0, "borders": 0, "components": 1,
            "surface_components": 1, **columns}


def cells(lines, label):
    """The columns of the line of a table that begins with `label`."""
    line = next(line for line in lines if line.startswith(f"| {label} |"))
    return line.strip("| ").split(" | ")[1:]


class Quality(unittest.TestCase):
    def test_number_is_the_last_digits_or_the_position(self):
        self.assertEqual(quality.number_of("8_gorilla_03", 7), 3)
        self.assertEqual(quality.number_of("cow", 7), 7)

    def test_halves_are_apart_and_failures_do_not_count(self):
        rows = [row("1", "odd", cone=10), row("2", "even", cone=20), row("3", "odd", cone=30),
                row("4", "even", failure="exit status 3")]
        lines = quality.table_of_set("s", rows).splitlines()
        self.assertEqual(cells(lines, "shapes"), ["3", "2", "1"])
        self.assertEqual(cells(lines, "cone error, 1/1000"), ["20.00", "20.00", "20.00"])
        self.assertIn("not measured: 4: exit status 3", lines)

    def test_open_meshes_have_no_say_in_the_betti_number(self):
        rows = [row("1", "odd", borders=2, betti_number=1), row("3", "odd"), row("5", "odd", genus=2, betti_number=1)]
        lines = quality.table_of_set("s", rows).splitlines()
        self.assertEqual(cells(lines, "Betti number = genus, closed"), ["1 of 2", "1 of 2", "-"])
        self.assertIn("Betti number is not the genus: 5", lines)

    def test_recall_and_precision_are_those_of_all_limbs_together(self):
        rows = [row("1", "odd", limbs=9, limbs_without_tip=0, tips=10, tips_without_limb=1),
                row("3", "odd", limbs=1, limbs_without_tip=1, tips=0, tips_without_limb=0)]
        lines = quality.table_of_set("s", rows).splitlines()
        self.assertEqual(cells(lines, "tip recall")[0], "0.900")
        self.assertEqual(cells(lines, "tip precision")[0], "0.900")


class Skeletons(unittest.TestCase):
    def test_turns_are_only_at_nodes_of_two_edges(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "s.graph"
            path.write_text("n 0 0 0\nn 1 0 0\nn 1 1 0\nn 2 1 0\nn 1 2 0\nc 0 1\nc 1 2\nc 2 3\nc 2 4\n")
            self.assertEqual([round(angle) for angle in programs.turns(path)], [90])

    def test_summary_has_a_column_for_each_skeletonizer(self):
        def run(seconds):
            return {"vertices": 1000, "seconds": seconds, "percent_inside": 99.6, "tips": 3}

        table = tables.summary_table({"mesh/cow/CSCD": run(0.1), "mesh/cow/CSCD_2_threads": run(0.1),
                                      "mesh/cow/MCF": run(1), "mesh/dog/CSCD": run(0.1)}).splitlines()
        self.assertIn("| CSCD, s | MCF, s (times as long) | % inside: CSCD / MCF | tips |", table[0])
        self.assertEqual(table[2], "| cow | 1,000 | 0.100 | 1.00 (10) | 100 / 100 | 3 / 3 |")
        self.assertEqual(table[3], "| dog | 1,000 | 0.100 | – | 100 / – | 3 / – |")


if __name__ == "__main__":
    unittest.main()
