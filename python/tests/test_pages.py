# SPDX-License-Identifier: MIT
"""The Python on docs/python.md, docs/potentials.md and docs/tour.md runs as it stands, and prints what the lines after `#>` say."""

import contextlib
import io
import re
import shutil

import numpy as np
import pytest
from conftest import PROJECT

NUMBER = re.compile(r"[-+]?\d+\.\d*(?:e[-+]?\d+)?")


def blocks(page):
    text = (PROJECT / "docs" / page).read_text()
    return [(text[: m.start(1)].count("\n") + 1, m[1]) for m in re.finditer(r"^```python\n(.*?)^```$", text, re.M | re.S)]


def same(found, expected):
    """The same words; numbers with a point to 1e-9 of themselves, or of one."""
    if [w.strip() for w in NUMBER.split(found)] != [w.strip() for w in NUMBER.split(expected)]:
        return False
    a, b = (np.array([float(x) for x in NUMBER.findall(t)]) for t in (found, expected))
    return bool(np.allclose(a, b, rtol=1e-9, atol=1e-9))


def run_page(page, found):
    """Runs a page's blocks one after another; what they leave, and how many lines were compared."""
    namespace, compared = {}, 0
    for line, code in found:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(code, f"docs/{page}:{line}", "exec"), namespace)
        expected = [row[2:].strip() for row in code.splitlines() if row.startswith("#>")]
        printed = [row.strip() for row in out.getvalue().splitlines()]
        assert len(printed) == len(expected), f"docs/{page}:{line} prints {printed}"
        for a, b in zip(printed, expected):
            assert same(a, b), f"docs/{page}:{line} prints {a!r}, not {b!r}"
        compared += len(expected)
    return {**namespace, "compared": compared}


@pytest.mark.parametrize("page, least", [("python.md", 8), ("potentials.md", 8), ("tour.md", 4)])
def test_page(page, least, tmp_path, monkeypatch):
    if page == "tour.md":
        pytest.importorskip("matplotlib", reason="python3-matplotlib is not installed")
    examples = tmp_path / "examples"
    shutil.copytree(PROJECT / "docs/examples", examples)
    monkeypatch.chdir(examples)
    found = blocks(page)
    assert len(found) >= least
    assert run_page(page, found)["compared"] >= least


def test_comparison_sees_differences():
    assert same("[1. 2.5] True", "[1. 2.5] True") and same("-2.2e-16", "0.0")
    assert not same("[1. 2.5] True", "[1. 2.6] True") and not same("True", "False") and not same("(2, 8)", "(2, 9)")
