#!/bin/sh
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the pictures of doc/cut_locus.md in doc/fig: cut loci on meshes of CGAL's data, seen from both sides.
# Usage: doc/make_cut_locus_pictures.sh PROGRAM [FOLDER]: the path of a built cut_locus_example, and where pictures go,
# by default doc/fig. Needs three.js when that is built, Chromium, and Debian's libcgal-demo.

set -eu

if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  echo "usage: $0 PROGRAM [FOLDER] (the path of a built cut_locus_example; where pictures go)" >&2
  exit 1
fi
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
figures=${2:-$(dirname "$0")/fig}
mkdir -p "$figures"
figures=$(cd "$figures" && pwd)
archive=/usr/share/doc/libcgal-dev/data.tar.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tar -xzf "$archive" -C "$work" --wildcards 'data/meshes/*.off'

# take PICTURE SWITCHES makes a screenshot of the page of the last mesh; the switches are those that the page's address
# can carry. Graphics are computed in software, which works on machines without a graphics card.
take() {
  timeout 120 chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader \
    --ignore-gpu-blocklist --no-first-run --disable-background-networking --disable-component-update --disable-sync \
    --disable-quic --disable-dev-shm-usage --hide-scrollbars --window-size=560,560 --virtual-time-budget=5000 \
    --user-data-dir="$work/profile" --screenshot="$figures/$1.png" \
    "file://$work/cut_locus.html#separators=1&opacity=100&balls=1&panel=0&$2" 2>"$work/chromium.log" ||
    { cat "$work/chromium.log" >&2; exit 1; }
  echo "$figures/$1.png"
}

# show MESH VERTEX TURN makes two pictures of the cut locus of a vertex: from one side, and from the opposite one.
show() {
  (cd "$work" && "$program" "data/meshes/$1.off" "$2" >/dev/null)
  take "cut_locus_$1" "turn=$3"
  take "cut_locus_$1_behind" "turn=$(($3 + 180))"
}

show camel 100 0
show elephant 100 330
show armadillo 100 180
