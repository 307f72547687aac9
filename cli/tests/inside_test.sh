#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Whether points are inside, from the command line. Usage: inside_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
source "$(dirname "$(readlink -f "$0")")/support.sh"
refuses() { refuses_to inside "$@"; }

# In the cube, on a face, an edge and a vertex, off by one unit in the last place, and far away.
cat >points.csv <<'CSV'
0,0,0
0.25,0.125,0.0625
0.5,0.25,0.125
0.5,0.5,0.125
0.5,0.5,0.5
0.49999999999999994,0.25,0.125
0.50000000000000011,0.25,0.125
1e300,0,0
CSV
"$cageproof" inside --cage cube --points points.csv >found.csv 2>said || fail "cube: $(cat said)"
[ "$(cut -d, -f1 found.csv | tr '\n' ' ')" = "place inside inside on on on inside outside outside " ] || fail "places: $(cat found.csv)"
[ "$(cut -d, -f3,4 found.csv | tail -n +2 | tr '\n' ' ')" = "1,0 1,0 nan,0 nan,0 nan,0 1,0 0,0 0,0 " ] || fail "numbers: $(cat found.csv)"
[ "$(awk -F, 'NR > 1 && ($1 == "on") != ($2 >= 0)' found.csv)" = "" ] || fail "faces: $(cat found.csv)"
grep -q '^3 inside, 3 on, 2 outside, exactly$' said || fail "$(cat said)"
# The same from standard input by one thread, and in .npy.
"$cageproof" inside --cage cube --points - --jobs 1 --quiet <points.csv 2>said | cmp - found.csv || fail "standard input"
[ -s said ] && fail "not quiet: $(cat said)"
"$cageproof" inside --cage cube --points points.csv --out found.npy || fail ".npy"
/usr/bin/python3 - <<'PY' || fail ".npy differs"
import numpy as np
a = np.load("found.npy")
words = [line.split(",") for line in open("found.csv")][1:]
place = {"inside": 1, "on": 0, "outside": -1}
b = np.array([[place[w[0]], *map(float, w[1:])] for w in words])
assert a.shape == (8, 4) and np.array_equal(a, b, equal_nan=True)
PY
# A polygon, and a quad that is kept: the saddle's own surface, which splits miss.
printf 'v 0 0\nv 4 0\nv 0 4\nl 1 2\nl 2 3\nl 3 1\n' >triangle.obj
printf '1,1\n2,2\n3,3\n' | "$cageproof" inside --cage triangle.obj --points - --quiet | cut -d, -f1 | tr '\n' ' ' | grep -q '^place inside on outside $' || fail "a polygon"
cat >saddle.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1.5
v 1 1 1
v 0 1 1.5
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
OBJ
echo 0.5,0.5,1.25 | "$cageproof" inside --cage saddle.obj --points - --keep-quads --quiet | grep -q '^on,1,' || fail "on the bilinear quad"
echo 0.5,0.5,1.25 | "$cageproof" inside --cage saddle.obj --points - --quiet | grep -q '^on,' && fail "on the split quad"

# Meshes that are no cage: without a lid five sixths of the sphere are seen from the centre.
cat >cup.obj <<'OBJ'
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 1 4 3 2
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
OBJ
refuses cup.obj hole -- --cage cup.obj --points points.csv
"$cageproof" inside --cage cup.obj --any-mesh --points points.csv >cup.csv 2>said || fail "a cup: $(cat said)"
printf '0,0,0\n1,0.5,0.25\n' >in_cup.csv
"$cageproof" inside --cage cup.obj --any-mesh --points in_cup.csv --quiet >cup.csv || fail 'a cup'
awk -F, 'NR == 2 {d = $3 - 5 / 6; if (d < 0) d = -d; ok = $1 == "inside" && d <= $4 && $4 < 1e-13} NR == 3 {ok = ok && $1 == "on" && $2 == 2} END {exit !ok}' cup.csv || fail "a cup: $(cat cup.csv)"
grep -q 'winding numbers to' said || fail "$(cat said)"

refuses '.npy' -- --cage cube --points points.csv --out found.txt
refuses 'points.csv' '--points' -- --cage cube --points points.csv --out points.csv
refuses '--any-mesh' '--keep-quads' -- --cage cup.obj --any-mesh --keep-quads --points points.csv
refuses 'nonexistent' -- --cage cube --points nonexistent.csv
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\n' >broken.obj
refuses broken.obj -- --cage broken.obj --any-mesh --points points.csv
exit $((failures > 0))
