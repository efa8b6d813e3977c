#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages (Debian, Ubuntu), builds everything, checks format and style, and runs the tests: the tests
# that take seconds first, then those that take longer. Meanwhile, clang-tidy and sanitizers run. Takes no arguments; may
# be run again.

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

# begin_in_background <name> <command>... starts a command that takes the processor time that the steps leave. It is
# awaited at the end, and has a process group of its own, so that it can be ended whole.
background_names=()
background_groups=()
background_outputs=()
begin_in_background()
{
  background_names+=("$1")
  background_outputs+=("$(mktemp)")
  shift
  set -m
  ( renice -n 19 -p "$BASHPID" >/dev/null && "$@" ) >"${background_outputs[-1]}" 2>&1 &
  background_groups+=($!)
  set +m
}
end_background()
{
  local group
  for group in "${background_groups[@]}"; do
    kill -- "-$group" 2>/dev/null || true
  done
  rm -f "${background_outputs[@]}"
}
trap end_background EXIT
# finish_in_background <index>
finish_in_background()
{
  local status=0
  wait "${background_groups[$1]}" || status=$?
  cat "${background_outputs[$1]}"
  return "$status"
}

# The sanitized tests run at once: one of the address sanitizer takes longer than all others.
check_by_sanitizers()
{
  build_preset asan-ubsan
  build_preset tsan
  run_tests tsan &
  run_tests asan-ubsan --parallel "$jobs"
  wait $!
}

# clang-tidy reads one file for minutes: it starts first. The sanitizers start when the large build is over, so that two
# builds do not share the memory.
begin_in_background "clang-tidy" build_preset tidy
step "build" cmake --build --preset checked --parallel "$jobs"
begin_in_background "sanitizers" check_by_sanitizers
step "fast tests" run_tests checked --parallel "$jobs" --label-exclude 'slow|python|web'
step "Python module" run_tests checked --label-regex python
step "slow tests" run_tests checked --parallel "$jobs" --label-regex slow
for index in "${!background_names[@]}"; do
  step "${background_names[$index]}, the rest of it" finish_in_background "$index"
done

echo "Seconds of each step, $SECONDS in all:"
printf '%s\n' "${summary[@]}"
# lines_of <path>... the lines of code that Git knows
lines_of()
{
  git ls-files -z "$@" | xargs -0 cat | wc -l
}
echo "Lines of code:"
echo "$(lines_of include src) include, src"
echo "$(lines_of 'test/*.cpp' 'test/*.h' 'test/*.py' 'test/*.js') test"
echo "$(lines_of 'benchmark/*.cpp' 'benchmark/*.h' 'benchmark/*.py' 'benchmark/*.sh') benchmark"
echo "CPU time of the shell, and of all that it ran (user, system):"
times # in a pipe, it would report those of a subshell
