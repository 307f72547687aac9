#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""thickness_test.py CAGEPROOF: the local thickness of maps of the plane ([W12] Eq 21), against differences of images next to the edges."""

import json
import os
import sys
import tempfile
from pathlib import Path

import numpy as np
from checks import call, check, exit_code

# A pentagon on whose edges hardly a point is a double.
CORNERS = np.array([[0, 0], [1.1, 0.13], [1.4, 0.9], [0.7, 1.7], [-0.2, 0.8]])
CENTRE = np.array([[0.6, 0.7]])
METHODS = ("green", "cauchy", "somigliana", "mean_value", "harmonic", "biharmonic_1_3", "biharmonic_boundary", "tp")


def deform(points: np.ndarray, posed: np.ndarray, method: str, *more: str) -> tuple[np.ndarray, dict]:
    np.save("points.npy", points)
    np.savetxt("pose.txt", posed, fmt="%.17g")
    call("deform", "--cage", "pentagon.obj", "--posed", "pose.txt", "--points", "points.npy", "--method", method, "--out", "image.npy", *more)
    return np.load("image.npy")[:, :2], json.loads(Path("image.json").read_text())


def outward(corners: np.ndarray) -> np.ndarray:
    along = np.roll(corners, -1, axis=0) - corners
    return np.column_stack([along[:, 1], -along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Path("pentagon.obj").write_text("".join(f"v {x} {y} 0\n" for x, y in CORNERS) + "f 1 2 3 4 5\n")
        normals = outward(CORNERS)
        posed = CORNERS @ np.array([[0.9, 0.4], [-0.5, 1.2]]).T + np.array([[0.1, 0], [0, 0.2], [0.2, -0.1], [0, 0], [-0.1, 0.1]])
        step = 1e-4
        for method in METHODS:
            thickness = deform(CENTRE, posed, method, "--order", "1")[1]["local_thickness"]
            places = CORNERS + thickness["where"] * (np.roll(CORNERS, -1, axis=0) - CORNERS)
            near = np.vstack([places - k * step * normals for k in (1, 2, 3)])
            image = deform(near, posed, method)[0].reshape(3, 5, 2)
            # A quadratic's slope on the edge, from three points inside. Next to edges second derivatives of solved kinds are large.
            slope = (2.5 * image[0] - 4 * image[1] + 1.5 * image[2]) / step
            expected = np.sum(outward(posed) * slope, axis=1)
            check(f"{method}: by differences", float(np.abs(thickness["edges"] - expected).max()), 5e-4)
            check(f"{method}: least", abs(thickness["least"] - min(thickness["edges"])), 0)
            check(f"{method}: largest", abs(thickness["largest"] - max(thickness["edges"])), 0)
        # A similarity by 1.5 stretches everything by 1.5.
        turn = 1.5 * np.array([[0.8, -0.6], [0.6, 0.8]])
        for method, more in (("green", []), ("biharmonic_boundary", ["--parameter", "normals=complex"]), ("mean_value", [])):
            edges = deform(CENTRE, CORNERS @ turn.T, method, "--order", "1", *more)[1]["local_thickness"]["edges"]
            check(f"{method}: a similarity", float(np.abs(np.array(edges) - 1.5).max()), 1e-9)
        if "local_thickness" in deform(CENTRE, posed, "green")[1]:
            check("without --order there is none", 1, 0)
    return exit_code()


sys.exit(main())
