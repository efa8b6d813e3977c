#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# examples/run.sh [--all-methods]
# installs missing packages (Debian, Ubuntu), builds the program cscd, skeletonizes a real mesh and a real point set, and
# names the files to open. May be run again. With --all-methods, the program also has the published method, the method
# for graphs, and wraps.

set -euo pipefail

if (($#)) && [[ $* != --all-methods ]]; then
  echo "run.sh: $*: is not an argument; the only one is --all-methods" >&2
  exit 1
fi

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$source_dir/build
output_dir=$build_dir/examples-output
# Of libcgal-demo: 2775 vertices, four legs and a trunk.
mesh=$build_dir/cgal_data/data/meshes/elephant.off
# Of libcgal-demo, too: 5210 points of a kitten.
archive=/usr/share/doc/libcgal-dev/data.tar.gz
points=data/points_3/kitten.xyz

# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
install_packages "${library_packages[@]}"

# A build folder keeps the tests, benchmarks and methods that it has.
configure=(cmake -S "$source_dir" -B "$build_dir" -G Ninja)
if [[ ! -e $build_dir/CMakeCache.txt ]]; then
  configure+=(-DCSCD_BUILD_TESTS=OFF -DCSCD_BUILD_BENCHMARKS=OFF -DCSCD_WITH_ALL_METHODS=OFF)
fi
if (($#)); then
  configure+=(-DCSCD_WITH_ALL_METHODS=ON)
fi
echo "Building in $build_dir: two to four minutes on two cores, once; with --all-methods, half as long again"
"${configure[@]}" >/dev/null
cmake --build "$build_dir" --parallel "$(number_of_jobs)" --target cscd

echo "Skeletonizing $mesh"
mkdir -p "$output_dir"
"$build_dir/bin/cscd" skeletonize "$mesh" \
  --output "$output_dir/elephant.graph" --output "$output_dir/elephant.obj" \
  --report "$output_dir/elephant.json" --output "$output_dir/elephant.html"

echo "Skeletonizing $points of CGAL's data"
tar --extract --gzip --file "$archive" --directory "$output_dir" --strip-components 2 "$points"
"$build_dir/bin/cscd" skeletonize "$output_dir/kitten.xyz" \
  --output "$output_dir/kitten.graph" --output "$output_dir/kitten.html"

cat <<END

Done. Look at
  $output_dir/elephant.html    in a web browser: the mesh and its skeleton
  $output_dir/elephant.graph   the skeleton: lines "n x y z" and "c i j"
  $output_dir/elephant.obj     the skeleton as polylines, for Blender or MeshLab
  $output_dir/elephant.json    counts and timings
  $output_dir/kitten.html      the points, the surface made of them, and its skeleton
  $build_dir/bin/cscd          the program; the target cscd_examples builds the small examples, too
END
