# SPDX-License-Identifier: MIT
"""Builds the wheel: pure Python and one shared library, the same file for every Python 3.

The library is the file that CAGEPROOF_LIBRARY names, or else that of the project's build folder, which is built if need be.
"""

import os
import shutil
import subprocess
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parent


def version() -> str:
    words = (PROJECT / "CMakeLists.txt").read_text().partition("project(cageproof VERSION ")[2].split()
    if not words:
        raise SystemExit(f"{PROJECT}/CMakeLists.txt names no version: build the package within the project")
    return words[0]


def library() -> Path:
    given = os.environ.get("CAGEPROOF_LIBRARY")
    if given:
        return Path(given).resolve()
    built = PROJECT / "build/release/lib/libcageproof.so"
    if not built.exists():
        subprocess.run([PROJECT / "scripts/build.sh", "release", "cageproof_shared"], check=True, cwd=PROJECT)
    return built


class BuildWithLibrary(build_py):
    """Puts the library beside the modules, without its debugging symbols."""

    def run(self):
        super().run()
        to = Path(self.build_lib) / "cageproof" / "libcageproof.so"
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(library(), to)
        # The list of linked libraries and their licences goes with it.
        for name in ("LICENSE", "docs/licences.md"):
            if (PROJECT / name).is_file():
                shutil.copyfile(PROJECT / name, to.parent / Path(name).name)
        if shutil.which("strip"):
            subprocess.run(["strip", "--strip-unneeded", str(to)], check=True)


class WithLibrary(Distribution):
    """Not pure Python. The package then stands at the wheel's root, where it also serves those who only unpack the wheel."""

    def has_ext_modules(self):
        return True


class PlatformWheel(bdist_wheel):
    """Any Python 3 on this platform."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(
    name="cageproof",
    version=version(),
    description="Cage coordinates, deformers, inside tests and potentials of polyhedra, right to the last digits",
    license="MIT",
    packages=["cageproof"],
    package_data={"cageproof": ["py.typed"]},
    python_requires=">=3.9",
    install_requires=["numpy"],
    distclass=WithLibrary,
    cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel},
    zip_safe=False,
)
