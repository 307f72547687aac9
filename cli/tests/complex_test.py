#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""complex_test.py CAGEPROOF: complex biharmonic coordinates ([W12] Section 5.2).

They must be what the definition makes of biharmonic_boundary, keep every similarity, pose drawings as the deformer with stretched normals does, come near to
what Goursat's functions give, and have the Hermite property of the paper in the limit: edges go to edges, and Jacobians there are similarities."""

import os
import sys
import tempfile
from pathlib import Path

import numpy as np
from checks import call, check, exit_code

INSIDE = {"square": [[0.5, 0.5], [0.2, 0.7]], "l-shape": [[0.3, 0.3], [0.2, 1.4]], "pentagon.obj": [[0.6, 0.7], [0.3, 0.5]], "frame": []}


def coordinates(cage: str, points: np.ndarray, kind: str, *more: object) -> dict[str, np.ndarray]:
    np.save("points.npy", points)
    call("coordinates", "--cage", cage, "--points", "points.npy", "--kind", kind, *more, "--out", "c.npz", "--quiet")
    return dict(np.load("c.npz"))


def as_complex(points: np.ndarray) -> np.ndarray:
    return points[:, 0] + 1j * points[:, 1]


def by_definition(c: dict[str, np.ndarray]) -> np.ndarray:
    """alpha_j - i (beta_before/length_before - beta_j/length_j)."""
    edges, v = c["elements"], c["cage_vertices"]
    over_length = c["beta"] / np.linalg.norm(v[edges[:, 1]] - v[edges[:, 0]], axis=1)
    found = c["alpha"].astype(complex)
    for e, (start, end) in enumerate(edges):
        found[:, start] += 1j * over_length[:, e]
        found[:, end] -= 1j * over_length[:, e]
    return found


def solved(cage: str, points: np.ndarray, pieces: int = 4) -> np.ndarray:
    c = coordinates(cage, points, "biharmonic_complex", "--parameter", f"pieces={pieces}")
    return c["re"] + 1j * c["im"]


def laws(cage: str, points: np.ndarray, generator: np.random.Generator) -> None:
    real = coordinates(cage, points, "biharmonic_boundary")
    vertices, c = real["cage_vertices"], solved(cage, points)
    check(f"{cage}: by the definition", np.abs(c - by_definition(real)).max(), 1e-13)
    check(f"{cage}: sum of one", np.abs(c.sum(axis=1) - 1).max(), 1e-12)
    check(f"{cage}: similarities", np.abs(c @ ((0.6 - 1.3j) * as_complex(vertices) + 2) - (0.6 - 1.3j) * as_complex(points) - 2).max(), 1e-12)
    posed = vertices + generator.uniform(-0.2, 0.2, vertices.shape)
    np.savetxt("pose.txt", posed, fmt="%.17g")
    call("deform", "--cage", cage, "--posed", "pose.txt", "--points", "points.npy", "--method", "biharmonic_boundary", "--parameter", "normals=complex", "--out", "m.npy",
         "--quiet")
    check(f"{cage}: as the deformer", np.abs(c @ as_complex(posed) - as_complex(np.load("m.npy"))).max(), 1e-12)


def truth(cage: str, points: np.ndarray) -> None:
    exact = by_definition(coordinates(cage, points, "biharmonic_goursat"))
    errors = [float(np.abs(solved(cage, points, pieces) - exact).max()) for pieces in (1, 4, 16)]
    check(f"{cage}: 16 pieces, against Goursat's functions", errors[2], 4e-2)
    check(f"{cage}: more pieces are nearer: {errors}", errors[2] / errors[0], 0.8)
    # The other sign is no approximation.
    check(f"{cage}: not the conjugates", 0.1 / float(np.abs(np.conj(solved(cage, points, 16)) - exact).max()), 1)


def hermite(generator: np.random.Generator) -> None:
    """A square posed at random: next to the middle of each edge, values are those between the posed ends, and Jacobians nearly similarities."""
    corners = np.array([0, 1, 1 + 1j, 1j])
    posed = corners + generator.uniform(-0.2, 0.2, 4) + 1j * generator.uniform(-0.2, 0.2, 4)
    misses = []
    for pieces in (4, 32):
        value, slope = 0.0, 0.0
        for e in range(4):
            along = corners[(e + 1) % 4] - corners[e]
            # Between nodes of the solution; points 1e-4 and 2e-4 inside.
            share = (pieces // 2 + 0.5) / pieces
            places = np.array([corners[e] + share * along + 1e-4 * k * 1j * along for k in (1, 2)])
            images = solved("square", np.column_stack([places.real, places.imag]), pieces) @ posed
            edge = posed[(e + 1) % 4] - posed[e]
            value = max(value, abs(2 * images[0] - images[1] - posed[e] - share * edge))
            slope = max(slope, abs((images[1] - images[0]) / 1e-4 - 1j * edge))
        misses.append((value, slope))
    check(f"values on edges: {misses}", misses[1][0], 1e-4)
    check(f"derivatives across edges: {misses}", misses[1][1], 2e-2)
    check("values are nearer by more pieces", misses[1][0] / misses[0][0], 0.5)


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Path("pentagon.obj").write_text("v 0 0 0\nv 1.1 0.13 0\nv 1.4 0.9 0\nv 0.7 1.7 0\nv -0.2 0.8 0\nf 1 2 3 4 5\n")
        generator = np.random.default_rng(2)
        for cage, inside in INSIDE.items():
            points = np.array(inside)
            if not inside:
                vertices = coordinates(cage, np.array([[0.05, 0.05]]), "green")["cage_vertices"]
                points = vertices[:1] + 0.05 * np.ptp(vertices, axis=0)
            laws(cage, points, generator)
        for cage in ("square", "pentagon.obj"):
            truth(cage, np.array(INSIDE[cage]))
        hermite(generator)
    return exit_code()


sys.exit(main())
