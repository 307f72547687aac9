#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The accounting of scripts/mutate, on a stand-in project: a program and tests of a few lines that fail as a mutant's number says."""

import json
import os
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from mutants import campaign, report, sites, verification  # noqa: E402
from mutants.accounting import Answers, chosen, lines_of  # noqa: E402

# Mutants by their expected verdict.
VERIFY, TESTS, BOTH, NEITHER, NOWHERE, HANGS, HANGS_IN_VERIFY, SKIPS, BY_ALL_UNITS = range(1, 10)
OUTCOMES = {
    VERIFY: "verify only",
    TESTS: "tests only",
    BOTH: "both",
    NEITHER: "neither",
    NOWHERE: "unreached",
    HANGS: "tests only",
    HANGS_IN_VERIFY: "verify only",
    SKIPS: "neither",
    BY_ALL_UNITS: "verify only",
}

COMMON = f"""#!{sys.executable}
import json, os, sys, time
VERIFY, TESTS, BOTH, NEITHER, NOWHERE, HANGS, HANGS_IN_VERIFY, SKIPS, BY_ALL_UNITS = range(1, 10)
mutant = int(os.environ.get("CAGEPROOF_MUTANT", 0))
def reach(*numbers):
    if "CAGEPROOF_MUTANT_TRACE" in os.environ:
        with open(os.environ["CAGEPROOF_MUTANT_TRACE"], "a") as file: print(*numbers, file=file)
"""

# Four units of work, of two subjects; a unit's finding is the number that breaks a promise, or 0.
PROGRAM = COMMON + """
UNITS = 4
def measured(unit):
    reach(*([VERIFY, TESTS, BOTH, NEITHER, HANGS, HANGS_IN_VERIFY, SKIPS, BY_ALL_UNITS] if unit == 3 else [BOTH, BY_ALL_UNITS]))
    if mutant == HANGS_IN_VERIFY and unit == 3: time.sleep(60)
    breaks = unit == 3 and mutant in (VERIFY, BOTH, BY_ALL_UNITS)
    row = {"key": ["formulas", f"subject {unit % 2}"], "broken": breaks}
    return '{"units":[[' + str(unit) + ',1]],' + json.dumps({"seconds": 0, "rows": [row]})[1:]
def rows(path):
    return [row for line in open(path).read().splitlines()[1:] for row in json.loads(line)["rows"]]
command, options = sys.argv[1], sys.argv[2:]
if command == "verify":
    given = dict(o.lstrip("-").split("=") for o in options)
    if "resume" in given:
        journal = given["resume"] + "/journal"
        lines = open(journal).read().splitlines()
        there = [json.loads(line)["units"][0][0] for line in lines[1:]]
        own = [u for u in range(UNITS) if u % 2 == json.loads(lines[0])["shard"] and u not in there]
        with open(journal, "a") as file: file.writelines(measured(u) + chr(10) for u in own)
    else:
        shard, shards = map(int, given["shard"].split("/"))
        os.makedirs(given["out"], exist_ok=True)
        own = [u for u in range(UNITS) if u % shards == shard]
        open(given["out"] + "/journal", "w").write(chr(10).join([json.dumps({"units": UNITS}), *map(measured, own)]) + chr(10))
elif command == "compare":
    broken = [row for row in rows(options[1]) if row["broken"]]
    for row in broken: print(row["key"], "kept -> BROKEN")
    sys.exit(1 if broken else 0)
elif command == "report":
    sys.exit(1 if any(row["broken"] for row in rows(options[0] + "/journal")) else 0)
"""

SUITES = COMMON + """
asked = sys.argv[1].removeprefix("--gtest_filter=").split(":")
if asked == ["Skipped.*"]: sys.exit(77)
if "Checked.*" in asked:
    reach(VERIFY, TESTS, BOTH, NEITHER, HANGS_IN_VERIFY, SKIPS, BY_ALL_UNITS)
    if mutant in (TESTS, BOTH):
        print("[  FAILED  ] Checked.one")
        sys.exit(1)
"""

SCRIPT = COMMON + """
reach(HANGS, SKIPS)
if mutant == HANGS: time.sleep(60)
if mutant == SKIPS: sys.exit(77)
"""

# It fails whether or not a mutant is on, so that it says nothing of one.
BROKEN = COMMON + "reach(NEITHER)\nsys.exit(1)\n"


class Quick(campaign.Campaign):
    grace = 1


def stand_in(folder: Path) -> None:
    """Writes a build with the stand-ins, and the mutants' records."""
    build = folder / "build"
    for name, text in {"bin/cageproof": PROGRAM, "bin/suites": SUITES, "script": SCRIPT, "broken": BROKEN}.items():
        path = build / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)
    tests = [f'add_test(suites.{s} "{build}/bin/suites" "--gtest_filter={s}.*")' for s in ("Checked", "Skipped")]
    tests += [f'add_test({name} "{build}/{name}")' for name in ("script", "broken")]
    (build / "CTestTestfile.cmake").write_text("\n".join(tests) + "\n")
    rooms = ["closed_form", "closed_form", "closed_form", "core", "core", "validation", "validation", "reports", "solved"]
    with (folder / "mutants.jsonl").open("w") as file:
        for number, room in zip(OUTCOMES, rooms):
            names = {"file": f"{room}/src/a.cpp", "function": f"f{number}", "source": "a + b", "kind": "sign", "before": "a", "after": "b"}
            file.write(json.dumps({"number": number, "line": number, "may_be_constant": False, **names}) + "\n")


