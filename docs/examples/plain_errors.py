# SPDX-License-Identifier: MIT
"""plain_errors.py FORMULA [ORDER]: the largest relative errors of evaluations of a triangle formula at each distance, in float and in double.

Points are above, beside and next to the unit right triangle; they are rounded to float, so that both scalars see the same input. The truth is the closed
form in 50 digits, which `cageproof verify` holds against the integral."""
import json
import random
import struct
import subprocess
import sys
from fractions import Fraction

CORNERS = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
EVALUATIONS = [("plain", "float"), ("plain", "double"), ("gauss-8", "double"), ("gauss-16", "double")]
PLACES = {
    "any direction": [1e4, 1e3, 1e2, 1e1, 3, 1],
    "over the face": [1e-1, 1e-2, 1e-3, 1e-4, 1e-6],
    "next to an edge": [1e-1, 1e-2, 1e-3, 1e-4, 1e-6],
}


def rounded(x: float) -> float:
    return struct.unpack("f", struct.pack("f", x))[0]


def point(place: str, distance: float) -> list[float]:
    way = [random.gauss(0, 1) for _ in range(3)]
    length = sum(x * x for x in way) ** 0.5
    if place == "any direction":
        at = [0.3, 0.3, 0]
    elif place == "over the face":
        at, way, length = [random.uniform(0.2, 0.4), random.uniform(0.2, 0.4), 0], [0, 0, random.choice([-1, 1])], 1
    else:  # across the edge along the first axis
        at, way[0] = [random.uniform(0.2, 0.8), 0, 0], 0
        length = (way[1] ** 2 + way[2] ** 2) ** 0.5
    return [rounded(a + distance * w / length) for a, w in zip(at, way)]


def evaluated(formula: str, evaluation: str, scalar: str, order: int, points: list) -> list[list]:
    lines = "".join(json.dumps({"element": CORNERS, "point": p}) + "\n" for p in points)
    command = ["cageproof", "eval", "--formula", formula, "--evaluation", evaluation, "--scalar", scalar, "--order", str(order)]
    run = subprocess.run(command, input=lines, capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stderr)
    name = ["value", "gradient", "hessian"][order]
    return [[Fraction(str(x)) for x in json.loads(line)[name]] for line in run.stdout.splitlines()]


def relative_error(found: list, truth: list) -> float:
    error = sum((a - b) ** 2 for a, b in zip(found, truth))
    return float(error / sum(b**2 for b in truth)) ** 0.5


def main() -> None:
    formula, order = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 0
    random.seed(1)
    print(f"{'place':<16}{'distance':>9}" + "".join(f"{e + ', ' + s:>18}" for e, s in EVALUATIONS))
    for place, distances in PLACES.items():
        for distance in distances:
            points = [point(place, distance) for _ in range(100)]
            truth = evaluated(formula, "closed_form", "mp50", order, points)
            row = []
            for evaluation, scalar in EVALUATIONS:
                found = evaluated(formula, evaluation, scalar, order, points)
                row.append(max(relative_error(f, t) for f, t in zip(found, truth)))
            print(f"{place:<16}{distance:>9g}" + "".join(f"{e:>18.1e}" for e in row))


main()
