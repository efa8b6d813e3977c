#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Skeletonizes the shapes that a list names as an array job of Slurm: each task does a part of them.
#   sbatch --array=1-16 slurm_array.sh LIST OUTPUT_FOLDER [-- option of skeletonize...]
# cscd and cscd-batch have to be in PATH, list and folder on a file system that all nodes share. If submitted again with
# the same number of tasks, it does the remaining shapes.

#SBATCH --job-name=cscd
#SBATCH --array=1-8
#SBATCH --requeue
#SBATCH --open-mode=append

set -euo pipefail

list=$1
folder=$2
shift 2

status=0
cscd-batch --list "$list" --output-dir "$folder" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
  --jobs "${SLURM_CPUS_PER_TASK:-1}" --resume "$@" || status=$?

# If killed, for example when a node runs out of memory, it continues with the remaining shapes, at most three times.
if ((status > 128 && ${SLURM_RESTART_COUNT:-0} < 3)); then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$status"
