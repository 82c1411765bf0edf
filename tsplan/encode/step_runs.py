"""Requirements over runs of steps: who asks, from when to when."""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from tsplan.encode.running_sums import RunningSums
from tsplan.encode.selection import ALWAYS, Choices, Literal

_WRITTEN = 4  # literals written out for each change of who asks


class Span(NamedTuple):
    """Something is required at the steps `first .. last` where a literal is 1."""

    first: int
    last: int
    literal: Literal


def joined(spans: Iterable[Span]) -> list[Span]:
    """The same requirements without those said twice, in the order of their beginnings."""
    asked: dict[Literal, list[tuple[int, int]]] = defaultdict(list)
    for first, last, literal in spans:
        asked[literal].append((first, last))
    whole = _runs(asked.pop(ALWAYS, []))
    found = [Span(first, last, ALWAYS) for first, last in whole]
    for literal, runs in asked.items():
        found += [Span(*rest, literal) for run in _runs(runs) for rest in _without(run, whole)]
    return sorted(found)


def _runs(pairs: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """Runs of steps in order, those that meet made one."""
    found: list[tuple[int, int]] = []
    for first, last in sorted(pairs):
        if found and first <= found[-1][1] + 1:
            found[-1] = (found[-1][0], max(found[-1][1], last))
        else:
            found.append((first, last))
    return found


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


def by_column(spans: Iterable[Span]) -> list[Span]:
    """The same requirements with a single column or `ALWAYS` as the literal of each."""
    return joined(
        Span(first, last, (column,)) if literal else Span(first, last, ALWAYS)
        for first, last, literal in spans
        for column in literal or (-1,)
    )


def by_step(spans: Sequence[Span], choices: Choices) -> dict[int, list[Literal]]:
    """The literals of each step, exclusive ones added up; steps are in order.

    Where the literals of all steps together would be far longer than the list of who begins and
    ends, each family of exclusive columns has a column for its running total instead.
    """
    written = sum((last - first + 1) * len(literal) for first, last, literal in spans)
    changes = sum(len(literal) for _, _, literal in spans)
    steps = max((s.last for s in spans), default=0) - min((s.first for s in spans), default=0) + 1
    if written <= _WRITTEN * (2 * changes + 3 * steps):
        return {step: choices.merged(found) for step, found in _at(spans).items()}
    found = _at([span for span in spans if not span.literal])
    single = [span for span in by_column(spans) if span.literal]
    begins: dict[int, list[Span]] = defaultdict(list)
    for span in single:
        begins[span.literal[0]].append(span)
    for family in choices.families(begins):
        mine = [span for column in family for span in begins[column]]
        for span in _totals(mine, choices):
            for step in range(span.first, span.last + 1):
                found.setdefault(step, []).append(span.literal)
    return dict(sorted(found.items()))


def _at(spans: Iterable[Span]) -> dict[int, list[Literal]]:
    found: dict[int, list[Literal]] = defaultdict(list)
    for first, last, literal in spans:
        for step in range(first, last + 1):
            found[step].append(literal)
    return dict(sorted(found.items()))


def _totals(spans: Sequence[Span], choices: Choices) -> list[Span]:
    """One column per stretch of steps for all the spans of a family of exclusive columns."""
    if len(spans) == 1:
        return list(spans)
    first = np.array([span.first for span in spans])
    after = np.array([span.last + 1 for span in spans])
    columns = np.array([span.literal[0] for span in spans])
    changes = RunningSums(
        np.concatenate([first, after]),
        np.concatenate([columns, columns]),
        np.repeat([1.0, -1.0], len(spans)),
    )
    found = stretches(changes, columns.tolist(), choices)
    begin = np.array([span.first for span in found])
    busy = np.searchsorted(np.sort(first), begin, side="right") - np.searchsorted(
        np.sort(after), begin, side="right"
    )
    return [span for span, many in zip(found, busy.tolist(), strict=True) if many]


def stretches(changes: RunningSums, above: Sequence[int], choices: Choices) -> list[Span]:
    """The running totals of `changes`, which are 0 or 1, as literals for as long as each lasts."""
    totals = choices.running(changes, above).tolist()
    first = changes.positions.tolist()
    return [
        Span(begin, after - 1, (total,))
        for total, begin, after in zip(totals, first, first[1:], strict=False)
    ]
