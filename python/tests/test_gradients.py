# SPDX-License-Identifier: MIT
"""Derivatives of images by the posed cage: against differences, both directions, and the page's function for PyTorch."""

import sys

import cageproof
import numpy as np
import pytest
import torch_stub
from test_pages import blocks, run_page


def differences(function, at, change, step=1e-4):
    """The derivative along a change, of fourth order."""
    near, far = (function(at + k * step * change) - function(at - k * step * change) for k in (1, 2))
    return (8 * near - far) / (12 * step)


@pytest.fixture
def posed():
    cage = cageproof.Cage.embedded("twisted-bar")
    random = np.random.default_rng(4)
    change = random.normal(size=cage.vertices.shape)
    return cage, cage.vertices + 0.1 * random.normal(size=change.shape), change, random.uniform(-0.3, 0.3, (150, 3))


@pytest.mark.parametrize("method, options", [("mean_value", {}), ("green", {}), ("green", {"digits": 3}), ("biharmonic_1_3", {"neumann": "affine"}), ("somigliana", {}), ("quad_somigliana", {"variant": "local"})])
def test_both_directions(posed, method, options):
    cage, vertices, change, points = posed
    deformer = cage.deformer(method, **options)
    bound = deformer.bind(points)
    found = deformer.pose(vertices).jvp(points, change)
    assert np.array_equal(found, deformer.jvp(bound, change))
    weights = np.random.default_rng(5).normal(size=points.shape)
    back = deformer.vjp(points, weights)
    assert np.array_equal(back, deformer.vjp(bound, weights))
    assert np.array_equal(back, cage.deformer(method, threads=1, **options).pose(vertices).vjp(points, weights))
    assert abs(np.sum(back * change) - np.sum(found * weights)) < 1e-13 * np.abs(weights).sum()
    out = np.empty_like(found)
    assert deformer.jvp(bound, change, out=out) is out and np.array_equal(out, found)
    assert abs(found - differences(lambda v: deformer.pose(v).images(bound), vertices, change)).max() < 1e-8
    # The last pose counts, and mean value coordinates have one derivative for all poses.
    other = deformer.pose(2 * vertices + change).jvp(bound, change)
    assert np.array_equal(found, other) == (method == "mean_value")


def test_in_the_plane():
    square = cageproof.Cage([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1], [1, 2], [2, 3], [3, 0]])
    change, points = np.arange(8.0).reshape(4, 2), [[0.3, 0.6], [0.5, 0.5]]
    deformer = square.deformer("biharmonic_boundary").pose(square.vertices + 0.1 * change[::-1])
    found = deformer.jvp(points, change)
    expected = differences(lambda v: square.deformer("biharmonic_boundary").pose(v).images(points), square.vertices + 0.1 * change[::-1], change)
    assert found.shape == (2, 2) and abs(found - expected).max() < 1e-8
    assert deformer.vjp(points, found).shape == (4, 2)


def test_refusals(posed):
    cage, vertices, change, points = posed
    green = cage.deformer("green")
    with pytest.raises(cageproof.Error, match="pose"):
        green.jvp(points, change)
    green.pose(vertices)
    with pytest.raises(cageproof.Error, match="change"):
        green.jvp(points, change[:-1])
    with pytest.raises(cageproof.Error, match="weights"):
        green.vjp(points, points[:-1])
    with pytest.raises(cageproof.Error, match="another"):
        green.vjp(cage.deformer("green").bind(points), points)
    with pytest.raises(cageproof.Error, match="ahap: .* mean_value, .*quad_green"):
        cage.deformer("ahap").pose(vertices).jvp(points, change)
    with pytest.raises(cageproof.Error, match="somigliana: .* with these parameters"):
        cage.deformer("somigliana", gamma=1).pose(vertices).jvp(points, change)
    with pytest.raises(cageproof.Error, match="no area"):
        cage.deformer("green", stretch="area").pose(vertices * 0).vjp(points, points)


