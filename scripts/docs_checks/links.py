# SPDX-License-Identifier: MIT
"""Whether what a page refers to exists: links to other pages, their headings, and files of the project that it names."""

import re
import unicodedata
from functools import cache
from pathlib import Path

from docs_checks.page import code, shown_name

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
NAMED = re.compile(r"`([\w./-]+?)(?::\d+)?`")
SOURCES = (".c", ".cpp", ".h", ".hpp", ".py", ".sh", ".cmake", ".js", ".css", ".mustache", ".md")


def anchor(heading: str) -> str:
    """The name that GitHub gives a heading."""
    text = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return "".join(c for c in text.replace(" ", "-") if c in "-_" or unicodedata.category(c)[0] in "LN")


def prose(path: Path):
    """Yields (number, line) of all lines outside blocks of code."""
    lines = path.read_text().splitlines()
    for number, language, block in code(lines):
        if language is None and block is None:
            yield number, lines[number - 1]


def anchors(path: Path) -> set[str]:
    names: dict[str, int] = {}
    found = set()
    for _, line in prose(path):
        heading = re.match(r"#+ +(.*?)#*$", line)
        if heading:
            name = anchor(heading[1])
            found.add(f"{name}-{names[name]}" if name in names else name)
            names[name] = names.get(name, 0) + 1
    return found


def exists(name: str, page: Path, root: Path) -> bool:
    """Whether a file that a page names exists: from the page's folder, from the root, among the pages, as sources include it (without `include/cageproof`), or, unless its first folder is one of the project's, as the end of a source's path."""
    room, _, rest = name.partition("/")
    if any(path.exists() for path in (page.parent / name, root / name, root / "docs" / name, root / room / "include/cageproof" / room / rest)):
        return True
    return room not in folders(root) and any(source.endswith("/" + name) for source in sources(root))


def broken(page: Path, root: Path) -> list[str]:
    found = []
    where = shown_name(page, root)
    for number, line in prose(page):
        for target in LINK.findall(line):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, heading = target.partition("#")
            file = page if not name else (page.parent / name)
            if not file.exists():
                found.append(f"{where}:{number}: no file {name}")
            elif heading and heading not in anchors(file):
                found.append(f"{where}:{number}: {name or where} has no heading #{heading}; it has {', '.join(sorted(anchors(file)))}")
        for name in NAMED.findall(line):
            if is_ours(name, root) and not exists(name, page, root):
                found.append(f"{where}:{number}: no file `{name}`")
    return found


def is_ours(name: str, root: Path) -> bool:
    """Files of the project begin with one of its folders, or are sources in some folder, or pages. Others are the user's (my_...), of a report, or written with dots for a part of their name."""
    if "my_" in name or "..." in name:
        return False
    first, separator, _ = name.partition("/")
    return bool(separator and (first in folders(root) or name.endswith(SOURCES))) or (name.endswith(".md") and not separator and name != "summary.md")


@cache
def folders(root: Path) -> frozenset[str]:
    """The project's own folders: those at its top that are neither hidden nor made by a build or a run (.gitignore)."""
    made = {line.strip("/\n") for line in (root / ".gitignore").read_text().splitlines()}
    return frozenset(path.name for path in root.iterdir() if path.is_dir() and not path.name.startswith(".") and path.name not in made)


@cache
def sources(root: Path) -> frozenset[str]:
    """The paths of the project's sources, from the root."""
    return frozenset(str(path.relative_to(root)) for folder in folders(root) for path in (root / folder).rglob("*") if path.suffix in SOURCES)
