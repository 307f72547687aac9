# SPDX-License-Identifier: MIT
"""Relations that hold for any cage and any points, which hypothesis seeks counterexamples of."""

import cageproof
import numpy as np
import pytest

pytest.importorskip("hypothesis", reason="python3-hypothesis is not installed")
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
CUBE = np.array([[x, y, z] for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], float)
ROUNDING = 2.0**-53

# A busy machine is no failure.
few = settings(max_examples=20, deadline=None, derandomize=True, database=None, suppress_health_check=[HealthCheck.too_slow])


def vectors(count, most=0.25):
    """Up to that far along each axis. Multiples of 2^-10, so that sums of them are exact."""
    return arrays(np.int64, (count, 3), elements=st.integers(int(-1024 * most), int(1024 * most))).map(lambda n: n / 1024)


@st.composite
def cages(draw):
    """A cube whose vertices are moved by up to a quarter: closed, and it holds the cube of half its size."""
    return cageproof.Cage(CUBE + draw(vectors(8)), FACES)


@few
@given(cages(), vectors(5, 0.5), st.sampled_from(["mean_value", "green", "quad_mean_value"]))
def test_points_are_reproduced(cage, points, kind):
    prepared = cage.prepare(kind)
    values = prepared(points)
    data = [cage.vertices] + [block.normal_factor * prepared.normals for block in prepared.blocks if block.reproduces == "normals"]
    size = np.ptp(cage.vertices, axis=0).max()
    bound = 64 * ROUNDING * size * (1 + abs(values).sum(axis=1))
    assert (abs(values @ np.vstack(data) - points).max(axis=1) <= bound).all()


@few
@given(cages(), vectors(20, 1.5), vectors(1), st.permutations(range(3)), st.integers(-40, 40))
def test_places_move_with_the_cage(cage, points, shift, axes, exponent):
    points[:8] = cage.vertices
    places = cage.places(points)
    assert (places.place[:8] == 0).all()

    def moved(x):
        return np.ldexp((x + shift)[:, axes], exponent)

    # A permutation of axes that is no rotation turns the faces inside out.
    turned = np.linalg.det(np.eye(3)[:, axes]) < 0
    faces = [[f[0], *f[:0:-1]] for f in cage.faces] if turned else cage.faces
    found = cageproof.Cage(moved(cage.vertices), faces).places(moved(points))
    assert np.array_equal(found.place, places.place) and np.array_equal(found.face, places.face)
    assert np.array_equal(found.winding, places.winding, equal_nan=True)


@few
@given(cages(), vectors(8), vectors(8), vectors(6), vectors(6, 0.5), st.sampled_from(["mean_value", "green", "somigliana"]))
def test_products_are_of_one_matrix(cage, change, pose, weights, points, method):
    deformer = cage.deformer(method).pose(cage.vertices + pose)
    along, back = deformer.jvp(points, change), deformer.vjp(points, weights)
    bound = 64 * ROUNDING * (abs(weights).sum() + abs(change).sum())
    assert abs(np.sum(along * weights) - np.sum(change * back)) <= bound


@few
@given(cages(), vectors(8), vectors(9, 2), st.sampled_from(["mean_value", "green", "somigliana", "biharmonic_1_3"]))
def test_bound_points_have_the_images_of_points(cage, pose, points, method):
    deformer = cage.deformer(method)
    bound = deformer.bind(points)
    deformer.pose(cage.vertices + pose)
    assert np.array_equal(deformer.images(bound), deformer.images(points), equal_nan=True)
