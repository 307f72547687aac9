# SPDX-License-Identifier: MIT
"""What a command printed, compared with what the page says that it prints."""

import difflib
import math
import re
from functools import lru_cache

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?|\bnan\b|\binf\b"
TOKEN = re.compile(rf"(?P<number>{NUMBER})|(?P<dots>\.\.\.)|(?P<space>\s+)")


def pattern(said: str, numbers: str) -> re.Pattern:
    """What a line of the page stands for: `...` for anything; where numbers may differ, any numbers, a group each, in columns of any width."""
    parts, at = [], 0
    for token in TOKEN.finditer(said):
        parts.append(re.escape(said[at : token.start()]))
        if token["dots"]:
            parts.append(".*")
        elif token["number"] and numbers:
            parts.append(f"({NUMBER})")
        elif token["space"] and numbers:
            parts.append(r"\s+")
        else:
            parts.append(re.escape(token[0]))
        at = token.end()
    return re.compile("".join(parts) + re.escape(said[at:]))


def same_line(said: str, printed: str, numbers: str) -> bool:
    said, printed = said.rstrip(), printed.rstrip()
    if said == printed:
        return True
    found = pattern(said, numbers).fullmatch(printed)
    if not found or not numbers.startswith("within "):
        return found is not None
    tolerance = float(numbers.removeprefix("within "))
    expected = [token["number"] for token in TOKEN.finditer(said) if token["number"]]
    return all(a == b or math.isclose(float(a), float(b), rel_tol=tolerance, abs_tol=tolerance) for a, b in zip(expected, found.groups()))


def same(said: list[str], printed: list[str], numbers: str) -> bool:
    """Whether the page's lines are those that were printed: a line `...` stands for any lines, or none."""

    @lru_cache(maxsize=None)
    def matches(i: int, j: int) -> bool:
        if i == len(said):
            return j == len(printed)
        if said[i].strip() == "...":
            return any(matches(i + 1, k) for k in range(len(printed), j - 1, -1))
        return j < len(printed) and same_line(said[i], printed[j], numbers) and matches(i + 1, j + 1)

    return matches(0, 0)


def difference(said: list[str], printed: list[str]) -> str:
    return "\n".join(difflib.unified_diff(said, printed, "the page", "the program", lineterm="", n=1))
