#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""claims_test.py PROGRAMS PAGE: whether docs/claims.md names every numbered item of the papers, and its commands run.

Exit 0: yes; 1: no, each reason named. `claims_test.py --counts PAGE` prints the table of counts for the page's head."""

import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"

# The last equation, figure and so on of each paper. Each number from 1 to it stands in some row.
LAST = {
    "T24": {"Eq": 65, "Figure": 11},
    "W12": {"Eq": 22, "Figure": 11},
    "C23": {"Eq": 15, "Figure": 11},
    "T18": {"Eq": 29, "Figure": 18, "Table": 1, "Algorithm": 2, "Definition": 1},
}
LEMMAS = {"T18": ["3.1", "3.2", "3.3", "3.4"]}
OTHERS = ("Claim", "Section", "Appendix")
HEAD = ["item", "what it says", "command", "state", "the paper", "measured"]
STATE = re.compile(r"(works|partly: \S.*|missing: \S.*)")
# Seconds per command, in a build with sanitizers too.
LIMIT = 300


@dataclass
class Row:
    line: int
    paper: str
    item: str
    command: str
    state: str
    measured: str


def cells(line: str) -> list[str]:
    return [cell.strip().replace(r"\|", "|") for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]]


def read_rows(lines: list[str], wrong: list[str]) -> list[Row]:
    rows, paper, inside = [], "", False
    for number, line in enumerate(lines, 1):
        heading = re.match(r"## \[(\w+)\]", line)
        if heading:
            paper, inside = heading[1], False
        if not paper or not line.startswith("|"):
            continue
        found = cells(line)
        if found == HEAD or set(line) <= set("|-"):
            inside = True
        elif not inside or len(found) != len(HEAD):
            wrong.append(f"line {number}: a row has {len(HEAD)} cells ({', '.join(HEAD)}), not {len(found)}")
        else:
            rows.append(Row(number, paper, found[0], found[2].strip("`"), found[3], found[5]))
    return rows


def numbers(item: str) -> tuple[str, list[int]]:
    """What an item counts, as Eq, and its numbers: ("", []) for claims, sections and appendices."""
    word, _, rest = item.partition(" ")
    if word not in {word for last in LAST.values() for word in last}:
        return "", []
    found = []
    for part in rest.split(", "):
        ends = [int(end) for end in part.split("-")]
        found += range(ends[0], ends[-1] + 1)
    return word, found


def missing_items(rows: list[Row]) -> list[str]:
    wrong = []
    for paper, last in LAST.items():
        named = {(word, n) for row in rows if row.paper == paper for word, found in [numbers(row.item)] for n in found}
        wrong += [f"[{paper}] has no row for {word} {n}" for word, end in last.items() for n in range(1, end + 1) if (word, n) not in named]
        wrong += [f"[{paper}] has no {word} {n}" for word, n in sorted(named) if n > last.get(word, 0) or n < 1]
        lemmas = " ".join(row.item for row in rows if row.paper == paper and row.item.startswith("Lemma "))
        wrong += [f"[{paper}] has no row for Lemma {name}" for name in LEMMAS.get(paper, []) if name not in lemmas]
    return wrong


def counts(rows: list[Row]) -> list[str]:
    lines = []
    for paper, last in LAST.items():
        own = [row for row in rows if row.paper == paper]
        other = sum(last.get(word, 0) for word in ("Table", "Algorithm", "Definition")) + len(LEMMAS.get(paper, []))
        told = sum(row.item.startswith(OTHERS) for row in own)
        states = [sum(row.state.startswith(word) for row in own) for word in ("works", "partly", "missing")]
        lines.append("| " + " | ".join(map(str, [f"[{paper}]", last["Eq"], last["Figure"], other, told, len(own), *states])) + " |")
    return lines


def setup(lines: list[str]) -> str:
    start = lines.index("<!-- setup -->") + 2
    end = next(k for k in range(start, len(lines)) if not lines[k].startswith("    "))
    return "".join(line.strip() + "\n" for line in lines[start:end])


def same_figures(said: str, printed: str) -> bool:
    """Whether words agree, numbers to a tenth, and times, which the unit s follows, within a factor of ten: sanitizers take three times as long."""
    a, b = (re.split(r"[, ]+", text.strip()) for text in (said, printed))

    def alike(x: str, y: str, unit: str) -> bool:
        try:
            numbers = float(x), float(y)
        except ValueError:
            return x == y
        if unit == "s":
            return max(numbers) < 10 * min(numbers)
        return math.isclose(*numbers, rel_tol=0.1)

    return len(a) == len(b) and all(alike(x, y, unit) for x, y, unit in zip(a, b, [*a[1:], ""]))


def run_command(command: str, before: str, environment: dict[str, str]) -> subprocess.CompletedProcess:
    """Runs it in a folder of its own that holds the examples."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "examples"
        shutil.copytree(EXAMPLES, folder)
        script = f"set -euo pipefail\n{before}{command}\n"
        try:
            return subprocess.run(["bash", "-c", script], cwd=folder, env=environment, capture_output=True, text=True, errors="replace", timeout=LIMIT)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess([], -1, "", f"stopped after {LIMIT} s")


def run_commands(rows: list[Row], before: str, programs: str) -> list[str]:
    environment = dict(os.environ, PATH=f"{programs}:/usr/bin:{os.environ['PATH']}", LC_ALL="C.UTF-8")
    rows = [row for row in rows if not row.state.startswith("missing")]
    commands = list(dict.fromkeys(row.command for row in rows))
    with ThreadPoolExecutor(2) as pool:
        ended = dict(zip(commands, pool.map(lambda command: run_command(command, before, environment), commands)))
    wrong = []
    for row in rows:
        run = ended[row.command]
        if run.returncode:
            tail = "\n".join("    " + line for line in (run.stdout + run.stderr).splitlines()[-4:])
            wrong.append(f"line {row.line}: exit code {run.returncode}: {row.command}\n{tail}")
        elif "claims.py" in row.command and not same_figures(row.measured, run.stdout):
            wrong.append(f"line {row.line}: measured {run.stdout.strip()}; the page says {row.measured}")
    print(f"{len(rows)} rows with {len(commands)} commands")
    return wrong


def main() -> int:
    lines = Path(sys.argv[2]).read_text().splitlines()
    wrong: list[str] = []
    rows = read_rows(lines, wrong)
    if sys.argv[1] == "--counts":
        print("\n".join(counts(rows)))
        return 0
    for row in rows:
        if not STATE.fullmatch(row.state):
            wrong.append(f"line {row.line}: state '{row.state}' is none of works, partly: WHY, missing: WHY")
        if not row.command.startswith(("cageproof ", "python3 claims.py ", "echo ")):
            wrong.append(f"line {row.line}: no command: '{row.command}'")
        if not numbers(row.item)[0] and not row.item.startswith((*OTHERS, "Lemma")):
            wrong.append(f"line {row.line}: item '{row.item}' begins with no word that is counted")
    wrong += missing_items(rows)
    wrong += [f"the page's head must say: {line}" for line in counts(rows) if line not in lines]
    wrong += run_commands(rows, setup(lines), str(Path(sys.argv[1]).resolve()))
    for text in wrong:
        print(f"FAILED: {text}")
    return 1 if wrong else 0


sys.exit(main())
