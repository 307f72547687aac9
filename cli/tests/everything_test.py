#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""everything_test.py CAGEPROOF [deform] [coordinates] [eval] [verify]: one small call of all that the program can do: a deformation by every method, coordinates of every
kind in every order, lines of `eval` that are whole, cut off and nested, and a verification with every formula, regime and check. The sanitizers run it, because a path that no test takes has no memory errors to show."""

import gzip
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

# Cages that together every method and kind accepts: triangles, quads that stay quads, and a polygon.
CAGES = {"cube": "0.125,0.25,-0.0625\n-0.25,0.125,0.3\n", "spiky-box": "0.125,0.25,-0.0625\n", "twisted-bar": "0.05,0.1,-0.0625\n", "square": "0.25,0.125\n0.7,0.4\n"}
POSITIONS = {2: [[0.2, 0.3], [0.7, 0.2], [0.6, 0.8], [0.3, 0.6]], 3: [[-0.3, 0.1, 0.2], [0.3, -0.1, 0.2], [0.1, 0.3, -0.2], [0, -0.2, -0.3]]}
# The smallest cage that has a quad, with symmetric poses.
PYRAMID = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 1\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


class Failures:
    def __init__(self) -> None:
        self.count = 0

    def say(self, text: str) -> None:
        self.count += 1
        print(f"FAILED: {text}", flush=True)


def run(program: str, *arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run([program, *arguments], capture_output=True, text=True, errors="replace", stdin=subprocess.DEVNULL)


def accepted_by_some_cage(what: str, call, failures: Failures) -> None:
    """call(cage) must succeed for some cage, and for the others be refused with exit code 2, which no crash has."""
    refusals = []
    for cage in CAGES:
        ended = call(cage)
        if ended.returncode == 0:
            return
        refusals.append(f"{cage}: {ended.stderr.strip()[-2000:]}")
        if ended.returncode != 2:
            return failures.say(f"{what} on {cage} ends with exit code {ended.returncode}: {refusals[-1]}")
    failures.say(f"no cage is accepted by {what}:\n  " + "\n  ".join(refusals))


def deform(program: str, listed: dict, failures: Failures) -> None:
    for dimension, places in POSITIONS.items():
        asked = [{"at": at, "to": [*at[:-1], at[-1] + 0.1 * k]} for k, at in enumerate(places)]
        constraints = {"schema": "cageproof-constraints", "schema_version": 1, "positions": asked}
        Path(f"constraints{dimension}.json").write_text(json.dumps(constraints))
    for method in listed["deformers"]:
        name = method["name"]

        def call(cage: str) -> subprocess.CompletedProcess:
            pose = ["--posed", cage] if method["takes"] == "posed cages" else ["--constraints", f"constraints{2 if cage == 'square' else 3}.json"]
            orders = ["--order", "1", "--derivatives", "derivatives.csv"]
            common = ["--cage", cage, "--points", f"{cage}.csv", "--method", name, "--out", "moved.csv", *pose]
            ended = run(program, "deform", *common, *orders)
            return ended if ended.returncode != 2 else run(program, "deform", *common)

        accepted_by_some_cage(f"method {name}", call, failures)


def coordinates(program: str, listed: dict, failures: Failures) -> None:
    for kind in listed["coordinates"]:
        for order in range(3):

            def call(cage: str) -> subprocess.CompletedProcess:
                arguments = ["--cage", cage, "--points", f"{cage}.csv", "--kind", kind["name"], "--out", "coordinates.csv"]
                ended = run(program, "coordinates", *arguments, "--order", str(order))
                # Some kinds have no second derivatives, or none at all.
                for fewer in range(order - 1, -1, -1):
                    if ended.returncode == 2:
                        ended = run(program, "coordinates", *arguments, "--order", str(fewer))
                return ended

            accepted_by_some_cage(f"kind {kind['name']}, order {order}", call, failures)


ELEMENTS = {"segment": ([[0, 0], [1, 0.25]], [0.25, 0.5]),
            "triangle": ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [0.25, 0.25, 1]),
            "quad": ([[0, 0, 0], [1, 0, 0], [1, 1, 0.25], [0, 1, 0]], [0.25, 0.25, 1])}


def evaluate(program: str, listed: dict, failures: Failures) -> None:
    right = {"closed_form": [], "line_form": []}
    for formula in listed["formulas"]:
        element, point = ELEMENTS[formula["element"]]
        algebra = next((e for e in formula["evaluations"] if e["name"] in right), None)
        for scalar in algebra["scalars"] if algebra else []:
            for order in range(algebra["max_order"] + 1):
                right[algebra["name"]].append(json.dumps({"formula": formula["name"], "element": element, "point": point, "order": order, "scalar": scalar}))
    whole = '{"formula":"segment.single_layer","element":[[0,0],[1,0.25]],"point":[0.5,1]}'
    wrong = [whole[:cut] for cut in range(1, len(whole))]
    wrong += [whole.replace("point", "pint"), whole.replace("0.5", "1e999999"), whole.replace("0.5", '"' + "1" * 5000 + 'x"'), "[" * 100000, '{"a":' * 100000, "\0", '"\\ud800"', "null", "[]"]
    for evaluation, lines in right.items():
        ended = subprocess.run([program, "eval", "--evaluation", evaluation], input="\n".join([*lines, *wrong]) + "\n", capture_output=True, text=True)
        answers = ended.stdout.splitlines()
        if len(answers) != len(lines) + len(wrong):
            failures.say(f"eval --evaluation {evaluation} answers {len(answers)} of {len(lines) + len(wrong)} lines, exit code {ended.returncode}: {ended.stderr.strip()[-2000:]}")
        for number, (line, answer) in enumerate(zip([*lines, *wrong], answers)):
            if ("error" in json.loads(answer)) != (number >= len(lines)):
                failures.say(f"eval --evaluation {evaluation} answers {line[:200]} with {answer[:200]}")


def verify(program: str, listed: dict, failures: Failures) -> None:
    Path("pyramid.obj").write_text(PYRAMID)
    Path("tetrahedron.obj").write_text(TETRAHEDRON)
    rows = []
    # Every formula in some regimes, and all of a small cage of space; every regime of some formulas, because integrals of Kelvin kernels on quads take a minute there,
    # and twenty under a sanitizer; then only cages and deformers, which the regime of hulls leaves: in the plane, and with a small face.
    small = ["--enclosures", "1"]
    for options in (
        [*small, "--cage", "pyramid.obj", "--points", "pyramid.obj", "--regimes", "generic,near-face,on-line,tiny,hull"],
        [*small, "--cage", "tetrahedron.obj", "--formulas", "*.single_layer,*.mean_value,triangle.double_layer,segment.*"],
        ["--cage", "square", "--regimes", "hull"],
        ["--cage", "pinch-1e-8", "--regimes", "hull", "--formulas", "triangle.double_layer"],
    ):
        ended = run(program, "verify", "--suite", "quick", "--samples", "1", "--out", "report", *options)
        # A sample is too few for promises to be kept; only a run that ends with its report is asked for. Sanitizers exit with 1, too.
        if ended.returncode not in (0, 1) or not Path("report/summary.json.gz").exists():
            return failures.say(f"verify {' '.join(options)} ends with exit code {ended.returncode}: {ended.stderr.strip()[-4000:]}")
        rows += json.loads(gzip.decompress(Path("report/summary.json.gz").read_bytes()))["rows"]
    for what, known, seen in (
        ("formula", {f["name"] for f in listed["formulas"]}, {row["subject"] for row in rows}),
        ("regime", {r["name"] for r in listed["regimes"]}, {row["regime"] for row in rows}),
        ("check", {c["name"] for c in listed["checks"]}, {row["check"] for row in rows}),
    ):
        if missing := known - seen:
            failures.say(f"verify has no row of the {what} {', '.join(sorted(missing))}")


def main() -> int:
    program, *parts = sys.argv[1:]
    failures = Failures()
    listed = json.loads(run(program, "list", "--json").stdout)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for cage, points in CAGES.items():
            Path(f"{cage}.csv").write_text(points)
        for part in parts or ("deform", "coordinates", "eval", "verify"):
            {"deform": deform, "coordinates": coordinates, "eval": evaluate, "verify": verify}[part](program, listed, failures)
        os.chdir("/")
    return int(failures.count > 0)


if __name__ == "__main__":
    sys.exit(main())
