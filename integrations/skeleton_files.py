# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletonizes files by the Python module cscd or, where it cannot be imported, by the program cscd."""

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


def skeletonize_file(source, outputs, program="", **options):
    """Writes the skeleton of the file `source` to the files `outputs`, in the formats of their endings.

    program: the file of the program; if empty, the module is tried first
    options: of `cscd skeletonize`, such as detail=0.5
    Raises SkeletonError.
    """
    cscd = None
    if not program:
        try:
            import cscd
        except ImportError:
            pass  # then the program does it
    if cscd:
        try:
            shape = cscd.read(source)
            skeleton = cscd.skeletonize(shape.vertices, shape.faces, **options)
            for output in outputs:
                skeleton.save(output)
        except (ValueError, cscd.FileError) as error:
            raise SkeletonError(str(error)) from error
        return
    arguments = [find_program(program), "skeletonize", str(source), "--quiet"]
    for output in outputs:
        arguments += ["-o", str(output)]
    for name, value in options.items():
        arguments += ["--" + name.replace("_", "-"), str(value)]
    run = subprocess.run(arguments, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise SkeletonError(run.stderr.strip() or f"cscd: ended with status {run.returncode}; try another mesh")
