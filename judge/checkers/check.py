#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks one function against vectors of `cageproof vectors`; the standard library is enough.

usage: check.py VECTORS.json [BOUND]
Replace `tensors`, and FORMULA. Exit 0: all vectors within BOUND conditioned units (64); 1: not all; 2: the file cannot be read."""
import json
import math
import sys
from fractions import Fraction

FORMULA = "triangle.solid_angle"  # the formula of your function


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
    """The angle of its plane that a triangle fills around the origin: the limit from inside on it, zero beside it. Takes exact numbers."""
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
    square = sum((Fraction(f) - t) ** 2 for f, t in zip(found, truth))
    if square == 0:
        return 0.0
    below = (denominator * unit) ** 2
    return math.sqrt(square / below) if below and square / below < 10 ** 300 else math.inf


def doubles(texts):
    return [float.fromhex(t) for t in texts]


def vectors_of(data):
    """The file's vectors with numbers for texts: inputs of the function, [(truth, denominator)] by order, flags."""
    vectors = []
    for v in data["vectors"]:
        truths = [([Fraction(t) for t in v[key]], Fraction(v[key + "_denominator"])) for key in ("value", "gradient", "hessian") if key in v]
        if "value" not in v or not isinstance(v["defects"], list):
            raise ValueError("a vector has no value, or no list of defects")
        vectors.append((([doubles(c) for c in v["element"]], doubles(v["point"]), doubles(v["parameters"])), truths, v["defects"]))
    if not vectors:
        raise ValueError("the file has no vectors")
    return vectors


def worst_error(inputs, truths, unit):
    """The largest error of the tensors that the function returns; infinite where it fails."""
    try:
        found = tensors(*inputs)
        return max(units(tensor, *truth, unit) for tensor, truth in zip(found, truths))
    except Exception:  # yours: whatever it raises, it has no answer
        return math.inf


def main():
    try:
        with open(sys.argv[1], encoding="ascii") as file:
            data = json.load(file)
        bound = float(sys.argv[2] if len(sys.argv) > 2 else data["bound"])
        unit = Fraction(float.fromhex(data["unit"]))
        vectors = vectors_of(data)
        if not 0 < bound < math.inf:
            raise ValueError("BOUND is not a positive number")
        if data["formula"] != FORMULA:
            raise ValueError(f"it has {data['formula']}, and the function is of {FORMULA}")
    except (IndexError, OSError, ValueError, KeyError, TypeError, OverflowError, AttributeError) as e:
        print(f"check.py: cannot read vectors: {e!r}; usage: check.py VECTORS.json [BOUND]", file=sys.stderr)
        return 2
    tally, worst = {}, (-1.0, None)
    for number, (inputs, truths, flags) in enumerate(vectors):
        error = worst_error(inputs, truths, unit)
        if error > worst[0]:
            worst = (error, number)
        for flag in flags + ["all"]:
            passed, asked = tally.get(flag, (0, 0))
            tally[flag] = (passed + (error <= bound), asked + 1)
    for flag, (passed, asked) in sorted(tally.items()):
        print(f"{flag}: {passed} of {asked} within {bound:g} units")
    shown = {key: data["vectors"][worst[1]][key] for key in ("element", "point")}
    print(f"worst: {worst[0]:.3g} units, vector {worst[1]}: {json.dumps(shown)}")
    return 0 if tally["all"][0] == tally["all"][1] else 1


if __name__ == "__main__":
    sys.exit(main())
