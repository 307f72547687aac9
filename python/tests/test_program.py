# SPDX-License-Identifier: MIT
"""The package gives what the command line gives, to the bit."""

import json

import cageproof
import numpy as np
import pytest


def rows_of(coordinates, points, order):
    """A point's row as the command line orders it: by blocks, values before derivatives."""
    found = coordinates(points, order)
    arrays = [found] if order == 0 else list(found)
    columns = []
    for b in coordinates.blocks:
        size = b.count * b.rows * b.columns
        columns += [a[:, b.offset : b.offset + size].reshape(len(points), -1) for a in arrays]
    return np.hstack(columns)


@pytest.mark.parametrize(
    "cage, kind, order, options",
    [
        ("cube", "green", 2, {}),
        ("twisted-bar", "mean_value", 1, {"triangulation": "fan"}),
        ("twisted-bar", "quad_green", 0, {}),
        ("l-block", "somigliana", 1, {"nu": 0.3}),
        ("cube", "biharmonic", 1, {"evaluation": "closed_form"}),
    ],
)
def test_coordinates(program, tmp_path, points, cage, kind, order, options):
    np.save(tmp_path / "points.npy", points)
    words = {"triangulation": "--triangulate", "evaluation": "--evaluation"}
    given = [x for k, v in options.items() for x in ([words[k], v] if k in words else ["--parameter", f"{k}={v}"])]
    arguments = ["--cage", cage, "--points", "points.npy", "--kind", kind, "--order", order, "--out", "out.npy", *given]
    program("coordinates", *arguments)
    prepared = cageproof.Cage.embedded(cage).prepare(kind, **options)
    expected, found = np.load(tmp_path / "out.npy"), rows_of(prepared, points, order)
    assert found.shape == expected.shape
    assert np.array_equal(found, expected, equal_nan=True)


@pytest.mark.parametrize("method, options", [("green", {}), ("somigliana", {"nu": 0.25}), ("mean_value", {})])
def test_images(program, tmp_path, points, method, options):
    cage = cageproof.Cage.embedded("twisted-bar")
    posed = cage.vertices * [1, 2, 0.5] + np.sin(cage.vertices[:, ::-1])
    inside = points[1:]
    np.save(tmp_path / "points.npy", inside)
    np.save(tmp_path / "posed.npy", posed)
    given = [x for k, v in options.items() for x in ("--parameter", f"{k}={v}")]
    arguments = ["--cage", "twisted-bar", "--posed", "posed.npy", "--points", "points.npy", "--method", method, *given]
    program("deform", *arguments, "--out", "out.csv")
    expected = np.loadtxt(tmp_path / "out.csv", delimiter=",", skiprows=1)[:, :3]
    deformer = cage.deformer(method, **options).pose(posed)
    assert np.array_equal(deformer.images(inside), expected)
    assert np.array_equal(deformer.images(deformer.bind(inside)), expected)


def test_inside(program, tmp_path, points):
    cage = cageproof.Cage.embedded("l-block")
    asked = np.vstack([points * 5, cage.vertices, (cage.vertices[0] + cage.vertices[1:]) / 2])
    np.save(tmp_path / "points.npy", asked)
    program("inside", "--cage", "l-block", "--points", "points.npy", "--out", "out.npy")
    expected, found = np.load(tmp_path / "out.npy"), cage.places(asked)
    assert np.array_equal(np.column_stack(found), expected, equal_nan=True)
    assert {-1, 0, 1} == set(found.place)


@pytest.mark.parametrize("name", ["triangle.double_layer", "triangle.kelvin_traction", "quad.mean_value", "segment.single_layer"])
def test_formulas(program, name):
    shape, random = cageproof.formula(name), np.random.default_rng(3)
    corners = np.array([[0, 0, 0], [1, 0, 0.25], [1.25, 1, 0], [0, 1, 0.25]])
    elements = (corners[: shape.corners] + random.uniform(-0.1, 0.1, (20, shape.corners, 3)))[:, :, : shape.dimension]
    points = random.uniform(-1, 2, (20, shape.dimension))
    for evaluation in cageproof.names(name)[:1]:
        lines = [json.dumps({"element": e.tolist(), "point": p.tolist()}) for e, p in zip(elements, points)]
        text = program("eval", "--formula", name, "--evaluation", evaluation, "--order", 2, given="\n".join(lines))
        expected = [json.loads(line) for line in text.splitlines()]
        found = cageproof.evaluate(name, elements, points, order=2)
        for word, tensor in zip(("value", "gradient", "hessian"), found):
            assert np.array_equal(tensor.reshape(20, -1), [row[word] for row in expected])
        # The same as all pairs, and as sums.
        pairs = cageproof.potentials(name, elements, points)
        each = [cageproof.evaluate(name, elements, p) for p in points]
        assert np.array_equal(pairs, each)