def test_points_without_images(posed):
    cage, vertices, change, points = posed
    points, weights = points.copy(), np.ones_like(points)
    points[3], weights[3] = 40, 0
    green = cage.deformer("green").pose(vertices)
    bound = green.bind(points)
    assert np.isnan(green.jvp(points, change)[3]).all() and np.isfinite(green.jvp(bound, change)[4:]).all()
    kept = np.delete(points, 3, axis=0)
    assert abs(green.vjp(bound, weights) - green.vjp(kept, np.ones_like(kept))).max() < 1e-13
    weights[3, 1] = 1e-30
    for where in (points, bound):
        with pytest.raises(cageproof.Error, match="point 3 has no image"):
            green.vjp(where, weights)
    assert green.vjp(np.empty((0, 3)), np.empty((0, 3))).shape == vertices.shape and not green.vjp(np.empty((0, 3)), np.empty((0, 3))).any()


@pytest.mark.parametrize("plane", [False, True])
def test_coordinates_by_the_rest_cage(posed, plane):
    cage, _, change, points = posed
    if plane:
        cage = cageproof.Cage([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]], [[k, (k + 1) % 6] for k in range(6)])
        change, points = change[:6, :2], points[:, :2] + 0.5
        points[0] = [300, 200]
    else:
        points[0] = 40
    green = cage.prepare("green")
    found = green.jvp(points, change)
    # Quads must stay cut as they are.
    faces = [[v for v in row if v >= 0] for row in green.elements.tolist()]
    expected = differences(lambda v: cageproof.Cage(v, faces).coordinates("green", points), cage.vertices, change)
    assert abs(found - expected).max() < 1e-9
    weights = np.random.default_rng(6).normal(size=found.shape)
    back = green.vjp(points, weights)
    assert np.array_equal(back, cage.prepare("green", threads=1).vjp(points, weights))
    assert abs(np.sum(weights * found) - np.sum(back * change)) < 1e-12
    # A shift of the cage is one of the points, back; a scaling of both keeps phi.
    gradients = green(points, 1)[1]
    assert abs(green.jvp(points, np.ones_like(cage.vertices)) + gradients.sum(axis=2)).max() < 1e-13
    scaling = green.jvp(points, cage.vertices) + np.einsum("pix,px->pi", gradients, points)
    assert abs(green.split(scaling)["phi"]).max() < 1e-13
    # On an edge there is none; on a face the limit from inside.
    on = np.stack([cage.vertices[faces[0]].mean(axis=0), cage.vertices[faces[0][:1]].mean(axis=0)])
    assert np.isfinite(green.jvp(on, change)[0]).all() and np.isnan(green.jvp(on, change)[1]).any()
    for act in (lambda: cage.prepare("mean_value").jvp(points, change), lambda: cage.prepare("mean_value").vjp(points, np.ones((len(points), len(cage.vertices))))):
        with pytest.raises(cageproof.Error, match="mean_value: .* those of green"):
            act()
    with pytest.raises(cageproof.Error, match="weights"):
        green.vjp(points, weights[:, :-1])
    with pytest.raises(cageproof.Error, match="change"):
        green.jvp(points, change[:-1])


def test_page_and_its_function_for_pytorch(posed, monkeypatch):
    monkeypatch.setitem(sys.modules, "torch", torch_stub.module())
    namespace = run_page("gradients.md", blocks("gradients.md"))
    cage, vertices, change, points = posed
    deformer = cage.deformer("green")
    bound, tensor = deformer.bind(points), torch_stub.Tensor
    images, back = namespace["Images"].apply(tensor(vertices), deformer, bound)
    # Another pose in between, as in a graph that uses the deformer twice.
    namespace["Images"].apply(tensor(2 * vertices), deformer, bound)
    weights = 2 * images.array
    gradient, *others = back(tensor(weights))
    assert others == [None, None]

    def loss(v):
        return np.sum(deformer.pose(v).images(bound) ** 2)

    assert abs(np.sum(gradient.array * change) - differences(loss, vertices, change)) < 1e-7
    single, back = namespace["Images"].apply(tensor(vertices.astype(np.float32)), deformer, bound)
    assert single.array.dtype == np.float32 and back(single)[0].array.dtype == np.float32
