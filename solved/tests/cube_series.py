#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Harmonic coordinates of the embedded cage `cube` by Fourier series: the table of harmonic_in_space_test.cpp.

Each face's data, a hat function that is affine on two triangles, have a double sine series, whose coefficients are
integrated by Gauss points on each triangle. Each term continues into the cube by a quotient of hyperbolic sines. All
terms are kept that double sees at least 0.1 of a face. The sums over all vertices, 1 and the point itself, are checked.
Needs NumPy, and no part of the program. Usage: solved/tests/cube_series.py
"""
import numpy as np

TERMS, NODES = 128, 320
CORNERS = np.array([[(k >> a & 1) - 0.5 for a in range(3)] for k in range(8)])
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
TRIANGLES = [[(f[0], f[1], f[2]), (f[0], f[2], f[3])] for f in FACES]
POINTS = [(0.1, 0.2, 0.3), (0, 0, 0), (-0.25, 0.125, 0.375), (0.4, 0.4, -0.3), (-0.4, 0.05, -0.35)]

nodes, weights = np.polynomial.legendre.leggauss(NODES)
nodes, weights = (nodes + 1) / 2, weights / 2
modes = np.arange(1, TERMS + 1)


def coefficients(triangles, axes, vertex):
    """4 times the integral of the hat function times both sines, over a face of [0, 1]^2 in these axes."""
    found = np.zeros((TERMS, TERMS))
    for triangle in triangles:
        if vertex not in triangle:
            continue
        corners = [CORNERS[v][axes] + 0.5 for v in triangle]
        hat = [1.0 if v == vertex else 0.0 for v in triangle]
        a, b = corners[1] - corners[0], corners[2] - corners[0]
        area = abs(a[0] * b[1] - a[1] * b[0])
        # The square of the rule's points, pulled together at the first corner.
        u = np.repeat(nodes, NODES)
        v = np.tile(nodes, NODES)
        second, third = u * (1 - v), u * v
        points = corners[0][:, None] + a[:, None] * second + b[:, None] * third
        values = hat[0] * (1 - second - third) + hat[1] * second + hat[2] * third
        values = values * np.repeat(weights, NODES) * np.tile(weights, NODES) * u * area
        found += (np.sin(np.pi * np.outer(modes, points[0])) * values) @ np.sin(np.pi * np.outer(modes, points[1])).T
    return 4 * found


decay = np.pi * np.hypot(modes[:, None], modes[None, :])


def continued(depth):
    """What is left of each term at a distance from the opposite face."""
    return np.exp(decay * (depth - 1)) * (1 - np.exp(-2 * decay * depth)) / (1 - np.exp(-2 * decay))


table = np.zeros((len(POINTS), 8))
for face, triangles in zip(FACES, TRIANGLES):
    axis = int(np.argmin(np.ptp(CORNERS[list(face)], axis=0)))
    axes = [a for a in range(3) if a != axis]
    side = CORNERS[face[0]][axis]
    for vertex in face:
        of_face = coefficients(triangles, axes, vertex)
        for row, point in enumerate(POINTS):
            p = np.array(point) + 0.5
            depth = p[axis] if side > 0 else 1 - p[axis]
            sines = [np.sin(np.pi * modes * p[a]) for a in axes]
            table[row, vertex] += sines[0] @ (of_face * continued(depth)) @ sines[1]

assert np.abs(table.sum(axis=1) - 1).max() < 1e-12
assert np.abs(table @ CORNERS - np.array(POINTS)).max() < 1e-12
for point, row in zip(POINTS, table):
    print("    {{" + ", ".join(map(str, point)) + "}, {" + ", ".join(f"{x:.13f}" for x in row) + "}},")
