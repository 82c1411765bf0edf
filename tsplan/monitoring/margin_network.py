"""The robustness of formulas on a trace that changes here and there.

Only what a change can reach is computed again, window by window. Two rows of values go through the
same operators, which take the least and the greatest of their parts: the availability, and by how
many steps everything may yet be late (`tsplan.monitoring.lateness_runs`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import reduce
from typing import NamedTuple

import numpy as np

from tsplan.logic import nodes
from tsplan.logic.nodes import Formula
from tsplan.logic.traces import Floats
from tsplan.logic.windows import switched, windowed
from tsplan.monitoring.decisions import needed

ROWS = 2
AVAILABILITY, LATENESS = range(ROWS)

_BLOCK = 64  # steps of a long window whose extreme is kept


class Span(NamedTuple):
    """Steps `first` to `last`; none where the last comes before the first."""

    first: int
    last: int

    def within(self, other: Span) -> Span:
        """The steps of both."""
        return Span(max(self.first, other.first), min(self.last, other.last))

    def hull(self, other: Span) -> Span:
        """The steps from the first of either to the last."""
        return Span(min(self.first, other.first), max(self.last, other.last))

    @property
    def empty(self) -> bool:
        """Whether there is no step."""
        return self.last < self.first


NOTHING = Span(0, -1)


@dataclass(eq=False)
class _Cell:
    node: Formula
    span: Span
    values: Floats  # (rows, steps of the span)
    parents: list[_Cell] = field(default_factory=list)
    changed: list[tuple[Formula, Span]] = field(default_factory=list)  # children, and where
    blocks: Floats | None = None  # extremes of a window that is looked at from one step only

    def between(self, first: int, last: int) -> Floats:
        """The values at some steps; not a number where they are not asked for."""
        span = Span(first, last).within(self.span)
        begin = span.first - self.span.first
        inside = self.values[:, begin : begin + span.last - span.first + 1]
        if span == (first, last):
            return inside
        found = np.full((ROWS, last - first + 1), np.nan)
        if not span.empty:
            found[:, span.first - first : span.last - first + 1] = inside
        return found


class MarginNetwork:
    """The values of some formulas, in positive normal form, at step 0.

    Atoms, and negated ones, are told; what follows is computed by `settle`.
    """

    def __init__(self, roots: Sequence[Formula]) -> None:
        spans = {node: Span(*span) for node, span in needed(roots).items()}
        inner = {n: s for n, s in spans.items() if n.children and not isinstance(n, nodes.Not)}
        self._cells = {
            node: _Cell(node, span, np.full((ROWS, max(span.last - span.first + 1, 0)), np.nan))
            for node, span in spans.items()
        }
        self._order = tuple(self._cells[node] for node in inner)
        for cell in self._order:
            for child in dict.fromkeys(cell.node.children):
                self._cells[child].parents.append(cell)

    def value(self, root: Formula) -> tuple[float, float]:
        """Availability and lateness of one of the formulas."""
        availability, lateness = self._cells[root].values[:, 0].tolist()
        return availability, lateness

    def tell(self, atom: Formula, first: int, values: Floats) -> None:
        """Set the values (rows, steps) of an atom from a step on; others are left out."""
        cell = self._cells[atom]
        span = Span(first, first + values.shape[1] - 1).within(cell.span)
        if not span.empty:
            self._put(cell, span, values[:, span.first - first : span.last - first + 1])

    def settle(self) -> None:
        """Compute what follows from all that was told."""
        for cell in self._order:
            if cell.changed:
                changed, cell.changed = cell.changed, []
                span = _reached(cell, changed)
                if not span.empty:
                    self._put(cell, span, self._computed(cell, span, changed))

    def _put(self, cell: _Cell, span: Span, values: Floats) -> None:
        begin = span.first - cell.span.first
        known = cell.values[:, begin : begin + values.shape[1]]
        differ = np.flatnonzero((known != values).any(axis=0))
        if not differ.size:
            return
        known[:] = values
        where = Span(span.first + int(differ[0]), span.first + int(differ[-1]))
        for parent in cell.parents:
            parent.changed.append((cell.node, where))

    def _computed(self, cell: _Cell, span: Span, changed: Iterable[tuple[Formula, Span]]) -> Floats:
        """The values of a node at some steps from those of its children."""
        node, (first, last) = cell.node, span
        match node:
            case nodes.Eventually() | nodes.Always():
                child = self._cells[node.child]
                choose = np.maximum if isinstance(node, nodes.Eventually) else np.minimum
                if cell.span.first == cell.span.last:
                    return _extreme(cell, child, choose, changed)
                part = child.between(first + node.low, last + node.high)
                return windowed(part, 0, node.high - node.low, choose)
            case nodes.Until() | nodes.Release():
                left = self._cells[node.left].between(first, last + max(node.high - 1, 0))
                right = self._cells[node.right].between(first, last + node.high)
                choices = (np.maximum, np.minimum)
                best, worst = choices if isinstance(node, nodes.Until) else choices[::-1]
                return switched((left, right), (node.low, node.high), best, worst)
        parts = (self._cells[child].between(first, last) for child in node.children)
        return reduce(np.minimum if isinstance(node, nodes.And) else np.maximum, parts)


def _reached(cell: _Cell, changed: Iterable[tuple[Formula, Span]]) -> Span:
    """The steps of a node that look at some steps of its children."""
    node, found = cell.node, NOTHING
    for _, (first, last) in changed:
        match node:
            case nodes.Eventually() | nodes.Always():
                here = Span(first - node.high, last - node.low)
            case nodes.Until() | nodes.Release():
                here = Span(first - node.high, last)
            case _:
                here = Span(first, last)
        found = here if found.empty else found.hull(here)
    return found.within(cell.span)


def _extreme(
    cell: _Cell, child: _Cell, choose: np.ufunc, changed: Iterable[tuple[Formula, Span]]
) -> Floats:
    """The extreme of a window that is looked at from one step, by the extremes of its blocks."""
    assert isinstance(cell.node, nodes.Window)
    begin, end = cell.span.first + cell.node.low, cell.span.first + cell.node.high
    values = child.between(begin, end)
    if values.shape[1] <= 2 * _BLOCK:
        return np.asarray(choose.reduce(values, axis=1, keepdims=True))
    if cell.blocks is None:
        starts = np.arange(0, values.shape[1], _BLOCK)
        cell.blocks = choose.reduceat(values, starts, axis=1)
    else:
        for _, (first, last) in changed:
            low, high = max(first, begin) - begin, min(last, end) - begin
            if low <= high:
                block, over = low // _BLOCK, high // _BLOCK + 1
                part = values[:, block * _BLOCK : over * _BLOCK]
                starts = np.arange(0, part.shape[1], _BLOCK)
                cell.blocks[:, block:over] = choose.reduceat(part, starts, axis=1)
    return np.asarray(choose.reduce(cell.blocks, axis=1, keepdims=True))
