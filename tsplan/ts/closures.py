"""Places that are closed for a time: steps at which nobody may be at a state or on an edge."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias

Span: TypeAlias = tuple[int, int]
"""The first and the last of some steps, both included."""

Closed: TypeAlias = tuple[Span, ...]
"""Steps at which a place is closed, in order; between two spans it is open at some step."""

FOREVER = 2**40
"""A step after all that any mission has."""


def spans(given: Iterable[Any]) -> Any:
    """Spans of steps in order, those that overlap or follow each other as one.

    What is no span is left to the checks.

    >>> spans([[7, 9], (2, 4), (5, 5)])
    ((2, 5), (7, 9))
    """
    try:
        pairs = tuple(tuple(pair) for pair in given)
    except TypeError:
        return given
    if not all(is_span(pair) for pair in pairs):
        return pairs
    found: list[Span] = []
    for first, last in sorted(pairs):
        if found and first <= found[-1][1] + 1:
            found[-1] = found[-1][0], max(found[-1][1], last)
        else:
            found.append((first, last))
    return tuple(found)


def is_span(pair: Any) -> bool:
    """Whether a value is a first and a last step."""
    two = isinstance(pair, tuple) and len(pair) == 2  # noqa: PLR2004 - first and last
    return two and all(type(step) is int for step in pair) and 0 <= pair[0] <= pair[1]


def closed_at(closed: Closed, first: int, last: int) -> Span | None:
    """The first of some spans that has a step of `first`..`last` in it, if there is one.

    >>> closed_at(((4, 9),), 0, 3), closed_at(((4, 9),), 2, 4)
    (None, (4, 9))
    """
    return next((span for span in closed if span[0] <= last and first <= span[1]), None)


def shifted(closed: Closed, steps: int) -> Closed:
    """The same so many steps later, or earlier where that is negative; none before step 0.

    >>> shifted(((1, 2), (4, 9)), -3)
    ((1, 6),)
    """
    moved = ((first + steps, last + steps) for first, last in closed)
    return tuple((max(first, 0), last) for first, last in moved if last >= 0)


def outside(barred: Sequence[Span]) -> Closed:
    """The steps from 0 on that are in none of some spans, which are sorted by their first step.

    >>> outside([(-2, 0), (4, 9)])
    ((1, 3), (10, 1099511627776))
    """
    found, begin = [], 0
    for first, last in barred:
        if begin < first:
            found.append((begin, first - 1))
        begin = max(begin, last + 1)
    return (*found, (begin, FOREVER))
