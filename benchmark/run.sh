#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing (Debian, Ubuntu), builds the benchmarks, runs them, and writes their tables to
# doc/performance.md, doc/points.md, doc/geodesics.md, doc/published.md, doc/trees.md and README.md. Takes half an
# hour.
# Usage: benchmark/run.sh [REPETITIONS [PROGRAM...]], by default 3 and all programs.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$source_dir/build
repetitions=${1:-3}
programs=("${@:2}")
if [[ ${#programs[@]} -eq 0 ]]; then
  programs=(benchmark_skeletonization benchmark_stages benchmark_points benchmark_geodesics
    benchmark_published benchmark_trees)
fi

# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
install_packages "${library_packages[@]}" libbenchmark-dev python3 gnuplot-nox

# In a build folder that has the tests or examples, they stay.
configure=(cmake -S "$source_dir" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCSCD_BUILD_BENCHMARKS=ON)
if [[ ! -e $build_dir/CMakeCache.txt ]]; then
  configure+=(-DCSCD_BUILD_TESTS=OFF -DCSCD_BUILD_EXAMPLES=OFF)
fi
"${configure[@]}" >/dev/null
cmake --build "$build_dir" --target "${programs[@]}"

results=()
for program in "${programs[@]}"; do
  "$build_dir/bin/benchmark/$program" --benchmark_min_time=0.1 --benchmark_repetitions="$repetitions" \
    --benchmark_out="$build_dir/$program.json" --benchmark_out_format=json
  if [[ $program == benchmark_geodesics ]]; then
    python3 "$source_dir/benchmark/write_geodesics_tables.py" "$build_dir/$program.json"
  else
    results+=("$build_dir/$program.json")
  fi
done
if [[ ${#results[@]} -gt 0 ]]; then
  python3 "$source_dir/benchmark/write_tables.py" "$repetitions" "${results[@]}"
fi
