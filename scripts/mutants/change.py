# SPDX-License-Identifier: MIT
"""A mutant's change as text, and what makes one of a cursor of libclang."""

from dataclasses import dataclass, field

from clang import cindex

Kind = cindex.CursorKind


@dataclass
class Change:
    """What a mutant changes: the text of the node before and after, and edits (start, end, text) that put both into the file. In an edit
    SWITCH stands for the question whether the mutant is on."""

    before: str
    after: str
    edits: list = field(default_factory=list)


def children_of(cursor):
    """Its children but concepts and constraints, which these bindings do not know."""
    for child in cursor.get_children():
        try:
            child.kind
        except ValueError:
            continue
        yield child


def unwrapped(cursor):
    """The cursor without the implicit conversions around it."""
    while cursor.kind == Kind.UNEXPOSED_EXPR:
        inner = list(children_of(cursor))
        if len(inner) != 1 or inner[0].extent != cursor.extent:
            break
        cursor = inner[0]
    return cursor


class Maker:
    def __init__(self, cursor, source, context):
        self.cursor, self.source, self.context = cursor, source, context
        self.start, self.end = cursor.extent.start.offset, cursor.extent.end.offset
        self.text = source.text(self.start, self.end)
        self.children = list(children_of(cursor))

    def text_of(self, cursor) -> str:
        return self.source.text(cursor.extent.start.offset, cursor.extent.end.offset)

    def switch(self, mutant: str, start: int, end: int, wrap: str, after: str = "") -> Change:
        """Puts `SWITCH ? mutant : original` around a part of the file. \\param wrap function around either, or nothing"""
        edits = [(start, start, f"(SWITCH ? {wrap}({mutant}) : {wrap}("), (end, end, "))")]
        edits += self.context.constant
        before = self.source.text(start, end)
        return Change(before, after or mutant, edits)

    def value(self, mutant: str, after: str = "") -> Change:
        return self.switch(mutant, self.start, self.end, "::cageproof_mutants::value", after)

    def whole(self, mutant: str, after: str = "") -> Change:
        return self.switch(mutant, self.start, self.end, "", after)

    def operands(self, operators):
        """(left, operator, right) of something with two operands; nothing otherwise."""
        parts = [c for c in self.children if self.text_of(c).strip() not in operators]
        if len(parts) != 2:
            return None
        left, right = parts
        if left.extent.start.offset != self.start or right.extent.end.offset != self.end:
            return None
        between = self.source.text(left.extent.end.offset, right.extent.start.offset).strip()
        return (left, between, right) if between in operators else None
