#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the faults of test/mutants.txt one at a time, and prints which test notices each.

Usage: test/mutants.py [--check] [--build FOLDER] [--write] [NUMBER...]
Without numbers, it makes all faults, in order. A fault costs the compilation of a test program and of what it links.
The working tree is changed while a fault is in it, so it has to be clean. The exit status is 1 if a fault is not noticed.
"""

import argparse
import datetime
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "test/mutants.txt"
KEYS = ("rule", "file", "line", "as", "tests", "run")


def read_list():
    """The comment at the head of the list, and the faults as dictionaries."""
    head, *blocks = LIST.read_text(encoding="utf-8").rstrip().split("\n\n")
    return head, [dict(line.split(": ", 1) for line in block.splitlines()) for block in blocks]


def write_list(head, mutants):
    blocks = ("\n".join(f"{key}: {mutant[key]}" for key in KEYS if key in mutant) for mutant in mutants)
    LIST.write_text("\n\n".join([head, *blocks]) + "\n", encoding="utf-8")


def complaints(mutants):
    for number, mutant in enumerate(mutants, 1):
        file = ROOT / mutant["file"]
        count = file.read_text(encoding="utf-8").count(mutant["line"]) if file.exists() else 0
        if count != 1:
            yield f"{number}: the line is {count} times in {mutant['file']}: {mutant['line']}"


def first_failure(build, tests):
    """The first test that fails, or None. A fault that does not compile, or that hangs, is noticed, too."""
    program, test_filter = tests.split(" ", 1)
    built = subprocess.run(["cmake", "--build", build, "--target", program], capture_output=True, text=True, check=False)
    if built.returncode != 0:
        return "the compiler"
    try:
        run = subprocess.run([build / "bin/test" / program, f"--gtest_filter={test_filter}"], capture_output=True,
                             text=True, timeout=600, check=False)
    except subprocess.TimeoutExpired:
        return "the time limit"
    if "Running 0 tests" in run.stdout:
        sys.exit(f"no test is called {test_filter} in {program}")
    failed = re.search(r"^\[  FAILED  \] ([^\s,]+)", run.stdout, re.MULTILINE)
    return failed.group(1) if failed else f"a crash of {program}" if run.returncode != 0 else None


def make(mutant, build):
    """The outcome of a fault. The file is restored."""
    file = ROOT / mutant["file"]
    text = file.read_text(encoding="utf-8")
    try:
        file.write_text(text.replace(mutant["line"], mutant["as"]), encoding="utf-8")
        return first_failure(build, mutant["tests"])
    finally:
        file.write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="only check that every line is where the list says")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build-checked", help="a build folder with tests")
    parser.add_argument("--write", action="store_true", help="write what came of it to the list")
    parser.add_argument("numbers", type=int, nargs="*", metavar="NUMBER", help="of faults, counted from 1")
    arguments = parser.parse_args()
    head, mutants = read_list()
    stale = list(complaints(mutants))
    if arguments.check or stale:
        sys.exit("\n".join(stale) if stale else 0)

    survived = 0
    for number in arguments.numbers or range(1, len(mutants) + 1):
        mutant = mutants[number - 1]
        failure = make(mutant, arguments.build)
        survived += failure is None
        mutant["run"] = f"{datetime.date.today()}, " + (f"noticed by {failure}" if failure else "not noticed")
        print(f"{number}: {mutant['rule']}: {mutant['run']}", flush=True)
        if arguments.write:
            write_list(head, mutants)
    sys.exit(1 if survived else 0)


if __name__ == "__main__":
    main()
