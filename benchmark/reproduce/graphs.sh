#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints the quality of skeletons of graphs: of the edges of meshes, and of points joined to their neighbors.
# Usage: benchmark/reproduce/graphs.sh FOLDER [--points N] [--neighbors K], see benchmark/reproduce/graphs.py.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/../build_benchmarks.sh"

build_benchmarks cscd
python3 "$source_dir/benchmark/reproduce/graphs.py" "$build_dir/bin/cscd" "$@"
