# SPDX-License-Identifier: MIT
"""Builds the wheel: pure Python and one shared library, the same file for every Python 3.

The library is the file that CAGEPROOF_LIBRARY names, or else that of the project's build folder, which is built if need be.
"""

import os
import re
import shutil
import subprocess
import sys
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


# These go with the library (docs/licences.md): texts of licences, and notices of the packages that it includes or links.
TEXTS = [Path("/usr/share/common-licenses", name) for name in ("LGPL-3", "GPL-3", "LGPL-2.1", "MPL-2.0", "Apache-2.0")]
PARTS = ("libcgal-dev", "libeigen3-dev", "libfmt-dev", "libgmp-dev", "libmpfr-dev", "libnlopt-dev", "librandom123-dev", "libtbb-dev")
NOTICES = [Path("/usr/share/doc", part, "copyright") for part in PARTS]


def add_licences(to: Path) -> None:
    to.mkdir(exist_ok=True)
    for file in TEXTS + NOTICES:
        name = file.parent.name if file in NOTICES else file.name
        if file.is_file():
            shutil.copyfile(file, to / f"{name}.txt")
        else:
            print(f"warning: {file} is missing: add it before you pass the wheel on (docs/licences.md)", file=sys.stderr)


# The first version of glibc whose systems have a libstdc++ with symbols up to GLIBCXX_3.4.<key> (manylinux's policies).
GLIBC_OF = {28: 31, 29: 34, 30: 35, 33: 39}


def platform_of(library: Path, plain: str) -> str:
    """manylinux_2_<n>_<machine> with the oldest glibc that the library runs with, or the plain tag of this machine for a
    library that needs more than the C and C++ libraries."""
    if not plain.startswith("linux_") or not shutil.which("readelf"):
        return plain
    text = subprocess.run(["readelf", "--wide", "--dynamic", "--version-info", str(library)], check=True, capture_output=True, text=True).stdout
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", text)
    if not all(re.match(r"(libc|libm|libstdc\+\+|libgcc_s|libpthread|libdl|ld-linux.*)\.so", name) for name in needed):
        return plain
    glibc = max([17, *(int(n) for n in re.findall(r"\bGLIBC_2\.(\d+)", text))])
    cxx = max([0, *(int(n) for n in re.findall(r"\bGLIBCXX_3\.4\.(\d+)", text))])
    known = [0] if cxx == 0 else [GLIBC_OF[n] for n in sorted(GLIBC_OF) if n >= cxx]
    return f"manylinux_2_{max(glibc, known[0])}_{plain[len('linux_'):]}" if known else plain


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
        add_licences(to.parent / "licenses")
        if shutil.which("strip"):
            subprocess.run(["strip", "--strip-unneeded", str(to)], check=True)


class WithLibrary(Distribution):
    """Not pure Python. The package then stands at the wheel's root, where it also serves those who only unpack the wheel."""

    def has_ext_modules(self):
        return True


class PlatformWheel(bdist_wheel):
    """Any Python 3, on platforms that have what the library needs."""

    def get_tag(self):
        return "py3", "none", platform_of(library(), super().get_tag()[2])


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
