#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Compares CSCD with CGAL's mean curvature flow (MCF), with GEL's multi-scale local separators (MSLS) where PyGEL is
# installed, and with any other skeletonizer: runs all on the same meshes, and prints one table of CPU seconds and
# quality, medians of three runs.
# Usage: benchmark/run.sh [--quick] [--peer "NAME=COMMAND"]... [MESH...]
# COMMAND is run by the shell with {mesh} and {skeleton} replaced by names of files, and writes the skeleton in GEL's
# format: lines `n X Y Z` for nodes, `c I J` for edges. If it prints a number, that is the time in place of the CPU
# seconds of the whole command. Without meshes, it takes six of CGAL's; with --quick, the two smallest of them.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/build_benchmarks.sh"

names=(elephant knot1 homer camel armadillo refined_elephant)
arguments=()
meshes=()
if python3 -c 'import pygel3d' 2>/dev/null; then
  script="import sys, time; from pygel3d import hmesh, graph
edges = graph.from_mesh(hmesh.load(sys.argv[1])); begin = time.process_time(); skeleton = graph.MSLS_skeleton(edges)
print(time.process_time() - begin); graph.save(sys.argv[2], skeleton)"
  arguments+=("--peer=MSLS=python3 -c '$script' {mesh} {skeleton}")
else
  echo "PyGEL is not installed (pip install PyGEL3D): the table is without MSLS" >&2
fi
while (($#)); do
  case $1 in
    --quick) names=(elephant knot1) ;;
    --peer)
      arguments+=("--peer=$2")
      shift
      ;;
    *) meshes+=("$1") ;;
  esac
  shift
done
build_benchmarks benchmark_meshes >&2
if ((${#meshes[@]} == 0)); then
  meshes=("${names[@]/#/$build_dir/cgal_data/data/meshes/}")
  meshes=("${meshes[@]/%/.off}")
fi
"$build_dir/bin/benchmark/benchmark_meshes" --benchmark_repetitions=3 --benchmark_min_time=0.1 \
  --benchmark_filter=-2_threads --benchmark_out="$build_dir/benchmark_meshes.json" --benchmark_out_format=json \
  "${arguments[@]}" "${meshes[@]}" >&2
python3 "$source_dir/benchmark/tables.py" "$build_dir/benchmark_meshes.json"
