#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Real output obeys the schemas of docs/schemas, and they admit nothing else.

schemas_test.py PATH_OF_CAGEPROOF FOLDER_OF_SCHEMAS FOLDER_OF_JUDGE
"""
import copy
import gzip
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import jsonschema

PROGRAM, SCHEMAS, JUDGE = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()


def validator(name):
    schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def run(*arguments, text=None, codes=(0,)):
    done = subprocess.run([str(PROGRAM), *arguments], input=text, capture_output=True, text=True, check=False)
    assert done.returncode in codes, (arguments, done.returncode, done.stdout, done.stderr)
    return done.stdout


def lines(path):
    opened = gzip.open(path, "rt") if path.suffix == ".gz" else open(path)
    with opened as file:
        return [json.loads(line) for line in file if line.strip()]


def check(name, objects):
    """All objects obey the schema; none does with a member more, or without one that is required."""
    schema = validator(name)
    assert objects, f"{name}: nothing was written"
    for one in objects:
        error = next(schema.iter_errors(one), None)
        assert error is None, f"{name}: {list(error.absolute_path)}: {error.message[:300]}"
    more = copy.deepcopy(objects[0])
    more["unheard of"] = 1
    assert not schema.is_valid(more), f"{name}: a member more is admitted"
    for key in schema.schema.get("required", []):
        less = {k: v for k, v in objects[0].items() if k != key}
        assert not schema.is_valid(less), f"{name}: {key} may be missing"
    print(f"{name}: {len(objects)}")


def main():
    run("verify", "--formulas", "segment.winding_angle,quad.solid_angle", "--regimes", "generic,on-edge", "--samples", "2", "--out", "report", "--quiet", codes=(0, 1))
    run("verify", "--cage", "square", "--regimes", "hull", "--samples", "2", "--out", "cage", "--quiet", codes=(0, 1))
    with gzip.open("report/summary.json.gz", "rt") as first, gzip.open("cage/summary.json.gz", "rt") as second:
        check("summary", [json.load(first), json.load(second)])
    worst = [line for folder in ("report", "cage") for path in sorted(Path(folder, "worst").glob("*.gz")) for line in lines(path)[:20]]
    assert {"formula", "kind", "deformer"} <= {key for line in worst for key in line}, "worst cases of all three kinds"
    check("worst", worst)
    run("vectors", "--formulas", "triangle.solid_angle,segment.kelvin_displacement", "--out", "vectors")
    check("vectors", [json.loads(path.read_text()) for path in sorted(Path("vectors").glob("*.json"))])
    run("vectors", "--kinds", "mean_value,somigliana", "--cages", "l-shape", "--out", "cages")
    run("vectors", "--kinds", "maximum_entropy", "--cages", "bent-box", "--out", "cages")
    check("cage-vectors", [json.loads(path.read_text()) for path in sorted(Path("cages").glob("*.json"))])
    run("judge", "mine='" + str(PROGRAM) + "' eval --evaluation plain", "--formula", "segment.winding_angle", "--samples", "10", "--promise", "1e-10", "--out", "element", "--quiet", codes=(0, 1))
    run("judge", "--template", "python-cage")
    run("judge", "mine=./mine_cage.py", "--kind", "mean_value", "--samples", "5", "--out", "whole", "--quiet")
    run("judge", "mine=./mine_cage.py", "--kind", "mean_value", "--dimension", "2", "--samples", "5", "--out", "plane", "--quiet")
    run("judge", f"mine={JUDGE}/tests/programs/threshold.py", "--samples", "10", "--regimes", "generic", "--out", "defect", "--quiet", codes=(1,))
    run("judge", f"mine={JUDGE}/zoo/sides.py", "--kind", "inside", "--samples", "5", "--regimes", "on-face", "--out", "sides", "--quiet", codes=(1,))
    certificates = [json.loads(Path(folder, "certificate.json").read_text()) for folder in ("element", "whole", "plane", "defect", "sides")]
    assert any(one["findings"] for one in certificates) and any(one["promise"] for one in certificates)
    check("certificate", certificates)
    questions = [
        {"formula": "triangle.kelvin_displacement", "order": 2, "element": [[0, 0, 0], [1, 0, 0], [0, "0x1p+0", 0]], "point": [0.25, 0.25, 1], "parameters": {"nu": 0.3}},
        {"formula": "segment.single_layer", "scalar": "mp50", "element": [[0, 0], [1, 0]], "point": [0, 0]},
        {"formula": "segment.nothing", "element": [[0, 0], [1, 0]], "point": [0, 0]},
        {"describe": True},
    ]
    answers = run("eval", "--evaluation", "closed_form", text="".join(json.dumps(q) + "\n" for q in questions), codes=(0, 2))
    questions.append({"kind": "mean_value", "vertices": [[0, 0, 0]], "faces": [[0, 1, 2]], "points": [[0, 0, 1]]})
    questions.append({"kind": "mean_value", "vertices": [[0, 0]], "faces": [[0, 1]], "points": [[0, 1]]})
    check("eval-question", questions)
    quad = {"element": [[0, 0, 0], [1, 0, 0], [1, 1, 0.25], [0, 1, 0]], "point": [0.25, 0.5, 1]}
    answers += run("eval", "--formula", "quad.mean_value", "--evaluation", "riemann-16", "--steps", text=json.dumps(quad) + "\n")
    answers += run("eval", "--formula", "quad.solid_angle", "--evaluation", "certified", text=json.dumps(quad) + "\n")
    check("eval-answer", [json.loads(line) for line in answers.splitlines()])
    run("figures", "--out", "figures", "--quiet")
    check("figures", [json.loads(Path("figures/figures/figures.json").read_text())])


if __name__ == "__main__":
    os.environ["CAGEPROOF_TRUTH_CACHE"] = "off"
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        main()
