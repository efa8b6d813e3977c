#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes all tables, plots and pictures of doc and README.md anew: runs all benchmarks, then makes the
# pictures of doc and takes those of the viewer page by Chromium. Installs missing packages (Debian, Ubuntu). Takes
# about an hour.
# Usage: benchmark/reproduce/run.sh [--quick] [REPETITIONS], by default 1. With --quick only small benchmarks are run, which
# takes some minutes, and all is written to build/quick.
# If the environment variable CSCD_MODELS names a folder of OFF files, they are measured besides CGAL's.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/../build_benchmarks.sh"
quick=()
figures=$source_dir/doc/fig
if [[ ${1:-} == --quick ]]; then
  quick=(--quick)
  figures=$build_dir/quick/doc/fig
  shift
fi

"$source_dir/benchmark/reproduce/tables.sh" "${quick[@]}" "${1:-1}"

install_packages "${library_packages[@]}" chromium python3-numpy python3-matplotlib python3-pil
cmake -S "$source_dir" -B "$build_dir" -DCSCD_BUILD_EXAMPLES=ON >/dev/null
cmake --build "$build_dir" --target cscd cut_locus_example point_cut_locus_example
"$source_dir/doc/make_screenshots.sh" "$build_dir/bin/cscd" "$figures"
/usr/bin/python3 "$source_dir/doc/make_figures.py" --program "$build_dir/bin/cscd" --output "$figures"
"$source_dir/doc/make_cut_locus_pictures.sh" "$build_dir/bin/cut_locus_example" "$figures"
"$source_dir/doc/make_point_cut_locus_pictures.sh" "$build_dir/bin/point_cut_locus_example" "$figures"
