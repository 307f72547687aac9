#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sides of a cage by solid angles, or in the plane by angles, as programs have them that count windings: a point on the cage is nothing special."""
import json
import sys
from math import atan2, hypot, pi


def turn(corners):
    """The angle or solid angle that a face is seen under, over the whole one."""
    if len(corners) == 2:
        a, b = corners
        return atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) / (2 * pi)
    a, b, c = corners
    la, lb, lc = (hypot(*v) for v in corners)
    dot = lambda u, v: sum(x * y for x, y in zip(u, v))
    volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    return atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb) / (2 * pi)


for line in sys.stdin:
    query = json.loads(line)
    if "describe" in query:
        print(json.dumps({"formulas": {}, "about": "winding number"}), flush=True)
        continue
    sides = []
    for point in query["points"]:
        d = [[x - y for x, y in zip(v, point)] for v in query["vertices"]]
        sides.append(1 if sum(turn([d[i] for i in face]) for face in query["faces"]) > 0.5 else -1)
    print(json.dumps({"coordinates": sides}), flush=True)
