# SPDX-License-Identifier: MIT
"""Conan 2: the shared library libcageproof.so with its C and C++ headers (docs/library.md). The program is built without Conan."""

import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load
from conan.tools.system.package_manager import Apt


class Cageproof(ConanFile):
    name = "cageproof"
    license = "MIT"
    description = "Cage coordinates, deformers, inside tests and potentials of polyhedra, right to the last digits"
    topics = ("geometry", "barycentric coordinates", "deformation", "potentials")
    package_type = "shared-library"
    settings = "os", "arch", "compiler", "build_type"
    # Without them: docs/library.md.
    options = {"mpfr": [True, False], "nlopt": [True, False], "tbb": [True, False]}
    # Static MPFR keeps thread-local settings that a shared library cannot have (library/shared.cmake).
    default_options = {"mpfr": True, "nlopt": True, "tbb": True, "mpfr/*:shared": True, "gmp/*:shared": True, "boost/*:header_only": True, "fmt/*:shared": False}
    exports_sources = "CMakeLists.txt", "LICENSE", "cmake/*", "docs/licences.md", *(
        f"{room}/*" for room in ("core", "closed_form", "adaptive_qmvc", "solved", "deformation", "fast", "library")
    )

    def set_version(self):
        listing = load(self, os.path.join(self.recipe_folder, "CMakeLists.txt"))
        self.version = re.search(r"project\(cageproof VERSION (\S+)", listing).group(1)

    def requirements(self):
        # The headers of the installed library include none of these.
        self.requires("boost/[>=1.74 <2]", headers=True, libs=False, visible=False)
        self.requires("cgal/[>=5.5 <7]", headers=True, libs=False, visible=False)
        self.requires("eigen/[>=3.4 <4]", headers=True, libs=False, visible=False)
        self.requires("fmt/[>=9 <12]", visible=False)
        if self.options.mpfr:
            self.requires("gmp/[>=6.2 <7]")
            self.requires("mpfr/[>=4.1 <5]")
        if self.options.nlopt:
            self.requires("nlopt/[>=2.7 <3]")
        if self.options.tbb:
            self.requires("onetbb/[>=2021 <2023]")

    def system_requirements(self):
        # Header only, and not in ConanCenter.
        Apt(self).install(["librandom123-dev"])

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["CAGEPROOF_LIBRARY_ONLY"] = True
        toolchain.cache_variables["CAGEPROOF_MPFR"] = bool(self.options.mpfr)
        toolchain.cache_variables["CAGEPROOF_NLOPT"] = bool(self.options.nlopt)
        toolchain.cache_variables["CAGEPROOF_TBB"] = bool(self.options.tbb)
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="cageproof_shared")

    def package(self):
        copy(self, "cageproof.h*", os.path.join(self.source_folder, "library/include"), os.path.join(self.package_folder, "include"))
        copy(self, "libcageproof.so*", os.path.join(self.build_folder, "lib"), os.path.join(self.package_folder, "lib"))
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "licences.md", os.path.join(self.source_folder, "docs"), os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.libs = ["cageproof"]
        self.cpp_info.set_property("cmake_target_name", "cageproof::shared")
        self.cpp_info.set_property("pkg_config_name", "cageproof-c")
