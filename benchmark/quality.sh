#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the program cscd and prints the quality of its skeletons of all meshes of some folders, by default CGAL's data.
# Odd- and even-numbered shapes are listed separately: only odd ones are used to choose constants.
# Usage: benchmark/quality.sh [--mcf] [OPTION...] [FOLDER...]
# --mcf measures CGAL's mean curvature flow too, which takes most of the time. The other options are those of
# measure_quality.py, such as --fast, --output CSV, --compare CSV, --args "--seed 1", --program CSCD for skeletons of
# another build; --help lists all of them.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/build_benchmarks.sh"

targets=(cscd)
arguments=(--program "$build_dir/bin/cscd" --evaluator "$build_dir/bin/cscd")
folders=()
while (($#)); do
  case $1 in
    --mcf)
      targets+=(mcf_skeleton)
      arguments+=(--mcf "$build_dir/bin/benchmark/mcf_skeleton")
      ;;
    --fast | --help | --*=*) arguments+=("$1") ;;
    --*)
      arguments+=("$1=$2")
      shift
      ;;
    *) folders+=("$1") ;;
  esac
  shift
done
build_benchmarks "${targets[@]}"
if ((${#folders[@]} == 0)); then
  folders=("$build_dir/cgal_data/data/meshes")
fi
python3 "$source_dir/benchmark/measure_quality.py" "${arguments[@]}" "${folders[@]}"
