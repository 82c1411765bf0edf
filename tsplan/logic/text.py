"""Formulas as text. What is printed parses back to the same formula.

How each class of nodes is written is told by `tsplan.logic.layouts`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from enum import IntEnum
from functools import singledispatch
from typing import Any, NamedTuple, TypeAlias

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

    formula: Any
    least: Binding


Part: TypeAlias = "str | Operand"


class Layout(NamedTuple):
    """The text of a node, with its sub-formulas in place."""

    binding: Binding
    parts: tuple[Part, ...]


def text_of(formula: Any, longest: int | None = None) -> str:
    """The text of a formula; cut off after `longest` characters if that is given."""
    pieces: list[str] = []
    length = 0
    for piece in _pieces(formula):
        pieces.append(piece)
        length += len(piece)
        if longest is not None and length > longest:
            return "".join(pieces)[:longest] + "..."
    return "".join(pieces)


def _pieces(formula: Any) -> Iterator[str]:
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


def operator_text(formula: Any, longest: int = 60) -> str:
    """The text of a node's operator alone; of an atom or task, its whole text, cut off if long.

    >>> from tsplan.logic import parse
    >>> operator_text(parse("F[0,3] a")), operator_text(parse("sum(a) > 2"))
    ('F[0,3]', 'sum(a) > 2')
    """
    if not formula.children:
        return text_of(formula, longest)
    parts = layout(formula).parts
    signs = dict.fromkeys(part.strip(" (),") for part in parts if not isinstance(part, Operand))
    return " ".join(sign for sign in signs if sign)


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


def sum_text(terms: Iterable[tuple[str, float]]) -> str:
    """A sum of signals, each with its factor.

    >>> sum_text((("x", 2.0), ("y", -1.0))), sum_text((("x", -1.0),)), sum_text(())
    ('2*x - y', '-x', '0')
    """
    text = ""
    for name, factor in terms:
        sign = ("-" if factor < 0 else "") if not text else " - " if factor < 0 else " + "
        size = abs(factor)
        text += sign + (quoted(name) if size == 1 else f"{number_text(size)}*{quoted(name)}")
    return text or "0"


@singledispatch
def layout(node: Any) -> Layout:
    """How a node is written. Every class of nodes registers its own."""
    raise TypeError(f"no text is registered for {type(node).__name__}")
