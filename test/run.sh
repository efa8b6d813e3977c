#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages (Debian, Ubuntu), builds everything, checks format and style, and runs the tests: the tests
# that take seconds first, then parts under sanitizers, then the tests that take longer. Takes no arguments; may be run
# again.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$source_dir"
# shellcheck source=cmake/install_packages.sh
source cmake/install_packages.sh

summary=()
# step <name> <command>... runs the command, and prints how many seconds it took.
step()
{
  local name=$1
  shift
  echo "== $name"
  local begin=$SECONDS
  "$@"
  summary+=("$(printf '%6d %s' $((SECONDS - begin)) "$name")")
  echo "== $name: $((SECONDS - begin)) s"
}

# Node.js of other sources brings npm, and excludes the package.
node_packages=()
command -v node >/dev/null || node_packages+=(nodejs)
command -v npm >/dev/null || node_packages+=(npm)
step "packages" install_packages "${library_packages[@]}" "${python_packages[@]}" libgtest-dev libbenchmark-dev \
  chromium clang clang-format clang-tidy ccache doxygen dpkg-dev file python3 \
  ${node_packages[@]+"${node_packages[@]}"}
jobs=$(number_of_jobs)

# configure <preset> [<option>...]
configure()
{
  cmake --preset "$@" --log-level=WARNING >/dev/null
}

# build_preset <preset> [<option of the build>...]
build_preset()
{
  local preset=$1
  shift
  configure "$preset"
  cmake --build --preset "$preset" --parallel "$jobs" "$@"
}

# run_tests <preset> [<option of ctest>...] runs tests. In continuous integration, a test that skips itself fails.
run_tests()
{
  local output
  output=$(mktemp)
  ctest --preset "$@" | tee "$output"
  local status=0
  if [[ -n ${CI:-} ]] && grep '[(]Skipped[)]$' "$output"; then
    echo "Tests were skipped: install the tools that they miss" >&2
    status=1
  fi
  rm -f "$output"
  return "$status"
}

step "configure" configure checked
step "format" cmake --build --preset checked --target format_check
step "order of includes" run_tests checked --tests-regex '^includes_point_down'

# clang-tidy reads one file for minutes: it starts first, takes what the others leave, and is awaited at the end.
output_of_tidy=$(mktemp)
set -m # a process group of its own, so that it can be ended whole
{
  configure tidy
  nice -n 19 cmake --build --preset tidy
} >"$output_of_tidy" 2>&1 &
tidy=$!
set +m
trap 'kill -- "-$tidy" 2>/dev/null || true; rm -f "$output_of_tidy"' EXIT
finish_tidy()
{
  local status=0
  wait "$tidy" || status=$?
  cat "$output_of_tidy"
  return "$status"
}

step "build" cmake --build --preset checked --parallel "$jobs"
step "fast tests" run_tests checked --parallel "$jobs" --label-exclude 'slow|python|web'
step "Python module" run_tests checked --label-regex python
step "build for the address sanitizer" build_preset asan-ubsan
step "tests under the address sanitizer" run_tests asan-ubsan --parallel "$jobs"
step "build for the thread sanitizer" build_preset tsan
step "tests under the thread sanitizer" run_tests tsan
step "slow tests" run_tests checked --parallel "$jobs" --label-regex slow
step "clang-tidy, the rest of it" finish_tidy

echo "Seconds of each step, $SECONDS in all:"
printf '%s\n' "${summary[@]}"
echo "CPU time of the shell, and of all that it ran (user, system):"
times # in a pipe, it would report those of a subshell
