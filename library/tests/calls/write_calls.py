# SPDX-License-Identifier: MIT
"""Asks the library 2,000 calls from Python and writes them with their results, for C and C++ to ask again. Usage: write_calls.py FILE

A line per call: what, name, cage, order, then three arrays: elements or a pose, points, results (values, then gradients). An array is its size and its
numbers, as hexadecimal floats, in which no bit is lost."""

import sys

import cageproof
import numpy as np

CAGES = ["cube", "thin-box", "l-block", "twisted-bar"]
random = np.random.default_rng(41)


def point():
    """Anywhere around, or on a grid on which faces, edges and vertices lie."""
    return random.choice([-1, -0.5, 0, 0.25, 0.5, 1], 3) if random.random() < 0.3 else random.uniform(-0.6, 0.6, 3)


def points():
    return np.array([point() for _ in range(random.integers(1, 6))])


def element(name):
    shape = cageproof.formula(name)
    if shape.corners == 4:
        return np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]) + random.uniform(-0.2, 0.2, (4, 3))
    return random.uniform(-1, 1, (shape.corners, shape.dimension))


def pose(cage):
    return cage.vertices + random.uniform(-0.2, 0.2, cage.vertices.shape)


def write(file, what, name, cage, order, given, at, results):
    arrays = [np.concatenate([np.ravel(part) for part in array] or [[]]) for array in (given, at, results)]
    numbers = " ".join(f"{len(array)} {' '.join(float(x).hex() for x in array)}" for array in arrays)
    file.write(f"{what} {name} {cage} {order} {numbers}\n")


def main():
    formulas = [name for name in cageproof.names("formulas") if cageproof.names(name)[0] in ("hybrid", "line_form")]
    cages = {name: cageproof.Cage.embedded(name) for name in CAGES}
    kinds = ["mean_value", "green", "biharmonic", "somigliana", "quad_mean_value", "quad_green"]
    prepared = {(kind, cage): cages[cage].prepare(kind) for kind in kinds for cage in CAGES}
    deformers = {(m, cage): cages[cage].deformer(m) for m in ("mean_value", "green", "somigliana") for cage in CAGES}
    with open(sys.argv[1], "w") as file:
        for call in range(2000):
            cage, order = str(random.choice(CAGES)), int(random.integers(2))
            if call % 4 == 0:
                name = formulas[call // 4 % len(formulas)]
                corners, at = element(name), point()[: cageproof.formula(name).dimension]
                found = cageproof.evaluate(name, corners, at, order=order)
                write(file, "evaluate", name, "-", order, [corners], [at], found if order else [found])
            elif call % 4 == 1:
                kind, at = str(random.choice(kinds)), points()
                found = prepared[kind, cage](at, order)
                write(file, "coordinates", kind, cage, order, [], [at], found if order else [found])
            elif call % 4 == 2:
                method, posed, at = str(random.choice(["mean_value", "green", "somigliana"])), pose(cages[cage]), points()
                found = deformers[method, cage].pose(posed).images(at, jacobians=order == 1)
                write(file, "images", method, cage, order, [posed], [at], found if order else [found])
            else:
                at = points()
                found = cages[cage].places(at)
                write(file, "places", "-", cage, 0, [], [at], [found.place, found.face, found.winding])


if __name__ == "__main__":
    main()
