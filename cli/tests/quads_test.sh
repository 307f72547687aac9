#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Which quads of a cage are valid, from the command line. Usage: quads_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
source "$(dirname "$(readlink -f "$0")")/support.sh"

"$cageproof" quads --cage cube >found.csv 2>said || fail "cube: exit $?"
[ "$(sort -u found.csv | tail -n +1 | grep -c ',,yes,yes,$')" -eq 6 ] || fail "cube: $(cat found.csv)"
grep -qx 'cube: 6 quads, 0 not valid (\[T18\] Definition 1)' said || fail "cube: $(cat said)"
# Triangles are no quads.
[ "$("$cageproof" quads --cage icosphere --quiet)" = face,line,planar,valid,reason ] || fail icosphere

# Boxes whose corners are moved at random, and every quad by Definition 1 itself: onto the plane of each three successive corners its projection is convex,
# which is where its diagonals cross.
/usr/bin/python3 - "$cageproof" <<'PY' || fail "random boxes"
import csv, random, subprocess, sys
from fractions import Fraction as F

sub = lambda a, b: [x - y for x, y in zip(a, b)]
dot = lambda a, b: sum(x * y for x, y in zip(a, b))
cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

def is_convex(q, n):
    """Whether the diagonals of the projection along n cross between their ends."""
    q = [sub(x, [F(dot(x, n), dot(n, n)) * c for c in n]) for x in q]
    area = lambda a, b, c: dot(cross(sub(b, a), sub(c, a)), n)
    return area(q[0], q[2], q[1]) * area(q[0], q[2], q[3]) < 0 and area(q[1], q[3], q[0]) * area(q[1], q[3], q[2]) < 0

def is_valid(q):
    normals = [cross(sub(q[(i + 1) % 4], q[i]), sub(q[i - 1], q[i])) for i in range(4)]
    return all(any(n) and is_convex(q, n) for n in normals)

random.seed(1)
corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
vertices, quads = [], []
for box in range(60):
    reach = 1 + box % 5
    quads += [[8 * box + c for c in face] for face in faces]
    vertices += [[8 * c + random.randint(-reach, reach) + (40 * box if k == 0 else 0) for k, c in enumerate(corner)] for corner in corners]
with open("boxes.obj", "w") as file:
    file.writelines(f"v {x} {y} {z}\n" for x, y, z in vertices)
    file.writelines("f " + " ".join(str(v + 1) for v in quad) + "\n" for quad in quads)
ended = subprocess.run([sys.argv[1], "quads", "--cage", "boxes.obj", "--flip-inward", "--out", "boxes.csv"], capture_output=True, text=True)
rows = list(csv.DictReader(open("boxes.csv")))
valid = [is_valid([vertices[v] for v in quad]) for quad in quads]
planar = [dot(cross(sub(vertices[b], vertices[a]), sub(vertices[c], vertices[a])), sub(vertices[d], vertices[a])) == 0 for a, b, c, d in quads]
assert ended.returncode == 1, ended
assert 20 < sum(valid) < len(quads) - 20, sum(valid)
assert [row["valid"] for row in rows] == ["yes" if v else "no" for v in valid], "validity"
assert [row["planar"] for row in rows] == ["yes" if p else "no" for p in planar], "planarity"
assert [int(row["face"]) for row in rows] == list(range(len(quads))) and int(rows[0]["line"]) == len(vertices) + 1, rows[0]
assert all((row["reason"] == "") == (row["valid"] == "yes") for row in rows), "reasons"
assert f"{len(quads)} quads, {len(quads) - sum(valid)} not valid" in ended.stderr, ended.stderr
PY

refuses_to quads 'no such file' -- --cage nowhere.obj
refuses_to quads '.csv' -- --cage cube --out quads.npy
refuses_to quads 'the file of --cage, too' -- --cage boxes.csv --out boxes.csv
[ $failures -eq 0 ] && echo "quads are valid where they are"
exit $failures
