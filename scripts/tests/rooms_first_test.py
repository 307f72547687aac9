#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""rooms_first_test.py BUILD: in each test program the functions that both a room and the tests instantiate are the room's, optimised as users get them, not the
tests', which are compiled without optimisation (cmake/cageproof.cmake). A copy is told by its size. Exit 0: they are; 1: some are not, or none was compared."""

import subprocess
import sys
from pathlib import Path


def sizes(files: list[Path]) -> dict[str, int]:
    """The sizes of weak functions, of the first file that has them."""
    found: dict[str, int] = {}
    if not files:
        return found
    listed = subprocess.run(["nm", "--print-size", "--defined-only", "--no-sort", *map(str, files)], check=True, capture_output=True, text=True).stdout
    for line in listed.splitlines():
        words = line.split()
        if len(words) == 4 and words[2] == "W":
            found.setdefault(words[3], int(words[1], 16))
    return found


def main() -> int:
    build = Path(sys.argv[1])
    programs = sorted((build / "bin").glob("*_tests"))
    compared, wrong = 0, []
    for program in programs:
        room = program.name.removesuffix("_tests")
        own = sizes(sorted(build.glob(f"{room}/CMakeFiles/{room}_test_objects.dir/**/*.o")))
        linked = sizes([program])
        shared = sizes(sorted(build.glob(f"{room}/CMakeFiles/cageproof_{room}.dir/**/*.o")))
        for name in own.keys() & shared.keys() & linked.keys():
            if own[name] != shared[name]:
                compared += 1
                if linked[name] == own[name]:
                    wrong.append(f"{program.name}: {name} has {linked[name]} bytes as in the tests, {shared[name]} in the room")
    for line in wrong[:10]:
        print(line)
    print(f"{compared} functions of {len(programs)} test programs compared, {len(wrong)} are the tests' own copies")
    return 0 if compared and not wrong else 1


if __name__ == "__main__":
    sys.exit(main())
