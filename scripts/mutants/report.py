# SPDX-License-Identifier: MIT
"""docs/power.md, from what a campaign found."""

import json
from collections import Counter
from pathlib import Path

from mutants.accounting import CAUGHT, OPEN, Answers, lines_of
from mutants.scope import JUDGES

HEAD = """# Which deliberate defects does the suite catch?

"""

HOW = """## How defects are made

A *mutant* is a copy of the project with one expression changed. Two *detectors* are asked of each mutant separately: `cageproof verify` with its defaults,
and `./test`. A seed draws 420 places in the code that computes results, and 100 in the code that judges and shows them. `scripts/mutants/scope.py` names the
files that are left out, and `scripts/mutants/operators.py` the kinds of changes.

<!-- not run: a night -->

    scripts/mutate                               # draws, builds and runs; --hours H stops it, --resume goes on
    scripts/mutate --only closed_form --sample 9 # nine mutants of one room, drawn evenly from its files
    scripts/mutate report                        # only writes this page, from the last campaign

The command works in `build/mutants` and never changes sources.

* `verify` **catches** a mutant when a promise breaks, when it ends with an error, or when it takes far longer than usual.
* Tests **catch** a mutant when a suite fails, crashes or takes that long, if only in a build with sanitizers.
* A mutant is **open**, and counts in no share, until both detectors have caught it or have run all parts that reach it.
* A mutant is **unreached** if no part of either detector runs the changed place.
* A mutant is **equivalent** if nothing caught it and it provably changes no promised result. At most a tenth may be.

Places that only the compiler evaluates do not count, and neither do mutants of code that was removed because of them.
"""

OUTCOMES = ["verify only", "tests only", "both", "neither", "unreached", "equivalent", "open"]
CAUGHT_BY_EITHER = ("verify only", "tests only", "both")
NOBODY = ("neither", "unreached")


def key_of(record: dict) -> tuple:
    return tuple(record[name] for name in ("file", "function", "source", "kind", "before", "after"))


def table(head: list, rows: list) -> str:
    lines = ["| " + " | ".join(head) + " |", "|---" + "|---:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def code(text: str) -> str:
    shown = text if len(text) <= 110 else text[:107] + " ..."
    return f"`{shown}`"


# Goals in percent, for rooms that compute results and for rooms that judge them: caught by verify, by tests, by either.
GOALS = (("that compute results", False, (90, 0, 97)), ("that judge and show them", True, (0, 95, 0)))


class Found:
    """Every mutant with its outcome."""

    def __init__(self, root: Path, folder: Path):
        proofs = root / "scripts/mutants/equivalent.json"
        entries = json.loads(proofs.read_text()) if proofs.exists() else []
        proven = {key_of(e) for e in entries}
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
            if nobody and mutant["outcome"] != "constant" and key_of(mutant) in proven:
                mutant["outcome"] = "gone" if key_of(mutant) in gone else "equivalent"
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
        """For rooms that compute and rooms that judge: name, mutants asked, mutants caught by verify, tests and either, goals in percent."""
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
        """How many mutants each detector caught, with the goals."""
        rows = []
        for name, asked, by, goals in self.caught():
            cells = [f"{n}" + (f", {100 * n / asked:.1f} %" if asked else "") + (f" (goal {g} %)" if g else "") for n, g in zip(by, goals)]
            rows.append([name, asked, *cells])
        return table(["rooms", "asked of both", "caught by verify", "caught by tests", "caught by either"], rows)


def room_of(mutant: dict) -> str:
    return mutant["file"].split("/")[0]


def summary(found: Found) -> str:
    """The answer in words, and which mutants it counts."""
    still_open = len(found.of("open"))
    asked = len(found.mutants) - still_open - len(found.of("equivalent"))
    if not asked:
        return "No mutant has been asked of both detectors to the end yet: there is no figure of what `verify` catches by itself.\n"
    by_verify, by_either = (sum(len(found.of(outcome)) for outcome in outcomes) for outcomes in (("verify only", "both"), CAUGHT_BY_EITHER))
    text = f"`cageproof verify` catches {by_verify} of {asked} deliberate defects by itself. `verify` and the tests together catch {by_either}.\n\n"
    text += f"{len(found.mutants)} mutants are drawn. {asked} were asked of both detectors to the end and are not equivalent; shares count only these."
    if still_open:
        text += f" {still_open} are open, {found.half_asked} of them with an answer from one detector."
    sanitized = sum(m["how"].startswith("sanitized ") for m in found.mutants)
    if sanitized:
        text += f" {sanitized} of those that tests caught needed a sanitized build."
    return text + "\n"


def write(root: Path, folder: Path) -> list:
    """Writes docs/power.md. Returns the goals that are missed."""
    found = Found(root, folder)
    parts = [HEAD + summary(found)]
    if found.mutants:
        parts.append(found.shares())
        parts.append(found.counted("room", room_of))
    left_out = [record["id"] for record in lines_of(folder / "detectors.jsonl") if record["fails"]]
    if left_out:
        names = ", ".join(f"`{name}`" for name in sorted(left_out))
        parts.append(f"These tests are left out, because they fail or are skipped without mutants: {names}.\n")
    if found.of("equivalent"):
        parts.append("`scripts/mutants/equivalent.json` has the proof of each equivalent mutant, and the mutants of code that was removed.\n")

    def listed(title: str, mutants: list) -> None:
        if not mutants:
            return
        lines = [f"* `{m['file']}:{m['line']}` {m['function']}: {m['kind']}: {code(m['before'])} -> {code(m['after'])}" for m in mutants]
        parts.append(f"## {title}\n\n" + "\n".join(lines) + "\n")

    listed("Caught by nothing", found.of("neither"))
    listed("Caught only by tests, in rooms that compute results", [m for m in found.of("tests only") if room_of(m) not in JUDGES])
    listed("Unreached", found.of("unreached"))
    parts.append(HOW)
    earlier = root / "scripts/mutants/tests_first.md"
    if earlier.exists():
        parts.append(earlier.read_text())
    (root / "docs/power.md").write_text("\n".join(parts))
    return found.missed()
