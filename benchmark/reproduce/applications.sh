#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints the tables of doc/applications.md.
# Usage: benchmark/reproduce/applications.sh PRINCETON [TOSCA [FAUST]] [OPTION...]
# PRINCETON is the Princeton segmentation benchmark: off/N.off and seg/Benchmark/N/N_*.seg. TOSCA and FAUST, remeshed,
# are off/NAME.off with correspondences vts/NAME.vts (J. Ren et al., 2018). Options of applications.py choose tables and methods, such as --tables diameters, and a time limit a mesh. All
# tables take about an hour, most of it for CGAL's rays and mean curvature flow.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/../build_benchmarks.sh"

declare -a folders=()
for option in --princeton --tosca --faust; do
  if [[ $# -gt 0 && $1 != -* ]]; then
    folders+=("$option" "$(realpath "$1")")
    shift
  fi
done
build_benchmarks benchmark_applications cscd
exec python3 "$source_dir/benchmark/reproduce/applications.py" --programs "$build_dir/bin" "${folders[@]}" "$@"
