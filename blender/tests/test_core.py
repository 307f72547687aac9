# SPDX-License-Identifier: MIT
"""What the add-on computes, without Blender, is what `cageproof deform` writes."""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import cageproof
import numpy as np
import pytest

sys.dont_write_bytecode = True
# The package itself wants Blender's bpy.
_spec = importlib.util.spec_from_file_location("core", Path(__file__).resolve().parents[1] / "cageproof_blender/core.py")
core = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(core)
CUBE = cageproof.Cage.embedded("cube")
POINTS = np.random.default_rng(3).uniform(-0.4, 0.4, (60, 3))
POSED = CUBE.vertices * [1, 2, 0.5] + np.sin(CUBE.vertices[:, ::-1])


@pytest.mark.parametrize("method, parameters", [("green", ""), ("somigliana", "nu=0.45 variant=local"), ("mean_value", ""), ("quad_green", ""), ("harmonic", "")])
def test_images_are_those_of_deform(tmp_path, method, parameters):
    program = os.environ.get("CAGEPROOF_PROGRAM")
    if not program:
        pytest.skip("CAGEPROOF_PROGRAM names no program to compare with")
    np.save(tmp_path / "points.npy", POINTS)
    np.save(tmp_path / "posed.npy", POSED)
    given = [x for word in parameters.split() for x in ("--parameter", word)]
    words = ["deform", "--cage", "cube", "--posed", "posed.npy", "--points", "points.npy", "--method", method, "--out", "out.npy", *given]
    done = subprocess.run([program, *words], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert np.array_equal(core.Binding(CUBE.vertices, CUBE.faces, POINTS, method, parameters).images(POSED), np.load(tmp_path / "out.npy"))


def test_every_method_keeps_the_rest_pose():
    methods = core.methods()
    assert methods[:2] == ["mean_value", "green"] and "positive_mean_value" in methods and "cauchy" not in methods
    for method in methods:
        assert abs(core.Binding(CUBE.vertices, CUBE.faces, POINTS, method).images(CUBE.vertices) - POINTS).max() < 1e-9, method


def test_faces_that_point_inward():
    turned = core.Binding(CUBE.vertices, [f[::-1] for f in CUBE.faces], POINTS, "green").images(POSED)
    assert abs(turned - core.Binding(CUBE.vertices, CUBE.faces, POINTS, "green").images(POSED)).max() < 1e-13


def test_points_outside():
    points = np.vstack([POINTS[:3], [[9, 9, 9]]])
    with pytest.raises(core.Error, match=r"1 of the mesh's 4 vertices are outside of the cage \(vertices 3, counted from 0\)"):
        core.Binding(CUBE.vertices, CUBE.faces, points, "green")
    green = core.Binding(CUBE.vertices, CUBE.faces, points, "green", outside=True).images(CUBE.vertices + 1)
    assert np.allclose(green, np.vstack([points[:3] + 1, points[3:]]))
    mean_value = core.Binding(CUBE.vertices, CUBE.faces, points, "mean_value", outside=True).images(CUBE.vertices + 1)
    assert np.allclose(mean_value, points + 1)


@pytest.mark.parametrize(
    "change, text",
    [
        (lambda a: a.update(faces=a["faces"][1:]), "the cage has a hole"),
        (lambda a: a.update(faces=[[0, 1, 2, 3, 4]]), "face 0 has 5 corners"),
        (lambda a: a.update(faces=[]), "it has no faces"),
        (lambda a: a.update(points=[]), "the mesh has no vertices"),
        (lambda a: a.update(method="greem"), "method 'greem' is none of mean_value, green"),
        (lambda a: a.update(parameters="nu"), "'nu' is not NAME=VALUE"),
        (lambda a: a.update(parameters="stretch=rms stretch=unit"), "comes twice"),
        (lambda a: a.update(parameters="nu=0.3"), "green has only stretch"),
    ],
)
def test_what_is_refused(change, text):
    given = {"vertices": CUBE.vertices, "faces": CUBE.faces, "points": POINTS, "method": "green"}
    change(given)
    with pytest.raises(core.Error, match=text):
        core.Binding(**given)


def test_poses_that_are_refused():
    bound = core.Binding(CUBE.vertices, CUBE.faces, POINTS, "green")
    with pytest.raises(core.Error, match="the cage has 7 vertices, and had 8"):
        bound.images(POSED[:7])
    with pytest.raises(core.Error, match="vertex 2 is not finite"):
        bound.images(np.where(np.arange(8)[:, None] == 2, np.nan, POSED))
    with pytest.raises(core.Error, match="single precision"):
        core.in_single(np.full((2, 3), 1e300))


def test_spaces():
    turn = np.array([[0, -2, 0, 1], [2, 0, 0, 2], [0, 0, 2, 3], [0, 0, 0, 1]], float)
    assert np.array_equal(core.moved(core.between(turn, turn), POINTS), POINTS)
    assert np.allclose(core.moved(core.between(turn, np.eye(4)), core.moved(turn, POINTS)), POINTS)
    with pytest.raises(core.Error, match="scaled to nothing"):
        core.between(np.diag([1, 0, 1, 1]), np.eye(4))
    mixed = [[0, 1, 2], [3, 4, 5, 6]]
    assert core.unflat(core.flat(mixed)) == mixed
