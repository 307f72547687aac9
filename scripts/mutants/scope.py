# SPDX-License-Identifier: MIT
"""Which files carry mutants: those that a promised result is computed with, and those that judge and show results."""

import fnmatch
import subprocess
from pathlib import Path

# Files of these rooms, whose agreement is the proof, and the files that they use: most mutants are drawn there.
PROOF = [
    "closed_form/include/*",
    "closed_form/src/*",
    "fast/include/*",
    "fast/src/*",
    "adaptive_qmvc/include/*",
    "adaptive_qmvc/src/*",
    "quadrature_ref/include/*",
    "quadrature_ref/src/*",
    "core/include/*",
    "core/src/*",
    "core/readers/*",
]

# Rooms that judge results and show them.
JUDGES = ("validation", "reports", "cli")

# Every file of these has mutants too, drawn apart from the former.
BEYOND = [f"{room}/{part}/*" for room in (*JUDGES, "deformation", "solved") for part in ("include", "src")]

# But not these.
EXCLUDED = {
    "core/*/error_measure.*": "the judge's yardstick",
    "core/*/partial_result.*": "what the judge counts in",
    "core/*/tally.*": "what the judge counts in",
    "core/*/run_result.h": "what the judge says",
    "core/*/work_precision.h": "what benchmarks say",
    "core/*/random_stream.*": "where samples come from",
    "core/*/embedded_cages.*": "inputs",
    "core/*/whole_file.*": "writes reports",
    "core/*/unknown_name.*": "words of messages",
    "core/*/counted_name.h": "names of evaluations",
}


def mutated_files(root: Path, patterns: list[str], rooms: set[str]) -> list[str]:
    """The files that PROOF or BEYOND name, as paths relative to the project's root, in alphabetical order. \\param rooms the only ones; empty: all"""
    tracked = subprocess.run(
        ["git", "ls-files", "*.h", "*.cpp"], cwd=root, check=True, capture_output=True, text=True
    ).stdout.split()

    def matches(path: str, patterns) -> bool:
        return any(fnmatch.fnmatch(path, pattern) for pattern in patterns)

    inside = [path for path in tracked if not rooms or path.split("/")[0] in rooms]
    return sorted(path for path in inside if matches(path, patterns) and not matches(path, EXCLUDED))
