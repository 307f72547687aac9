# SPDX-License-Identifier: MIT
"""Checks of tests in Python that run the program, which is the test's first argument."""

import subprocess
import sys
from pathlib import Path

import numpy as np

PROGRAM = Path(sys.argv[1]).resolve()
_failures = 0


def check(what: str, error: float | np.ndarray, bound: float) -> None:
    """Counts a failure where `error`, of an array its largest size, is above the bound or not a number."""
    global _failures
    worst = float(np.abs(error).max()) if isinstance(error, np.ndarray) else float(error)
    if not worst <= bound:
        _failures += 1
        print(f"FAILED: {what}: {worst:.2e} above {bound:.0e}", flush=True)


def call(*arguments: object, code: int = 0) -> str:
    """Runs the program, and ends the test where it ends with another code. Returns its standard error."""
    ended = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if ended.returncode != code:
        sys.exit(f"FAILED: exit code {ended.returncode}, not {code}: {arguments}\n{ended.stderr}")
    return ended.stderr


def exit_code() -> int:
    return 1 if _failures else 0
