#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages (Debian, Ubuntu), builds the benchmarks, runs them, and writes their tables and plots to
# the pages of doc and to README.md. Takes three quarters of an hour.
# Usage: benchmark/reproduce/tables.sh [--quick] [REPETITIONS [PROGRAM...]], by default 3 and all programs. With --quick only small
# benchmarks are run, which takes some minutes, and the pages are written to build/quick.
# If the environment variable CSCD_MODELS names a folder of OFF files, they are measured besides CGAL's.

set -euo pipefail

command="benchmark/reproduce/tables.sh${*:+ $*}"
if [[ -n ${CSCD_MODELS:-} ]]; then
  command="CSCD_MODELS=folder $command"
fi
# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/../build_benchmarks.sh"

# The benchmarks of each program that --quick runs.
declare -A small=(
  [benchmark_skeletonization]='^mesh/(elephant|knot1)/|^growing/elephant_[01]/'
  [benchmark_points]='^(cloud|published)/(knot1|elephant)/uniform, 5,000/|^growing/armadillo/(5000|20000)/'
  [benchmark_geodesics]='/elephant$|^tube.*/(250|500)$'
  [benchmark_published]='^(method|noise|holes|resolution)/(elephant|torus)/|^sources/elephant/(8|32|128|512)/|^ring/'
  [benchmark_trees]='^tree/|^growing_tree/.*0000$'
)
is_quick=false
if [[ ${1:-} == --quick ]]; then
  is_quick=true
  shift
fi
repetitions=${1:-3}
programs=("${@:2}")
if [[ ${#programs[@]} -eq 0 ]]; then
  programs=(benchmark_skeletonization benchmark_points benchmark_geodesics benchmark_published benchmark_trees)
fi

build_benchmarks "${programs[@]}"
results_dir=$build_dir
pages=("$source_dir")
if $is_quick; then
  # Copies of the pages, with the parts that are not measured anew.
  results_dir=$build_dir/quick
  mkdir -p "$results_dir/doc/fig"
  cp "$source_dir/README.md" "$results_dir"
  cp "$source_dir"/doc/*.md "$results_dir/doc"
  pages=("$results_dir")
fi

results=()
for program in "${programs[@]}"; do
  filter=.
  if $is_quick; then
    filter=${small[$program]}
  fi
  "$build_dir/bin/benchmark/$program" --benchmark_filter="$filter" --benchmark_min_time=0.1 \
    --benchmark_repetitions="$repetitions" \
    --benchmark_out="$results_dir/$program.json" --benchmark_out_format=json
  results+=("$results_dir/$program.json")
done
python3 "$source_dir/benchmark/reproduce/write_tables.py" "$command" "$build_dir" "${pages[@]}" "${results[@]}"
