# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A recipe for Conan 2, for `conan create cmake/conan` in a clone. Not tested by the project."""

import pathlib

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Cscd(ConanFile):
    name = "cscd"
    version = "0.2.0"
    license = "GPL-3.0-or-later"
    description = "Curve skeletons of triangle meshes and point clouds"
    settings = "os", "compiler", "build_type", "arch"
    package_type = "static-library"
    requires = "cgal/[>=5.5]", "eigen/[>=3.3 <4]", "boost/[>=1.74]", "onetbb/[>=2021]", "nlohmann_json/[>=3.11]"

    def export_sources(self):
        root = pathlib.Path(self.recipe_folder).parents[1]
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.variables["CSCD_BUILD_COMPILED"] = True
        for part in ("TESTS", "EXAMPLES", "BENCHMARKS"):
            toolchain.variables[f"CSCD_BUILD_{part}"] = False
        toolchain.variables["CSCD_DOCUMENTATION"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs.append("share/cmake/CSCD")
