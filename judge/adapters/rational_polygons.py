#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Wachspress and discrete harmonic coordinates of convex polygons by a program, against exact numbers: both are quotients of polynomials (docs/judged.md).

usage: rational_polygons.py wachspress|discrete_harmonic COMMAND...
The command answers lines: number of vertices, vertices, point; then one number a vertex. Wachspress 1975: the area of three corners over those of the point
with both edges. Discrete harmonic, Pinkall and Polthier 1993: the sum of the cotangents opposite to the line from the point to the corner."""
import random
import subprocess
import sys
from fractions import Fraction

REGIMES = ("inside", "near-edge", "near-vertex", "on-edge", "on-vertex", "units", "offset")
POLYGONS = {"square": [(0, 0), (1, 0), (1, 1), (0, 1)], "bar": [(0, 0), (1, 0), (1, 0.0009765625), (0, 0.0009765625)],
            "hexagon": [(0, 0), (4, -1), (7, 1), (7, 4), (3, 6), (0, 4)]}


def doubled_area(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def on_border(v, x):
    """Coordinates of a point on an edge, or None."""
    for i in range(len(v)):
        a, b = v[i], v[(i + 1) % len(v)]
        if doubled_area(a, b, x) == 0:
            k = 0 if a[0] != b[0] else 1
            t = (x[k] - a[k]) / (b[k] - a[k])
            if 0 <= t <= 1:
                return [1 - t if j == i else t if j == (i + 1) % len(v) else Fraction(0) for j in range(len(v))]
    return None


def exact(kind, vertices, point):
    v, x = [tuple(map(Fraction, p)) for p in vertices], tuple(map(Fraction, point))
    if (found := on_border(v, x)) is not None:
        return found
    weights, n = [], len(v)
    square = lambda p: (p[0] - x[0]) ** 2 + (p[1] - x[1]) ** 2
    for i in range(n):
        before, at, after = v[i - 1], v[i], v[(i + 1) % n]
        left, right = doubled_area(x, before, at), doubled_area(x, at, after)
        if kind == "wachspress":
            weights.append(doubled_area(before, at, after) / (left * right))
        else:
            weights.append((square(after) * left - square(at) * doubled_area(x, before, after) + square(before) * right) / (left * right))
    found = [w / sum(weights) for w in weights]
    # Both give the point back, which no wrong weights would.
    assert all(sum(share * p[k] for share, p in zip(found, v)) == x[k] for k in range(2))
    return found


def sample(regime, numbers):
    name = numbers.choice(sorted(POLYGONS))
    v = [tuple(map(float, p)) for p in POLYGONS[name]]
    shares = [numbers.uniform(0.05, 1) for _ in v]
    middle = tuple(sum(s * p[k] for s, p in zip(shares, v)) / sum(shares) for k in range(2))
    i = numbers.randrange(len(v))
    a, b = v[i], v[(i + 1) % len(v)]
    t = numbers.randrange(1, 16) / 16
    on = a if regime.endswith("vertex") else tuple(p + t * (q - p) for p, q in zip(a, b))
    if regime.startswith("on-"):
        middle = on
    if regime.startswith("near-"):
        step = 10 ** numbers.uniform(-12, -1)
        middle = tuple(p + step * (q - p) for p, q in zip(on, middle))
    unit = numbers.choice((2.0**-30, 2.0**30)) if regime == "units" else 1
    shift = 1e4 if regime == "offset" else 0
    move = lambda p: tuple((c + shift) * unit for c in p)
    return [move(p) for p in v], move(middle)


def main():
    kind, command = sys.argv[1], sys.argv[2:]
    numbers = random.Random(1)
    for regime in REGIMES:
        cases = [sample(regime, numbers) for _ in range(200)]
        lines = "".join(" ".join(repr(c) for c in (len(v), *(x for p in v + [point] for x in p))) + "\n" for v, point in cases)
        answers = subprocess.run(command, input=lines, capture_output=True, text=True, check=True).stdout.splitlines()
        errors, lost = [], 0
        for (v, point), line in zip(cases, answers, strict=True):
            truth, found = exact(kind, v, point), [float(x) for x in line.split()]
            if len(found) != len(truth) or not all(abs(x) < float("inf") for x in found):
                lost += 1
                continue
            errors.append(float(max(abs(Fraction(x) - t) for x, t in zip(found, truth)) / max(abs(t) for t in truth)))
        errors.sort()
        print(f"{regime:12} median {errors[len(errors) // 2]:.1e} worst {errors[-1]:.1e}" + (f" not finite {lost}" if lost else ""))


main()
