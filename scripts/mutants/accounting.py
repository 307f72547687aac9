# SPDX-License-Identifier: MIT
"""What both detectors, `verify` and the tests, say of each mutant. Knows no compiler and no build."""

import json
import random
from pathlib import Path

DETECTORS = ("verify", "tests")

# A detector's answer: it caught the mutant; all of it that reaches the mutant passed; nothing of it reaches the mutant; it was not asked to the end.
CAUGHT, MISSED, UNREACHED, OPEN = "caught", "missed", "unreached", "open"


def lines_of(path: Path) -> list:
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


class Answers:
    """The answers that a campaign's results hold. A result is {"number", "detector", "answer", "how", "tried"}, of one portion of a detector."""

    def __init__(self, results: list):
        self.answers, self.how, self.tried = {}, {}, {}
        for result in results:
            self.add(result)

    def add(self, result: dict) -> None:
        key = result["number"], result["detector"]
        self.tried.setdefault(key, set()).update(result["tried"])
        if self.answers.get(key) == CAUGHT:
            return  # what comes after does not take it back
        self.answers[key], self.how[key] = result["answer"], result["how"]

    def of(self, number: int, detector: str) -> str:
        return self.answers.get((number, detector), OPEN)

    def outcome(self, number: int) -> str:
        """Who caught a mutant; "open" until both were asked to the end."""
        answers = [self.of(number, detector) for detector in DETECTORS]
        if OPEN in answers:
            return "open"
        caught = [detector for detector, answer in zip(DETECTORS, answers) if answer == CAUGHT]
        if caught:
            return "both" if len(caught) == 2 else f"{caught[0]} only"
        return "unreached" if answers == [UNREACHED, UNREACHED] else "neither"


def chosen(mutants: list, rooms: set, count, seed: int) -> list:
    """The mutants (records) of some rooms. \\param rooms empty: all
    \\param count how many, drawn in turn from rooms, and within a room from its files, as long as they have any; None: all"""
    inside = [m for m in mutants if not rooms or m["file"].split("/")[0] in rooms]
    if count is None:
        return inside
    dice = random.Random(seed)
    dice.shuffle(inside)
    turns = {}  # how many of the room, and how many of the file, stand before a mutant
    places = []
    of_file = {}
    for mutant in inside:
        of_file.setdefault(mutant["file"], []).append(mutant)
    for file, found in of_file.items():
        places += [(level, file.split("/")[0], mutant) for level, mutant in enumerate(found)]
    places.sort(key=lambda place: place[0])  # stable: files of one level keep their random order
    ordered = []
    for _, room, mutant in places:
        ordered.append((turns.get(room, 0), mutant))
        turns[room] = turns.get(room, 0) + 1
    ordered.sort(key=lambda place: place[0])
    return sorted((mutant for _, mutant in ordered[:count]), key=lambda m: m["number"])
