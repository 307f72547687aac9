#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The add-on as a user meets it: its zip, installed in a Blender without a window, moves a mesh as `cageproof deform` does.
# Usage: blender_test.sh PROGRAM LIBRARY. Exit 77, for CTest's "skipped", where Blender is absent.
set -u
here=$(dirname "$(readlink -f "$0")") && program=$(readlink -f "$1")
CAGEPROOF_LIBRARY=$(readlink -f "$2")
export CAGEPROOF_LIBRARY PYTHONDONTWRITEBYTECODE=1
if ! command -v blender >/dev/null; then
  echo "skipped: no Blender here (on Debian: apt-get install blender)"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "FAILED: $*"
  exit 1
}
cd "$work" || exit 1
# Blender's settings, add-ons and caches, away from the user's.
export HOME=$work BLENDER_USER_SCRIPTS=$work/scripts BLENDER_USER_CONFIG=$work/config
mkdir scripts config
/usr/bin/python3 "$here/../build.py" --out "$work/built" >zip || fail "no zip"
# Single precision holds all places exactly, so that Blender and the program are asked the same.
/usr/bin/python3 - <<'PY' || fail "no cage"
import json
import numpy as np
rest = np.array([[x, y, z] for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], float)
faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
posed = (rest * [1, 2, 0.5] + np.sin(rest[:, ::-1])).astype(np.float32).astype(float)
points = np.random.default_rng(7).uniform(-0.9, 0.9, (200, 3)).astype(np.float32).astype(float)
json.dump({"rest": rest.tolist(), "posed": posed.tolist(), "faces": faces}, open("cage.json", "w"))
np.save("points.npy", points)
np.save("posed.npy", posed)
with open("cage.obj", "w") as to:
    to.writelines(f"v {' '.join(map(repr, v))}\n" for v in rest.tolist())
    to.writelines(f"f {' '.join(str(x + 1) for x in f)}\n" for f in faces)
PY
"$program" deform --cage cage.obj --posed posed.npy --points points.npy --method green --out expected.npy >log 2>&1 || fail "deform: $(cat log)"
env -u CAGEPROOF_LIBRARY blender --background --factory-startup --python-exit-code 1 --python "$here/in_blender.py" -- "$(cat zip)" "$work" >log 2>&1 ||
  fail "in Blender: $(tail -n 15 log)"
/usr/bin/python3 - <<'PY' || fail "Blender moves the mesh elsewhere than cageproof deform"
import sys
import numpy as np
expected = np.load("expected.npy")
assert np.array_equal(np.load("images.npy"), expected.astype(np.float32)), abs(np.load("images.npy") - expected).max()
# The file's cage stands under a parent that is moved and turned, in single precision.
assert abs(np.load("later.npy") - expected).max() < 1e-5
PY
grep 'all is well' log
