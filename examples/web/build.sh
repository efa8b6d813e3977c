#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages (Debian, Ubuntu) and builds the page that computes, build/web/cscd.html: one file, which
# works offline. Takes no arguments; may be run again. It takes minutes. The other builds do not include it.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_dir=$source_dir/build/web

# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
install_packages emscripten cmake ninja-build python3 libcgal-dev libeigen3-dev libboost-dev nlohmann-json3-dev \
  libjs-three

# Debian's Emscripten looks for the packages of Node there.
export NODE_PATH=/usr/share/nodejs
echo "Building in $build_dir"
emcmake cmake -S "$source_dir/examples/web" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$build_dir" --parallel "$(number_of_jobs)"

echo "Done. Open $build_dir/cscd.html in a web browser."
