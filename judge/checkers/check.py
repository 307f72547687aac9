#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks one function against vectors of `cageproof vectors`; the standard library is enough.

usage: check.py VECTORS.json [BOUND]
Replace `tensors`. Exit 0: all vectors within BOUND conditioned units (64); 1: not all; 2: the file cannot be read."""
import json
import math
import sys
from fractions import Fraction


def tensors(element, point, parameters):
    """Yours. Here: the value of triangle.solid_angle. Takes lists of floats. Returns [value], [value, gradient] or [value, gradient, Hessian], each a list of
    numbers in the catalogue's order; those that it returns are checked."""
    x = [[c - p for c, p in zip(corner, point)] for corner in element]
    a, b, c = ([float(t) for t in v] for v in x)

    def dot(u, v):
        return math.fsum(s * t for s, t in zip(u, v))

    # The determinant of exact differences: in floats it cancels far away and on slivers.
    e = [[Fraction(s) - Fraction(t) for s, t in zip(corner, point)] for corner in element]
    volume = (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0])
              + e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]))
    if volume == 0:
        return [[angle_in_plane(e)]]
    la, lb, lc = math.hypot(*a), math.hypot(*b), math.hypot(*c)
    size = max(la, lb, lc)
    a, b, c = ([t / size for t in v] for v in (a, b, c))
    la, lb, lc = la / size, lb / size, lc / size
    below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
    return [[2 * math.atan2(float(volume / Fraction(size) ** 3), below)]]


def angle_in_plane(corners):
    """What a triangle fills of its plane around the origin: the limit from inside on it, zero beside it. Takes exact numbers."""
    def cross(u, v):
        return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]

    normal = cross([s - t for s, t in zip(corners[1], corners[0])], [s - t for s, t in zip(corners[2], corners[0])])
    angles = []
    for u, v in ((corners[0], corners[1]), (corners[1], corners[2]), (corners[2], corners[0])):
        turn = cross(u, v)
        along = sum(s * t for s, t in zip(u, v))
        size = max(map(abs, turn + [along]))
        # An edge that the point lies on has the plane on one of its sides only.
        if size == 0 or not any(turn):
            continue
        across = math.hypot(*(float(t / size) for t in turn))
        side = 1 if sum(s * t for s, t in zip(turn, normal)) > 0 else -1
        angles.append(side * math.atan2(across, float(along / size)))
    # Beside the triangle the angles add up to zero, up to rounding.
    total = math.fsum(angles)
    return total if len(angles) == 1 or total > 1 else 0.0


def units(found, truth, denominator, unit):
    """The error over the conditioned denominator, in roundings; exact but for one square root."""
    if len(found) != len(truth) or not all(math.isfinite(f) for f in found):
        return math.inf
    square = sum((Fraction(f) - Fraction(t)) ** 2 for f, t in zip(found, truth))
    if square == 0:
        return 0.0
    below = (Fraction(denominator) * Fraction(unit)) ** 2
    return math.sqrt(square / below) if below and square / below < 10 ** 300 else math.inf


def main():
    try:
        with open(sys.argv[1], encoding="ascii") as file:
            data = json.load(file)
        bound = float(sys.argv[2]) if len(sys.argv) > 2 else data["bound"]
        vectors = data["vectors"]
    except (IndexError, OSError, ValueError, KeyError) as e:
        print(f"check.py: cannot read vectors: {e}; usage: check.py VECTORS.json [BOUND]", file=sys.stderr)
        return 2
    tally, worst = {}, (-1.0, None)
    for number, vector in enumerate(vectors):
        numbers = [[float.fromhex(t) for t in corner] for corner in vector["element"]]
        point = [float.fromhex(t) for t in vector["point"]]
        try:
            found = tensors(numbers, point, [float.fromhex(t) for t in vector["parameters"]])
        except (ArithmeticError, ValueError):
            found = [[math.nan]]
        error = max(units(tensor, vector[key], vector[key + "_denominator"], float.fromhex(data["unit"]))
                    for key, tensor in zip(("value", "gradient", "hessian"), found) if key in vector)
        if error > worst[0]:
            worst = (error, number)
        for flag in vector["defects"] + ["all"]:
            passed, asked = tally.get(flag, (0, 0))
            tally[flag] = (passed + (error <= bound), asked + 1)
    for flag, (passed, asked) in sorted(tally.items()):
        print(f"{flag}: {passed} of {asked} within {bound:g} units")
    if not vectors:
        print("check.py: the file has no vectors", file=sys.stderr)
        return 2
    print(f"worst: {worst[0]:.3g} units, vector {worst[1]}: {json.dumps({k: vectors[worst[1]][k] for k in ('element', 'point')})}")
    return 0 if tally["all"][0] == tally["all"][1] else 1


if __name__ == "__main__":
    sys.exit(main())
