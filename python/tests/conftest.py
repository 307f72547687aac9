# SPDX-License-Identifier: MIT
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

sys.dont_write_bytecode = True
PROJECT = Path(__file__).resolve().parents[2]


@pytest.fixture
def program(tmp_path):
    """Runs the command line in a folder of its own; what it writes there is compared."""
    path = os.environ.get("CAGEPROOF_PROGRAM")
    if not path:
        pytest.skip("CAGEPROOF_PROGRAM names no program to compare with")

    def run(*arguments, given=""):
        done = subprocess.run([path, *map(str, arguments)], cwd=tmp_path, input=given, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


@pytest.fixture
def cube():
    """Vertices and faces of the cube of edge 2."""
    vertices = np.array([[x, y, z] for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], float)
    return vertices, [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


@pytest.fixture
def points():
    """Inside the embedded cages cube and twisted-bar, and one outside."""
    found = np.random.default_rng(7).uniform(-0.2, 0.2, (100, 3))
    found[0] = 40
    return found
