# SPDX-License-Identifier: MIT
"""What may catch a mutant: a test that ./test runs, or one of `cageproof verify`'s units of work."""

import json
import os
import resource
import signal
import subprocess
import time
from dataclasses import asdict, dataclass, field
from pathlib import Path

SKIPPED = 77  # the exit code of a test that is skipped (cmake/test_main.cpp)
MEMORY = 12 << 30  # bytes; a mutant may ask for all there is


@dataclass
class Detector:
    """A test, or a place in the order of `verify`'s units of work."""

    id: str
    command: list
    folder: str  # where it runs
    binary: str = ""  # that holds the test: tests of one run together; empty for scripts and units of work
    is_unit: bool = False
    place: int = 0  # of the unit
    seconds: float = 0.0
    reached: list = field(default_factory=list)  # the mutants' numbers
    fails: str = ""  # what it says when it fails, or is skipped, without mutants

    @staticmethod
    def of(record: dict) -> "Detector":
        found = Detector(**record)
        found.reached = set(found.reached)
        return found

    @property
    def kind(self) -> str:
        return "verify" if self.is_unit else "tests"

    @property
    def filter(self) -> str:
        return next(w.removeprefix("--gtest_filter=") for w in self.command if w.startswith("--gtest_filter="))


def run(command, folder, limit, environment):
    """(exit code, output's end); None for a code where the time was up. Kills whatever was started."""
    process = subprocess.Popen(
        command,
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env={**os.environ, **environment},
        start_new_session=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)),
    )
    try:
        output, _ = process.communicate(timeout=limit)
        code = process.returncode
    except subprocess.TimeoutExpired:
        code, output = None, b""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()
    process.stdout.close()
    return code, output.decode(errors="replace")


def tests(build: Path) -> list[Detector]:
    """Every test that ctest knows."""
    command = ["ctest", "--test-dir", str(build), "--show-only=json-v1"]
    listed = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    found = []
    for test in listed["tests"]:
        folder = next((p["value"] for p in test["properties"] if p["name"] == "WORKING_DIRECTORY"), str(build))
        command = test["command"]
        is_unit_test = any(word.startswith("--gtest_filter=") for word in command)
        found.append(Detector(test["name"], command, folder, command[0] if is_unit_test else ""))
    return found


def measure(detector: Detector, folder: Path) -> dict:
    """Runs a detector without mutants: its time and what it reaches."""
    trace = folder / "trace"
    trace.unlink(missing_ok=True)
    start = time.monotonic()
    environment = {"CAGEPROOF_MUTANT_TRACE": str(trace), "TMPDIR": str(folder)}
    code, output = run(detector.command, detector.folder, None, environment)
    detector.seconds = round(time.monotonic() - start, 3)
    if code:
        detector.fails = output[-2000:] or f"exit code {code}"
    detector.reached = sorted({int(number) for number in trace.read_text().split()}) if trace.exists() else []
    return asdict(detector)
