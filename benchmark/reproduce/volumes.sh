#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints the topology, accuracy and time of skeletons of volumes, compared with the thinning of scikit-image where
# Debian's package python3-skimage is installed.
# Usage: benchmark/reproduce/volumes.sh FOLDER [SIZE]
# FOLDER gets the volumes, about 400 MB. The volume with a hundred labels has SIZE voxels along each side, 512 by default.

set -euo pipefail

# shellcheck source=benchmark/build_benchmarks.sh
source "$(dirname "${BASH_SOURCE[0]}")/../build_benchmarks.sh"

build_benchmarks cscd
/usr/bin/python3 "$(dirname "${BASH_SOURCE[0]}")/volumes.py" "$build_dir/bin/cscd" "$@"
