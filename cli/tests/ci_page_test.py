#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""ci_page_test.py CAGEPROOF PAGE: runs the shell steps of the workflows in docs/ci.md, which must pass, and fail where the kept report was better."""

import gzip
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

program, page = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).read_text()
environment = os.environ | {"PATH": f"{program.parent}:{os.environ['PATH']}", "CAGEPROOF_PROGRESS": "1e9"}
jobs = [re.findall(r"^ +- (?:run: )?(cageproof .*)$", block, re.M) for block in re.findall(r"^```yaml\n(.*?)^```", page, re.M | re.S)]
# The second job takes minutes, so that its command is compared and not run.
assert [len(job) for job in jobs] == [2, 1, 2], jobs
assert page.count(jobs[1][0]) == 2, jobs[1]
for number, (measure, compare) in enumerate(job for job in jobs if len(job) == 2):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run = lambda step: subprocess.run(["bash", "-ec", step], cwd=folder, env=environment | {"GITHUB_STEP_SUMMARY": str(folder / "step.md")}, capture_output=True, text=True)
        measured = run(measure)
        assert measured.returncode == 0, measured.stderr
        shutil.copytree(folder / "after", folder / "accuracy/before")
        same = run(compare)
        assert same.returncode == 0, same.stdout + same.stderr
        assert 'failures="0"' in (folder / "compare.xml").read_text()
        assert number == 1 or "Nothing got worse" in (folder / "step.md").read_text()
        # A report whose errors are a thousand times larger: the step must stop the change.
        packed = folder / "after/summary.json.gz"
        summary = json.loads(gzip.decompress(packed.read_bytes()))
        row = next(row for row in summary["rows"] if row["check"] == "truth" and row["verdict"] == "kept")
        row["max"] = 1000 * max(1, row["max"])
        packed.write_bytes(gzip.compress(json.dumps(summary).encode()))
        worse = run(compare)
        assert worse.returncode == 1, worse.stdout + worse.stderr
        assert 'failures="1"' in (folder / "compare.xml").read_text()
with tempfile.TemporaryDirectory() as name:
    # A history that cannot be written is found before anything else is.
    folder = Path(name)
    (folder / "times.json").write_text(json.dumps({"context": {}, "benchmarks": [{"name": "one", "cpu_time": 1}]}))
    command = [program, "compare", "times.json", "times.json", "--tolerance", "2x", "--junit", "compare.xml", "--history", "no/folder.jsonl"]
    refused = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert refused.returncode == 2 and "no/folder.jsonl" in refused.stderr and not (folder / "compare.xml").exists(), refused
print("The steps of docs/ci.md pass, and stop a change that costs accuracy.")
