#!/bin/sh
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the pictures in doc/fig that show the viewer page, without its panel: skeletonizes shapes of CGAL's data, a generated
# volume and a generated scan of a tree, and takes screenshots of their pages.
# Usage: doc/make_screenshots.sh PROGRAM [FOLDER]: the path of a built cscd, and where pictures go, by default
# doc/fig. Needs Chromium, and Debian's libcgal-demo and python3-numpy.

set -eu

if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  echo "usage: $0 PROGRAM [FOLDER] (the path of a built cscd; where pictures go)" >&2
  exit 1
fi
program=$1
figures=${2:-$(dirname "$0")/fig}
mkdir -p "$figures"
figures=$(cd "$figures" && pwd)
archive=/usr/share/doc/libcgal-dev/data.tar.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tar -xzf "$archive" -C "$work" --wildcards 'data/meshes/*.off' 'data/points_3/*'

# take PICTURE INPUT SWITCHES [OPTION...] makes one screenshot of the page of a file of CGAL's data; the switches are those
# that the page's address can carry, the options those of the program.
# Graphics are computed in software, which works on machines without a graphics card.
take() {
  picture=$1 input=$2 switches=$3
  shift 3
  page=$work/data/$input.html
  if [ ! -e "$page" ] || [ $# -gt 0 ]; then
    "$program" skeletonize "$work/data/$input" -o "$page" --quiet "$@"
  fi
  timeout 120 chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader \
    --ignore-gpu-blocklist --no-first-run --disable-background-networking --disable-component-update --disable-sync \
    --disable-quic --disable-dev-shm-usage --hide-scrollbars --window-size=1600,1000 --virtual-time-budget=5000 \
    --user-data-dir="$work/profile" --screenshot="$figures/$picture.png" "file://$page#panel=0&background=white&$switches" 2>"$work/chromium.log" ||
    { cat "$work/chromium.log" >&2; exit 1; }
  echo "$figures/$picture.png"
}

take viewer_camel_branches meshes/camel.off "separators=1&color=1"
take viewer_elephant_balls meshes/elephant.off "balls=1&surface=0"
take viewer_kitten_points points_3/kitten.xyz "points=1&repairs=1"
take viewer_hippo_repairs points_3/hippo1.ply "repairs=1"
take viewer_graph meshes/camel.off "up=y" --as graph
# A tree of vessels as voxels, and points on the bark of a tree.
PYTHONPATH=$(dirname "$0") /usr/bin/python3 -c "import numpy, make_figures
volumes = make_figures.volumes
vessels = volumes.vessel_tree(4, numpy.random.default_rng(volumes.RNG_SEED))
volumes.write_nrrd('$work/data/vessels.nrrd', volumes.Tube(vessels).fill(96))
numpy.savetxt('$work/data/tree.xyz', make_figures.tree_scan(numpy.random.default_rng(make_figures.SEED)), '%.5f')"
take viewer_volume vessels.nrrd "up=z"
take viewer_tree tree.xyz "points=1&color=1&up=z" --shape tree
