"""Formulas as text. What is printed parses back to the same formula."""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import IntEnum
from functools import singledispatch
from typing import NamedTuple, TypeAlias

from tsplan.logic.atoms import Count, Limit, Linear, Task
from tsplan.logic.nodes import (
    Always,
    And,
    Constant,
    Eventually,
    Formula,
    Iff,
    Implies,
    Not,
    Or,
    Release,
    Several,
    Switch,
    Until,
    Window,
)

KEYWORDS = frozenset({"true", "True", "false", "False", "not"})
"""Words that are never names, unless they are quoted."""

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")
_EXACT = 2.0**53  # whole numbers up to here are printed without a fraction


class Binding(IntEnum):
    """How tightly an operator holds its operands together; looser ones need parentheses."""

    LOOSE = 0  # U, R, => and <=> stand alone on their level
    OR = 1
    AND = 2
    COMPARISON = 3  # would parse bare below a prefix, but reads better in parentheses
    UNARY = 4  # also names, tasks and limits


class Operand(NamedTuple):
    """A sub-formula inside a text, in parentheses if it binds less than `least`."""

    formula: Formula
    least: Binding


Part: TypeAlias = "str | Operand"


class Layout(NamedTuple):
    """The text of a node, with its sub-formulas in place."""

    binding: Binding
    parts: tuple[Part, ...]


def text_of(formula: Formula, longest: int | None = None) -> str:
    """The text of a formula; cut off after `longest` characters if that is given."""
    pieces: list[str] = []
    length = 0
    for piece in _pieces(formula):
        pieces.append(piece)
        length += len(piece)
        if longest is not None and length > longest:
            return "".join(pieces)[:longest] + "..."
    return "".join(pieces)


def _pieces(formula: Formula) -> Iterator[str]:
    stack: list[Part] = [Operand(formula, Binding.LOOSE)]
    while stack:
        part = stack.pop()
        if isinstance(part, str):
            yield part
            continue
        binding, parts = layout(part.formula)
        if binding < part.least:
            parts = ("(", *parts, ")")
        stack += reversed(parts)


def quoted(name: str) -> str:
    """A label, capability or signal as the grammars read it: in quotes unless it is a plain word.

    >>> quoted("depot"), quoted("north field")
    ('depot', '"north field"')
    """
    if _NAME.match(name) and name not in KEYWORDS:
        return name
    escaped = name.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def number_text(value: float) -> str:
    """The shortest text of a number; whole numbers without a fraction."""
    return str(int(value)) if value == int(value) and abs(value) < _EXACT else repr(value)


@singledispatch
def layout(node: Formula) -> Layout:
    """How a node is written. Every class of nodes registers its own."""
    raise TypeError(f"no text is registered for {type(node).__name__}")


@layout.register
def _(node: Constant) -> Layout:
    return Layout(Binding.UNARY, ("true" if node.value else "false",))


@layout.register
def _(node: Not) -> Layout:
    return Layout(Binding.UNARY, ("!", Operand(node.child, Binding.UNARY)))


@layout.register
def _(node: And) -> Layout:
    return _joined(node, " && ", Binding.AND)


@layout.register
def _(node: Or) -> Layout:
    return _joined(node, " || ", Binding.OR)


@layout.register
def _(node: Implies) -> Layout:
    return _between(node.left, " => ", node.right)


@layout.register
def _(node: Iff) -> Layout:
    return _between(node.left, " <=> ", node.right)


@layout.register
def _(node: Eventually) -> Layout:
    return _before("F", node)


@layout.register
def _(node: Always) -> Layout:
    return _before("G", node)


@layout.register
def _(node: Until) -> Layout:
    return _between(node.left, f" U{_interval(node)} ", node.right)


@layout.register
def _(node: Release) -> Layout:
    return _between(node.left, f" R{_interval(node)} ", node.right)


@layout.register
def _(node: Count) -> Layout:
    if (node.function, node.capability, node.relation, node.bound) == ("sum", None, ">=", 1):
        return _atom(quoted(node.label))
    inside = [quoted(node.label)]
    if node.capability is not None:
        inside.append(quoted(node.capability))
    return _comparison(f"{node.function}({','.join(inside)})", node.relation, str(node.bound))


@layout.register
def _(node: Linear) -> Layout:
    text = ""
    for name, factor in node.terms:
        sign = (" - " if factor < 0 else " + ") if text else ""
        size = abs(factor)
        text += sign + (quoted(name) if size == 1 else f"{number_text(size)}*{quoted(name)}")
    return _comparison(text or "0", node.relation, number_text(node.bound))


@layout.register
def _(node: Task) -> Layout:
    parts = [str(node.duration), quoted(node.label), _pairs(node.needs)]
    if node.resources:
        parts.append(_pairs(node.resources))
    return _atom(f"T({','.join(parts)})")


@layout.register
def _(node: Limit) -> Layout:
    return _atom(f"L({quoted(node.label)},{_pairs(node.needs)})")


def _atom(text: str) -> Layout:
    return Layout(Binding.UNARY, (text,))


def _comparison(left: str, relation: str, right: str) -> Layout:
    return Layout(Binding.COMPARISON, (f"{left} {relation} {right}",))


def _joined(node: Several, sign: str, binding: Binding) -> Layout:
    parts: list[Part] = []
    for child in node.children:
        if parts:
            parts.append(sign)
        parts.append(Operand(child, Binding(binding + 1)))
    return Layout(binding, tuple(parts))


def _between(left: Formula, sign: str, right: Formula) -> Layout:
    parts = (Operand(left, Binding.UNARY), sign, Operand(right, Binding.UNARY))
    return Layout(Binding.LOOSE, parts)


def _before(letter: str, node: Window) -> Layout:
    parts = (f"{letter}{_interval(node)} ", Operand(node.child, Binding.UNARY))
    return Layout(Binding.UNARY, parts)


def _interval(node: Window | Switch) -> str:
    return f"[{node.low},{node.high}]"


def _pairs(pairs: tuple[tuple[str, int], ...] | tuple[tuple[str, float], ...]) -> str:
    inside = (f"({quoted(name)},{number_text(amount)})" for name, amount in pairs)
    return "{" + ",".join(inside) + "}"
