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
/usr/bin/python3 -m venv --system-site-packages "$work/venv" || fail "no virtual environment: on Debian, python3-venv"
"$work/venv/bin/pip" install --no-index --no-build-isolation --no-deps "$work/project/python" >"$work/log" 2>&1 || { tail -n 30 "$work/log"; fail "pip install"; }
# Away from the sources, and without the build's library.
cd "$work" && unset CAGEPROOF_LIBRARY
"$work/venv/bin/python" - "$work/venv" <<'PY' || fail "the installed package"
import sys, pathlib, importlib.metadata, cageproof, numpy as np
folder = pathlib.Path(cageproof.__file__).parent
assert str(folder).startswith(sys.argv[1]), folder
assert (folder / "libcageproof.so").is_file() and (folder / "py.typed").is_file()
assert (folder / "LICENSE").is_file() and (folder / "licences.md").is_file()
tags = [line for line in importlib.metadata.distribution("cageproof").read_text("WHEEL").splitlines() if line.startswith("Tag:")]
assert len(tags) == 1 and tags[0].startswith("Tag: py3-none-linux_"), tags
assert importlib.metadata.version("cageproof") == cageproof.version()
assert list(cageproof.Cage.embedded("cube").inside([[0, 0, 0], [2, 0, 0]])) == [1, -1]
print(tags[0], (folder / "libcageproof.so").stat().st_size, "bytes")
PY
echo "the wheel does what docs/python.md says"
