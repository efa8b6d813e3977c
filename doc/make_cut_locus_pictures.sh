#!/bin/sh
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the pictures of doc/cut_locus.md: cut loci on meshes of CGAL's data, and on their vertices without faces, the
# source black, its cut locus red; all seen from both sides.
# Usage: doc/make_cut_locus_pictures.sh PROGRAMS [FOLDER]: the folder of the built cut_locus_example, and where pictures
# go, by default doc/fig. Needs three.js when the example is built, Chromium, and Debian's libcgal-demo.

set -eu

if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  echo "usage: $0 PROGRAMS [FOLDER] (the folder of the built cut_locus_example; where pictures go)" >&2
  exit 1
fi
programs=$(cd "$1" && pwd)
figures=${2:-$(dirname "$0")/fig}
mkdir -p "$figures"
figures=$(cd "$figures" && pwd)
archive=/usr/share/doc/libcgal-dev/data.tar.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tar -xzf "$archive" -C "$work" --wildcards 'data/meshes/*.off'

# take PICTURE ADDRESS SWITCH... makes a screenshot of a file in the folder of work, with switches of Chromium.
take() {
  picture=$figures/$1.png
  address=file://$work/$2
  shift 2
  timeout 120 chromium --headless --no-sandbox --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --disable-quic --disable-dev-shm-usage --hide-scrollbars \
    --window-size=560,560 --user-data-dir="$work/profile" "$@" --screenshot="$picture" "$address" \
    2>"$work/chromium.log" || { cat "$work/chromium.log" >&2; exit 1; }
  echo "$picture"
}

# take_page PICTURE TURN makes a screenshot of the page of the last mesh, whose address carries switches. Graphics are
# computed in software, which works on machines without a graphics card.
take_page() {
  take "$1" "cut_locus.html#separators=1&opacity=100&balls=1&panel=0&turn=$2" --use-angle=swiftshader \
    --enable-unsafe-swiftshader --ignore-gpu-blocklist --virtual-time-budget=5000
}

# draw SOURCE TURN prints a picture of points.xyz with the curves of the program, the upright body turned by so many
# degrees. Points are discs so large that near ones hide far ones: all shapes are sorted by depth, which each line has in
# front. Curves lie a little nearer than their points.
draw() {
  awk -v source="$1" -v turn="$2" '
    function put(x, y, z) {
      depth = (-sine * x + cosine * z) / extent
      across = 280 + 520 * (cosine * x + sine * z) / extent
      down = 280 - 520 * y / extent
    }
    FNR == NR {
      for (k = 1; k <= 3; ++k) {
        if (FNR == 1 || $k < low[k]) { low[k] = $k }
        if (FNR == 1 || $k > high[k]) { high[k] = $k }
      }
      n = FNR
      next
    }
    FNR == 1 && !extent {
      for (k = 1; k <= 3; ++k) {
        middle[k] = (low[k] + high[k]) / 2
        extent = high[k] - low[k] > extent ? high[k] - low[k] : extent
      }
      sine = sin(turn * 3.14159265 / 180)
      cosine = cos(turn * 3.14159265 / 180)
      radius = 780 / sqrt(n)
    }
    FILENAME ~ /xyz$/ {
      put($1 - middle[1], $2 - middle[2], $3 - middle[3])
      shade = int(214 + 70 * depth)
      printf "%.6f <circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"rgb(%d,%d,%d)\"/>\n", depth, across, down, radius,
        shade - 8, shade, shade + 10
      printf "%.6f <circle cx=\"%.1f\" cy=\"%.1f\" r=\"0.7\" fill=\"#7884a0\"/>\n", depth + 2 * radius / 520, across, down
      if (FNR == source + 1) {
        printf "%.6f <circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\"/>\n", depth + 6 * radius / 520, across, down
      }
      next
    }
    {
      for (i = 0; i < $1; ++i) {
        put($(3 * i + 2) - middle[1], $(3 * i + 3) - middle[2], $(3 * i + 4) - middle[3])
        if (i > 0) {
          printf "%.6f <path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#e00000\" stroke-width=\"2.5\" stroke-linecap=\"round\"/>\n",
            depth + 4 * radius / 520, old_across, old_down, across, down
        }
        old_across = across
        old_down = down
      }
    }' "$work/points.xyz" "$work/points.xyz" "$work/cut_locus.polylines.txt" | sort -n | cut -d ' ' -f 2- |
    { echo '<svg xmlns="http://www.w3.org/2000/svg" width="560" height="560">'; cat; echo '</svg>'; }
}

# take_drawing PICTURE SOURCE TURN makes a screenshot of a drawing of the last points.
take_drawing() {
  draw "$2" "$3" >"$work/picture.svg"
  take "$1" picture.svg --disable-gpu
}

# show_mesh MESH VERTEX TURN makes two pictures of the cut locus of a vertex: from one side, and from the opposite one.
show_mesh() {
  (cd "$work" && "$programs/cut_locus_example" "data/meshes/$1.off" "$2" >/dev/null)
  take_page "cut_locus_$1" "$3"
  take_page "cut_locus_$1_behind" $(($3 + 180))
}

# show_points NAME MESH POINT TURN makes the same two pictures for the vertices of a mesh as points.
show_points() {
  awk 'NR == 2 { n = $1 } NR > 2 && NF >= 3 && n-- > 0 { print $1, $2, $3 }' "$work/data/meshes/$2.off" \
    >"$work/points.xyz"
  (cd "$work" && "$programs/cut_locus_example" points.xyz "$3" >/dev/null)
  take_drawing "point_cut_locus_$1" "$3" "$4"
  take_drawing "point_cut_locus_$1_behind" "$3" $(($4 + 180))
}

show_mesh camel 100 0
show_mesh elephant 100 330
show_mesh armadillo 100 180
show_points armadillo armadillo 100 180
show_points elephant refined_elephant 100 330
show_points bear bear 100 0
