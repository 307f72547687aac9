#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tidy_units.py COMMANDS OUT FILE...: sources that clang-tidy reads at once, because it spends most of its time on what they include.

COMMANDS: a folder that CMake configured for a unity build. Writes OUT/<n>.cpp, which include at most eight of the FILEs that one unit of that build includes,
and OUT/compile_commands.json. Prints a line per unit: its path and its FILEs. A FILE that no command compiles is left out.
"""
import json
import os
import re
import sys

kAtOnce = 8


def main(commands, out, *files):
    units = {}  # what is compiled, or included by a unit: that unit's command
    for entry in json.load(open(os.path.join(commands, "compile_commands.json"))):
        units[entry["file"]] = entry
        # Sources that a build writes are not there yet.
        if entry["file"].startswith(os.path.realpath(commands) + os.sep) and os.path.exists(entry["file"]):
            for included in re.findall(r'^#include "(/.*\.cpp)"', open(entry["file"]).read(), re.MULTILINE):
                units[included] = entry
    groups = {}
    for file in files:
        unit = units.get(os.path.realpath(file))
        if unit:
            groups.setdefault(unit["file"], (unit, []))[1].append(file)
    os.makedirs(out)
    database = []
    for unit, group in groups.values():
        for first in range(0, len(group), kAtOnce):
            chosen = group[first : first + kAtOnce]
            path = os.path.join(out, f"{len(database)}.cpp")
            with open(path, "w") as source:
                source.writelines(f'#include "{os.path.realpath(file)}"\n' for file in chosen)
            database.append({**unit, "file": path, "command": unit["command"].replace(unit["file"], path)})
            print(path, *chosen)
    json.dump(database, open(os.path.join(out, "compile_commands.json"), "w"))


main(*sys.argv[1:])
