#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The package as a user meets it: built and installed by pip without a network, in a virtual environment of its own. Usage: wheel_test.sh LIBRARY
set -u
here=$(dirname "$(readlink -f "$0")") && root=$(readlink -f "$here/../..")
CAGEPROOF_LIBRARY=$(readlink -f "$1")
export CAGEPROOF_LIBRARY PYTHONDONTWRITEBYTECODE=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "FAILED: $*"
  exit 1
}
# A copy of what pip reads, so that the project's folder stays as it is.
mkdir "$work/project" && cp -r "$root/python" "$work/project/" && cp "$root/CMakeLists.txt" "$root/LICENSE" "$work/project/" &&
  mkdir "$work/project/docs" && cp "$root/docs/licences.md" "$work/project/docs/"
# The tags of three tiny libraries: without new symbols, with one of glibc 2.35, and with another library, which manylinux does not allow.
echo 'double f(double x, double y) { return x + y; }' | cc -shared -fPIC -x c - -o "$work/plain.so" &&
  printf '__asm__(".symver g, hypot@GLIBC_2.35");\ndouble g(double, double);\ndouble f(double x) { return g(x, x); }' | cc -shared -fPIC -x c - -lm -o "$work/newer.so" &&
  echo 'int f(void) { return 0; }' | cc -shared -fPIC -x c - -Wl,--no-as-needed -L "$work" -l:plain.so -o "$work/others.so" || fail "tiny libraries"
/usr/bin/python3 - "$root/python/setup.py" "$work" <<'PY' || fail "tags"
import pathlib, platform, runpy, sys
import setuptools
setuptools.setup = lambda **given: None  # only its functions
tag, machine = runpy.run_path(sys.argv[1])["platform_of"], platform.machine()
for name, expected in (("plain", "manylinux_2_17"), ("newer", "manylinux_2_35"), ("others", "linux")):
    found = tag(pathlib.Path(sys.argv[2], name + ".so"), f"linux_{machine}")
    assert found == f"{expected}_{machine}", (name, found)
assert tag(None, "macosx_11_0_arm64") == "macosx_11_0_arm64"
PY
/usr/bin/python3 -m venv --system-site-packages "$work/venv" || fail "no virtual environment: on Debian, python3-venv"
"$work/venv/bin/pip" install --no-index --no-build-isolation --no-deps "$work/project/python" >"$work/log" 2>&1 || { tail -n 30 "$work/log"; fail "pip install"; }
# Away from the sources, and without the build's library.
cd "$work" && unset CAGEPROOF_LIBRARY
"$work/venv/bin/python" - "$work/venv" <<'PY' || fail "the installed package"
import sys, pathlib, importlib.metadata, cageproof, numpy as np
folder = pathlib.Path(cageproof.__file__).parent
assert str(folder).startswith(sys.argv[1]), folder
assert (folder / "libcageproof.so").is_file() and (folder / "py.typed").is_file()
for text, words in (("LGPL-3", "LESSER GENERAL"), ("GPL-3", "GNU GENERAL"), ("MPL-2.0", "Mozilla Public"), ("libcgal-dev", "CGAL"), ("librandom123-dev", "D. E. Shaw")):
    assert words in (folder / "licenses" / f"{text}.txt").read_text(), text
assert (folder / "LICENSE").is_file() and (folder / "licences.md").is_file()
tags = [line for line in importlib.metadata.distribution("cageproof").read_text("WHEEL").splitlines() if line.startswith("Tag:")]
assert len(tags) == 1 and tags[0].startswith(("Tag: py3-none-linux_", "Tag: py3-none-manylinux_2_")), tags
assert importlib.metadata.version("cageproof") == cageproof.version()
assert list(cageproof.Cage.embedded("cube").inside([[0, 0, 0], [2, 0, 0]])) == [1, -1]
print(tags[0], (folder / "libcageproof.so").stat().st_size, "bytes")
PY
echo "the wheel does what docs/python.md says"
