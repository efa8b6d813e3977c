#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing (Debian, Ubuntu) and builds the manual. Takes no arguments; may be run again.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$source_dir/build

# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
install_packages "${library_packages[@]}" doxygen

# In a build folder that has the tests, examples or benchmarks, they stay.
configure=(cmake -S "$source_dir" -B "$build_dir" -G Ninja -DCSCD_DOCUMENTATION=ON)
if [[ ! -e $build_dir/CMakeCache.txt ]]; then
  configure+=(-DCSCD_BUILD_TESTS=OFF -DCSCD_BUILD_EXAMPLES=OFF -DCSCD_BUILD_BENCHMARKS=OFF)
fi
"${configure[@]}" >/dev/null
cmake --build "$build_dir" --target documentation
