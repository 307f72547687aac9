# SPDX-License-Identifier: MIT
"""Where mutants may go: the expressions and statements of the files in scope, found by libclang."""

import json
import re
import shlex
import sys
from dataclasses import dataclass, field
from pathlib import Path

sys.path.append("/usr/lib/python3/dist-packages")
from clang import cindex  # noqa: E402  (Debian: python3-clang-16)

from mutants import operators  # noqa: E402
from mutants.change import children_of  # noqa: E402

Kind = cindex.CursorKind

# Nodes that compute nothing at run time, or only a message.
SKIPPED = {
    Kind.STATIC_ASSERT,
    Kind.CXX_THROW_EXPR,
    Kind.TYPE_ALIAS_DECL,
    Kind.TYPE_ALIAS_TEMPLATE_DECL,
    Kind.TYPEDEF_DECL,
    Kind.ENUM_DECL,
    Kind.TYPE_REF,
    Kind.TEMPLATE_REF,
    Kind.NAMESPACE_REF,
    Kind.CXX_UNARY_EXPR,
}
FUNCTIONS = {Kind.FUNCTION_DECL, Kind.FUNCTION_TEMPLATE, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.CONVERSION_FUNCTION}
CLASSES = {Kind.CLASS_DECL, Kind.STRUCT_DECL, Kind.CLASS_TEMPLATE, Kind.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION}
# A class's static constants of these types choose templates.
CHOICES = {"const int", "const bool"}
COMPILER = re.compile(r"(clang|g)\+\+(-\d+)?$")
# These calls change no result.
WITHOUT_EFFECT = {"reserve", "shrink_to_fit"}




# Uses and definitions of macros, as far as their arguments' first parenthesis: the compiler sees other code there.
MACRO = re.compile(rb"\b(CAGEPROOF|BOOST|EIGEN)_[A-Z_]+(\([^()]*\))?|^ *#(.*\\\n)*.*$", re.M)


@dataclass
class Node:
    """An expression or statement: the mutants that are possible there, by kind."""

    file: str
    start: int
    end: int
    line: int
    source: str  # the line's text
    function: str
    may_be_constant: bool  # in a function that the compiler may evaluate
    kinds: dict = field(default_factory=dict)  # name of a kind -> operators.Change


@dataclass
class Context:
    """What encloses a cursor."""

    function: str = ""
    may_be_constant: bool = False  # in a function that the compiler may evaluate
    constant: list = field(default_factory=list)  # the edits that make the enclosing constant one of the run time
    parent: object = None
    in_for: bool = False

    def constant_of(self, variable, source) -> list:
        """The edits that let a mutant stand in a variable's initialiser."""
        start = variable.extent.start.offset
        head = source.text(start, variable.location.offset)
        if "constexpr" not in head.split():
            return []
        at = start + head.index("constexpr")
        word = "const" if self.function or "inline" in head.split() else "inline const"
        return [(at, at + len("constexpr"), word)]


class Source:
    """A file's bytes, and where macros stand in it."""

    def __init__(self, path: Path):
        self.bytes = path.read_bytes()
        self.macros = [m.span() for m in MACRO.finditer(self.bytes)]

    def text(self, start: int, end: int) -> str:
        return self.bytes[start:end].decode()

    def line_at(self, offset: int) -> str:
        begin, end = self.bytes.rfind(b"\n", 0, offset) + 1, self.bytes.find(b"\n", offset)
        return self.bytes[begin:end].decode().strip()

    def in_macro(self, start: int, end: int) -> bool:
        return any(start < e and s < end for s, e in self.macros)


