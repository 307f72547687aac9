# SPDX-License-Identifier: MIT
"""Runs the command cageproof for claims.py and its modules, and prints figures."""

import resource
import subprocess
import sys
from pathlib import Path

import numpy as np

CAGE, POSED, MESH = "my_cage.obj", "my_posed_cage.obj", "my_mesh.obj"


def cageproof(*arguments: object) -> str:
    run = subprocess.run(["cageproof", *map(str, arguments)], capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stderr)
    return run.stderr


def timed(*arguments: object) -> float:
    """The processor time of a command, in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    cageproof(*arguments)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def write_mesh(name: str, points: np.ndarray, triangles: np.ndarray) -> None:
    Path(name).write_text("".join(f"v {x} {y} {z}\n" for x, y, z in points) + "".join("f {} {} {}\n".format(*(v + 1 for v in t)) for t in triangles))


def vertices(name: str) -> np.ndarray:
    return np.array([line.split()[1:4] for line in Path(name).read_text().splitlines() if line.startswith("v ")], float)


def size(name: str = CAGE) -> float:
    return float(np.linalg.norm(np.ptp(vertices(name), axis=0)))


def images(method: str, points: np.ndarray, posed: object = POSED, cage: str = CAGE, **parameters: object) -> np.ndarray:
    """The images of points (n x 3) under a method, with its parameters."""
    if isinstance(posed, np.ndarray):
        np.savetxt("pose.txt", posed, fmt="%.17g")
        posed = "pose.txt"
    np.save("at.npy", points)
    options = [part for name, value in parameters.items() for part in ("--parameter", f"{name}={value}")]
    cageproof("deform", "--cage", cage, "--posed", posed, "--points", "at.npy", "--method", method, *options, "--out", "image.npy", "--quiet")
    return np.load("image.npy")


def figures(named: dict[str, float]) -> str:
    return ", ".join(f"{name} {value:.1e}" if value >= 1e-12 else f"{name} below 1e-12" for name, value in named.items())
