# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the Python module and the program by CMake in build-pip. The variable CMAKE_ARGS holds options for CMake."""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

import setuptools
from distutils.command.build_scripts import build_scripts  # that of setuptools
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).parent.resolve()
BUILD = SOURCE / "build-pip"
VERSION = re.search(r'CSCD_VERSION "(.*)"', (SOURCE / "include/CSCD/version.h").read_text(encoding="utf-8")).group(1)


class Build_module(build_ext):
    def run(self):
        options = ["-DCSCD_BUILD_PYTHON=ON", "-DCSCD_BUILD_TESTS=OFF", "-DCSCD_BUILD_BENCHMARKS=OFF"]
        options += [f"-DPython_EXECUTABLE={sys.executable}", "-DCSCD_PYTHON_DESTINATION=."]
        options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.run(["cmake", "-S", SOURCE, "-B", BUILD, "-G", "Ninja", *options], check=True)
        subprocess.run(["cmake", "--build", BUILD, "--target", "cscd_python", "cscd"], check=True)
        subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", self.build_lib], check=True)

    def get_outputs(self):
        return []


class Copy_programs(build_scripts):
    def run(self):
        self.mkpath(self.build_dir)
        for program in ("cscd", "cscd-batch"):
            shutil.copy2(BUILD / "bin" / program, self.build_dir)


BUILD.mkdir(exist_ok=True)
setuptools.setup(
    version=VERSION,
    packages=[],
    ext_modules=[setuptools.Extension("cscd._core", [])],
    scripts=["program/cscd_batch.py"],
    cmdclass={"build_ext": Build_module, "build_scripts": Copy_programs},
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
)
