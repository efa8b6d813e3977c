#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the program cscd and CGAL's mean curvature flow (MCF), runs both, GEL's multi-scale local separators (MSLS) where
# PyGEL is installed, and any other skeletonizer on the same meshes, one thread each, and prints one table: time, memory,
# topology, inside, reconstruction error.
# Usage: benchmark/run.sh [--quick] [--peer "NAME=COMMAND"]... [--timeout SECONDS] [MESH...]
# A COMMAND is run by the shell with {mesh} and {skeleton} replaced by file names; it writes a skeleton in one of the
# formats that cscd reads, by default .graph, or that of "NAME.ENDING=COMMAND". doc/performance.md has commands of
# skeletor and kimimaro. Without meshes, it takes six of CGAL's; with --quick, the two smallest of them.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/build_benchmarks.sh"

names=(elephant knot1 homer camel armadillo refined_elephant)
if [[ ${1:-} == --quick ]]; then
  names=(elephant knot1)
  shift
fi
build_benchmarks cscd mcf_skeleton
arguments=(
  --peer "CSCD=$build_dir/bin/cscd skeletonize {mesh} -o {skeleton} --quiet --threads 1"
  --peer "MCF=$build_dir/bin/benchmark/mcf_skeleton {mesh} {skeleton}")
if python3 -c 'import pygel3d' 2>/dev/null; then
  script="import sys; from pygel3d import hmesh, graph; g = graph.from_mesh(hmesh.load(sys.argv[1]))
graph.save(sys.argv[2], graph.MSLS_skeleton(g))"
  arguments+=(--peer "MSLS=python3 -c '$script' {mesh} {skeleton}")
else
  echo "PyGEL is not installed (pip install PyGEL3D): the table is without MSLS" >&2
fi
for name in "${names[@]}"; do
  arguments+=(--default "$build_dir/cgal_data/data/meshes/$name.off")
done
python3 "$source_dir/benchmark/measure_peers.py" --evaluator "$build_dir/bin/cscd" "${arguments[@]}" "$@"
