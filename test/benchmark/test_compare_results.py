# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Tests benchmark/compare_results.py on small files as Google Benchmark writes them.

Usage: test_compare_results.py SCRIPT
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv.pop(1)).resolve()
MACHINE = {"processor": "one", "num_cpus": 2, "compiler": "a compiler", "flags": "-O3", "load_avg": [0.1, 0.1, 0.1]}
STEADY = [100, 101, 99, 100, 102]


def runs_of(name, times, unit="ms"):
    return [{"name": f"{name}/process_time", "run_name": f"{name}/process_time", "run_type": "iteration",
             "repetition_index": i, "real_time": 3 * time, "cpu_time": time, "time_unit": unit}
            for i, time in enumerate(times)]


def aggregate_of(name, time):
    return [{"name": f"{name}_median", "run_name": name, "run_type": "aggregate", "aggregate_name": "median",
             "real_time": time, "cpu_time": time, "time_unit": "ms"}]


class Compare_results(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, runs, context=None):
        path = self.folder / name
        path.write_text(json.dumps({"context": {**MACHINE, **(context or {})}, "benchmarks": runs}))
        return path

    def compare(self, before, after, *options, context=None):
        """Returns the exit status and all that is printed."""
        paths = [self.write("before.json", before), self.write("after.json", after, context)]
        run = subprocess.run([sys.executable, SCRIPT, *options, *paths], capture_output=True, text=True, check=False)
        return run.returncode, run.stdout + run.stderr

    def test_slower_beyond_the_spread_fails(self):
        status, text = self.compare(runs_of("find", STEADY), runs_of("find", [120, 121, 119, 122, 120]))
        self.assertEqual(status, 1)
        self.assertRegex(text, r"find +100\.000 +120\.000  1\.200  1\.188 to 1\.210  SLOWER\n")
        self.assertIn("1 slower, 0 faster, 0 the same", text)

    def test_faster_is_told(self):
        status, text = self.compare(runs_of("find", STEADY), runs_of("find", [50, 51, 49, 50, 52]))
        self.assertEqual(status, 0)
        self.assertRegex(text, r"find .* 0\.500 .*faster\n")

    def test_one_slow_repetition_makes_no_difference(self):
        status, text = self.compare(runs_of("find", STEADY), runs_of("find", [99, 100, 101, 100, 900]))
        self.assertEqual(status, 0)
        self.assertIn("within the spread", text)

    def test_a_large_ratio_within_the_spread_does_not_count(self):
        status, text = self.compare(runs_of("find", [80, 100, 120, 140, 160]),
                                    runs_of("find", [110, 130, 150, 170, 190]))
        self.assertEqual(status, 0)
        self.assertRegex(text, r"find .* 1\.250 .*within the spread\n")

    def test_tolerance(self):
        before, after = runs_of("find", STEADY), runs_of("find", [104, 104, 104, 104, 104])
        status, text = self.compare(before, after)
        self.assertEqual(status, 0)
        self.assertIn("within the tolerance", text)
        self.assertEqual(self.compare(before, after, "--tolerance", "3")[0], 1)

    def test_units_are_respected(self):
        status, text = self.compare(runs_of("find", STEADY), runs_of("find", [time / 1000 for time in STEADY], "s"))
        self.assertEqual(status, 0)
        self.assertRegex(text, r"find .* 1\.000 .*within the spread\n")

    def test_control_takes_out_a_slow_machine(self):
        slow = [2 * time for time in STEADY]
        before = runs_of("find", STEADY) + runs_of("other", STEADY)
        after = runs_of("find", slow) + runs_of("other", slow)
        self.assertEqual(self.compare(before, after)[0], 1)
        status, text = self.compare(before, after, "--control", "^other$")
        self.assertEqual(status, 0)
        self.assertIn("divided: 2.000", text)
        self.assertEqual(self.compare(before, after, "--control", "nobody")[0], 2)

    def test_aggregates_and_failed_runs_are_passed_over(self):
        failed = [{**run, "error_occurred": True} for run in runs_of("pack", STEADY)]
        before = runs_of("find", STEADY) + aggregate_of("find", 7) + failed
        status, text = self.compare(before, runs_of("find", STEADY) + runs_of("pack", STEADY))
        self.assertEqual(status, 0)
        self.assertIn("only in the second file: pack", text)

    def test_missing_benchmarks_are_warned_of(self):
        status, text = self.compare(runs_of("find", STEADY) + runs_of("gone", STEADY),
                                    runs_of("find", STEADY) + runs_of("new", STEADY))
        self.assertEqual(status, 0)
        self.assertIn("warning: only in the first file: gone", text)
        self.assertIn("warning: only in the second file: new", text)

    def test_other_machines_are_warned_of(self):
        status, text = self.compare(runs_of("find", STEADY), runs_of("find", STEADY),
                                    context={"processor": "two", "flags": "-O0"})
        self.assertEqual(status, 0)
        self.assertIn("warning: processor differs: one / two", text)
        self.assertIn("warning: flags differs: -O3 / -O0", text)
        self.assertNotIn("warning", self.compare(runs_of("find", STEADY), runs_of("find", STEADY))[1])

    def test_too_few_repetitions_are_not_compared(self):
        status, text = self.compare(runs_of("find", [100, 101]), runs_of("find", [200, 201]))
        self.assertEqual(status, 2)
        self.assertIn("fewer than 3 repetitions or no time: find", text)

    def test_real_time_on_request(self):
        status, text = self.compare(runs_of("find", STEADY), runs_of("find", STEADY), "--time", "real_time")
        self.assertEqual(status, 0)
        self.assertRegex(text, r"find +300\.000 +300\.000")

    def test_what_cannot_be_compared(self):
        self.assertEqual(self.compare(runs_of("find", STEADY), runs_of("pack", STEADY))[0], 2)
        good = self.write("good.json", runs_of("find", STEADY))
        bad = self.folder / "bad.json"
        for text in ("no JSON", "[]", "{}"):
            bad.write_text(text)
            run = subprocess.run([sys.executable, SCRIPT, good, bad], capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 2, text)
            self.assertIn("compare_results.py: ", run.stderr)
        none = self.folder / "none.json"
        run = subprocess.run([sys.executable, SCRIPT, good, none], capture_output=True, check=False)
        self.assertEqual(run.returncode, 2)


if __name__ == "__main__":
    unittest.main()
