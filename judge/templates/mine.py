#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A program for `cageproof judge`: the angle that a segment of the plane is seen under. Replace the formula by yours.

  chmod +x mine.py
  cageproof judge mine=./mine.py
"""
import json
import sys
from math import acos, atan2, hypot

# The formulas that are there, each with its highest derivative: 0 is the value only.
DESCRIPTION = {"formulas": {"segment.winding_angle": 0}, "about": "winding angle by the arctangent, 1.0"}


def minus(a, b):
    return [a[0] - b[0], a[1] - b[1]]


def winding_angle(corners, point):
    """atan2(a x b, a . b) of the ends as the point sees them (K. Hormann and A. Agathos, "The point in polygon problem for arbitrary polygons", Comput. Geom. 20
    (2001), Section 2).

    a x b is the nearer end times the segment itself, which loses nothing far away or near an end. There is no threshold.
    At an end it is a right angle, half of what the inside sees on the segment.
    """
    a, b = minus(corners[0], point), minus(corners[1], point)
    nearer, side = (a if hypot(*a) < hypot(*b) else b), minus(corners[1], corners[0])
    if hypot(*nearer) == 0:
        return acos(0)
    return atan2(nearer[0] * side[1] - nearer[1] * side[0], a[0] * b[0] + a[1] * b[1])


def answer(query):
    """The answer to one line; an answer with "error" says that this one is not there."""
    if "describe" in query:
        return DESCRIPTION
    if query["formula"] != "segment.winding_angle" or query["order"] > 0:
        return {"error": "values of segment.winding_angle only"}
    return {"value": [winding_angle(query["element"], query["point"])]}


# One answer for each line, in their order, each flushed: the other side waits for it. Whole numbers become floats, so that -0 keeps its sign.
for line in sys.stdin:
    print(json.dumps(answer(json.loads(line, parse_int=float))), flush=True)
