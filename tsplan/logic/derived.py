"""Operators that stand for formulas of others: exactly one holds, and all count as a whole.

What they mean, and how robust they are, is what they stand for. `one` is not printed again: its
robustness is the greatest, over the parts, of the least of that part and the negations of all
others. `all` is `and`, or an always, that counts as a whole or not at all where a formula may hold
in part.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from tsplan.logic.nodes import (
    Always,
    And,
    Eventually,
    Formula,
    Or,
    Whole,
    conjunction,
    disjunction,
)
from tsplan.logic.traversal import fold

MOST_NODES = 100_000
"""Nodes of what an operator stands for, written out: nested in each other, they grow fast."""


def stands_for(word: str, parts: Sequence[Formula], steps: Sequence[int] = ()) -> Formula:
    """What the operator of a word stands for over parts, or over the window of one part.

    Raises ValueError where that is a formula of more than `MOST_NODES` nodes.

    >>> from tsplan.logic import parse
    >>> print(stands_for("all", [parse("a")], (2, 3)))
    all[2,3] a
    """
    over = DERIVED[word]
    made = over.over_steps(steps[0], steps[1], parts[0]) if steps else over.over_parts(parts)
    if fold(made, _nodes) > MOST_NODES:
        raise ValueError(f"'{word}' stands for a formula of more than {MOST_NODES:,} parts here")
    return made


def _nodes(_: Formula, below: tuple[int, ...]) -> int:
    return 1 + sum(below)


def one_of(parts: Sequence[Formula]) -> Formula:
    """Exactly one of two or more parts holds.

    It is exactly one of one half and none of the other, so that the size for n parts is that of
    n log n.

    >>> from tsplan.logic import parse
    >>> print(one_of([parse("a"), parse("b")]))
    a && !b || !a && b
    """
    if len(parts) == 1:
        return parts[0]
    first, last = parts[: len(parts) // 2], parts[len(parts) // 2 :]
    return Or((And((one_of(first), _none(last))), And((_none(first), one_of(last)))))


def _none(parts: Sequence[Formula]) -> Formula:
    return conjunction(~part for part in parts)


def one_step(low: int, high: int, child: Formula) -> Formula:
    """A formula holds at exactly one step `low .. high` from now.

    Raises ValueError for a window of more than `MOST_NODES` steps.

    >>> from tsplan.logic import parse
    >>> print(one_step(0, 1, parse("a")))
    F[0,0] a && G[1,1] !a || G[0,0] !a && F[1,1] a
    """
    if high - low >= MOST_NODES:
        raise ValueError(f"a window of 'one' has at most {MOST_NODES:,} steps")
    return disjunction(conjunction(_only(step, low, high, child)) for step in range(low, high + 1))


def _only(step: int, low: int, high: int, child: Formula) -> Iterator[Formula]:
    """At one step of a window, and at none before or after it."""
    if low < step:
        yield Always(low, step - 1, ~child)
    yield Eventually(step, step, child)
    if step < high:
        yield Always(step + 1, high, ~child)


def all_of(parts: Sequence[Formula]) -> Formula:
    """All parts hold, which counts as a whole or not at all; a single part counts so itself.

    >>> from tsplan.logic import parse
    >>> from tsplan.logic.fraction import denominator
    >>> made = all_of([parse("a"), parse("b")])
    >>> print(made, denominator(made), denominator(parse("a && b")))
    all(a, b) 1 2
    """
    return Whole(conjunction(parts))


def all_steps(low: int, high: int, child: Formula) -> Formula:
    """A formula holds at all steps `low .. high` from now; that counts as a whole or not at all.

    >>> from tsplan.logic import parse
    >>> print(all_steps(0, 5, parse("a")))
    all[0,5] a
    """
    return Whole(Always(low, high, child))


class Derived(NamedTuple):
    """What an operator stands for: over parts, and over the steps of a window."""

    over_parts: Callable[[Sequence[Formula]], Formula]
    over_steps: Callable[[int, int, Formula], Formula]


DERIVED: Mapping[str, Derived] = MappingProxyType(
    {"one": Derived(one_of, one_step), "all": Derived(all_of, all_steps)}
)
"""The derived operators by the words of formulas."""
