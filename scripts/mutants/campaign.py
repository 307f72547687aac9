# SPDX-License-Identifier: MIT
"""Asks both detectors of every mutant: of each what reaches the mutant, the quickest first, until something fails."""

import json
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mutants import detectors, verification
from mutants.accounting import CAUGHT, MISSED, OPEN, UNREACHED, Answers, chosen, lines_of

# A detector's work is run in portions of at most so many seconds (without a mutant), so that the cheap portions of all mutants come before costly ones. A
# portion of units of work is planned and judged once, which costs a second: units are not asked one by one.
PORTIONS = [5, 20, 100, 10**9]


class Campaign:
    grace = 20  # seconds that a portion has beyond five times its time

    def __init__(self, folder: Path, build: Path, jobs: int, until: float, say, rooms=(), sample=None):
        """\\param until the time at which nothing more is begun \\param rooms, sample which mutants are asked about, as in accounting.chosen"""
        self.folder, self.build, self.jobs, self.until, self.say = folder, build, jobs, until, say
        self.mutants = chosen(lines_of(folder / "mutants.jsonl"), set(rooms), sample, 1)
        self.verification = verification.Verification(build / "bin/cageproof", folder / "verify")
        self.lock = threading.Lock()
        self.results, self.known = folder / "results.jsonl", folder / "detectors.jsonl"

    def run(self) -> None:
        self.time_detectors(detectors.tests(self.build), "tests")
        self.time_detectors(self.verification.units(), "units of work")
        if self.is_over():
            return
        if not (self.folder / "verify/whole").exists():
            self.verification.check()
        self.verification.read()
        # Both by turns: the dear end of one does not keep the other's cheap beginning from being asked.
        for limit in PORTIONS:
            for detector in ("tests", "verify"):
                self.ask_all(detector, limit)

    def is_over(self) -> bool:
        if time.time() <= self.until:
            return False
        self.say("the time is up; --resume goes on")
        return True

    def slot(self) -> Path:
        """A thread's own folder."""
        slot = self.folder / f"slot-{threading.get_ident()}"
        slot.mkdir(parents=True, exist_ok=True)
        return slot

    def write(self, path: Path, record: dict) -> None:
        with self.lock, path.open("a") as file:
            file.write(json.dumps(record) + "\n")

    def time_detectors(self, found: list, what: str) -> None:
        """Time and reach of detectors, as far as they are not known."""
        done = {record["id"] for record in lines_of(self.known)}
        todo = [d for d in found if d.id not in done]
        self.say(f"{len(todo)} {what} to time")

        def work(detector):
            if time.time() < self.until:
                self.write(self.known, detectors.measure(detector, self.slot()))

        with ThreadPoolExecutor(self.jobs) as pool:
            list(pool.map(work, todo))
        for record in lines_of(self.known):
            if record["fails"]:
                self.say(f"left out, without mutants it fails or is skipped: {record['id']}: {record['fails'][-200:]}")

    def portion(self, open_ones: list, limit: float) -> list:
        """The quickest of them, at least one, that take no longer than the limit together."""
        found, spent = [], 0.0
        for detector in sorted(open_ones, key=lambda d: d.seconds):
            if found and spent + detector.seconds > limit:
                break
            found.append(detector)
            spent += detector.seconds
        return found

    def ask_all(self, detector: str, limit: float) -> None:
        """Asks one of both detectors, all of which is timed, of every mutant that it has not caught, a portion of it."""
        if self.is_over():
            return
        parts = [detectors.Detector.of(r) for r in lines_of(self.known) if not r["fails"]]
        parts = [part for part in parts if part.kind == detector]
        answers = Answers(lines_of(self.results))
        reaching = {m["number"]: [part for part in parts if m["number"] in part.reached] for m in self.mutants}

        def untried(number: int) -> list:
            return [part for part in reaching[number] if part.id not in answers.tried.get((number, detector), ())]

        def answer(number: int, given: str, how="", portion=(), seconds=0.0) -> None:
            result = {"number": number, "detector": detector, "answer": given, "how": how, "seconds": seconds}
            result["tried"] = [part.id for part in portion]
            self.write(self.results, result)
            answers.add(result)

        def work(number: int) -> None:
            if time.time() > self.until:
                return
            start = time.monotonic()
            left = untried(number)
            portion = self.portion(left, limit)
            how = self.try_portion(number, portion)
            given = CAUGHT if how else MISSED if len(portion) == len(left) else OPEN
            answer(number, given, how, portion, round(time.monotonic() - start, 1))

        for number, of_number in reaching.items():
            if not of_number and answers.of(number, detector) == OPEN:
                answer(number, UNREACHED)
        # New tests may catch mutants that the earlier ones missed.
        todo = [number for number in reaching if answers.of(number, detector) != CAUGHT and untried(number)]
        self.say(f"{detector}, portions of {limit} s: {len(todo)} mutants are not caught yet")
        with ThreadPoolExecutor(self.jobs) as pool:
            list(pool.map(work, todo))

    def try_portion(self, number: int, portion: list) -> str:
        """How some of a portion failed; nothing where all passed."""
        slot = self.slot()
        environment = {"CAGEPROOF_MUTANT": str(number), "TMPDIR": str(slot)}
        groups = {}
        for detector in portion:
            groups.setdefault("verify" if detector.is_unit else detector.binary or detector.id, []).append(detector)
        for name, group in sorted(groups.items(), key=lambda g: sum(d.seconds for d in g[1])):
            limit = self.grace + 5 * sum(d.seconds for d in group)
            if name == "verify":
                code, text = self.verification.try_units([d.place for d in group], slot, limit, environment)
            elif group[0].binary:
                tests = ":".join(d.filter for d in group)
                command = [group[0].binary, f"--gtest_filter={tests}", "--gtest_fail_fast"]
                code, text = detectors.run(command, group[0].folder, limit, environment)
            else:
                code, text = detectors.run(group[0].command, group[0].folder, limit, environment)
            if code not in (0, detectors.SKIPPED):
                return how(name, code, text)
        return ""


def how(name: str, code, text: str) -> str:
    """A line that says what failed."""
    if code is None:
        return f"{Path(name).name}: time limit"
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    failed = [line for line in lines if "FAILED" in line or "BROKEN" in line.upper()]
    ending = f"signal {-code}" if code < 0 else f"exit code {code}"
    return f"{Path(name).name}: {ending}: {(failed or lines or [''])[0][:200]}"
