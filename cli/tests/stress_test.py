#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""stress_test.py CAGEPROOF: the strain and stress that `deform --stress` writes, against affine maps, Kelvin's solution and equilibrium."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from checks import PROGRAM, call, check, exit_code

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
CUBE = np.array([[x, y, z] for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)])
# Corners of the cube by x, then y, then z; each quad outward.
CUBE_FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
INSIDE = {2: np.array([[0.3, 0.6], [0.55, 0.2], [0.7, 0.65]]), 3: np.array([[0.1, 0.2, -0.15], [-0.2, 0.05, 0.25], [0, -0.25, 0.1]])}


def write_cage(name: str, vertices: np.ndarray, faces: list) -> None:
    lines = ["v " + " ".join(repr(float(c)) for c in [*v, 0][:3]) for v in vertices]
    Path(name).write_text("\n".join(lines + ["f " + " ".join(str(k + 1) for k in face) for face in faces]) + "\n")


def stress(cage: str, posed: np.ndarray, points: np.ndarray, method: str, *more: str) -> dict[str, np.ndarray]:
    np.savetxt("pose.txt", posed, fmt="%.17g")
    return table_of(["deform", "--cage", cage, "--posed", "pose.txt", "--points", "points.npy", "--method", method, "--out", "images.csv", *more], points)


def table_of(command: list, points: np.ndarray) -> dict[str, np.ndarray]:
    """The columns of the table, with strain and stress as matrices."""
    np.save("points.npy", points)
    call(*command, "--stress", "stress.csv")
    table = np.genfromtxt("stress.csv", delimiter=",", names=True)
    found = {name: np.atleast_1d(table[name]) for name in table.dtype.names}
    for tensor in ("strain", "stress"):
        found[tensor] = np.zeros((len(points), 3, 3))
        for name in [name for name in found if name.startswith(tensor + "_")]:
            i, j = ("xyz".index(letter) for letter in name[-2:])
            found[tensor][:, i, j] = found[tensor][:, j, i] = found[name]
    return found


def hooke(gradient: np.ndarray, mu: float, nu: float) -> tuple[np.ndarray, np.ndarray]:
    """Strain and stress of one displacement gradient, by Young's modulus and compliance: strains are what stresses cause."""
    strain = np.zeros((3, 3))
    d = len(gradient)
    strain[:d, :d] = (gradient + gradient.T) / 2
    young = 2 * mu * (1 + nu)
    compliance = np.array([[(1 if i == j else -nu) / young for j in range(3)] for i in range(3)])
    return strain, np.diag(np.linalg.solve(compliance, np.diag(strain))) + (strain - np.diag(np.diag(strain))) * young / (1 + nu)


def affine_maps() -> None:
    """Methods that keep affine maps have one strain everywhere."""
    normals = {2: np.array([[0.6, 0.8], [3, 0], [-1, -1]]), 3: np.array([[0, 0, 2.0], [1, 2, 2], [-1, 1, 0]])}
    for cage, rest, matrix in (("square.obj", SQUARE, np.array([[1.3, 0.4], [-0.2, 0.8]])),
                               ("cube.obj", CUBE, np.array([[1.2, 0.3, -0.1], [0.05, 0.8, 0.2], [-0.3, 0.1, 1.1]]))):
        d = rest.shape[1]
        np.savetxt("normals.txt", normals[d], fmt="%.17g")
        unit = normals[d] / np.linalg.norm(normals[d], axis=1)[:, None]
        for method, nu, option in (("mean_value", 0.25, ["--poisson-ratio", "0.25"]), ("elastic", 0.4, ["--parameter", "nu=0.4"]),
                                   ("elastic", 0.3, [])):
            found = stress(cage, rest @ matrix.T, INSIDE[d], method, "--shear-modulus", "2.5", "--normals", "normals.txt", *option)
            strain, sigma = hooke(matrix - np.eye(d), 2.5, nu)
            name = f"{method} of {cage}, nu = {nu}"
            # Images are affine to 1e-14 (elastic: docs/elastic.md), and derivatives lose a digit or two.
            check(f"{name}: strain", found["strain"] - strain, 1e-12)
            check(f"{name}: stress", found["stress"] - sigma, 1e-11)
            # The traction across the plane has no part out of it.
            traction = np.column_stack([found[f"traction_{axis}"] for axis in "xyz"[:d]])
            check(f"{name}: traction", traction - unit @ sigma[:d, :d].T, 1e-11)
            principal = np.linalg.eigvalsh(sigma)
            mises = np.sqrt(((principal - np.roll(principal, 1)) ** 2).sum() / 2)
            check(f"{name}: von Mises", found["von_mises"] - mises, 1e-11)
            material = json.loads(Path("images.json").read_text())["stress"]
            check(f"{name}: the report", abs(material["largest_von_mises"] - mises) + abs(material["poisson_ratio"] - nu) + abs(material["shear_modulus"] - 2.5), 1e-11)


