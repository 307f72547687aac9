# SPDX-License-Identifier: MIT
"""A page of Markdown as blocks of code, with what the comments above each say about it."""

import re
from dataclasses import dataclass, field
from pathlib import Path

SHELL_LANGUAGES = {"sh", "bash", "shell"}

# A block without a language is one of commands when a line of it begins with one of these.
COMMAND = re.compile(
    r"(\w+=\S+ )*(cageproof\w*|\./\w+|scripts/\S+|\.ci/run|cmake|ctest|mpirun|srun|sbatch|export|git|python3|pip|sudo|apt-get|pkg-config|man|source)( |$)"
)

MARKS = re.compile(
    r"(?P<long>long)(: .+)?"
    r"|not run: (?P<reason>.+)"
    r"|(?P<stream>output|messages)(, (?P<numbers>numbers vary|within \S+))?"
    r"|exit (?P<exit>\d+)"
    r"|file: (?P<file>\S+)"
    r"|shown: (?P<shown>\S+)"
)
# A comment that begins with one of these words must be a mark; a misspelt mark would switch nothing, so it is an error.
MARK_WORDS = re.compile(r"(long|not run|output|messages|exit|file|shown)\b")


@dataclass
class Block:
    line: int  # of the first line of code, from 1
    language: str
    lines: list[str] = field(default_factory=list)
    long: bool = False
    reason: str = ""  # why it is never run
    stream: str = ""  # "output" or "messages": what the commands above print
    numbers: str = ""  # how its numbers are compared
    exit: int = 0
    file: str = ""  # name under which it is written
    shown: str = ""  # file of the project that it is an excerpt of

    @property
    def text(self) -> str:
        return "\n".join(self.lines) + "\n"

    @property
    def is_command(self) -> bool:
        if self.stream or self.file or self.shown:
            return False
        if self.language:
            return self.language in SHELL_LANGUAGES
        return self.long or bool(self.reason) or any(COMMAND.match(line.lstrip()) for line in self.lines)

    def first_command(self) -> str:
        return next((line.strip() for line in self.lines if line.strip() and not line.startswith("#")), "")

    def command_at(self, line: int) -> str:
        """The command in that line of the page."""
        return self.lines[line - self.line].strip() if 0 <= line - self.line < len(self.lines) else self.first_command()


class BadMark(Exception):
    pass


def shown_name(page: Path, root: Path) -> Path:
    """The page's name in messages: within the project from its root."""
    return page.relative_to(root) if page.is_relative_to(root) else page


def dedented(lines: list[str], width: int) -> list[str]:
    return [line[width:] if not line[:width].strip() else line.lstrip() for line in lines]


def code(lines: list[str]):
    """Yields (first line's number, language, lines) of fenced and indented blocks, and (number, None, [text]) of comments; other text as (number, None, None)."""
    at, previous_blank = 0, True
    while at < len(lines):
        line = lines[at]
        fence = re.match(r"( *)(```+|~~~+)\s*(\w*)", line)
        if fence:
            end = at + 1
            while end < len(lines) and not lines[end].strip().startswith(fence[2]):
                end += 1
            yield at + 2, fence[3] or "text", dedented(lines[at + 1 : end], len(fence[1]))
            at, previous_blank = end + 1, True
            continue
        if line.startswith("    ") and line.strip() and previous_blank:
            end = at
            while end < len(lines) and (not lines[end].strip() or lines[end].startswith("    ")):
                end += 1
            while not lines[end - 1].strip():
                end -= 1
            yield at + 1, "", dedented(lines[at:end], 4)
            at, previous_blank = end, True
            continue
        comment = re.fullmatch(r"\s*<!--\s*(.*?)\s*-->\s*", line)
        if comment:
            yield at + 1, None, [comment[1]]
            previous_blank = True
        elif line.strip():
            yield at + 1, None, None
            previous_blank = False
        else:
            previous_blank = True
        at += 1


def blocks(path: Path) -> list[Block]:
    """The page's blocks of code, marked. Raises BadMark, naming the line, where a mark is misspelt or stands above no code."""
    found, marks = [], []
    for number, language, lines in code(path.read_text().splitlines()):
        if language is not None:
            block = Block(number, language, lines)
            for _, mark in marks:
                apply(block, mark)
            found.append(block)
            marks = []
        elif lines is not None:
            mark = MARKS.fullmatch(lines[0])
            if mark:
                marks.append((number, mark))
            elif MARK_WORDS.match(lines[0]):
                raise BadMark(f"{path.name}:{number}: no mark is '{lines[0]}': long, not run: WHY, output, messages, exit N, file: NAME, shown: FILE")
        elif marks:
            raise BadMark(f"{path.name}:{marks[0][0]}: a mark above no block of code")
    if marks:
        raise BadMark(f"{path.name}:{marks[0][0]}: a mark above no block of code")
    return found


def apply(block: Block, mark: re.Match) -> None:
    block.long = block.long or bool(mark["long"])
    block.reason = mark["reason"] or block.reason
    block.stream = mark["stream"] or block.stream
    block.numbers = mark["numbers"] or block.numbers
    block.exit = int(mark["exit"] or block.exit)
    block.file = mark["file"] or block.file
    block.shown = mark["shown"] or block.shown
