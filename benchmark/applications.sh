#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints how near segmentations are to those of people, by classes, or how many shapes are found to be of their class.
# Usage: benchmark/applications.sh FOLDER [METHOD...]
# FOLDER is the Princeton segmentation benchmark: off/N.off and seg/Benchmark/N/N_*.seg. The methods are skeleton,
# diameter and rays; the first two by default, since the rays of the third take seconds a mesh. The method classes
# classifies the even-numbered meshes, of which 20 consecutive numbers are a class, by both descriptors.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/build_benchmarks.sh"

# classify FOLDER: writes accuracy and F1 score of both descriptors.
classify()
{
  local table folder
  folder=$(realpath "$1")
  table=$(mktemp)
  for ((number = 2; number <= 400; number += 2)); do
    if [[ -e $folder/off/$number.off ]]; then
      echo "$folder/off/$number.off,$(((number - 1) / 20))"
    fi
  done >"$table"
  for descriptor in diameter skeleton; do
    "$build_dir/bin/cscd" classify "$table" -o "$table.json" --descriptor "$descriptor" | sed "s/.*:/$descriptor:/"
  done
  rm "$table" "$table.json"
}

if [[ ${2-} == classes ]]; then
  build_benchmarks cscd
  classify "$1"
else
  build_benchmarks benchmark_segmentation
  "$build_dir/bin/benchmark/benchmark_segmentation" "$@"
fi
