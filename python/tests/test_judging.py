# SPDX-License-Identifier: MIT
"""cageproof.judge: callables of Python, judged by the program."""

import ctypes
import json
import os
import socket
import subprocess
import sys
import threading

import cageproof
import numpy as np
import pytest
from cageproof import judging

FORMULA = "segment.winding_angle"
FEW = {"samples": 8, "regimes": "generic,near-vertex"}


@pytest.fixture(autouse=True)
def asked(program):
    """Skips where there is no program to ask."""


def angle(element, point):
    """The angle that a segment is seen under; at its ends half of what the inside sees on it."""
    a, b = element - point
    nearer, side = (a if np.hypot(*a) < np.hypot(*b) else b), element[1] - element[0]
    if not nearer.any():
        return np.pi / 2
    return np.arctan2(nearer[0] * side[1] - nearer[1] * side[0], a @ b)


def by_cosine(element, point):
    """The same, without sign, and by the arc cosine, which loses half of the digits next to 0 and pi."""
    a, b = element - point
    return np.arccos(a @ b / (np.linalg.norm(a) * np.linalg.norm(b)))


def kinds(certificate):
    return [finding["kind"] for finding in certificate["findings"]]


def test_sound():
    found = cageproof.judge(FORMULA, angle, **FEW)
    assert found["schema"] == "cageproof-certificate" and found["verdict"] == "clean"
    assert kinds(found) == [] and found["judged"]["about"].endswith(".angle") and found["samples_per_regime"] == 8
    rows = found["formulas"][0]["rows"]
    assert {row["regime"] for row in rows} == {"generic", "near-vertex"}
    assert max(row["conditioned"]["worst"] for row in rows) < 8


def test_broken():
    found = cageproof.judge(FORMULA, by_cosine, **FEW)
    assert found["verdict"] == "defects" and any(finding["defect"] and "input" in finding for finding in found["findings"])


def test_conventions_and_promises():
    found = cageproof.judge(FORMULA, lambda e, p: -2 * angle(e, p), promise=1e-9, **FEW)
    assert found["verdict"] == "clean" and kinds(found) == ["convention"] and found["promise"]["kept"]
    assert cageproof.judge(FORMULA, angle, promise=1e-30, samples=4, regimes="generic")["verdict"] != "clean"


@pytest.mark.parametrize(
    "wrong, kind, text",
    [
        (lambda e, p: ctypes.string_at(0), "exit", "the callable's process ended"),
        (lambda e, p: exec("while True: pass"), "hang", "no answer within 0.25 s"),
        (lambda e, p: [angle(e, p)] * 0, "short answer", "0 numbers"),
    ],
)
def test_what_goes_wrong(wrong, kind, text):
    # At one input only: each crash takes the judge a while.
    few = {"samples": 4, "regimes": "generic"}
    row = cageproof.judge(FORMULA, angle, **few)["formulas"][0]["rows"][0]
    there = [float.fromhex(x) for x in row["relative"]["input"]["point"]]

    def once(element, point):
        return wrong(element, point) if point.tolist() == there else angle(element, point)

    found = cageproof.judge(FORMULA, once, seconds=0.25 if kind == "hang" else 10, **few)
    assert found["verdict"] == "defects"
    assert any(kind in finding["kind"] and text in finding["text"] for finding in found["findings"]), found["findings"]


def test_exceptions_end_the_relay(tmp_path):
    """With their text, behind the answers before; `judge` takes a process's last line on standard error."""

    def fragile(element, point):
        return {}["gone"] if point[0] else 0.5

    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind(str(tmp_path / "socket"))
        listening.listen()
        command = [sys.executable, "-I", "-S", judging._RELAY, tmp_path / "socket"]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as relay:
            served = threading.Thread(target=judging._Answers(FORMULA, fragile, 0).serve, args=(listening.accept()[0],))
            served.start()
            lines = [json.dumps({"formula": FORMULA, "order": 0, "element": [[0, 0], [1, 0]], "point": [x, 0]}) for x in (0, 0, 1, 0)]
            out, err = relay.communicate("\n".join(lines) + "\n", timeout=20)
            served.join(20)
    assert (out, err.strip(), relay.returncode) == ('{"value": [0.5]}\n' * 2, "KeyError: 'gone'", 1)


def test_declined_inputs_are_no_defect():
    def half(element, point):
        if point[0] > 0:
            raise NotImplementedError("points on the left only")
        return angle(element, point)

    row = cageproof.judge(FORMULA, half, samples=40, regimes="generic")["formulas"][0]["rows"][0]
    assert 0 < row["declined"] < 40


def test_the_package_itself_with_derivatives_and_a_parameter():
    def kelvin(element, point, mu, nu):
        return cageproof.evaluate("segment.kelvin_displacement", element, point, order=1, mu=mu, nu=nu)

    found = cageproof.judge("segment.kelvin_displacement", kelvin, order=1, samples=4, regimes="generic")
    assert found["verdict"] == "clean" and kinds(found) == []
    assert {(row["order"], row["samples"]) for row in found["formulas"][0]["rows"]} == {(0, 4), (1, 4)}


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("drift, verdict", [(0, "clean"), (1e-6, "defects")])
def test_coordinates_of_whole_cages(drift, verdict, dimension):
    def own(vertices, faces, points):
        assert vertices.shape[1] == faces.shape[1] == points.shape[1] == dimension
        # A factor that is the same everywhere is a convention.
        return (1 + drift * points[:, :1]) * cageproof.Cage(vertices, faces).coordinates("mean_value", points, threads=1)

    found = cageproof.judge("mean_value", own, dimension=dimension, samples=4, regimes="inside")
    assert found["verdict"] == verdict, found["findings"]


def test_without_isolation():
    """A thread of this process answers, and keeps what it was told."""
    seen = []
    assert cageproof.judge(FORMULA, lambda e, p: seen.append(0) or angle(e, p), isolate=False, **FEW)["verdict"] == "clean"
    assert seen


def test_what_is_refused(tmp_path):
    for arguments, given, text in [
        (("triangle.nothing", angle), {}, "triangle.nothing"),
        ((FORMULA, 3), {}, "no function"),
        ((FORMULA, angle), {"order": 3}, "order 3"),
        (("mean_value", angle), {"order": 1}, "only values"),
        ((FORMULA, angle), {"regimes": "nowhere"}, "nowhere"),
        ((FORMULA, angle), {"program": str(tmp_path / "absent")}, "is no program"),
    ]:
        with pytest.raises(cageproof.Error, match=text):
            cageproof.judge(*arguments, **given)


def test_nothing_is_left(tmp_path):
    """No process and no file, in a fresh interpreter."""
    code = f"import cageproof; cageproof.judge('{FORMULA}', lambda e, p: 0.0, samples=2, regimes='generic'); import os; os.waitpid(-1, 0)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env={**os.environ, "TMPDIR": str(tmp_path)})
    assert "ChildProcessError" in done.stderr
    assert not list(tmp_path.iterdir())
