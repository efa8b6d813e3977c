#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the faults of test/mutants.txt, one at a time, and prints which test notices each.

Usage: test/mutants.py [--check] FOLDER [NUMBER...]
All faults are compiled into one copy of the project in FOLDER, where the environment variable CSCD_FAULT chooses one, so
that the tests are built once. Without numbers, it makes all faults, in order, and writes the results to the list. The
exit status is 1 if a fault is not noticed.
"""

import argparse
import datetime
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "test/mutants.txt"
KEYS = ("rule", "file", "line", "as", "tests", "run")
SWITCH = """#pragma once
#include <cstdlib>

namespace CSCD::internal
{
inline const int number_of_fault = std::getenv("CSCD_FAULT") != nullptr ? std::atoi(std::getenv("CSCD_FAULT")) : 0;
}
"""


def read_list():
    """The comment at the head of the list, and the faults as dictionaries."""
    head, *blocks = LIST.read_text(encoding="utf-8").rstrip().split("\n\n")
    mutants = [dict(line.split(": ", 1) for line in block.splitlines()) for block in blocks]
    for mutant in mutants:
        before, rest = mutant["line"].split("[[", 1)
        expression, after = rest.rsplit("]]", 1)
        mutant["parts"] = (before, expression, after)
    return head, mutants


def write_list(head, mutants):
    blocks = ("\n".join(f"{key}: {mutant[key]}" for key in KEYS if key in mutant) for mutant in mutants)
    LIST.write_text("\n\n".join([head, *blocks]) + "\n", encoding="utf-8")


def complaints(mutants):
    for number, mutant in enumerate(mutants, 1):
        file = ROOT / mutant["file"]
        count = file.read_text(encoding="utf-8").count("".join(mutant["parts"])) if file.exists() else 0
        if count != 1:
            yield f"{number}: the line is {count} times in {mutant['file']}: {''.join(mutant['parts'])}"


def with_faults(text, mutants):
    """The text of a file with all its faults. `CSCD_FAULT` chooses one."""
    lines = {}
    for number, mutant in mutants:
        before, expression, after = mutant["parts"]
        start = text.index(before + expression + after) + len(before)
        lines.setdefault((start, len(expression)), []).append((number, mutant["as"]))
    for (start, length), faults in sorted(lines.items(), reverse=True):
        choice = text[start:start + length]
        for number, fault in faults:
            choice = f"(CSCD::internal::number_of_fault == {number} ? ({fault}) : ({choice}))"
        begin = text.rindex("\n", 0, start) + 1
        declaration = text[begin:start].replace("static constexpr", "static inline const").replace("constexpr", "const")
        text = text[:begin] + declaration + choice + text[start + length:]
    return re.sub(r"^#include", "#include <CSCD/internal/fault.h>\n#include", text, count=1, flags=re.MULTILINE)


def build(folder, mutants, programs):
    """Builds the test programs with all faults in a copy of the files that Git knows."""
    files = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    numbered = {}
    for number, mutant in enumerate(mutants, 1):
        numbered.setdefault(mutant["file"], []).append((number, mutant))
    for name in files:
        copy = folder / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        if name not in numbered:
            shutil.copy2(ROOT / name, copy)
            continue
        text = with_faults((ROOT / name).read_text(encoding="utf-8"), numbered[name])
        if not copy.exists() or copy.read_text(encoding="utf-8") != text:
            copy.write_text(text, encoding="utf-8")
    switch = folder / "include/CSCD/internal/fault.h"
    if not switch.exists():
        switch.write_text(SWITCH, encoding="utf-8")
    subprocess.run(["cmake", "--preset", "checked"], cwd=folder, check=True)
    subprocess.run(["cmake", "--build", "--preset", "checked", "--target", *programs], cwd=folder, check=True)


def first_failure(folder, tests, number):
    """The first test that fails, or None. A fault that makes the program crash or hang is noticed, too."""
    program, test_filter = tests.split(" ", 1)
    try:
        run = subprocess.run([folder / "build-checked/bin/test" / program, f"--gtest_filter={test_filter}"],
                             env={**os.environ, "CSCD_FAULT": str(number)}, capture_output=True, text=True, timeout=600,
                             check=False)
    except subprocess.TimeoutExpired:
        return "the time limit"
    if "Running 0 tests" in run.stdout:
        sys.exit(f"no test is called {test_filter} in {program}")
    failed = re.search(r"^\[  FAILED  \] ([^\s,]+)", run.stdout, re.MULTILINE)
    return failed.group(1) if failed else f"a crash of {program}" if run.returncode != 0 else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="only check that every line is where the list says")
    parser.add_argument("folder", type=pathlib.Path, nargs="?", help="for the copy of the project")
    parser.add_argument("numbers", type=int, nargs="*", metavar="NUMBER", help="of faults, counted from 1")
    arguments = parser.parse_args()
    head, mutants = read_list()
    stale = list(complaints(mutants))
    if arguments.check or stale:
        sys.exit("\n".join(stale) if stale else 0)
    if arguments.folder is None:
        parser.error("name the folder for the copy")

    numbers = arguments.numbers or range(1, len(mutants) + 1)
    all_tests = {mutants[number - 1]["tests"] for number in numbers}
    build(arguments.folder, mutants, sorted({tests.split(" ", 1)[0] for tests in all_tests}))
    for tests in sorted(all_tests):
        if failure := first_failure(arguments.folder, tests, 0):
            sys.exit(f"without a fault, {tests} fails: {failure}")
    survived = 0
    for number in numbers:
        mutant = mutants[number - 1]
        failure = first_failure(arguments.folder, mutant["tests"], number)
        survived += failure is None
        mutant["run"] = f"{datetime.date.today()}, " + (f"noticed by {failure}" if failure else "not noticed")
        print(f"{number}: {mutant['rule']}: {mutant['run']}", flush=True)
    write_list(head, mutants)
    sys.exit(1 if survived else 0)


if __name__ == "__main__":
    main()
