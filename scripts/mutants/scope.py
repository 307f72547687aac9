# SPDX-License-Identifier: MIT
"""Which files carry mutants: those that a promised result is computed with."""

import fnmatch
import subprocess
from pathlib import Path

# Every file of these.
INCLUDED = [
    "closed_form/include/*",
    "closed_form/src/*",
    "adaptive_qmvc/include/*",
    "adaptive_qmvc/src/*",
    "solved/include/*",
    "solved/src/*",
    "quadrature_ref/include/*",
    "quadrature_ref/src/*",
    "core/include/*",
    "core/src/*",
    "core/readers/*",
]

# But not these, and not `validation`, `reports`, `benchmarks` and `cli`: they judge results, or show them, and compute none. A mutant there asks whether
# the judge is right, which the tests of those rooms ask with judgements that are known.
EXCLUDED = {
    "core/*/error_measure.*": "the judge's yardstick",
    "core/*/findings.*": "what the judge counts in",
    "core/*/tally.*": "what the judge counts in",
    "core/*/run_result.h": "what the judge says",
    "core/*/work_precision.h": "what benchmarks say",
    "core/*/random_stream.*": "where samples come from",
    "core/*/embedded_cages.*": "inputs",
    "core/*/whole_file.*": "writes reports",
    "core/*/unknown_name.*": "words of messages",
    "core/*/counted_name.h": "names of evaluations",
}


def mutated_files(root: Path) -> list[str]:
    """The files in scope, as paths relative to the project's root, in alphabetical order."""
    tracked = subprocess.run(
        ["git", "ls-files", "*.h", "*.cpp"], cwd=root, check=True, capture_output=True, text=True
    ).stdout.split()

    def matches(path: str, patterns) -> bool:
        return any(fnmatch.fnmatch(path, pattern) for pattern in patterns)

    return sorted(path for path in tracked if matches(path, INCLUDED) and not matches(path, EXCLUDED))
