#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""solved_test.py CAGEPROOF: what --solved FILE.npz holds, against sums of our own in NumPy.

Densities times layers, which `coordinates` computes, must give the images of `deform`; the system solved by NumPy must give the densities; the system's
rows must be the layers at the samples."""

import os
import sys
import tempfile
from pathlib import Path

import numpy as np
from checks import call, check, exit_code

# Times the embedded cages' size: systems are solved in a unit of length next to it, which is 1 for the embedded ones.
TIMES = 5
KINDS = {"biharmonic_1_3": "regularised_1_3", "biharmonic_1_2": "regularised_1_2", "biharmonic_weber": "regularised_weber"}
LAYERS = (("phi", "V"), ("psi", "N"), ("phibar", "L"), ("psibar", "D"))


def larger(name: str) -> str:
    """An embedded cage, TIMES as large, as a file."""
    call("list", "--cage", name, "--out", "embedded.obj")
    lines = Path("embedded.obj").read_text().splitlines()
    vertices = (" ".join(["v", *(f"{TIMES * float(x):.17g}" for x in line.split()[1:])]) if line.startswith("v ") else line for line in lines)
    Path(f"{name}.obj").write_text("\n".join(vertices) + "\n")
    return f"{name}.obj"


def layers_at(cage: str, points: np.ndarray) -> dict[str, np.ndarray]:
    np.save("at.npy", points)
    call("coordinates", "--cage", cage, "--points", "at.npy", "--kind", "biharmonic", "--out", "layers.npz", "--quiet")
    return dict(np.load("layers.npz"))


def densities(cage: str, pose: str, points: np.ndarray, method: str, more: list[str]) -> None:
    """f = phi V + psi N + phibar L + psibar D, for two poses."""
    np.save("points.npy", points)
    call("deform", "--cage", cage, "--posed", cage, "--posed", pose, "--points", "points.npy", "--method", method, *more, "--out", "image_{n}.npy",
         "--solved", "densities.npz", "--quiet")
    solved, layers = np.load("densities.npz"), layers_at(cage, points)
    for k in range(2):
        image = sum(layers[block] @ solved[name][k] for block, name in LAYERS)
        check(f"{cage}, {method} {more}, map {k}: images", image - np.load(f"image_{k + 1}.npy"), 2e-12)
    rest, posed = layers["cage_vertices"], np.loadtxt(pose)
    check(f"{cage}, {method}: the rest pose has densities", solved["L"][0], 1e-11)
    check(f"{cage}, {method}: V", solved["V"][0] - rest, 1e-14)
    check(f"{cage}, {method}: V", solved["V"][1] - posed, 1e-13)


def matrices(cage: str, pose: str, points: np.ndarray, method: str, kind: str, more: list[str]) -> None:
    call("coordinates", "--cage", cage, "--points", "points.npy", "--kind", kind, *more, "--out", "alpha.npz", "--solved", "matrices.npz", "--quiet")
    m = dict(np.load("matrices.npz"))
    samples, hats = m["samples"], m["M_V"]
    on_cage = layers_at(cage, samples)
    # Samples are rounded: those outside by an ulp have other coordinates.
    within = on_cage["phi"].sum(axis=1) > 0.5
    check(f"{cage}, {kind}: samples on the cage or inside", np.array([within.mean() < 0.4]), 0)
    for block, name in (("phi", "Phi_V"), ("psi", "Psi_V"), ("phibar", "Phibar_V"), ("psibar", "Psibar_V")):
        check(f"{cage}, {kind}: {name} at samples", (on_cage[block] - m[name])[within], 1e-13 * max(1, np.abs(m[name]).max()))
    check(f"{cage}, {kind}: M_V", hats @ on_cage["cage_vertices"] - samples, 1e-14)
    call("deform", "--cage", cage, "--posed", pose, "--points", "points.npy", "--method", method, *more, "--out", "image.npy", "--solved", "densities.npz", "--quiet")
    solved = {name: values[0] for name, values in np.load("densities.npz").items()}
    scale = max(1, np.abs(solved["L"]).max(), np.abs(solved["D"]).max())
    check(f"{cage}, {kind}: L of C_11 and C_21", m["C_11"] @ solved["V"] + m["C_21"] @ solved["N"] - solved["L"], 1e-12 * scale)
    check(f"{cage}, {kind}: D of C_12 and C_22", m["C_12"] @ solved["V"] + m["C_22"] @ solved["N"] - solved["D"], 1e-12 * scale)
    # Eq 27.
    at, alpha = layers_at(cage, points), np.load("alpha.npz")
    check(f"{cage}, {kind}: alpha", at["phi"] + at["phibar"] @ m["C_11"] + at["psibar"] @ m["C_12"] - alpha["alpha"], 1e-12)
    check(f"{cage}, {kind}: beta", at["psi"] + at["phibar"] @ m["C_21"] + at["psibar"] @ m["C_22"] - alpha["beta"], 1e-12)
    if kind != "regularised_1_3":
        return
    # Eq 22-25 by NumPy's least squares.
    weight = np.sqrt(m["gamma_D"][0, 0])
    b = (hats - m["Phi_V"]) @ solved["V"] - m["Psi_V"] @ solved["N"]
    matrix = np.vstack([weight * np.hstack([m["Phibar_V"], m["Psibar_V"]]), np.hstack([m["Phi_V"] - hats, m["Psi_V"]])])
    found = np.linalg.lstsq(matrix, np.vstack([weight * b, 0 * b]), rcond=None)[0]
    check(f"{cage}, Eq 24 by NumPy", found - np.vstack([solved["L"], solved["D"]]), 1e-11 * scale)
    check(f"{cage}, Eq 25", m["C_L"] @ b - solved["L"], 1e-12 * scale)
    check(f"{cage}, Eq 25", m["C_D"] @ b - solved["D"], 1e-12 * scale)


def refusals() -> None:
    for message, arguments in (
        ("use .npz", ("deform", "--cage", "cube", "--posed", "cube", "--points", "points.npy", "--method", "ahap", "--out", "o.npy", "--solved", "s.txt")),
        ("no sums", ("deform", "--cage", "cube", "--posed", "cube", "--points", "points.npy", "--method", "somigliana", "--out", "o.npy", "--solved", "s.npz")),
        ("no matrices", ("coordinates", "--cage", "cube", "--points", "points.npy", "--kind", "green", "--out", "o.npy", "--solved", "s.npz")),
    ):
        if message not in call(*arguments, code=2) or Path("s.npz").exists() or Path("o.npy").exists():
            check(f"'{message}' refused, nothing written", np.array([1.0]), 0)


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        generator = np.random.default_rng(1)
        inside = {"cube": generator.uniform(-0.45, 0.45, (7, 3)), "l-shape": generator.uniform(0.05, 0.4, (7, 2))}
        for name, points in inside.items():
            points *= TIMES
            cage, pose = larger(name), f"{name}.txt"
            rest = layers_at(cage, points)["cage_vertices"]
            # Far from the origin, where poses are solved in their own place.
            np.savetxt(pose, rest + TIMES * generator.uniform(-0.15, 0.15, rest.shape) + 50, fmt="%.17g")
            for method, kind in KINDS.items():
                densities(cage, pose, points, method, [])
                matrices(cage, pose, points, method, kind, [])
            for method in ("ahap", "aaap", "tp"):
                densities(cage, pose, points, method, [])
            matrices(cage, pose, points, "biharmonic_1_3", "regularised_1_3", ["--parameter", "level=2", "--parameter", "gamma_rel=10"])
        np.save("points.npy", inside["cube"] / TIMES)
        refusals()
    return exit_code()


sys.exit(main())
