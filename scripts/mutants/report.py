# SPDX-License-Identifier: MIT
"""docs/power.md, from what a campaign found."""

import json
from collections import Counter
from pathlib import Path

from mutants.accounting import CAUGHT, OPEN, Answers, lines_of
from mutants.scope import JUDGES

HEAD = """# What the suite catches: mutants

A suite that catches no defects looks like one that finds none. So defects are made: *mutants*, one change of one expression each, and both detectors are
asked of every mutant: `cageproof verify` with its defaults, and `./test`. This page is written by

<!-- not run: a night -->

    scripts/mutate                               # hours: draws, builds, runs; --hours stops it, --resume goes on with what was stopped
    scripts/mutate --only closed_form --sample 9 # a few mutants of one room, drawn evenly from its files
    scripts/mutate report                        # this page alone, from the last campaign

`scripts/mutate` copies the project to `build/mutants`; sources are never changed. Sites are drawn by a seed, the same number from each file that has
enough of them: by default 420 in `closed_form`, `adaptive_qmvc`, `quadrature_ref`, and in `core` what results are computed with, and 100 in `validation`,
`reports`, `cli`, `deformation` and `solved` (`scripts/mutants/scope.py` says what is left out, and why). The kind of a change is drawn from all that are
possible at the site (`scripts/mutants/operators.py`). One build carries all mutants; the environment variable `CAGEPROOF_MUTANT` turns one on.

`verify` catches a mutant when it breaks a promise, ends with an error, or takes more than five times its time and 20 s; tests do when a suite fails, crashes
or takes that long. A suite that is skipped catches nothing. Each detector is asked by itself, and whatever the other said: only what of it reaches the site
is run, the quickest first, until something fails. The units of work of `verify`, dealt out in shards, are measured a shard at a time, and judged together with those of the run
without mutants: the verdict is that of a whole run in which only these units are the mutant's.

A mutant is *open*, and counts in no share, until both detectors either caught it or ran all that reaches it. *Unreached* means that nothing of either
detector reaches it.

A mutant that reads or writes beyond an array's end may have no effect in a release build. CI runs tests with sanitizers as well: such a mutant counts as
caught by tests where a test of the campaign's copy fails with it when the test and the files that the mutant is in are built with these; how many are such
is said below. Tests that are written for mutants that nothing caught are put into the copy (`build/mutants/src`) and built there; `--resume` tries them as
any others.

A mutant that nothing caught is called equivalent when it changes no promised result, with a line of proof each (`scripts/mutants/equivalent.json`); at most
a tenth may be. Where what was mutated has been removed since, because the mutant showed that nothing needs it or that it was wrong, the same file says so,
and the mutant counts nowhere. Neither do sites that only the compiler evaluates ("constant"). Every other mutant is taken to change a promised result.

The goals: 90 % caught by `verify` alone, that is, without help of tests, and 97 % by either, in the rooms that compute results; 95 % by tests in
those that judge and show them (`validation`, `reports`, `cli`).
"""

OUTCOMES = ["verify only", "tests only", "both", "neither", "unreached", "equivalent", "open"]
NOBODY = ("neither", "unreached")


def key_of(record: dict) -> tuple:
    return tuple(record[name] for name in ("file", "function", "source", "kind", "before", "after"))


