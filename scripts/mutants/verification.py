# SPDX-License-Identifier: MIT
"""`cageproof verify` with its defaults, cut into its units of work, so that a mutant is tried on those alone that reach it.

A shard with one unit measures it alone: that tells its time and what it reaches. A mutant's units are measured by `verify --resume`, of a journal of the
run without mutants in which they are missing. Where a unit finds what it finds without the mutant, no verdict changes; otherwise `cageproof compare` judges
both runs as wholes, and names the verdicts that differ."""

import json
import shutil
from pathlib import Path

from mutants.detectors import Detector, run


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
        """A detector for each place in the order in which units of work are dealt out to shards."""
        count = self.count()
        return [
            Detector(f"place {p}", self.command(f"--shard={p}/{count}", self.alone(p)), str(self.folder), is_unit=True, place=p)
            for p in range(count)
        ]

    def read(self) -> None:
        """What all units found without mutants, by their places."""
        if self.lines:
            return
        for place in range(self.count()):
            head, line = (self.alone(place) / "journal").read_text().splitlines()[:2]
            self.lines[place] = line
            self.subjects[place] = subjects(line)
        self.head = json.loads(head)

    def write(self, path: Path, shard: int, shards: int, lines: list[str], units: int) -> None:
        head = {**self.head, "shard": shard, "shards": shards, "shard_units": units}
        path.write_text("\n".join([json.dumps(head), *lines]) + "\n")

    def check(self) -> None:
        """Judges the run without mutants."""
        self.read()
        whole = self.folder / "whole"
        self.write(whole, 0, 1, list(self.lines.values()), len(self.lines))
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
            kept = [self.lines[p] for p in own if p not in missing]
            self.write(out / "journal", shard, 2, kept, len(own))
            code, text = run([str(self.program), "verify", f"--resume={out}", "--jobs=1"], self.folder, limit, environment)
            if code == 2 and "cannot resume" in text:
                # What is to be measured is the mutant's too: all of it, then.
                code, text = run(self.command("--suite=quick", slot / "afresh"), self.folder, 3600, environment)
                # An hour without a verdict is none.
                return (0, "") if code is None else (code, text)
            if code != 0:
                return code, text
            measured = {unit_of(line): line for line in (out / "journal").read_text().splitlines()[1:] if line.startswith('{"units"')}
            for place in missing & set(own):
                found[place] = measured[unit_of(self.lines[place])]
        if all(findings(found[p]) == findings(self.lines[p]) for p in missing):
            return 0, ""
        # Verdicts hang together within a subject alone, and comparing all takes ten times as long.
        changed = set().union(*(subjects(found[p]) | subjects(self.lines[p]) for p in missing))
        places = [p for p in self.lines if self.subjects[p] & changed]
        before, after = slot / "before", slot / "after"
        self.write(before, 0, 1, [self.lines[p] for p in places], len(found))
        self.write(after, 0, 1, [found[p] for p in places], len(found))
        code, text = run([str(self.program), "compare", str(before), str(after)], self.folder, 300, {})
        broken = [line for line in text.splitlines() if "-> BROKEN" in line]
        if not broken and f"only in {after}: " in text:
            # Rows that are there with the mutant alone have no verdict to compare.
            self.write(after, 0, 1, list(found.values()), len(found))
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


def unit_of(line: str) -> int:
    return json.loads(line[: line.index("]]") + 2] + "}")["units"][0][0]


def subjects(line: str) -> set:
    """The formulas, or kinds of coordinates, that a unit's rows are about."""
    return {row["key"][1] for row in json.loads(line).get("rows", [])}


def findings(line: str) -> dict:
    found = json.loads(line)
    del found["seconds"]
    return found
