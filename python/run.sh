#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages (Debian, Ubuntu), builds the Python module cscd and runs its tests. Takes no arguments; may
# be run again.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$source_dir/build
# The Python of the packages, even if another is first in PATH.
python=/usr/bin/python3

# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
install_packages "${library_packages[@]}" "${python_packages[@]}"

echo "Building in $build_dir"
# In a build folder that has the tests or benchmarks, they stay.
configure=(cmake -S "$source_dir" -B "$build_dir" -G Ninja -DCSCD_BUILD_PYTHON=ON -DCSCD_WITH_ALL_METHODS=ON
  "-DPython_EXECUTABLE=$python")
if [[ ! -e $build_dir/CMakeCache.txt ]]; then
  configure+=(-DCSCD_BUILD_TESTS=OFF -DCSCD_BUILD_BENCHMARKS=OFF)
fi
"${configure[@]}" >/dev/null
cmake --build "$build_dir" --parallel "$(number_of_jobs)" --target cscd_python

CSCD_CGAL_DATA_DIR=$build_dir/cgal_data/data/meshes PYTHONPATH=$build_dir/python PYTHONDONTWRITEBYTECODE=1 \
  "$python" -m pytest --quiet -p no:cacheprovider "$source_dir/python/tests"

cat <<END

Done. The module is $build_dir/python/cscd:
  PYTHONPATH=$build_dir/python $python -c 'import cscd; help(cscd)'
  cmake --install $build_dir --component python     installs it
END
