#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_symbols.sh FILE: what manylinux_2_28 asks of a shared library. Fails if it needs a newer glibc, any version of
# libstdc++ or a library that is not part of every system.

set -euo pipefail
newest=2.28
allowed='^(libc|libm|libpthread|libgcc_s|ld-linux-x86-64)\.so\.[0-9]+$'

faults=$(objdump --dynamic-syms "$1" | awk -v newest="$newest" '
  /\*UND\*/ && match($0, /\((GLIBC|GLIBCXX|CXXABI)_[0-9.]+\)/) {
    split(substr($0, RSTART + 1, RLENGTH - 2), version, "_")
    split(version[2], number, ".")
    split(newest, most, ".")
    if (version[1] != "GLIBC" || number[1] + 0 > most[1] + 0 || (number[1] == most[1] && number[2] + 0 > most[2] + 0))
      print $NF " of " version[1] " " version[2]
  }')
faults+=$(objdump --private-headers "$1" | awk -v allowed="$allowed" '
  $1 == "NEEDED" && $2 !~ allowed { print "\nlibrary " $2 }')
if [[ -n $faults ]]; then
  echo "$1 needs more than manylinux_2_28 has: $faults" >&2
  exit 1
fi
