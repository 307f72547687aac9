# SPDX-License-Identifier: MIT
"""The kinds of mutants: what each makes of an expression or a statement."""

import re

from clang import cindex

from mutants.change import Change, Maker, unwrapped

Kind = cindex.CursorKind

EXCHANGED = {
    "sign": {"+": "-", "-": "+"},
    "factor": {"*": "/", "/": "*"},
    "comparison": {"<": ">", "<=": ">", ">": "<", ">=": "<", "==": "!=", "!=": "=="},
    "boundary": {"<": "<=", "<=": "<", ">": ">=", ">=": ">"},
    "logic": {"&&": "||", "||": "&&"},
    "remainder": {"%": "*"},
}
COMPOUND = {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
NAMES = {
    "min": "max",
    "max": "min",
    "cwiseMin": "cwiseMax",
    "cwiseMax": "cwiseMin",
    "minCoeff": "maxCoeff",
    "maxCoeff": "minCoeff",
    "any_of": "all_of",
    "all_of": "any_of",
    "none_of": "any_of",
    "any": "all",
    "all": "any",
    "floor": "ceil",
    "ceil": "floor",
    "sin": "cos",
    "cos": "sin",
}
ABSOLUTE = {"abs", "fabs"}
BOUND = re.compile(r"(?i)error|bound|radius|radii|slack|lost|tolerance|uncertain|doubt|digits")
ZERO = re.compile(r"(\w+(<\w+>)?[({])?0(\.0*)?[)}]?")
OPERATORS = {op for table in EXCHANGED.values() for op in table} | set(COMPOUND) | {"="}


def changes(cursor, source, context) -> dict[str, Change]:
    """The mutants that a cursor allows, by their kind."""
    maker = {
        Kind.BINARY_OPERATOR: binary,
        Kind.COMPOUND_ASSIGNMENT_OPERATOR: binary,
        Kind.UNARY_OPERATOR: unary,
        Kind.CALL_EXPR: call,
        Kind.ARRAY_SUBSCRIPT_EXPR: subscript,
        Kind.INTEGER_LITERAL: integer,
        Kind.FLOATING_LITERAL: floating,
        Kind.IF_STMT: condition,
        Kind.CONDITIONAL_OPERATOR: condition,
        Kind.RETURN_STMT: result,
        Kind.VAR_DECL: initialiser,
    }.get(cursor.kind)
    return maker(Maker(cursor, source, context)) if maker else {}


def binary(m: Maker) -> dict[str, Change]:
    found = m.operands(OPERATORS)
    if not found:
        return {}
    left, op, right = found
    a, b = m.text_of(left), m.text_of(right)
    changes = {}
    for name, table in EXCHANGED.items():
        if op in table:
            changes[name] = m.value(f"{a} {table[op]} {b}")
    if op in ("*", "/"):
        changes["factor dropped"] = m.value(a)
    if op in ("+", "-"):
        changes["term dropped"] = m.value(a)
    if op in ("<", "<=", ">", ">=") and not ZERO.fullmatch(b):
        for name, factor in (("threshold up", "1e6"), ("threshold down", "1e-6")):
            changes[name] = m.value(f"{a} {op} ::cageproof_mutants::scaled({b}, {factor})", f"{a} {op} ({b}) * {factor}")
    if op in COMPOUND:
        changes["compound sign"] = m.whole(f"{a} {COMPOUND[op]} {b}")
        changes["statement dropped"] = m.whole(a)
    if op == "=" and m.context.parent.kind in (Kind.COMPOUND_STMT, Kind.IF_STMT, Kind.FOR_STMT):
        changes["statement dropped"] = m.whole(a)
    if op in COMPOUND or op == "=":
        if BOUND.search(a):
            scaled = f"{a} {op} ::cageproof_mutants::scaled(::cageproof_mutants::value({b}), 0.01)"
            changes["bound too small"] = m.whole(scaled, f"{a} {op} ({b}) / 100")
    return changes


def unary(m: Maker) -> dict[str, Change]:
    if m.text.startswith("-") and not m.text.startswith("--"):
        return {"minus dropped": m.value(m.text[1:].strip())}
    if m.text.startswith("!"):
        return {"not dropped": m.value(f"static_cast<bool>({m.text[1:].strip()})", m.text[1:].strip())}
    if m.text.startswith(("++", "--")) and not m.context.in_for:
        return {"step": m.whole({"++": "--", "--": "++"}[m.text[:2]] + m.text[2:])}
    return {}


def call(m: Maker) -> dict[str, Change]:
    if found := binary(m):
        return found
    if m.text.startswith(("-", "!")):
        return unary(m)
    if m.text.endswith("]"):
        return subscript(m)
    name = m.cursor.spelling or next((c.spelling for c in map(unwrapped, m.children) if c.spelling), "")
    if not name and "(" in m.text:
        name = m.text.split("(")[0].split("<")[0].split("::")[-1].split(".")[-1].strip()
    if m.context.parent.kind in (Kind.VAR_DECL, Kind.FIELD_DECL, Kind.CONSTRUCTOR):
        return {}  # its text is the variable's
    changes = {}
    arguments = list(m.cursor.get_arguments())
    if name in NAMES:
        head = re.match(rf"(.*?)\b{name}\b(?=\s*\()", m.text, re.S)
        if head:
            changes["function"] = m.value(f"{head[1]}{NAMES[name]}{m.text[head.end():]}")
    if name in ABSOLUTE and len(arguments) == 1:
        changes["absolute value dropped"] = m.value(m.text_of(arguments[0]))
    for i in range(len(arguments) - 1):
        first, second = arguments[i], arguments[i + 1]
        a, b = m.text_of(first), m.text_of(second)
        if a == b or name in NAMES or not a or not b:
            continue
        same = first.type.get_canonical().spelling == second.type.get_canonical().spelling
        if not same and "dependent" not in (first.type.spelling + second.type.spelling):
            continue
        places = [c.extent.start.offset for c in (first, second)], [c.extent.end.offset for c in (first, second)]
        (s0, s1), (e0, e1) = places
        swapped = m.source.text(m.start, s0) + b + m.source.text(e0, s1) + a + m.source.text(e1, m.end)
        changes[f"arguments {i + 1} and {i + 2} exchanged"] = m.whole(swapped)
    return changes


def subscript(m: Maker) -> dict[str, Change]:
    places = [c for c in m.children if c.extent.end.offset == m.end - 1 and c.extent.start.offset > m.start]
    if not m.text.endswith("]") or not places:
        return {}
    index = places[0]
    text = m.text_of(index)
    if re.fullmatch(r"\d+", text):
        shifted = str(int(text) - 1) if int(text) else "1"
    elif cycle := re.search(r"% (\d+)$", text):
        shifted = f"(({text}) + 1) % {cycle[1]}"
    else:
        shifted = f"(({text}) > 0 ? ({text}) - 1 : ({text}) + 1)"
    start, end = index.extent.start.offset, index.extent.end.offset
    change = m.switch(shifted, start, end, "::cageproof_mutants::value")
    change.before, change.after = m.text, m.source.text(m.start, start) + shifted + "]"
    return {"index": change}


def integer(m: Maker) -> dict[str, Change]:
    if not re.fullmatch(r"\d+[uUlL]*", m.text):
        return {}
    changes = {"constant": m.value(f"{m.text} + 1")}
    if not m.text.startswith(("0", "1")):
        changes["constant doubled"] = m.value(f"{m.text} * 2")
    return changes


def floating(m: Maker) -> dict[str, Change]:
    if not re.fullmatch(r"[\d.]+(e[-+]?\d+)?", m.text):
        return {}
    changes = {"constant": m.value(f"{m.text} * 2")}
    if abs(float(m.text)) < 1e-3:
        changes["threshold up"] = m.value(f"{m.text} * 1e6")
        changes["threshold down"] = m.value(f"{m.text} * 1e-6")
    return changes


def condition(m: Maker) -> dict[str, Change]:
    if len(m.children) != len(list(m.cursor.get_children())):
        return {}  # a concept is asked, which the compiler answers
    if not m.children or not m.children[0].kind.is_expression() or m.text.startswith(("if constexpr", "if consteval")):
        return {}
    asked = m.children[0]
    start, end = asked.extent.start.offset, asked.extent.end.offset
    text = m.text_of(asked)
    if m.source.in_macro(start, end) or text in ("true", "false"):
        return {}
    return {
        f"always {v}": m.switch(v, start, end, "static_cast<bool>", f"{v} instead of {text}") for v in ("true", "false")
    }


def smaller(m: Maker, expression) -> dict[str, Change]:
    start, end = expression.extent.start.offset, expression.extent.end.offset
    text = m.text_of(expression)
    if ZERO.fullmatch(text) or text.startswith("{") or m.source.in_macro(start, end):
        return {}
    value = f"::cageproof_mutants::value({text})"
    changes = {}
    for name, factor, shown in (("bound too small", "0.01", f"({text}) / 100"), ("bound zero", "0.0", "0")):
        mutant = f"::cageproof_mutants::scaled({value}, {factor})"
        changes[name] = m.switch(mutant, start, end, "::cageproof_mutants::value", shown)
    return changes


def result(m: Maker) -> dict[str, Change]:
    """What a function returns, where its name says that it is a bound."""
    if not BOUND.search(m.context.function) or len(m.children) != 1:
        return {}
    return smaller(m, m.children[0])


def initialiser(m: Maker) -> dict[str, Change]:
    """What a variable begins with, where its name says that it is a bound."""
    if not BOUND.search(m.cursor.spelling) or "=" not in m.text or not m.children:
        return {}
    last = m.children[-1]
    if not last.kind.is_expression() or last.extent.end.offset != m.end:
        return {}
    changes = smaller(m, last)
    for change in changes.values():
        change.edits += m.context.constant_of(m.cursor, m.source)
    return changes
