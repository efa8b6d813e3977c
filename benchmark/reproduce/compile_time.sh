#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages (Debian, Ubuntu), measures the cost of compiling programs that use the library, and writes
# the table to doc/performance.md. A round takes four minutes on a machine without other work, with a revision five.
# Usage: benchmark/reproduce/compile_time.sh [--rounds N] [--revision REVISION] [--parts] [--print], see benchmark/reproduce/compile_time.py.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
install_packages "${library_packages[@]}" git python3
python3 "$source_dir/benchmark/reproduce/compile_time.py" "$@"
