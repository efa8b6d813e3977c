# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tests that benchmark/reproduce/geodesics_tables.py finds what benchmark_geodesics.cpp counts.

Usage: test_geodesics_tables.py FOLDER_OF_THE_SCRIPTS
"""

import pathlib
import re
import sys
import unittest

FOLDER = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(FOLDER))

import geodesics_tables  # noqa: E402


class Tables(unittest.TestCase):
    def test_are_made_of_the_counters_of_the_benchmark(self):
        counters = re.findall(r'counters\["(\w+)"\]', (FOLDER / "benchmark_geodesics.cpp").read_text(encoding="utf-8"))
        values = {name: 1.0 for name in [*counters, "cpu_time"]}
        medians = {name: values for name in
                   ["prepare/cow", "prepare_cgal/cow", "one_by_one/cow", "together/cow", "cgal_one_by_one/cow", "tube/8",
                    "tube_cgal/8"]}
        for name, table in geodesics_tables.TABLES.items():
            self.assertIn("1", table(medians), name)


if __name__ == "__main__":
    unittest.main()
