#!/bin/sh
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the pictures in doc/fig: skeletonizes meshes and points of CGAL's data and takes screenshots of the viewer pages.
# Usage: doc/make_screenshots.sh PROGRAM [FOLDER]: the path of a built cscd, and where pictures go, by default
# doc/fig. Needs Chromium and Debian's libcgal-demo. The picture of a tree is made if the environment variable
# CSCD_BENCHMARK_TREES names a folder with the scan tree1.xyz.

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

# take PICTURE INPUT SWITCHES makes one screenshot of the page of a file of CGAL's data; the switches are those that the
# page's address can carry.
# Graphics are computed in software, which works on machines without a graphics card.
take() {
  page=$work/data/$2.html
  if [ ! -e "$page" ]; then
    "$program" skeletonize "$work/data/$2" --html "$page" --quiet
  fi
  timeout 120 chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader \
    --ignore-gpu-blocklist --no-first-run --disable-background-networking --disable-component-update --disable-sync \
    --disable-quic --disable-dev-shm-usage --hide-scrollbars --window-size=1280,800 --virtual-time-budget=5000 \
    --user-data-dir="$work/profile" --screenshot="$figures/$1.png" "file://$page#$3" 2>"$work/chromium.log" ||
    { cat "$work/chromium.log" >&2; exit 1; }
  echo "$figures/$1.png"
}

take viewer_armadillo meshes/armadillo.off "turn=180"
take viewer_camel_branches meshes/camel.off "separators=1&color=1"
take viewer_elephant_balls meshes/elephant.off "balls=1&surface=0"
take viewer_kitten_points points_3/kitten.xyz "points=1&repairs=1"
take viewer_hippo_repairs points_3/hippo1.ply "repairs=1"
if [ -n "${CSCD_BENCHMARK_TREES:-}" ]; then
  cp "$CSCD_BENCHMARK_TREES/tree1.xyz" "$work/data"
  take viewer_tree tree1.xyz "points=1&color=1&up=z"
fi
