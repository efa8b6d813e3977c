#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the program cscd and CGAL's mean curvature flow, runs both and any other skeletonizer on the same meshes, one
# thread each, and prints one table: time, memory, topology, inside, reconstruction error.
# Usage: benchmark/peers.sh [--peer "NAME=COMMAND"]... [--timeout SECONDS] [MESH...]
# A COMMAND is run by the shell with {mesh} and {skeleton} replaced by file names; it writes a skeleton in one of the
# formats that cscd reads, by default .graph, or that of "NAME.ENDING=COMMAND". doc/performance.md has those of GEL,
# skeletor and kimimaro. Without meshes, it takes six of CGAL's.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/build_benchmarks.sh"

build_benchmarks cscd mcf_skeleton
data="$build_dir/cgal_data/data/meshes"
python3 "$source_dir/benchmark/measure_peers.py" --evaluator "$build_dir/bin/cscd" \
  --peer "CSCD=$build_dir/bin/cscd skeletonize {mesh} -o {skeleton} --quiet --threads 1" \
  --peer "MCF=$build_dir/bin/benchmark/mcf_skeleton {mesh} {skeleton}" \
  --default "$data/elephant.off" --default "$data/knot1.off" --default "$data/homer.off" \
  --default "$data/camel.off" --default "$data/armadillo.off" --default "$data/refined_elephant.off" "$@"
