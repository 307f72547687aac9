#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A triangle's solid angle over 4 pi, zero where a volume is below an absolute threshold: lines of `eval` in, answers out."""
import json
import math
import sys


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def solid_angle(corners, point):
    a, b, c = ([corner[i] - point[i] for i in range(3)] for corner in corners)
    volume = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    if abs(volume) < 1e-10:
        return 0.0
    dot = lambda u, v: sum(x * y for x, y in zip(u, v))
    la, lb, lc = math.hypot(*a), math.hypot(*b), math.hypot(*c)
    return 2 * math.atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb) / (4 * math.pi)


for line in sys.stdin:
    query = json.loads(line)
    if "describe" in query:
        answer = {"formulas": {"triangle.solid_angle": 0}}
    else:
        answer = {"value": [solid_angle([[number(x) for x in p] for p in query["element"]], [number(x) for x in query["point"]])]}
    print(json.dumps(answer), flush=True)
