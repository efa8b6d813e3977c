# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
"""Compares two JSON files of Google Benchmark with repetitions, such as those in benchmark/results.

For each benchmark it prints the medians, their ratio, and the spread of the ratio: from the lower quartile of the
second over the upper quartile of the first to the upper over the lower one. A difference counts if 1 is outside of the
spread and the ratio differs from 1 by more than the tolerance.

Exit status: 0 if nothing is slower, 1 if something is, 2 if the files cannot be compared.
"""

import argparse
import math
import re
import statistics
import sys

from measurements import read_runs

UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
FEWEST_REPETITIONS = 3  # fewer have no quartiles to speak of
NAMED_IN_HEAD = ("commit", "date", "processor", "num_cpus", "compiler", "flags", "load_avg")
WARNED_OF = ("processor", "num_cpus", "compiler", "flags", "library_build_type")


class Times:
    """Quartiles of the times of one benchmark, in seconds."""

    def __init__(self, runs, key):
        seconds = [run[key] * UNITS[run["time_unit"]] for run in runs]
        self.number = len(seconds)
        self.lower, self.median, self.upper = (
            statistics.quantiles(seconds, n=4, method="inclusive") if self.number > 1 else seconds * 3)

    def is_usable(self):
        return self.number >= FEWEST_REPETITIONS and self.lower > 0


class Comparison:
    """The ratio of two times and its spread, both over the ratio of the control."""

    def __init__(self, before, after, tolerance, control):
        self.ratio = after.median / before.median / control
        self.least = after.lower / before.upper / control
        self.greatest = after.upper / before.lower / control
        is_beyond_spread = self.least > 1 or self.greatest < 1
        if not is_beyond_spread:
            self.verdict = "within the spread"
        elif abs(self.ratio - 1) <= tolerance:
            self.verdict = "within the tolerance"
        else:
            self.verdict = "SLOWER" if self.ratio > 1 else "faster"


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", help="the JSON file to compare with")
    parser.add_argument("after", help="the JSON file to judge")
    parser.add_argument("--time", default="cpu_time", choices=("cpu_time", "real_time"))
    parser.add_argument("--tolerance", type=float, default=5, metavar="PERCENT",
                        help="differences that do not count even if they exceed the spread (default: 5)")
    parser.add_argument("--control", metavar="REGEX",
                        help="benchmarks of code that has not changed: all ratios are divided by theirs (the geometric "
                             "mean), which takes out that the machine was faster or slower as a whole")
    return parser.parse_args(arguments)


def warnings(contexts, all_runs):
    """What makes a comparison doubtful."""
    for key in WARNED_OF:
        before, after = (context.get(key) for context in contexts)
        if before != after:
            yield f"{key} differs: {before} / {after}"
    before, after = all_runs
    for name in before.keys() - after.keys():
        yield f"only in the first file: {name}"
    for name in after.keys() - before.keys():
        yield f"only in the second file: {name}"


def usable_times(all_runs, key):
    """Pairs of times by benchmark, and the names of those that have too few repetitions."""
    pairs, unusable = {}, []
    for name in all_runs[0]:
        if name in all_runs[1]:
            pair = [Times(runs[name], key) for runs in all_runs]
            if all(times.is_usable() for times in pair):
                pairs[name] = pair
            else:
                unusable.append(name)
    return pairs, unusable


def ratio_of_control(pairs, pattern):
    if pattern is None:
        return 1
    ratios = [after.median / before.median for name, (before, after) in pairs.items() if re.search(pattern, name)]
    if not ratios:
        raise ValueError(f"no benchmark of both files is called like the control {pattern}")
    return math.exp(statistics.fmean(map(math.log, ratios)))


def print_head(contexts):
    for key in NAMED_IN_HEAD:
        if any(key in context for context in contexts):
            print(f"{key:>10}: {contexts[0].get(key, 'unknown')} / {contexts[1].get(key, 'unknown')}")


def print_table(comparisons, pairs):
    width = max(map(len, comparisons))
    print(f"\n{'benchmark':{width}}  before, ms   after, ms  ratio  spread")
    for name, comparison in comparisons.items():
        before, after = pairs[name]
        print(f"{name:{width}}  {1000 * before.median:10.3f}  {1000 * after.median:10.3f}  {comparison.ratio:5.3f}  "
              f"{comparison.least:.3f} to {comparison.greatest:.3f}  {comparison.verdict}")


def compare(arguments):
    """Prints the comparison. Returns the number of benchmarks that are slower."""
    contexts, all_runs = zip(*(read_runs(path) for path in (arguments.before, arguments.after)))
    pairs, unusable = usable_times(all_runs, arguments.time)
    print_head(contexts)
    for text in sorted(warnings(contexts, all_runs)):
        print(f"warning: {text}")
    for name in unusable:
        print(f"warning: not compared, as it has fewer than {FEWEST_REPETITIONS} repetitions or no time: {name}")
    if not pairs:
        raise ValueError("the files have no benchmark in common that can be compared")
    control = ratio_of_control(pairs, arguments.control)
    comparisons = {name: Comparison(before, after, arguments.tolerance / 100, control)
                   for name, (before, after) in pairs.items()}
    print_table(comparisons, pairs)
    if arguments.control is not None:
        print(f"\nratio of the control, by which all others are divided: {control:.3f}")
    verdicts = [comparison.verdict for comparison in comparisons.values()]
    slower = verdicts.count("SLOWER")
    print(f"\n{slower} slower, {verdicts.count('faster')} faster, {len(verdicts) - slower - verdicts.count('faster')} "
          f"the same; geometric mean of the ratios "
          f"{math.exp(statistics.fmean(math.log(comparison.ratio) for comparison in comparisons.values())):.3f}")
    return slower


def main(arguments):
    try:
        return 1 if compare(parse_arguments(arguments)) else 0
    except (OSError, ValueError, KeyError, TypeError, re.error) as error:
        reason = f"no file of Google Benchmark, no {error}" if isinstance(error, KeyError) else error
        print(f"compare_results.py: {reason}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
