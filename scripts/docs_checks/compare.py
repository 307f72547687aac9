# SPDX-License-Identifier: MIT
"""What a command printed, compared with what the page says that it prints."""

import difflib
import math
import re
from functools import lru_cache

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?|\bnan\b|\binf\b")


def pieces(line: str) -> tuple[list[str], list[str]]:
    """The line's text, with columns drawn together, and its numbers."""
    words = [re.sub(r"\s+", " ", text) for text in NUMBER.split(line)]
    return words, NUMBER.findall(line)


def same_line(said: str, printed: str, numbers: str) -> bool:
    """Whether they agree: `...` within a line stands for anything, and numbers may differ as `numbers` says."""
    said, printed = said.rstrip(), printed.rstrip()
    if said == printed:
        return True
    if not numbers:
        return "..." in said and re.fullmatch(".*".join(re.escape(part) for part in said.split("...")), printed) is not None
    if "..." in said:
        said_parts = [re.sub(r"\\?\s+", r"\\s+", re.escape(part)) for part in NUMBER.sub("\0", said).split("...")]
        return re.fullmatch(".*".join(said_parts).replace("\0", "\0"), NUMBER.sub("\0", printed)) is not None
    said_words, said_numbers = pieces(said)
    printed_words, printed_numbers = pieces(printed)
    if said_words != printed_words:
        return False
    if numbers == "numbers vary":
        return True
    tolerance = float(numbers.removeprefix("within "))
    return all(a == b or math.isclose(float(a), float(b), rel_tol=tolerance, abs_tol=tolerance) for a, b in zip(said_numbers, printed_numbers))


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
