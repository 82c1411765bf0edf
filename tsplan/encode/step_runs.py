"""Runs of steps: from when to when something is asked for, by whom, and how much of it."""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple, Protocol, TypeAlias, TypeVar

import numpy as np

from tsplan.milp.model import Ints

Selection: TypeAlias = tuple[int, ...]
"""Columns of which at most one is 1; their sum is 0 or 1 itself."""

ALWAYS: Selection = ()
"""What holds in any case."""


class Span(NamedTuple):
    """Something is required at the steps `first .. last` where a selection is 1."""

    first: int
    last: int
    selection: Selection


class Run(NamedTuple):
    """So many agents at the steps `first .. last`."""

    first: int
    last: int
    amount: float


class _Lasting(Protocol):
    @property
    def first(self) -> int: ...

    @property
    def last(self) -> int: ...


_L = TypeVar("_L", bound=_Lasting)


def union(runs: Iterable[tuple[int, int]]) -> list[tuple[int, int]]:
    """Runs of steps in order, those that meet made one."""
    found: list[tuple[int, int]] = []
    for first, last in sorted(runs):
        if found and first <= found[-1][1] + 1:
            found[-1] = (found[-1][0], max(found[-1][1], last))
        else:
            found.append((first, last))
    return found


def steps_of(runs: Iterable[tuple[int, int]]) -> Ints:
    """The steps of several runs, in order, each once."""
    parts = [np.arange(first, last + 1) for first, last in union(runs)]
    return np.concatenate([*parts, np.empty(0, dtype=np.int64)])


def joined(spans: Iterable[Span]) -> list[Span]:
    """The same requirements without those said twice, in the order of their beginnings."""
    asked: dict[Selection, list[tuple[int, int]]] = defaultdict(list)
    for first, last, selection in spans:
        asked[selection].append((first, last))
    always = union(asked.pop(ALWAYS, []))
    found = [Span(first, last, ALWAYS) for first, last in always]
    for selection, runs in asked.items():
        found += [Span(*rest, selection) for run in union(runs) for rest in _without(run, always)]
    return sorted(found)


def _without(run: tuple[int, int], others: Sequence[tuple[int, int]]) -> Iterator[tuple[int, int]]:
    """What is left of a run of steps without others, which are in order and apart."""
    first, last = run
    place = max(bisect_right(others, (first, last)) - 1, 0)
    for begin, end in others[place:]:
        if begin > last:
            break
        if begin > first:
            yield first, begin - 1
        first = max(first, end + 1)
    if first <= last:
        yield first, last


def by_column(spans: Iterable[Span]) -> dict[Selection, list[Span]]:
    """The same requirements by single columns, and by `ALWAYS` for what is required in any case."""
    single = [
        Span(first, last, (column,)) if selection else Span(first, last, ALWAYS)
        for first, last, selection in spans
        for column in selection or (-1,)
    ]
    found: dict[Selection, list[Span]] = defaultdict(list)
    for span in joined(single):
        found[span.selection].append(span)
    return found


def pieces(lasting: Iterable[_L]) -> Iterator[tuple[int, int, list[_L]]]:
    """Time cut where something begins or ends: first and last step, and all that lasts then."""
    waiting = sorted(lasting, key=lambda one: -one.first)
    edges = sorted({edge for one in waiting for edge in (one.first, one.last + 1)})
    active: list[_L] = []
    for first, after in pairwise(edges):
        while waiting and waiting[-1].first <= first:
            active.append(waiting.pop())
        active = [one for one in active if one.last >= first]
        if active:
            yield first, after - 1, active


def most_at_once(runs: Iterable[Run]) -> list[Run]:
    """The most of several runs at every step, as runs that share no step."""
    found: list[Run] = []
    for first, last, active in pieces(runs):
        amount = max(run.amount for run in active)
        if found and found[-1].amount == amount and found[-1].last == first - 1:
            found[-1] = found[-1]._replace(last=last)
        elif amount:
            found.append(Run(first, last, amount))
    return found
