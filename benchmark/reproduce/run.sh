#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages (Debian, Ubuntu), builds the programs of an experiment, runs it, and prints its tables.
# Usage: benchmark/reproduce/run.sh NAME [PATH...] [OPTION...]
#
# NAME          PATH...               tables in doc/results.md
# performance
# geodesics
# published     folders of closed meshes in OFF format, in addition to CGAL's
# points        likewise
# graphs        likewise
# trees         scans in XYZ format
# volumes       a folder that gets the volumes, about 100 MB
# connectomics  the volume of Kimimaro's benchmark, decoded: see truths.py
# rigs          quaternius-showcase/public/glb; the table is in doc/applications.md
# vessels       OpenCCO/ExpeIPOL
# applications  PRINCETON [TOSCA [FAUST]]: see applications.py
# quality       folders of meshes; by default CGAL's
# pictures                            pictures of all pages
#
# Options of the first six: --write replaces the tables in the pages and in README.md; --repetitions N, by default 3,
# is for timed programs; --quick measures little, as a test of the scripts. applications.py and quality.py have others.

set -euo pipefail

command="benchmark/reproduce/run.sh $*"
# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/../build_benchmarks.sh"

declare -A targets=(
  [performance]=benchmark_meshes
  [geodesics]=benchmark_geodesics
  [published]="cscd make_input mcf_skeleton"
  [points]="cscd make_input"
  [graphs]="cscd make_input"
  [trees]=measure_trees
  [volumes]=cscd
  [connectomics]=cscd
  [rigs]=cscd
  [vessels]=cscd
  [applications]="cscd measure_applications"
  [quality]=cscd
  [pictures]="cscd mcf_skeleton cut_locus_example"
)
name=${1:-}
if [[ -z ${targets[$name]+is_set} ]]; then
  sed -n '6,24s/^# \?//p' "$0" >&2
  exit 1
fi
shift
install_packages python3-numpy python3-scipy
read -r -a programs <<<"${targets[$name]}"
build_benchmarks "${programs[@]}" >&2
export PYTHONPATH=$source_dir/benchmark PYTHONDONTWRITEBYTECODE=1
scripts=$source_dir/benchmark/reproduce
case $name in
  connectomics | rigs | vessels) exec /usr/bin/python3 "$scripts/truths.py" "$build_dir" "$name" "$@" ;;
  volumes | applications | quality) exec /usr/bin/python3 "$scripts/$name.py" "$build_dir" "$@" ;;
  pictures)
    install_packages chromium python3-matplotlib python3-pil
    figures=$source_dir/doc/fig
    "$source_dir/doc/make_screenshots.sh" "$build_dir/bin/cscd" "$figures"
    /usr/bin/python3 "$source_dir/doc/make_figures.py" --program "$build_dir/bin/cscd" --output "$figures"
    "$source_dir/doc/make_cut_locus_pictures.sh" "$build_dir/bin" "$figures"
    ;;
  *) exec /usr/bin/python3 "$scripts/experiments.py" "$build_dir" "$command" "$name" "$@" ;;
esac
