# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For scripts of bash, to be read by `source`: sets source_dir and build_dir.
# shellcheck shell=bash

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$source_dir/build
# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"

# build_benchmarks [<program>...] installs missing packages (Debian, Ubuntu) and builds the programs in a Release build.
build_benchmarks()
{
  install_packages "${library_packages[@]}" git libbenchmark-dev python3
  # In a build folder that has the tests or examples, they stay.
  local -a configure=(
    cmake -S "$source_dir" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCSCD_BUILD_BENCHMARKS=ON
    -DCSCD_WITH_ALL_METHODS=ON -DCSCD_PROGRAM_FLAGS=)
  if [[ ! -e $build_dir/CMakeCache.txt ]]; then
    configure+=(-DCSCD_BUILD_TESTS=OFF)
  fi
  "${configure[@]}" >/dev/null
  if (($#)); then
    cmake --build "$build_dir" --parallel "$(number_of_jobs)" --target "$@"
  fi
}
