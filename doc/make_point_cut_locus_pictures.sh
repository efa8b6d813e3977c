#!/bin/sh
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the pictures of clouds of doc/cut_locus.md: cut loci on the vertices of meshes of CGAL's data, without their
# faces, seen from both sides: the source black, its cut locus red.
# Usage: doc/make_point_cut_locus_pictures.sh PROGRAM [FOLDER]: the path of a built point_cut_locus_example, and where
# pictures go, by default doc/fig. Needs Chromium and Debian's libcgal-demo.

set -eu

if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  echo "usage: $0 PROGRAM [FOLDER] (the path of a built point_cut_locus_example; where pictures go)" >&2
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

# draw SOURCE TURN prints a picture of points.xyz with the curves of the program, seen from the side to which the
# upright body is turned, in degrees. Points are discs so large that near ones hide far ones: what is drawn is sorted by
# depth, which each line has in front. Curves lie a little nearer than their points.
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
    }' "$work/points.xyz" "$work/points.xyz" "$work/point_cut_locus.polylines.txt" | sort -n | cut -d ' ' -f 2- |
    { echo '<svg xmlns="http://www.w3.org/2000/svg" width="560" height="560">'; cat; echo '</svg>'; }
}

# take PICTURE SOURCE TURN makes a screenshot of what is drawn.
take() {
  draw "$2" "$3" >"$work/picture.svg"
  timeout 120 chromium --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --disable-quic --disable-dev-shm-usage --hide-scrollbars \
    --window-size=560,560 --user-data-dir="$work/profile" --screenshot="$figures/$1.png" \
    "file://$work/picture.svg" 2>"$work/chromium.log" || { cat "$work/chromium.log" >&2; exit 1; }
  echo "$figures/$1.png"
}

# show NAME MESH POINT TURN makes two pictures of the cut locus of a point: from one side, and from the opposite one.
show() {
  awk 'NR == 2 { n = $1 } NR > 2 && NF >= 3 && n-- > 0 { print $1, $2, $3 }' "$work/data/meshes/$2.off" \
    >"$work/points.xyz"
  (cd "$work" && "$program" points.xyz "$3" >/dev/null)
  take "point_cut_locus_$1" "$3" "$4"
  take "point_cut_locus_$1_behind" "$3" $(($4 + 180))
}

mkdir -p "$figures"
show armadillo armadillo 100 180
show elephant refined_elephant 100 330
show bear bear 100 0
