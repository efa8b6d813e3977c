#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing (Debian, Ubuntu), builds the benchmarks, and measures a small fixed set of them into a new
# file of benchmark/results, which benchmark/compare_results.py compares with others. Takes some minutes.
# Usage: benchmark/record.sh [ROUNDS], by default 9.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/build_benchmarks.sh"

programs=()
for program in $(python3 "$source_dir/benchmark/record_results.py" --programs); do
  programs+=("$program")
done
build_benchmarks "${programs[@]}"
python3 "$source_dir/benchmark/record_results.py" "$build_dir" "${1:-9}"
