# SPDX-License-Identifier: MIT
"""Runs every mutant against what reaches it, the quickest first, until something fails."""

import json
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mutants import detectors, verification

# Detectors run in portions of at most so many seconds (without a mutant): all mutants' cheap ones come before any one's dear ones.
# Before the units of work are timed, which takes longest, the tests catch what they catch in one that is short.
EARLY, PORTIONS = [2], [20, 100, 10**9]


def lines_of(path: Path) -> list:
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


class Campaign:
    def __init__(self, folder: Path, build: Path, jobs: int, until: float, say):
        """\\param until the time at which nothing more is begun"""
        self.folder, self.build, self.jobs, self.until, self.say = folder, build, jobs, until, say
        self.mutants = lines_of(folder / "mutants.jsonl")
        self.verification = verification.Verification(build / "bin/cageproof", folder / "verify")
        self.lock = threading.Lock()
        self.results, self.known = folder / "results.jsonl", folder / "detectors.jsonl"

    def run(self) -> None:
        self.time_detectors(detectors.tests(self.build), "tests")
        self.try_all(EARLY, whole=False)
        units = self.verification.units()
        self.time_detectors(units, "units of work")
        if self.is_over():
            return
        if not (self.folder / "verify/whole").exists():
            self.verification.check()
        self.verification.read()
        self.try_all(PORTIONS, whole=True)

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
                self.say(f"left out, it fails without mutants: {record['id']}: {record['fails'][-200:]}")

    def portion(self, open_ones: list, limit: float) -> list:
        """The quickest of them, at least one, that take no longer than the limit together."""
        found, spent = [], 0.0
        for detector in sorted(open_ones, key=lambda d: d.seconds):
            if found and spent + detector.seconds > limit:
                break
            found.append(detector)
            spent += detector.seconds
        return found

    def try_all(self, limits: list, whole: bool) -> None:
        """Rounds of ever larger portions. \\param whole whether all detectors are known, not the tests alone, so that what none reaches is unreached"""
        known = [detectors.Detector.of(r) for r in lines_of(self.known) if not r["fails"] and (whole or not r["is_unit"])]
        tried, outcomes = {m["number"]: set() for m in self.mutants}, {}
        for result in lines_of(self.results):
            tried[result["number"]] |= set(result["tried"])
            outcomes[result["number"]] = result["outcome"]
        reaching = {m["number"]: [d for d in known if m["number"] in d.reached] for m in self.mutants}
        left = {number for number, of_number in reaching.items() if any(d.id not in tried[number] for d in of_number)}
        # Tests that are new may catch what survived those that there were.
        finished = {
            number
            for number, outcome in outcomes.items()
            if outcome.startswith("caught") or outcome == "constant" or (outcome != "open" and number not in left)
        }
        if whole and not self.is_over():
            for mutant in self.mutants:
                number = mutant["number"]
                if number in finished or number in left:
                    continue
                never = "constant" if mutant["may_be_constant"] else "unreached"
                outcome = "survived" if reaching[number] else never
                self.write(self.results, {"number": number, "outcome": outcome, "how": "", "tried": []})
                finished.add(number)

        def work(number, limit):
            if time.time() > self.until:
                return
            portion = self.portion([d for d in reaching[number] if d.id not in tried[number]], limit)
            if not whole and sum(d.seconds for d in portion) > limit:
                return
            start = time.monotonic()
            caught = self.try_portion(number, portion)
            tried[number] |= {d.id for d in portion}
            outcome = f"caught by {caught[0]}" if caught else "open"
            if not caught and whole and len(tried[number] & {d.id for d in reaching[number]}) == len(reaching[number]):
                outcome = "survived"
            result = {"number": number, "outcome": outcome, "how": caught[1] if caught else ""}
            result |= {"seconds": round(time.monotonic() - start, 1), "tried": [d.id for d in portion]}
            self.write(self.results, result)
            if outcome != "open":
                finished.add(number)

        for limit in limits:
            todo = [
                number
                for number, of_number in reaching.items()
                if number not in finished and any(d.id not in tried[number] for d in of_number)
            ]
            self.say(f"portions of {limit} s: {len(todo)} mutants are not caught yet")
            with ThreadPoolExecutor(self.jobs) as pool:
                list(pool.map(lambda number: work(number, limit), todo))
            if self.is_over():
                return

    def try_portion(self, number: int, portion: list):
        """(what failed, how) or nothing."""
        slot = self.slot()
        environment = {"CAGEPROOF_MUTANT": str(number), "TMPDIR": str(slot)}
        groups = {}
        for detector in portion:
            groups.setdefault("verify" if detector.is_unit else detector.binary or detector.id, []).append(detector)
        # Units of work last: planning and judging costs a second more.
        for name, group in sorted(groups.items(), key=lambda g: (g[0] == "verify", sum(d.seconds for d in g[1]))):
            limit = 20 + 5 * sum(d.seconds for d in group)
            if name == "verify":
                code, text = self.verification.try_units([d.place for d in group], slot, limit, environment)
            elif group[0].binary:
                tests = ":".join(d.filter for d in group)
                command = [group[0].binary, f"--gtest_filter={tests}", "--gtest_fail_fast"]
                code, text = detectors.run(command, group[0].folder, limit, environment)
            else:
                code, text = detectors.run(group[0].command, group[0].folder, limit, environment)
            if code != 0:
                return ("verify" if name == "verify" else "tests"), how(name, code, text)
        return None


def how(name: str, code, text: str) -> str:
    """A line that says what failed."""
    if code is None:
        return f"{Path(name).name}: time limit"
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    failed = [line for line in lines if "FAILED" in line or "BROKEN" in line.upper()]
    ending = f"signal {-code}" if code < 0 else f"exit code {code}"
    return f"{Path(name).name}: {ending}: {(failed or lines or [''])[0][:200]}"