def kelvin() -> None:
    """Displacements of a force outside, at the ends of short edges: the stress inside tends to Kelvin's, to second order in the edges' length."""
    source, force, mu, nu = np.array([1.5, 1.25]), np.array([1, -2]), 1.0, 0.3

    def displacement(x: np.ndarray) -> np.ndarray:
        r = x - source
        length = np.linalg.norm(r, axis=1)[:, None]
        return (-(3 - 4 * nu) * np.log(length) * force + r * (r @ force)[:, None] / length**2) / (8 * np.pi * mu * (1 - nu))

    def exact(x: np.ndarray) -> np.ndarray:
        r = x - source
        length = np.linalg.norm(r)
        e, identity = r / length, np.eye(2)
        ends = np.einsum("j,i->ij", e, force) + np.einsum("i,j->ij", e, force) - identity * (e @ force)
        return -(2 * np.outer(e, e) * (e @ force) + (1 - 2 * nu) * ends) / (4 * np.pi * (1 - nu) * length)

    wanted = np.array([exact(x) for x in INSIDE[2]])
    errors = []
    for n in (8, 16, 32):
        rest = np.vstack([a + t * (b - a) for a, b in zip(SQUARE, np.roll(SQUARE, -1, axis=0)) for t in np.arange(n)[:, None] / n])
        write_cage("many.obj", rest, [tuple(range(4 * n))])
        found = stress("many.obj", rest + displacement(rest), INSIDE[2], "elastic", "--parameter", f"nu={nu}")
        errors.append(np.abs(found["stress"][:, :2, :2] - wanted).max() / np.abs(wanted).max())
    check("Kelvin's stress", errors[-1], 1e-3)
    check("Kelvin's stress, order: the error with edges of half the length", max(errors[1] / errors[0], errors[2] / errors[1]), 0.3)


def div_sigma(d: int, table_at) -> float:
    """The largest div sigma, by differences of fourth order, as a share of the stress per unit of length."""
    step = 1e-3
    shifts = [k * step * axis for axis in np.eye(d) for k in (-2, -1, 1, 2)]
    points = np.vstack([INSIDE[d] + shift for shift in shifts])
    sigma = table_at(points)["stress"].reshape(d, 4, len(INSIDE[d]), 3, 3)[..., :d, :d]
    slopes = (sigma[:, 0] - 8 * sigma[:, 1] + 8 * sigma[:, 2] - sigma[:, 3]) / (12 * step)
    return float(np.abs(np.einsum("jpij->pi", slopes)).max() / np.abs(sigma).max())


def equilibrium() -> None:
    """Poses whose best rotation is the identity, so that Somigliana's map turns nothing: mirrored, they are themselves."""
    tapered = CUBE * np.where(CUBE[:, 2:] > 0, [[1.4, 1.2, 1.1]], [[0.8, 1, 1.1]])
    trapezoid = SQUARE + [[-0.2, 0], [0.2, 0], [-0.1, 0.3], [0.1, 0.3]]
    # Differences: step^4 times fifth derivatives, and roundings of 1e-14 over the step.
    bound = 1e-8
    for cage, posed, d in (("square.obj", trapezoid, 2), ("cube.obj", tapered, 3)):
        # Infinite nu leaves the plane without stress, below.
        for method, values in (("elastic", ("-0.4", "0.3")), ("somigliana", ("-0.4", "0.3", "inf")[:d])):
            for nu in values:
                load = div_sigma(d, lambda points: stress(cage, posed, points, method, "--parameter", f"nu={nu}"))
                check(f"{method} of {cage}, nu = {nu}: no body load", load, bound)
        # Another material, or a map that is none of elasticity, is not in equilibrium: the check above can fail.
        for method in ("mean_value", "green"):
            if div_sigma(d, lambda points: stress(cage, posed, points, method, "--poisson-ratio", "0.3")) < 1e-2:
                check(f"{method} of {cage}: a body load", 1, 0)


def conformal_maps() -> None:
    """Somigliana's maps of the plane with infinite nu are Green's ([C23] Figure 7), which are conformal: strain is a multiple of the identity, and the limit of
    the stress in the plane is zero."""
    bent = SQUARE + [[0, 0], [0.4, -0.2], [0.1, 0.3], [-0.2, 0.1]]
    found = stress("square.obj", bent, INSIDE[2], "somigliana", "--parameter", "nu=inf", "--parameter", "variant=local", "--parameter", "gamma=0")
    check("stress of a conformal map", found["stress"][:, :2, :2], 1e-12)
    if np.abs(found["strain"][:, 0, 0]).max() < 1e-2:
        check("the conformal map is not the identity", 1, 0)


