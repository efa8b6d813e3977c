#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the benchmark of segmentations and prints how near they are to those of people, by classes.
# Usage: benchmark/applications.sh FOLDER [METHOD...]
# FOLDER is the Princeton segmentation benchmark: off/N.off and seg/Benchmark/N/N_*.seg. The methods are skeleton,
# diameter and rays; the first two by default, since the rays of the third take seconds a mesh.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/build_benchmarks.sh"

build_benchmarks benchmark_segmentation
"$build_dir/bin/benchmark/benchmark_segmentation" "$@"
