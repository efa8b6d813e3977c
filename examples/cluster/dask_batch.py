# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletonizes the shapes that a list names on the workers of Dask: each task does a part of them.

Usage: dask_batch.py LIST OUTPUT_FOLDER [--parts N] [--scheduler ADDRESS | --workers N] [-- option of skeletonize...]

cscd and cscd-batch have to be in the PATH of the workers, list and folder on a file system that they share. Without a
scheduler, workers are processes of this machine. Started once more, with the same number of parts, it does what is
left.
"""

import argparse
import subprocess
import sys

import distributed


def run_part(part, options):
    """Runs `cscd-batch` on a part; it ends with the worker, so that another one can take over.

    Returns its last message if it ended by itself; raises if it was killed, for Dask to try again."""
    command = ["setpriv", "--pdeathsig", "KILL", "cscd-batch", "--part", part, "--jobs", "1", "--resume", *options]
    outcome = subprocess.run(command, capture_output=True, text=True, check=False)
    if outcome.returncode < 0 or outcome.returncode > 2:
        raise RuntimeError(f"part {part} was ended by status {outcome.returncode}: {outcome.stderr}")
    return f"part {part}: {outcome.stdout}{outcome.stderr}".strip()


def main():
    arguments = sys.argv[1:]
    end = arguments.index("--") if "--" in arguments else len(arguments)
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("list")
    parser.add_argument("folder")
    parser.add_argument("--parts", type=int, default=16)
    parser.add_argument("--scheduler")
    parser.add_argument("--workers", type=int)
    given = parser.parse_args(arguments[:end])

    cluster = given.scheduler or distributed.LocalCluster(
        n_workers=given.workers, threads_per_worker=1, protocol="tcp://", dashboard_address=None
    )
    options = ["--list", given.list, "--output-dir", given.folder, *arguments[end:]]
    with distributed.Client(cluster) as client:
        parts = [f"{i + 1}/{given.parts}" for i in range(given.parts)]
        futures = client.map(run_part, parts, options=options, retries=3, pure=False)
        for _, message in distributed.as_completed(futures, with_results=True):
            print(message, flush=True)


if __name__ == "__main__":
    main()