def run(folder: Path, hours=1.0, rooms=(), sample=None) -> None:
    Quick(folder, folder / "build", os.cpu_count(), time.time() + 3600 * hours, lambda text: None, rooms, sample).run()


def outcomes(folder: Path) -> dict:
    answers = Answers(lines_of(folder / "results.jsonl"))
    return {number: answers.outcome(number) for number in OUTCOMES}


class Accounting(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        stand_in(self.folder)

    def test_both_detectors_are_asked_of_every_mutant(self):
        run(self.folder)
        self.assertEqual(outcomes(self.folder), OUTCOMES)
        answers = Answers(lines_of(self.folder / "results.jsonl"))
        self.assertIn("time limit", answers.how[HANGS, "tests"])
        known = {record["id"]: record["fails"] for record in lines_of(self.folder / "detectors.jsonl")}
        self.assertTrue(known["suites.Skipped"] and known["broken"])
        self.assertFalse(known["suites.Checked"] or known["script"])

        root = self.folder / "root"
        (root / "docs").mkdir(parents=True)
        missed = report.write(root, self.folder)
        self.assertEqual([goal.split(";")[1] for goal in missed], [" the goal is 90 %", " the goal is 97 %", " the goal is 95 %"])
        page = (root / "docs/power.md").read_text()
        self.assertIn("`cageproof verify` catches 4 of 9 deliberate defects by itself. `verify` and the tests together catch 6.", page)
        self.assertIn("9 mutants are drawn. 9 were asked of both", page)
        # Rooms that compute results: 6 mutants, of which verify catches 3 and tests 2.
        self.assertIn("| that compute results | 6 | 3, 50.0 % (goal 90 %) | 2, 33.3 % | 4, 66.7 % (goal 97 %) |", page)
        self.assertIn("| that judge and show them | 3 | 1, 33.3 % | 1, 33.3 % (goal 95 %) | 2, 66.7 % |", page)
        self.assertIn("| closed_form | 3 | 1 | 1 | 1 | 0 | 0 | 0 | 0 |", page)
        self.assertIn("`broken`, `suites.Skipped`", page)

    def test_a_run_that_was_stopped_counts_nothing_and_is_resumed(self):
        run(self.folder, hours=-1)
        self.assertEqual(set(outcomes(self.folder).values()), {"open"})
        run(self.folder)
        self.assertEqual(outcomes(self.folder), OUTCOMES)
        before = (self.folder / "results.jsonl").read_text()
        run(self.folder)
        self.assertEqual((self.folder / "results.jsonl").read_text(), before)

    def test_shards_of_several_units_answer_as_their_units(self):
        with mock.patch.object(verification, "SHARDS", 2):
            run(self.folder)
        self.assertEqual(outcomes(self.folder), OUTCOMES)

    def test_a_part_of_a_detector_is_no_answer(self):
        with mock.patch.object(campaign, "PORTIONS", [0]):
            run(self.folder)
        self.assertEqual(outcomes(self.folder)[SKIPS], "open")  # two tests reach it
        run(self.folder)
        self.assertEqual(outcomes(self.folder), OUTCOMES)

    def test_one_detector_without_the_other_is_open(self):
        answers = Answers([{"number": 1, "detector": "tests", "answer": "caught", "how": "", "tried": []}])
        self.assertEqual(answers.outcome(1), "open")
        root = self.folder / "root"
        (root / "docs").mkdir(parents=True)
        self.assertEqual(report.write(root, self.folder), [])
        self.assertIn("No mutant has been asked of both detectors", (root / "docs/power.md").read_text())

    def test_a_compiler_behind_a_launcher_is_found(self):
        for launcher in ("", "/usr/bin/cmake -E env CCACHE_DEPEND=1 /usr/bin/ccache "):
            entry = {"file": "/a b/c.cpp", "directory": "/d", "command": launcher + "/usr/bin/clang++-16 -DX=1 -o c.o -c '/a b/c.cpp'"}
            (self.folder / "compile_commands.json").write_text(json.dumps([entry]))
            self.assertEqual(list(sites.commands(self.folder)), [("/a b/c.cpp", ["-DX=1"], "/d")])

    def test_a_part_is_drawn_evenly(self):
        run(self.folder, rooms=("core", "solved"), sample=2)
        asked = {result["number"] for result in lines_of(self.folder / "results.jsonl")}
        self.assertEqual(len(asked), 2)
        self.assertIn(BY_ALL_UNITS, asked)
        mutants = [{"number": n, "file": f"{room}/{n % 3}.cpp"} for n, room in enumerate(["a"] * 90 + ["b"] * 9)]
        drawn = chosen(mutants, set(), 12, 1)
        counts = {}
        for mutant in drawn:
            counts[mutant["file"]] = counts.get(mutant["file"], 0) + 1
        self.assertEqual(set(counts.values()), {2})
        self.assertEqual(len(counts), 6)
        self.assertEqual(drawn, chosen(mutants, set(), 12, 1))
        self.assertEqual(len(chosen(mutants, {"b"}, 50, 1)), 9)


if __name__ == "__main__":
    unittest.main()
