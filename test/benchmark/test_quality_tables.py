# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tests the sums over shapes of benchmark/quality_tables.py, and the turns of benchmark/measure_quality.py.

Usage: test_quality_tables.py FOLDER_OF_THE_SCRIPTS
"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))

import measure_quality  # noqa: E402
import quality_tables  # noqa: E402


def row(name, position=1, **columns):
    return {"set": "s", **quality_tables.identity(name, position), "genus": 0, "betti_number": 0, "borders": 0,
            "components": 1, "surface_components": 1, **columns}


def cells(lines, label):
    """The columns of the line of a table that begins with `label`."""
    line = next(line for line in lines if line.startswith(label))
    return line[len(label):].split()


class Identity(unittest.TestCase):
    def test_last_digits_are_the_number(self):
        self.assertEqual(quality_tables.identity("8_gorilla_03", 7)["number"], 3)
        self.assertEqual(quality_tables.identity("tr_reg_010", 7)["half"], "even")

    def test_position_where_there_are_no_digits(self):
        self.assertEqual(quality_tables.identity("cow", 7)["half"], "odd")
        self.assertEqual(quality_tables.identity("cow", 8)["half"], "even")

    def test_classes_of_twenty_and_poses(self):
        self.assertEqual(quality_tables.group_of("81"), quality_tables.group_of("100"))
        self.assertNotEqual(quality_tables.group_of("80"), quality_tables.group_of("81"))
        self.assertEqual(quality_tables.group_of("tr_reg_000"), quality_tables.group_of("tr_reg_099"))
        self.assertNotEqual(quality_tables.group_of("cat1"), quality_tables.group_of("dog1"))


class Tables(unittest.TestCase):
    def test_halves_are_apart_and_failures_do_not_count(self):
        rows = [row("1", cone=10), row("2", cone=20), row("3", cone=30), row("4", failure="exit status 3")]
        lines = quality_tables.table_of_set("s", rows)
        self.assertEqual(cells(lines, "shapes"), ["3", "2", "1"])
        self.assertEqual(cells(lines, "cone error, 1/1000"), ["20.00", "20.00", "20.00"])
        self.assertIn("not measured: 4: exit status 3", lines)

    def test_open_meshes_have_no_say_in_the_betti_number(self):
        rows = [row("1", borders=2, betti_number=1), row("3"), row("5", genus=2, betti_number=1)]
        lines = quality_tables.table_of_set("s", rows)
        self.assertEqual(cells(lines, "Betti number = genus, closed"), ["1", "of", "2", "1", "of", "2", "-"])
        self.assertIn("Betti number is not the genus: 5", lines)

    def test_ratios_only_where_both_are_known(self):
        rows = [row("1", cone=2, mcf_cone=1), row("3", cone=1, mcf_cone=2), row("5", cone=100, mcf_cone=None)]
        lines = quality_tables.table_of_set("s", rows)
        self.assertEqual(cells(lines, "  over MCF: mean, worst")[:2], ["1.000,", "2.00"])

    def test_recall_and_precision_are_those_of_all_limbs_together(self):
        rows = [row("1", limbs=9, limbs_without_tip=0, tips=10, tips_without_limb=1),
                row("3", limbs=1, limbs_without_tip=1, tips=0, tips_without_limb=0)]
        lines = quality_tables.table_of_set("s", rows)
        self.assertEqual(cells(lines, "limbs without a tip")[:3], ["1", "of", "10"])
        self.assertEqual(cells(lines, "tip recall")[0], "0.900")
        self.assertEqual(cells(lines, "tip precision")[0], "0.900")

    def test_spread_of_a_class(self):
        tips = [9, 9, 10, 14, 12, 12]
        lines = quality_tables.table_of_groups([row(f"pose{n}", tips=t) for n, t in enumerate(tips)])
        self.assertEqual(cells(lines, "pose")[:5], ["6", "9", "11", "14", "5"])

    def test_no_classes_among_different_names(self):
        self.assertEqual(quality_tables.table_of_groups([row(name, tips=1) for name in "abcdef"]), [])


class Comparison(unittest.TestCase):
    def test_only_shapes_of_both(self):
        before = [row("1", cone=2, tips=4), row("2", cone=2, tips=4), row("3", cone=9, tips=9)]
        after = [row("1", cone=1, tips=5), row("2", cone=4, tips=3), row("5", cone=1, tips=9)]
        lines = quality_tables.table_of_comparison(before, after)
        self.assertEqual(cells(lines, "shapes"), ["2", "1", "1"])
        self.assertEqual(cells(lines, "cone"), ["1.000,", "2.00", "0.500,", "0.50", "2.000,", "2.00"])
        self.assertEqual(cells(lines, "tips"), ["8", "->", "8", "4", "->", "5", "4", "->", "3"])
        self.assertIn("cone, most grown: 2 2.00 1 0.50", lines)

    def test_rows_are_read_as_they_are_written(self):
        rows = [row("1", cone=0.1 + 0.2, mcf_failure="more than 60 s"), row("2", failure="exit status 2")]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "rows.csv"
            quality_tables.write_rows(path, rows)
            read = quality_tables.read_rows(path)
        for written, back in zip(rows, read):
            self.assertEqual(written, {key: back[key] for key in written})
        self.assertEqual(quality_tables.report(read), quality_tables.report(rows))


class Sets(unittest.TestCase):
    def test_names_tell_folders_apart(self):
        self.assertEqual(measure_quality.names_of_sets(["/x/a/off", "/x/b/off"]), ["a/off", "b/off"])
        self.assertEqual(measure_quality.names_of_sets(["/x/a/off", "/y/a/off"]), ["x/a/off", "y/a/off"])


class Turns(unittest.TestCase):
    def test_only_at_nodes_of_two_edges(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0.5, 0.5, 0), (2, 1, 0), (1, 2, 0)]
        angles = measure_quality.turns(points, [(0, 1), (1, 2), (2, 4), (2, 5)])
        self.assertEqual([round(angle) for angle in angles], [90])

    def test_a_path_that_goes_back(self):
        self.assertEqual([round(a) for a in measure_quality.turns([(0, 0, 0), (1, 0, 0), (0, 0, 0)], [(0, 1), (2, 1)])],
                         [180])


if __name__ == "__main__":
    unittest.main()
