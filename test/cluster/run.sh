#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: test/cluster/run.sh [NUMBER_OF_SHAPES]
# Installs missing packages (Debian, Ubuntu) and tries the recipes of doc/datasets.md on generated shapes, 10,000 by
# default: each splits the list, has a worker killed, and has to give the same files as one `cscd-batch`. Runs as root,
# as it starts its own Slurm, and needs the built program. Not a part of the other tests, as it takes minutes.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
number=${1:-10000}
# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
install_packages parallel python3-distributed python3-numpy slurmctld slurmd slurm-client munge util-linux
export PATH=$source_dir/build/bin:$PATH
cluster=$source_dir/examples/cluster
work=$(mktemp -d)
pids=()
clean_up()
{
  if [[ -e slurm.conf ]]; then # the remains of an interrupted run
    scancel --user root 2>/dev/null || true
    sleep 2
  fi
  for pid in "${pids[@]}"; do
    kill "$pid" 2>/dev/null || true
  done
  wait
  rm -rf "$work"
}
trap clean_up EXIT
cd "$work"

/usr/bin/python3 "$source_dir/test/cluster/write_shapes.py" shapes "$number"
find shapes -name '*.off' | sort >list

# run_and_kill <folder> <option of pgrep>... -- <command>... runs the command, and kills the first process that pgrep
# finds, a worker, when some results exist. CHILD among its options stands for the process of the command.
run_and_kill()
{
  local folder=$1 begin=$SECONDS
  local -a victim=()
  shift
  while [[ $1 != -- ]]; do
    victim+=("$1")
    shift
  done
  shift
  "$@" >"$folder.log" 2>&1 &
  local pid=$!
  while [[ $(find "$folder" -name '*.graph' 2>/dev/null | head -n 20 | wc -l) -lt 20 ]] && kill -0 "$pid"; do
    sleep 0.1
  done
  local killed
  killed=$(pgrep "${victim[@]/#CHILD/$pid}" | head -n 1)
  kill -KILL "$killed"
  if ! wait "$pid"; then
    cat "$folder.log"
    exit 1
  fi
  echo "$folder: process $killed killed, $((SECONDS - begin)) s"
}

# expect_same <folder> compares it with the folder of the single machine.
expect_same()
{
  diff --recursive --brief --exclude 'manifest*' --exclude '.cscd_batch*' one "$1"
  local manifest
  for manifest in one "$1"; do
    cat "$manifest"/manifest*.csv | grep -v '^input,' | cut -d, -f1-9 | sort >"$manifest.rows"
  done
  diff one.rows "$1.rows"
  [[ $(wc -l <one.rows) == "$number" ]]
  echo "$1: same $(find "$1" -name '*.graph' | wc -l) files as of one machine"
}

# The test is about how work is shared: little work for each shape.
options=(-- --separators 8)

begin=$SECONDS
cscd-batch --list list --output-dir one "${options[@]}" || [[ $? == 2 ]] # some shapes are broken
echo "one: $((SECONDS - begin)) s"

run_parallel()
{
  seq 1 8 | parallel --jobs 2 --retries 3 \
    cscd-batch --list list --output-dir "$work/parallel" --part '{}/8' --jobs 1 --resume "${options[@]}"
}
run_and_kill parallel --full "cscd-batch .*--output-dir $work/parallel " -- run_parallel
expect_same parallel

run_and_kill dask --parent CHILD --full spawn_main -- \
  /usr/bin/python3 "$cluster/dask_batch.py" list dask --parts 8 --workers 2 "${options[@]}"
expect_same dask

# shellcheck source=test/cluster/start_slurm.sh
source "$source_dir/test/cluster/start_slurm.sh"
run_slurm()
{
  sbatch --wait --array=1-8 --output slurm_task.log "$cluster/slurm_array.sh" list "$work/slurm" "${options[@]}" ||
    [[ $? == 2 ]] # the greatest status of the tasks; one task has broken shapes
}
run_and_kill slurm --full "cscd-batch .*--output-dir $work/slurm " -- run_slurm
expect_same slurm