def commands(build: Path):
    """The compilations of a build: (file, arguments that decide on meaning, folder)."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        # A launcher, ccache say, stands before the compiler.
        compiler = next((i for i, word in enumerate(words) if COMPILER.search(word)), None)
        if compiler is None:
            raise RuntimeError(f"no compiler in: {entry['command']}")
        kept, skip = [], False
        for word in words[compiler + 1 :]:
            if skip or word in ("-c", entry["file"]):
                skip = False
            elif word == "-o":
                skip = True
            else:
                kept.append(word)
        yield entry["file"], kept, entry["directory"]


class Finder:
    """Collects the nodes of files, each file from the first translation unit that has it."""

    def __init__(self, root: Path, files: list[str]):
        self.paths = {str((root / f).resolve()): f for f in files}
        self.sources = {f: Source(root / f) for f in files}
        self.nodes = {f: {} for f in files}
        self.done, self.fresh, self.names = set(), set(), {}

    def add(self, main: str, arguments: list[str]) -> None:
        index = cindex.Index.create()
        # Incomplete: templates need no instances to be seen.
        options = cindex.TranslationUnit.PARSE_INCOMPLETE
        unit = index.parse(main, arguments + ["-Wno-everything"], options=options)
        seen = {self.path_of(i.include.name) for i in unit.get_includes() if i.include} | {self.path_of(main)}
        fresh = seen - self.done - {None}
        if not fresh:
            return
        self.fresh = fresh
        for cursor in children_of(unit.cursor):
            if self.file_of(cursor):
                self.visit(cursor, Context())
        self.done |= fresh

    def file_of(self, cursor):
        place = cursor.location.file
        if place is None:
            return None
        file = self.path_of(place.name)
        return file if file in self.fresh else None

    def path_of(self, name: str):
        if name not in self.names:
            self.names[name] = self.paths.get(str(Path(name).resolve()))
        return self.names[name]

    def visit(self, cursor, context: Context) -> None:
        kind = cursor.kind
        if kind in SKIPPED or not (file := self.file_of(cursor)):
            return
        source = self.sources[file]
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        text = source.text(start, end)
        inner = Context(**vars(context))
        inner.parent = cursor
        if kind in FUNCTIONS or kind == Kind.DESTRUCTOR:
            words = text.split("{")[0].split("(")[0].split()
            inner.function = cursor.spelling
            inner.may_be_constant = "constexpr" in words or "consteval" in words
            inner.constant = []
        elif kind in (Kind.VAR_DECL, Kind.FIELD_DECL):
            if kind == Kind.VAR_DECL and context.parent and context.parent.kind in CLASSES and cursor.type.spelling in CHOICES:
                return
            inner.constant = context.constant_of(cursor, source)
        elif kind == Kind.CALL_EXPR and cursor.spelling in WITHOUT_EFFECT:
            return
        if not source.in_macro(start, end):
            changes = operators.changes(cursor, source, context)
            if changes:
                node = Node(file, start, end, cursor.extent.start.line, source.line_at(start), context.function, context.may_be_constant)
                place = self.nodes[file].setdefault((start, end), node)
                for name, change in changes.items():
                    place.kinds.setdefault(name, change)
        children = list(children_of(cursor))
        if kind == Kind.IF_STMT and text.startswith("if constexpr"):
            children = children[1:]
        elif kind in FUNCTIONS and kind != Kind.CONSTRUCTOR:
            # Types in a declaration decide which function is meant, and whether there is one.
            children = [child for child in children if child.kind == Kind.COMPOUND_STMT]
        for child in children:
            inner.in_for = context.in_for or kind == Kind.FOR_STMT
            if kind in (Kind.COMPOUND_STMT, Kind.LAMBDA_EXPR):
                inner.in_for = False
            self.visit(child, inner)


def find(root: Path, files: list[str], build: Path) -> dict[str, list[Node]]:
    """All nodes of the files, in their order. \\param build a configured build whose translation units have these files"""
    cindex.Config.set_library_file("/usr/lib/llvm-16/lib/libclang-16.so.1")
    finder = Finder(root, files)
    rooms = {f.split("/")[0] for f in files}
    for main, arguments, _ in commands(build):
        path = Path(main).resolve()
        place = path.relative_to(build.resolve() if build.resolve() in path.parents else root.resolve()).parts
        # A source that the build has yet to write holds no mutants.
        if path.exists() and place[0] in rooms and "tests" not in place and set(files) - finder.done:
            finder.add(main, arguments)
    return {f: [n for _, n in sorted(finder.nodes[f].items())] for f in files}
