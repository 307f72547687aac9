# SPDX-License-Identifier: MIT
"""The copy of the project that carries the mutants: written, checked for what does not compile, and built."""

import hashlib
import json
import os
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mutants import draw, sites

ERROR = re.compile(r"^(/[^:\n]+):(\d+):(\d+): (error|fatal error|note): (.*)$")


class Workspace:
    """A folder with src (the copy), check (configured for reading), build, and what the campaign finds."""

    def __init__(self, root: Path, folder: Path, files: list[str], jobs: int, say):
        self.root, self.folder, self.jobs, self.say = root, folder.resolve(), jobs, say
        folder, self.files = self.folder, files
        self.source, self.check, self.build = folder / "src", folder / "check", folder / "build"
        self.places = {}  # of mutants in the files as they are written

    def copy(self) -> None:
        """The project's files as they are, and beside them the data that tests look for."""
        listed = subprocess.run(["git", "ls-files", "-z"], cwd=self.root, check=True, capture_output=True).stdout
        for name in filter(None, listed.decode().split("\0")):
            if (self.root / name).exists():
                self.put(name, (self.root / name).read_bytes())
                shutil.copymode(self.root / name, self.source / name)
        data = self.folder / "shared"
        if not data.exists() and (self.root / "../shared").exists():
            data.symlink_to((self.root / "../shared").resolve())

    def put(self, name: str, content: bytes) -> None:
        """Writes a file of the copy, unless it is so already: what does not change is not built again."""
        path = self.source / name
        if path.exists() and path.read_bytes() == content:
            return
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)

    def configure(self, build: Path, *options: str) -> None:
        switch = self.root / "scripts/mutants/switch.h"
        command = ["cmake", "-S", str(self.source), "-B", str(build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
        command += ["-DCMAKE_UNITY_BUILD=ON", "-DCAGEPROOF_BENCHMARKS=OFF", f"-DCMAKE_CXX_FLAGS=-std=c++20 -w -include {switch}"]
        environment = {**os.environ, "CC": "clang-16", "CXX": "clang++-16"}
        subprocess.run([*command, *options], check=True, stdout=subprocess.DEVNULL, env=environment)

    def nodes(self) -> dict:
        self.copy()
        self.configure(self.check, "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON")
        return sites.find(self.source, self.files, self.check)

    def write(self, mutants: list[draw.Mutant]) -> None:
        by_file = {file: [] for file in self.files}
        for mutant in mutants:
            by_file[mutant.node.file].append(mutant)
        for file, of_file in by_file.items():
            content, places = draw.written((self.root / file).read_bytes(), of_file)
            self.put(file, content)
            self.places[file] = (content, places)

    def guilty(self, output: str) -> tuple[set, list[str]]:
        """The mutants that a compiler's errors come from, and the errors that come from none."""
        groups, unknown, found = [], [], set()
        for line in output.splitlines():
            if match := ERROR.match(line):
                if match[4] != "note" or not groups:
                    groups.append([])
                groups[-1].append(match)
        for group in groups:
            mutant = next(filter(None, (self.at(m) for m in group)), None)
            mutant = mutant or next(filter(None, (self.on_line(m) for m in group)), None) or self.nearest(group[0])
            if mutant:
                found.add(id(mutant))
            else:
                unknown.append(group[0][0])
        return found, unknown

    def file_at(self, match):
        path = Path(match[1]).resolve()
        source = self.source.resolve()
        return str(path.relative_to(source)) if source in path.parents else None

    def offset(self, match) -> int:
        start, content = 0, self.places[self.file_at(match)][0]
        for _ in range(int(match[2]) - 1):
            start = content.index(b"\n", start) + 1
        return start + int(match[3]) - 1

    def at(self, match):
        """The innermost mutant around a place."""
        file = self.file_at(match)
        if file not in self.places:
            return None
        offset = self.offset(match)
        around = [(e - s, m.number, m) for s, e, m in self.places[file][1] if s <= offset < e]
        return min(around, key=lambda a: a[:2])[2] if around else None

    def on_line(self, match):
        """A mutant in the initialiser of a constant that is declared there."""
        file = self.file_at(match)
        for _, _, mutant in self.places.get(file, (None, []))[1]:
            if len(mutant.change.edits) > 2 and mutant.node.line == int(match[2]):
                return mutant
        return None

    def nearest(self, match):
        """The first mutant after a place on its line."""
        file = self.file_at(match)
        if file not in self.places:
            return None
        offset = self.offset(match)
        line_end = self.places[file][0].find(b"\n", offset)
        after = [(s, m.number, m) for s, _, m in self.places[file][1] if offset <= s < line_end]
        return min(after, key=lambda a: a[:2])[2] if after else None

    def remembered(self, mutants: list[draw.Mutant]) -> set:
        """Which mutants (by id) are known not to compile, in files that are still the same."""
        path = self.folder / "uncompilable.json"
        known = {tuple(entry) for entry in json.loads(path.read_text())} if path.exists() else set()
        return {id(m) for m in mutants if self.identity(m) in known}

    def remember(self, mutants: list[draw.Mutant]) -> None:
        path = self.folder / "uncompilable.json"
        known = json.loads(path.read_text()) if path.exists() else []
        path.write_text(json.dumps(known + [self.identity(m) for m in mutants]))

    def identity(self, mutant: draw.Mutant) -> tuple:
        node = mutant.node
        content = hashlib.sha1((self.root / node.file).read_bytes()).hexdigest()
        return node.file, content, node.start, node.end, mutant.kind

    def uncompilable(self, mutants: list[draw.Mutant]) -> set:
        """Which mutants (by id) do not compile where their own rooms use them."""
        rooms = {f.split("/")[0] for f in self.files}
        units = []
        for main, arguments, folder in sites.commands(self.check):
            path = Path(main).resolve()
            inside = path.relative_to(self.check if self.check in path.parents else self.source)
            if inside.parts[0] in rooms and "tests" not in inside.parts:
                units.append((main, arguments, folder))
        dropped = self.remembered(mutants)
        while units:
            self.write([m for m in mutants if id(m) not in dropped])
            with ThreadPoolExecutor(self.jobs) as pool:
                results = list(pool.map(self.errors_of, units))
            units = [unit for unit, (found, _) in zip(units, results) if found]
            unknown = [line for _, lines in results for line in lines]
            fresh = set().union(*(found for found, _ in results)) if results else set()
            if unknown and not fresh:
                raise SystemExit("errors that no mutant explains:\n" + "\n".join(unknown[:20]))
            dropped |= fresh
            self.remember([m for m in mutants if id(m) in fresh])
            self.say(f"{len(fresh)} do not compile; {len(units)} files to look at again")
        return dropped

    def errors_of(self, unit):
        main, arguments, folder = unit
        command = ["clang++-16", *arguments, "-fsyntax-only", "-ferror-limit=0", "-ftemplate-backtrace-limit=0"]
        command += ["-fno-caret-diagnostics", main]
        return self.guilty(subprocess.run(command, cwd=folder, capture_output=True, text=True).stderr)

    def compile(self, mutants: list[draw.Mutant]) -> list[draw.Mutant]:
        """Builds all; mutants that do not compile elsewhere are left out. Returns those that are in."""
        self.configure(self.build)
        while True:
            self.write(mutants)
            command = ["cmake", "--build", str(self.build), "--parallel", str(self.jobs), "--", "-k", "0"]
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode == 0:
                return mutants
            (self.folder / "build.log").write_text(done.stdout + done.stderr)
            found, unknown = self.guilty(done.stdout)
            if not found:
                raise SystemExit("the build fails:\n" + "\n".join(unknown[:20] or done.stdout.splitlines()[-20:]))
            self.say(f"{len(found)} more do not compile")
            self.remember([m for m in mutants if id(m) in found])
            # Numbers stay, so that files without these are not built again.
            mutants = [m for m in mutants if id(m) not in found]
