# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletonizes files by the program cscd."""

import os
import pathlib
import shutil
import subprocess


class SkeletonError(Exception):
    """The message names the fault and the remedy."""


def find_program(program=""):
    """`program` if it is given, else cscd next to this file, else that on the path."""
    folders = f"{pathlib.Path(__file__).parent}{os.pathsep}{os.environ.get('PATH', '')}"
    found = shutil.which(program or "cscd", path=None if program else folders)
    if not found:
        raise SkeletonError(f"{program or 'cscd'}: is not a program; install cscd, or name its file in the settings")
    return found


def skeletonize_file(source, output, program="", **options):
    """Writes the skeleton of the file `source` to the file `output`, in the format of its ending.

    program: the file of the program, see find_program()
    options: of `cscd skeletonize`, such as detail=0.5
    Raises SkeletonError.
    """
    arguments = [find_program(program), "skeletonize", str(source), "--quiet", "-o", str(output)]
    for name, value in options.items():
        arguments += ["--" + name, str(value)]
    run = subprocess.run(arguments, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise SkeletonError(run.stderr.strip() or f"cscd: ended with status {run.returncode}; try another mesh")