def table(head: list, rows: list) -> str:
    lines = ["| " + " | ".join(head) + " |", "|---" + "|---:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def code(text: str) -> str:
    shown = text if len(text) <= 110 else text[:107] + " ..."
    return f"`{shown}`"


# Goals in percent for rooms that compute results and for rooms that judge them: caught by verify alone, by tests, by either.
GOALS = (("that compute results", False, (90, 0, 97)), ("that judge and show them", True, (0, 95, 0)))


class Found:
    """Every mutant with its outcome."""

    def __init__(self, root: Path, folder: Path):
        proofs = root / "scripts/mutants/equivalent.json"
        entries = json.loads(proofs.read_text()) if proofs.exists() else []
        self.proofs = {key_of(e): e["why"] for e in entries}
        gone = {key_of(e) for e in entries if e.get("gone")}
        self.mutants = lines_of(folder / "mutants.jsonl")
        answers = Answers(lines_of(folder / "results.jsonl"))
        for mutant in self.mutants:
            number = mutant["number"]
            mutant["outcome"] = answers.outcome(number)
            mutant["how"] = answers.how.get((number, "tests"), "")
            if mutant["outcome"] == "unreached" and mutant["may_be_constant"]:
                mutant["outcome"] = "constant"
            nobody = CAUGHT not in (answers.of(number, "verify"), answers.of(number, "tests"))
            if nobody and mutant["outcome"] != "constant" and key_of(mutant) in self.proofs:
                mutant["outcome"] = "gone" if key_of(mutant) in gone else "equivalent"
        self.gone = self.of("gone")
        self.mutants = [m for m in self.mutants if m["outcome"] not in ("constant", "gone")]
        self.half_asked = sum(
            m["outcome"] == "open" and any(answers.of(m["number"], d) != OPEN for d in ("verify", "tests")) for m in self.mutants
        )

    def of(self, outcome: str) -> list:
        return [m for m in self.mutants if m["outcome"] == outcome]

    def counted(self, head: str, group) -> str:
        counts = Counter((group(m), m["outcome"]) for m in self.mutants)
        rows = []
        for name in sorted({group(m) for m in self.mutants}):
            row = [counts[name, outcome] for outcome in OUTCOMES]
            rows.append([name, sum(row), *row])
        rows.append(["all", *(sum(row[i] for row in rows) for i in range(1, len(OUTCOMES) + 2))])
        return table([head, "mutants", *OUTCOMES], rows)

    def caught(self) -> list:
        """Of the rooms that compute and of those that judge: name, how many were asked, how many verify, tests and either caught, and goals in percent."""
        found = []
        for name, judges, goals in GOALS:
            asked = [m for m in self.mutants if (room_of(m) in JUDGES) == judges and m["outcome"] not in ("equivalent", "open")]
            caught = Counter(m["outcome"] for m in asked)
            by = [caught["verify only"] + caught["both"], caught["tests only"] + caught["both"], sum(m["outcome"] not in NOBODY for m in asked)]
            found.append((name, len(asked), by, goals))
        return found

    def missed(self) -> list:
        """The goals that are not reached, in words."""
        return [
            f"in the rooms {name} {detector} caught {n} of {asked}, {100 * n / asked:.1f} %; the goal is {goal} %"
            for name, asked, by, goals in self.caught()
            for detector, n, goal in zip(("verify", "tests", "either"), by, goals)
            if goal and asked and 100 * n < goal * asked
        ]

    def shares(self) -> str:
        """How many each detector caught, beside the goals."""
        rows = []
        for name, asked, by, goals in self.caught():
            cells = [f"{n}" + (f", {100 * n / asked:.1f} %" if asked else "") + (f" (goal {g} %)" if g else "") for n, g in zip(by, goals)]
            rows.append([name, asked, *cells])
        return table(["rooms", "asked of both", "caught by verify", "caught by tests", "caught by either"], rows)


def room_of(mutant: dict) -> str:
    return mutant["file"].split("/")[0]


def summary(found: Found) -> str:
    """What was asked, in words."""
    still_open = len(found.of("open"))
    asked = len(found.mutants) - still_open - len(found.of("equivalent"))
    if not asked:
        return "No mutant has been asked of both detectors to the end yet: there is no figure of what `verify` catches by itself.\n"
    text = f"{len(found.mutants)} mutants are drawn. {asked} were asked of both detectors to the end and are not called equivalent: all shares are of these."
    if still_open:
        text += f" {still_open} are open, {found.half_asked} of them with an answer of one detector, and count in no share."
    sanitized = sum(m["how"].startswith("sanitized ") for m in found.mutants)
    if sanitized:
        text += f" {sanitized} of those that tests caught were so in a sanitized build."
    return text + "\n"


def write(root: Path, folder: Path) -> list:
    """Writes docs/power.md. Returns the goals that are missed."""
    found = Found(root, folder)
    parts = [HEAD, "## Figures\n", summary(found)]
    if found.mutants:
        parts.append(found.shares())
        parts.append(found.counted("room", room_of))
        parts.append(found.counted("kind", lambda m: "arguments exchanged" if "arguments" in m["kind"] else m["kind"]))
    left_out = [record["id"] for record in lines_of(folder / "detectors.jsonl") if record["fails"]]
    if left_out:
        parts.append(f"Left out, since they fail or are skipped without mutants: {', '.join(f'`{name}`' for name in sorted(left_out))}.\n")

    def listed(title: str, mutants: list, extra) -> None:
        if not mutants:
            return
        lines = [
            f"* `{m['file']}:{m['line']}` {m['function']}: {m['kind']}: {code(m['before'])} -> {code(m['after'])}{extra(m)}"
            for m in mutants
        ]
        parts.append(f"## {title}\n\n" + "\n".join(lines) + "\n")

    listed("Survivors", found.of("neither"), lambda m: "")
    blind = [m for m in found.of("tests only") if room_of(m) not in JUDGES]
    listed("Caught by tests only, in rooms that compute results: `verify` lacks a question", blind, lambda m: "")
    listed("Reached by nothing", found.of("unreached"), lambda m: "")
    listed("Called equivalent", found.of("equivalent"), lambda m: f". {found.proofs[key_of(m)]}")
    listed("Of what is gone since", found.gone, lambda m: f". {found.proofs[key_of(m)]}")
    earlier = root / "scripts/mutants/tests_first.md"
    if earlier.exists():
        parts.append(earlier.read_text())
    (root / "docs/power.md").write_text("\n".join(parts))
    return found.missed()
