#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A program for `cageproof judge --kind`: mean value coordinates of a whole cage. Replace `coordinates`, or for polygons in the plane
`plane_coordinates`, by yours.

  chmod +x mine_cage.py
  cageproof judge mine=./mine_cage.py --kind mean_value
  cageproof judge mine=./mine_cage.py --kind mean_value --dimension 2
"""
import json
import sys
from math import atan2, hypot


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def coordinates(vertices, faces, point):
    """One number per vertex (T. Ju, S. Schaefer and J. Warren, "Mean value coordinates for closed triangular meshes", SIGGRAPH 2005, with the mean vector
    written as a sum over edges).

    Angles come from atan2, which loses nothing for small and for nearly straight ones. There is no threshold: a point is on a face only if the determinant is
    zero, and then its coordinates are the barycentric ones.
    """
    d = [minus(v, point) for v in vertices]
    weights = [0.0] * len(vertices)
    for face in faces:
        a, b, c = (d[i] for i in face)
        det = dot(a, cross(b, c))
        # Normals of the planes through the point and the edge opposite each corner; the edge itself loses less than its far end.
        normals = [cross(b, minus(c, b)), cross(c, minus(a, c)), cross(a, minus(b, a))]
        if det == 0:
            across = cross(minus(b, a), minus(c, a))
            areas = [dot(n, across) for n in normals]
            if min(areas) >= 0:
                # On the face, or on its border.
                weights = [0.0] * len(vertices)
                for i, area in zip(face, areas):
                    weights[i] = area / sum(areas)
                return weights
            continue  # in its plane, next to it: it is seen edge-on
        mean = [0.0, 0.0, 0.0]
        for n, (u, v) in zip(normals, ((b, c), (c, a), (a, b))):
            length = hypot(*n)
            angle = atan2(length, dot(u, v))
            mean = [m + angle * x / length for m, x in zip(mean, n)]
        for i, n in zip(face, normals):
            weights[i] += dot(n, mean) / det
    total = sum(weights)
    return [w / total for w in weights]


def plane_coordinates(vertices, segments, point):
    """One number per vertex (M. Floater, "Mean value coordinates", CAGD 2003): tangents of half the angles that segments are seen under, over distances.

    A tangent comes from the angle's cosine and the area, of the two forms the one without cancellation; there is no threshold.
    """
    d = [minus(v, point) for v in vertices]
    weights = [0.0] * len(vertices)
    for i, j in segments:
        a, b = d[i], d[j]
        side, product, inner = minus(b, a), hypot(*a) * hypot(*b), dot(a, b)
        nearer = a if dot(a, a) <= dot(b, b) else b
        area = nearer[0] * side[1] - nearer[1] * side[0]
        if area == 0:
            if inner <= 0:
                # On the segment, or at one of its ends.
                weights = [0.0] * len(vertices)
                weights[i], weights[j] = (hypot(*x) / (hypot(*a) + hypot(*b)) for x in (b, a))
                return weights
            continue  # in its line, beside it: it is seen end-on
        tangent = (product - inner) / area if inner < 0 else area / (product + inner)
        weights[i] += tangent / hypot(*a)
        weights[j] += tangent / hypot(*b)
    total = sum(weights)
    return [w / total for w in weights]


def answer(query):
    """The answer to one line; an answer with "error" says that this one is not there."""
    if query.get("kind") != "mean_value":
        return {"error": "mean_value only"}
    f = plane_coordinates if len(query["vertices"][0]) == 2 else coordinates
    return {"coordinates": [f(query["vertices"], query["faces"], point) for point in query["points"]]}


for line in sys.stdin:
    try:
        print(json.dumps(answer(json.loads(line))), flush=True)
    except (ValueError, KeyError, TypeError, ZeroDivisionError) as error:
        print(json.dumps({"error": str(error)}), flush=True)