def refusals() -> None:
    np.savetxt("pose.txt", CUBE, fmt="%.17g")
    np.save("points.npy", INSIDE[3])
    np.savetxt("few.txt", np.eye(3)[:2])
    np.savetxt("zero.txt", np.diag([1, 0, 1]))

    def refused(words: str, *more: str) -> None:
        out = [] if "--out" in more else ["--out", "refused.obj"]
        ended = subprocess.run([PROGRAM, "deform", "--cage", "cube.obj", "--posed", "pose.txt", "--points", "points.npy", *out, *more], capture_output=True,
                               text=True)
        if ended.returncode != 2 or words not in ended.stderr or Path("refused.obj").exists():
            check(f"{more}: exit code {ended.returncode}, '{ended.stderr.strip()}' instead of '{words}'", 1, 0)

    file = ("--stress", "s.csv")
    refused("mean_value has no Poisson's ratio; give it by --poisson-ratio NU", "--method", "mean_value", *file)
    for nu in ("0.5", "-1", "0.7"):
        refused("must be between -1 and 1/2", "--method", "mean_value", *file, "--poisson-ratio", nu)
    refused("not a finite number", "--method", "mean_value", *file, "--poisson-ratio", "inf")
    refused("use --parameter nu=VALUE", "--method", "somigliana", *file, "--poisson-ratio", "0.3")
    refused("--shear-modulus", "--method", "somigliana", *file, "--shear-modulus", "0")
    refused("2 normals, there are 3 points", "--method", "somigliana", *file, "--normals", "few.txt")
    refused("normal number 1 has no direction", "--method", "somigliana", *file, "--normals", "zero.txt")
    refused("--stress s.txt: use .csv", "--method", "somigliana", "--stress", "s.txt")
    refused("2 maps need a name with {n}", "--method", "somigliana", *file, "--parameter", "nu=0,0.3", "--out", "m_{n}.obj")
    refused("--digits: --stress", "--method", "green", *file, "--poisson-ratio", "0", "--digits", "4")
    refused("s.csv: --stress is the file of --out, too", "--method", "somigliana", *file, "--out", "s.csv")
    for option, value in (("--normals", "zero.txt"), ("--shear-modulus", "2"), ("--poisson-ratio", "0.1")):
        refused("--stress", "--method", "green", option, value)


def files() -> None:
    """One per map, in each format; a point left at rest has no stress, and one without image none that is a number."""
    np.savetxt("pose.txt", CUBE * 1.5, fmt="%.17g")
    np.save("points.npy", np.vstack([INSIDE[3][:1], [[2, 0, 0]]]))
    common = ["deform", "--cage", "cube.obj", "--posed", "pose.txt", "--points", "points.npy", "--method", "somigliana"]
    for kind in ("csv", "npy", "vtp"):
        call(*common, "--outside", "rest", "--parameter", "nu=0,0.25", "--out", "m_{n}.obj", "--stress", f"s_{{n}}.{kind}")
    # sigma = (2 mu + 3 lambda)/2 I: mu = 1, lambda = 0 and 1.
    for k, wanted in ((1, 1.0), (2, 2.5)):
        table = np.load(f"s_{k}.npy")
        check(f"stress of map {k}", table[:, 6:12] - [[wanted] * 3 + [0] * 3, [0] * 6], 1e-12)
        check(f"text of map {k}", table - np.loadtxt(f"s_{k}.csv", delimiter=",", skiprows=1), 0)
    # Symmetric tensors have VTK's order.
    order = [f"{tensor}_{entry}" for tensor in ("strain", "stress") for entry in ("xx", "yy", "zz", "xy", "yz", "xz")]
    if Path("s_1.csv").read_text().splitlines()[0].split(",") != [*order, "von_mises"]:
        check("the columns of s_1.csv", 1, 0)
    if "von Mises stress" not in Path("s_1.vtp").read_text(errors="replace"):
        check("the arrays of s_1.vtp", 1, 0)
    call(*common, "--outside", "nan", "--out", "m.csv", "--stress", "s.npy")
    if np.isnan(np.load("s.npy")).tolist() != [[False] * 13, [True] * 13]:
        check("a point without image", 1, 0)


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_cage("square.obj", SQUARE, [(0, 1, 2, 3)])
        write_cage("cube.obj", CUBE, CUBE_FACES)
        affine_maps()
        kelvin()
        equilibrium()
        conformal_maps()
        refusals()
        files()
    return exit_code()


sys.exit(main())
