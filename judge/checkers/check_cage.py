#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks coordinates of a whole cage against vectors of `cageproof vectors --kinds`; the standard library and check.py beside this file are enough.

usage: check_cage.py VECTORS.json [BOUND]
Replace `coordinates`, KIND and QUADS. Exit 0: all vectors within BOUND units (64); 1: not all; 2: the file cannot be read."""
import json
import math
import sys
from fractions import Fraction

from check import doubles, units

KIND = "mean_value"  # the kind of your function
QUADS = False  # whether its cages have quads


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def coordinates(vertices, faces, point):
    """Yours. Here: mean value coordinates, one per vertex, in space of triangles and in the plane of segments. Takes lists of floats, and of indices. Returns
    one list of numbers, block by block."""
    # Exact differences: in floats they cancel next to a cage.
    exact = [[Fraction(x) - Fraction(y) for x, y in zip(v, point)] for v in vertices]
    weights = [0.0] * len(vertices)
    for face in faces:
        found, on = (of_segment if len(face) == 2 else of_triangle)([exact[i] for i in face])
        if on:
            weights = [0.0] * len(vertices)
        for i, w in zip(face, found):
            weights[i] += w
        if on:
            break
    total = math.fsum(weights)
    return [w / total for w in weights]


def of_triangle(d):
    """The weights of the corners, and whether the point is on the triangle."""
    sides = [minus(d[(k + 2) % 3], d[(k + 1) % 3]) for k in range(3)]
    normals = [cross(d[(k + 1) % 3], sides[k]) for k in range(3)]
    det = dot(d[0], normals[0])
    if det == 0:
        across = cross(sides[1], sides[2])
        areas = [dot(n, across) for n in normals]
        return ([float(a / sum(areas)) for a in areas], True) if min(areas) >= 0 else ([0.0] * 3, False)
    mean = [0.0] * 3
    for k in range(3):
        n = [float(x) for x in normals[k]]
        angle = math.atan2(math.hypot(*n), float(dot(d[(k + 1) % 3], d[(k + 2) % 3])))
        mean = [m + angle * x / math.hypot(*n) for m, x in zip(mean, n)]
    return [dot([float(x) for x in n], mean) / float(det) for n in normals], False


def of_segment(d):
    """The same of a segment: tangents of half the angle that it is seen under, over distances."""
    area, inner = d[0][0] * d[1][1] - d[0][1] * d[1][0], dot(*d)
    lengths = [math.hypot(*map(float, x)) for x in d]
    if area == 0:
        return ([lengths[1] / sum(lengths), lengths[0] / sum(lengths)], True) if inner <= 0 else ([0.0] * 2, False)
    area, inner, product = float(area), float(inner), lengths[0] * lengths[1]
    tangent = (product - inner) / area if inner < 0 else area / (product + inner)
    return [tangent / length for length in lengths], False


def worst_error(data, vector, unit):
    """The largest error of a block; infinite where the function fails."""
    try:
        found = coordinates([doubles(v) for v in data["vertices"]], data["faces"], doubles(vector["point"]))
    except Exception:  # yours: whatever it raises, it has no answer
        return math.inf
    truth, worst, begin = [Fraction(t) for t in vector["value"]], 0.0, 0
    if len(found) != len(truth):
        return math.inf
    for block, denominator in zip(data["blocks"], vector["denominators"]):
        part = slice(begin, begin + block["size"])
        worst, begin = max(worst, units(found[part], truth[part], Fraction(denominator), unit)), part.stop
    return worst


def refuse_damage(data):
    """Raises ValueError where the file is not whole: what is left of it would pass unchecked."""
    sizes, corners = [b["size"] for b in data["blocks"]], len(data["vertices"][0])
    if data["format"] != "cageproof cage vectors 1":
        raise ValueError(f"its format is {data['format']!r}")
    stated = data["candidates"] - data["without_truth"] - data["without_defect"]
    if len(data["vectors"]) != stated:
        raise ValueError(f"{len(data['vectors'])} vectors, not {stated}")
    if not sizes or not all(type(n) is int and 0 < n <= 36 * (len(data["vertices"]) + len(data["faces"])) for n in sizes):
        raise ValueError(f"its blocks have sizes {sizes}")
    for face in data["faces"]:
        if not (len(face) == corners or QUADS and len(face) == 4) or not all(type(i) is int and 0 <= i < len(data["vertices"]) for i in face):
            raise ValueError(f"a face is {face}")
    for number, v in enumerate(data["vectors"]):
        if len(v["value"]) != sum(sizes) or not all(isinstance(x, str) for x in v["value"]):
            raise ValueError(f"vector {number} has other values than the blocks {sizes}")
        if len(v["denominators"]) != len(sizes) or not all(Fraction(x) > 0 for x in v["denominators"]):
            raise ValueError(f"vector {number} has denominators {v['denominators']}")
        if not v["defects"] or not set(v["defects"]) <= set(data["defects"]):
            raise ValueError(f"vector {number} names the defects {v['defects']}")


def main():
    try:
        with open(sys.argv[1], encoding="ascii") as file:
            data = json.load(file)
        bound = float(sys.argv[2] if len(sys.argv) > 2 else data["bound"])
        unit = Fraction(float.fromhex(data["unit"]))
        refuse_damage(data)
        if unit <= 0 or data["bound"] is True or not 0 < bound < math.inf:
            raise ValueError("BOUND or the unit is not a positive number")
        if data["kind"] != KIND:
            raise ValueError(f"it has {data['kind']}, and the function is of {KIND}")
        errors = [worst_error(data, v, unit) for v in data["vectors"]]
        flags = [list(v["defects"]) for v in data["vectors"]]
        worst = errors.index(max(errors))
    except (IndexError, OSError, ValueError, KeyError, TypeError, OverflowError, AttributeError) as e:
        print(f"check_cage.py: cannot read vectors: {e!r}; usage: check_cage.py VECTORS.json [BOUND]", file=sys.stderr)
        return 2
    tally = {}
    for error, named in zip(errors, flags):
        for flag in named + ["all"]:
            passed, asked = tally.get(flag, (0, 0))
            tally[flag] = (passed + (error <= bound), asked + 1)
    for flag, (passed, asked) in sorted(tally.items()):
        print(f"{flag}: {passed} of {asked} within {bound:g} units")
    print(f"worst: {errors[worst]:.3g} units, vector {worst}: {json.dumps(data['vectors'][worst]['point'])}")
    return 0 if tally["all"][0] == tally["all"][1] else 1


if __name__ == "__main__":
    sys.exit(main())
