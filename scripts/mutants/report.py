# SPDX-License-Identifier: MIT
"""docs/power.md, from what a campaign found."""

import json
from collections import Counter
from pathlib import Path

HEAD = """# What the suite catches: mutants

A suite that catches no defects looks like one that finds none. So defects are made: *mutants*, one change of one expression each, and the suite is asked
which it catches. This page is written by

<!-- not run: a night -->

    scripts/mutate                  # hours: draws, builds, runs; --resume goes on with what was stopped
    scripts/mutate report           # this page alone, from the last campaign

`scripts/mutate` copies the project to `build/mutants`; sources are never changed. Sites are drawn by a seed, the same number from each file that has
enough of them: all of `closed_form`, `adaptive_qmvc` and `quadrature_ref`, and of `core` what results are computed with (`scripts/mutants/scope.py` says
what is left out, and why). What is done to a site is drawn from all that is possible there (`scripts/mutants/operators.py`). One build carries all
mutants; the environment variable `CAGEPROOF_MUTANT` turns one on.

A mutant is caught when `cageproof verify` with its defaults breaks a promise, or when a test of `./test` fails, crashes or takes five times its time and
20 s more. Only detectors that reach the site are run, the quickest first, so that "caught by tests" says that a test was quicker, not that `verify` is
blind there. The units of work of `verify` are measured a few at a time, and judged together with those of the run without mutants: the verdict is that of
a whole run in which these units alone are the mutant's.

What a mutant reads or writes beyond an array's end may have no effect in a release build. CI runs `./test` with the address and undefined-behaviour
sanitizers and with Eigen's assertions as well: such a mutant counts as caught by tests where a test of the campaign's copy fails with it when the test and
the files that the mutant is in are built with these; how many are such is said below. Tests that are written for survivors are put into the copy
(`build/mutants/src`) and built there; `--resume` tries them as any others.

A mutant is called equivalent when it changes no promised result, with a line of proof each (`scripts/mutants/equivalent.json`); at most a tenth may be.
Where what was mutated has been removed since, because the mutant showed that nothing needs it or that it was wrong, the same file says so, and the
mutant counts nowhere. Nor do sites that the compiler alone evaluates ("constant").
"""


def lines_of(path: Path) -> list:
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


def key_of(record: dict) -> tuple:
    return tuple(record[name] for name in ("file", "function", "source", "kind", "before", "after"))


def table(head: list, rows: list) -> str:
    lines = ["| " + " | ".join(head) + " |", "|---" + "|---:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def code(text: str) -> str:
    shown = text if len(text) <= 110 else text[:107] + " ..."
    return f"`{shown}`"


class Found:
    """Every mutant with its outcome."""

    def __init__(self, root: Path, folder: Path):
        proofs = root / "scripts/mutants/equivalent.json"
        entries = json.loads(proofs.read_text()) if proofs.exists() else []
        self.proofs = {key_of(e): e["why"] for e in entries}
        gone = {key_of(e) for e in entries if e.get("gone")}
        self.mutants = lines_of(folder / "mutants.jsonl")
        outcome = {}
        for result in lines_of(folder / "results.jsonl"):
            outcome[result["number"]] = result
        for mutant in self.mutants:
            result = outcome.get(mutant["number"], {"outcome": "open", "how": ""})
            mutant["outcome"], mutant["how"] = result["outcome"], result["how"]
            if mutant["outcome"] in ("survived", "unreached", "open") and key_of(mutant) in self.proofs:
                mutant["outcome"] = "gone" if key_of(mutant) in gone else "equivalent"
        self.gone = self.of("gone")
        self.mutants = [m for m in self.mutants if m["outcome"] not in ("constant", "gone")]

    def of(self, outcome: str) -> list:
        return [m for m in self.mutants if m["outcome"] == outcome]

    def counted(self, head: str, group) -> str:
        names = ["caught by verify", "caught by tests", "survived", "unreached", "equivalent", "open"]
        counts = Counter((group(m), m["outcome"]) for m in self.mutants)
        rows = []
        for name in sorted({group(m) for m in self.mutants}):
            row = [counts[name, outcome] for outcome in names]
            rows.append([name, sum(row), *row])
        rows.append(["all", *(sum(row[i] for row in rows) for i in range(1, len(names) + 2))])
        return table([head, "mutants", *names], rows)


def write(root: Path, folder: Path) -> None:
    found = Found(root, folder)
    caught = len(found.of("caught by verify")) + len(found.of("caught by tests"))
    judged = len(found.mutants) - len(found.of("equivalent")) - len(found.of("open"))
    sanitized = sum(m["how"].startswith("sanitized ") for m in found.mutants)
    parts = [HEAD, "## Figures\n"]
    parts.append(
        f"{len(found.mutants)} mutants; of {judged} that were run to the end and are not called equivalent **{caught} are caught, "
        f"{100 * caught / max(judged, 1):.1f} %**."
        + (f" {len(found.of('open'))} are caught by nothing that was run so far, and wait for the rest." if found.of("open") else "")
        + (f" {sanitized} of those that are caught were so in a sanitized build." if sanitized else "")
        + "\n"
    )
    parts.append(found.counted("room", lambda m: m["file"].split("/")[0]))
    parts.append(found.counted("kind", lambda m: "arguments exchanged" if "arguments" in m["kind"] else m["kind"]))

    def listed(title: str, mutants: list, extra) -> None:
        if not mutants:
            return
        lines = [
            f"* `{m['file']}:{m['line']}` {m['function']}: {m['kind']}: {code(m['before'])} -> {code(m['after'])}{extra(m)}"
            for m in mutants
        ]
        parts.append(f"## {title}\n\n" + "\n".join(lines) + "\n")

    listed("Survivors", found.of("survived"), lambda m: "")
    listed("Reached by nothing", found.of("unreached"), lambda m: "")
    listed("Not run to the end", found.of("open"), lambda m: "")
    listed("Called equivalent", found.of("equivalent"), lambda m: f". {found.proofs[key_of(m)]}")
    listed("Of what is gone since", found.gone, lambda m: f". {found.proofs[key_of(m)]}")
    (root / "docs/power.md").write_text("\n".join(parts))
