#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sides of a cage for `cageproof judge --kind inside`: sound, or with a defect that programs have.

usage: sides.py [windings|exact|threshold]
windings: sums of solid angles, or of angles in the plane, for which a point on the cage is nothing special. exact: a ray in exact numbers, which is sound.
threshold: the same, but points nearer than 1e-6 to a face's plane are moved into it first."""
import json
import sys
from fractions import Fraction
from math import atan2, hypot, pi

CUTOFF = 1e-6


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def det(*d):
    return dot(d[0], cross(d[1], d[2])) if len(d) == 3 else d[0][0] * d[1][1] - d[0][1] * d[1][0]


def turn(corners):
    """The angle or solid angle that a face is seen under, over the whole one."""
    if len(corners) == 2:
        a, b = corners
        return atan2(det(a, b), dot(a, b)) / (2 * pi)
    a, b, c = corners
    la, lb, lc = (hypot(*v) for v in corners)
    return atan2(det(a, b, c), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb) / (2 * pi)


def by_windings(corners_of_faces):
    return 1 if sum(turn([[float(x) for x in v] for v in face]) for face in corners_of_faces) > 0.5 else -1


def is_on(d):
    """Whether the origin is on a face whose line or plane it is in."""
    if len(d) == 2:
        return dot(*d) <= 0
    normal = cross([x - y for x, y in zip(d[1], d[0])], [x - y for x, y in zip(d[2], d[0])])
    return all(dot(normal, cross(d[k], d[(k + 1) % 3])) >= 0 for k in range(3))


def crossing(d, ray):
    """1 or -1 where the ray leaves or enters through a face, 0 where it misses it, None where it meets an edge."""
    sides = [det(ray, d[k], d[(k + 1) % 3]) for k in range(3)] if len(d) == 3 else [-det(ray, d[0]), det(ray, d[1])]
    if 0 in sides:
        return None
    if not (min(sides) > 0 or max(sides) < 0):
        return 0
    # The face is ahead where it is met at a positive multiple of the ray.
    return (1 if sides[0] > 0 else -1) if det(*d) * sides[0] > 0 else 0


def by_ray(corners_of_faces):
    if any(det(*d) == 0 and is_on(d) for d in corners_of_faces):
        return 0
    for k in range(1, 100):
        found = [crossing(d, [Fraction(3 * k + 1, 7), Fraction(k * k, 3), Fraction(5, 4 * k)][:len(d)]) for d in corners_of_faces]
        if None not in found:
            return 1 if sum(found) else -1
    raise ValueError("all rays meet edges")


def by_threshold(corners_of_faces):
    for d in corners_of_faces:
        normal = cross([x - y for x, y in zip(d[1], d[0])], [x - y for x, y in zip(d[2], d[0])]) if len(d) == 3 else [d[1][1] - d[0][1], d[0][0] - d[1][0]]
        height = det(*d) / Fraction(hypot(*map(float, normal)))
        if abs(height) < CUTOFF:
            shift = [height * x / Fraction(hypot(*map(float, normal))) for x in normal]
            if is_on([[x - s for x, s in zip(v, shift)] for v in d]):
                return 0
    return by_ray(corners_of_faces)


def main():
    how = {"windings": by_windings, "exact": by_ray, "threshold": by_threshold}[(sys.argv[1:] or ["windings"])[0]]
    for line in sys.stdin:
        query = json.loads(line)
        if "describe" in query:
            print(json.dumps({"formulas": {}, "about": f"sides by {how.__name__[3:]}"}), flush=True)
            continue
        vertices = [[Fraction(float(x)) for x in v] for v in query["vertices"]]
        sides = []
        for point in query["points"]:
            d = [[x - Fraction(y) for x, y in zip(v, point)] for v in vertices]
            sides.append(how([[d[i] for i in face] for face in query["faces"]]))
        print(json.dumps({"coordinates": sides}), flush=True)


main()
