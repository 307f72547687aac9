#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""aligned_test.py CAGEPROOF: gamma_rel and neumann=affine of ahap, aaap and tp.

Energies are computed again from second derivatives of biharmonic_1_3 with the normal derivatives that were found: the sums must be the ones reported, and
no small change of these derivatives may lower them."""

import json
import os
import sys
import tempfile
from pathlib import Path

import numpy as np
from checks import call, check, exit_code

METHODS = ("ahap", "aaap", "tp")
AFFINE = np.array([[1.3, 0.05, -0.2], [0.2, 0.8, 0.1], [-0.1, 0.3, 1.1]])


def deform(cage: str, points: np.ndarray, posed: np.ndarray, method: str, *more: str, **parameters: object) -> np.ndarray:
    """Rows of images, and of derivatives behind them with --order."""
    np.save("points.npy", points)
    np.savetxt("pose.txt", posed, fmt="%.17g")
    options = [part for name, value in parameters.items() for part in ("--parameter", f"{name}={value}")]
    call("deform", "--cage", cage, "--posed", "pose.txt", "--points", "points.npy", "--method", method, *options, *more, "--out", "image.npy", "--quiet")
    return np.load("image.npy")


def write_cage(name: str, times: float) -> np.ndarray:
    call("list", "--cage", "cube", "--out", "embedded.obj")
    lines = Path("embedded.obj").read_text().splitlines()
    vertices = times * np.array([line.split()[1:4] for line in lines if line.startswith("v ")], float)
    faces = [line for line in lines if line.startswith("f ")]
    Path(name).write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices.tolist()) + "\n".join(faces) + "\n")
    return vertices


def relative_weights(rest: np.ndarray, posed: np.ndarray, points: np.ndarray) -> None:
    larger = write_cage("larger.obj", 10)
    size = np.linalg.norm(np.ptp(rest, axis=0))
    for method in METHODS:
        relative = deform("cube.obj", points, posed, method, gamma_rel=20)
        check(f"{method}: gamma_rel is gamma_d over size^4", np.abs(relative - deform("cube.obj", points, posed, method, gamma_d=20 / size**4)).max(), 1e-12)
        there = deform("larger.obj", 10 * points, 10 * posed, method, gamma_rel=20) / 10
        check(f"{method}: gamma_rel in another unit", np.abs(there - relative).max(), 1e-11)
        check(f"{method}: gamma_d is another method there", 1e-5 / np.abs(deform("larger.obj", 10 * points, 10 * posed, method, gamma_d=20 / size**4) / 10 - relative).max(), 1)
    assert larger.shape == rest.shape


def laws(rest: np.ndarray, points: np.ndarray) -> None:
    turn = 1.5 * np.array([[0.8, -0.6, 0], [0.6, 0.8, 0], [0, 0, 1]])
    for method in METHODS:
        moved = deform("cube.obj", points, rest @ AFFINE.T, method, alignment="free", neumann="affine")
        if method == "ahap":
            # Laplacians are as many as densities, and determine no more normal derivatives: 8 + 12 of 36.
            system = json.loads(Path("image.json").read_text())["posed"][0]
            check("ahap, free: rank", abs(system["rank"] - 20), 0)
        else:
            check(f"{method}, free: affine maps", np.abs(moved - points @ AFFINE.T).max(), 1e-10)
        moved = deform("cube.obj", points, rest @ turn.T, method, neumann="affine")
        check(f"{method}, hard: similarities", np.abs(moved - points @ turn.T).max(), 1e-10)


def energy_of(method: str, hessians: np.ndarray, normals: np.ndarray) -> float:
    """A sample's mean: of Laplacians, of all second derivatives, of those along the rest normal."""
    if method == "ahap":
        parts = np.einsum("scii->sc", hessians)
    elif method == "aaap":
        parts = hessians
    else:
        parts = np.einsum("si,scij,sj->sc", normals, hessians, normals)
    return float(np.sum(parts**2)) / len(hessians)


def energies(posed: np.ndarray, points: np.ndarray) -> None:
    call("coordinates", "--cage", "cube.obj", "--points", "points.npy", "--kind", "regularised_1_3", "--out", "alpha.npz", "--solved", "matrices.npz", "--quiet")
    matrices = np.load("matrices.npz")
    # Limits from inside, all but: derivatives change by this over the distance to the next edge.
    places = matrices["samples"] - 1e-7 * matrices["sample_normals"]

    def with_normals(normals: np.ndarray) -> np.ndarray:
        np.savetxt("normals.txt", normals, fmt="%.17g")
        rows = deform("cube.obj", places, posed, "biharmonic_1_3", "--normal-derivatives", "normals.txt", "--order", "2", neumann="affine")
        return rows[:, -27:].reshape(-1, 3, 3, 3)

    generator = np.random.default_rng(3)
    for method in METHODS:
        for alignment in ("free", "hard"):
            name = f"{method}, {alignment}"
            image = deform("cube.obj", points, posed, method, "--solved", "densities.npz", alignment=alignment, neumann="affine")
            reported = json.loads(Path("image.json").read_text())["figures"]["energy a sample"]
            normals = np.load("densities.npz")["N"][0]
            np.savetxt("normals.txt", normals, fmt="%.17g")
            again = deform("cube.obj", points, posed, "biharmonic_1_3", "--normal-derivatives", "normals.txt", neumann="affine")
            check(f"{name}: as biharmonic_1_3 with these normal derivatives", np.abs(again - image).max(), 1e-11)
            hessians = with_normals(normals)
            found = energy_of(method, hessians, matrices["sample_normals"])
            check(f"{name}: energy {reported:.4g} reported, {found:.4g} found", abs(found - reported), 1e-4 * energy_of("aaap", hessians, normals))
            # Stretches of posed normals are what hard alignment may change.
            change = generator.uniform(-1, 1, (len(normals), 3)) if alignment == "free" else normals * generator.uniform(-1, 1, (len(normals), 1))
            above, below = (energy_of(method, with_normals(normals + sign * change), matrices["sample_normals"]) for sign in (1, -1))
            # A quadratic function rises alike on both sides of its least.
            check(f"{name}: slope along a change", abs(above - below) / (above + below - 2 * found), 2e-3)


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        rest = write_cage("cube.obj", 1)
        generator = np.random.default_rng(1)
        points = generator.uniform(-0.4, 0.4, (5, 3))
        posed = rest + generator.uniform(-0.15, 0.15, rest.shape)
        relative_weights(rest, posed, points)
        laws(rest, points)
        energies(posed, points)
    return exit_code()


sys.exit(main())
