# SPDX-License-Identifier: MIT
"""`cageproof verify` with its defaults, cut into shards of its units of work, so that a mutant is tried only on those that reach it.

A shard measured without mutants tells its time and what it reaches. A mutant's shards are measured by `verify --resume`, of a journal of the run without
mutants in which their units are missing. Where they find what they find without the mutant, no verdict changes; otherwise `cageproof compare` judges
both runs as wholes, and names the verdicts that differ."""

import json
import shutil
from pathlib import Path

from mutants.detectors import Detector, run


# As many as make each a matter of seconds; even, so that shards and the halves that are resumed deal units out alike.
SHARDS = 96


class Verification:
    def __init__(self, program: Path, folder: Path):
        self.program, self.folder = program, folder
        folder.mkdir(parents=True, exist_ok=True)
        self.lines, self.subjects, self.head = {}, {}, {}

    def command(self, option: str, out) -> list[str]:
        return [str(self.program), "verify", option, "--jobs=1", f"--out={out}"]

    def count(self) -> int:
        """How many units there are."""
        out = self.folder / "count"
        if not out.exists():
            code, text = run(self.command("--shard=999999/1000000", out), self.folder, None, {})
            if code:
                raise SystemExit(f"cageproof verify fails without mutants:\n{text}")
        return json.loads((out / "journal").read_text().splitlines()[0])["units"]

    def alone(self, place: int) -> Path:
        return self.folder / f"alone-{place}"

    def units(self) -> list[Detector]:
        """A detector for each shard, whose place is its number."""
        shards = min(SHARDS, self.count() // 2 * 2)
        return [
            Detector(f"shard {p}/{shards}", self.command(f"--shard={p}/{shards}", self.alone(p)), str(self.folder), is_unit=True, place=p)
            for p in range(shards)
        ]

    def read(self) -> None:
        """What all units found without mutants, by the places of their shards."""
        if self.lines:
            return
        for detector in self.units():
            head, *lines = (self.alone(detector.place) / "journal").read_text().splitlines()
            self.lines[detector.place] = [line for line in lines if is_of_unit(line)]
            self.subjects[detector.place] = subjects(self.lines[detector.place])
        self.head = json.loads(head)

    def write(self, path: Path, shard: int, shards: int, lines: list[str], units: int) -> None:
        head = {**self.head, "shard": shard, "shards": shards, "shard_units": units}
        path.write_text("\n".join([json.dumps(head), *lines]) + "\n")

    def check(self) -> None:
        """Judges the run without mutants."""
        self.read()
        whole = self.folder / "whole"
        self.write(whole, 0, 1, together(self.lines.values()), self.count())
        code, text = self.judge(whole, self.folder / "report")
        if code:
            raise SystemExit(f"verify breaks a promise without mutants:\n{text}")

    def try_units(self, places: list[int], slot: Path, limit: float, environment: dict):
        """(exit code, output) of the whole run in which these units are measured with the environment's mutant; 0 where no promise breaks."""
        self.read()
        found, missing = dict(self.lines), set(places)
        for shard in (0, 1):
            own = [p for p in self.lines if p % 2 == shard]
            if not missing & set(own):
                continue
            out = slot / "run"
            shutil.rmtree(out, ignore_errors=True)
            out.mkdir()
            kept = together(self.lines[p] for p in own if p not in missing)
            self.write(out / "journal", shard, 2, kept, sum(len(self.lines[p]) for p in own))
            code, text = run([str(self.program), "verify", f"--resume={out}", "--jobs=1"], self.folder, limit, environment)
            if code == 2 and "cannot resume" in text:
                # The mutant changes which work is planned, so the whole suite is run.
                code, text = run(self.command("--suite=quick", slot / "afresh"), self.folder, 3600, environment)
                # An hour without a verdict is none.
                return (0, "") if code is None else (code, text)
            if code != 0:
                return code, text
            measured = {unit_of(line): line for line in (out / "journal").read_text().splitlines() if is_of_unit(line)}
            for place in missing & set(own):
                found[place] = [measured[unit_of(line)] for line in self.lines[place]]
        differing = [(new, old) for p in missing for new, old in zip(found[p], self.lines[p]) if findings(new) != findings(old)]
        if not differing:
            return 0, ""
        # Verdicts depend only on rows of the same subject, and comparing all takes ten times as long.
        changed = subjects(together(differing))
        places = [p for p in self.lines if self.subjects[p] & changed]
        before, after = slot / "before", slot / "after"
        self.write(before, 0, 1, together(self.lines[p] for p in places), self.count())
        self.write(after, 0, 1, together(found[p] for p in places), self.count())
        code, text = run([str(self.program), "compare", str(before), str(after)], self.folder, 300, {})
        broken = [line for line in text.splitlines() if "-> BROKEN" in line]
        if not broken and f"only in {after}: " in text:
            # Rows that only the mutant has cannot be compared with a verdict.
            self.write(after, 0, 1, together(found.values()), self.count())
            return self.judge(after, slot / "report")
        if code not in (0, 1):
            return code, text
        return (1, "\n".join(f"BROKEN {line}" for line in broken)) if broken else (0, "")

    def judge(self, journal: Path, out: Path):
        """(exit code, output) of the report that a whole run's journal makes."""
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir()
        shutil.copy(journal, out / "journal")
        return run([str(self.program), "report", str(out)], self.folder, 600, {})


def together(lists) -> list:
    return [x for one in lists for x in one]


def is_of_unit(line: str) -> bool:
    return line.startswith('{"units":[[')


def unit_of(line: str) -> int:
    return json.loads(line[: line.index("]]") + 2] + "}")["units"][0][0]


def subjects(lines: list) -> set:
    """The formulas, or kinds of coordinates, that units' rows are about."""
    return {row["key"][1] for line in lines for row in json.loads(line).get("rows", [])}


def findings(line: str) -> dict:
    found = json.loads(line)
    del found["seconds"]
    return found
