# SPDX-License-Identifier: MIT
"""Draws mutants from the nodes of all files, by a seed, and writes them into the files."""

import random
import re
from dataclasses import dataclass

from mutants.change import Change
from mutants.sites import Node


@dataclass
class Mutant:
    """One change at one node. Its number is set when it is written."""

    node: Node
    kind: str
    change: Change
    number: int = 0

    def record(self) -> dict:
        one_line = lambda text: re.sub(r"\s+", " ", text)  # noqa: E731
        return {
            "number": self.number,
            "file": self.node.file,
            "line": self.node.line,
            "function": self.node.function,
            "kind": self.kind,
            "source": self.node.source,
            "before": one_line(self.change.before),
            "after": one_line(self.change.after),
            "may_be_constant": self.node.may_be_constant,
        }


def candidates(nodes: dict[str, list[Node]], seed: int) -> dict[str, list[Mutant]]:
    """Every node of every file in an order that the seed decides, with one of its kinds."""
    found = {}
    for file, of_file in nodes.items():
        dice = random.Random(f"{seed} {file}")
        shuffled = list(of_file)
        dice.shuffle(shuffled)
        found[file] = []
        for node in shuffled:
            kind = dice.choice(sorted(node.kinds))
            found[file].append(Mutant(node, kind, node.kinds[kind]))
    return found


def evenly(found: dict[str, list[Mutant]], count: int, seed: int) -> list[Mutant]:
    """The first of each file's, the same number of each while it has any; files take their last turn in a random order."""
    turns = list(found)
    random.Random(seed).shuffle(turns)
    drawn, level = [], 0
    while len(drawn) < count and any(len(found[f]) > level for f in turns):
        drawn += [found[f][level] for f in turns if len(found[f]) > level][: count - len(drawn)]
        level += 1
    return sorted(drawn, key=lambda m: (m.node.file, m.node.start, m.node.end))


def one_line(text: str) -> str:
    return re.sub(r"\s+", " ", re.sub(r"//[^\n]*", "", text))


def written(original: bytes, mutants: list[Mutant]) -> tuple[bytes, list[tuple[int, int, Mutant]]]:
    """A file's bytes with mutants in it, its lines as before; and where in them each stands."""
    opening, closing, replaced = [], [], set()
    for mutant in mutants:
        switch = "on_at_run_time" if mutant.node.may_be_constant else "on"
        switch = f"::cageproof_mutants::{switch}({mutant.number})"
        spans = [e for e in mutant.change.edits if e[0] == e[1]]
        length = max(e[0] for e in spans) - min(e[0] for e in spans)
        for start, end, text in mutant.change.edits:
            if start != end:
                replaced.add((start, end, text))
            elif "SWITCH" in text:
                opening.append((start, 1, -length, mutant.number, one_line(text).replace("SWITCH", switch), mutant))
            else:
                closing.append((start, 0, length, -mutant.number, text, mutant))
    inserts = sorted(opening + closing, key=lambda i: i[:4])
    pieces = [(i[0], i[0], i[4], i[5], i[1]) for i in inserts]
    pieces += [(s, e, t, None, 2) for s, e, t in replaced]
    pieces.sort(key=lambda p: p[0])  # stable: what stands at one place keeps its order
    out, at, begun, places = bytearray(), 0, {}, []
    for start, end, text, mutant, is_opening in pieces:
        out += original[at:start]
        at = end
        if mutant and is_opening:
            begun[mutant.number] = len(out)
        out += text.encode()
        if mutant and not is_opening:
            places.append((begun[mutant.number], len(out), mutant))
    out += original[at:]
    return bytes(out), places
