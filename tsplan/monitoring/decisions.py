"""Which formulas are decided while a trace goes on, each step at a constant cost.

Every sub-formula is undecided at first at every step at which it is asked for. It becomes true or
false as soon as the three-valued logic of Kleene says so: an `F` with the first step of its window
at which its child holds, a `G` with the last one, and so on. That is what progression says by
trivial truth (`tsplan.logic.progress`). Nothing is evaluated twice: what is decided is told to the
windows that contain it, each of which counts how many of its steps it still waits for.

Source of the logic: S. C. Kleene, "Introduction to Metamathematics", 1952, section 64.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.logic import nodes
from tsplan.logic.nodes import Formula
from tsplan.logic.settled import settled
from tsplan.logic.time_horizon import lookahead
from tsplan.logic.traversal import walk_all
from tsplan.logic.windows import switched

Truths: TypeAlias = npt.NDArray[np.int8]

HOLDS, FAILS, OPEN = 1, -1, 0


class Run(NamedTuple):
    """A formula is decided alike at the steps `first` to `last`."""

    first: int
    last: int
    truth: int


def needed(roots: Sequence[Formula]) -> dict[Formula, tuple[int, int]]:
    """Every sub-formula, children first, and the steps between which it is asked for.

    All roots are asked for at step 0.
    """
    order = list(walk_all(roots))
    spans: dict[Formula, tuple[int, int]] = dict.fromkeys(roots, (0, 0))
    for node in reversed(order):
        first, last = spans[node]
        for child, (low, high) in zip(node.children, lookahead(node), strict=True):
            if high < low:  # is never looked at
                spans.setdefault(child, (0, -1))
                continue
            here = first + low, last + high
            before = spans.get(child, here)
            known = here if before[1] < before[0] else before
            spans[child] = min(known[0], here[0]), max(known[1], here[1])
    return {node: spans[node] for node in order}


@dataclass(eq=False)
class Cell:
    """What is decided of one formula at the steps `first` to `last`.

    Where `decisive` is known of one child or step, that decides; of all others each of those that
    are `waiting` has to be known.
    """

    node: Formula
    first: int
    last: int
    truths: Truths
    waiting: npt.NDArray[np.int32]
    low: int = 0
    high: int = 0
    decisive: int = 0
    parents: list[Cell] = field(default_factory=list)
    inbox: list[Run] = field(default_factory=list)

    def between(self, first: int, last: int) -> Truths:
        """The truths at some steps; open where they are not asked for."""
        found = np.zeros(last - first + 1, dtype=np.int8)
        begin, end = max(first, self.first), min(last, self.last)
        if begin <= end:
            found[begin - first : end - first + 1] = self.truths[
                begin - self.first : end - self.first + 1
            ]
        return found

    def decide(self, first: int, last: int, truth: int) -> list[Run]:
        """Decide what is open of a span, all alike."""
        part = self.truths[first - self.first : last - self.first + 1]
        if first == last:
            if part[0]:
                return []
            part[0] = truth
            return [Run(first, last, truth)]
        return self._where(part, part == OPEN, first, truth)

    def settle(self, first: int, found: Truths) -> list[Run]:
        """Decide what is open as was found, from a step on."""
        part = self.truths[first - self.first : first - self.first + found.size]
        return [
            run
            for truth in (HOLDS, FAILS)
            for run in self._where(part, (part == OPEN) & (found == truth), first, truth)
        ]

    @staticmethod
    def _where(part: Truths, chosen: npt.NDArray[np.bool_], first: int, truth: int) -> list[Run]:
        places = np.flatnonzero(chosen)
        if not places.size:
            return []
        part[places] = truth
        gaps = np.flatnonzero(np.diff(places) > 1) + 1
        begins = places[np.concatenate([[0], gaps])].tolist()
        ends = places[np.concatenate([gaps - 1, [places.size - 1]])].tolist()
        return [Run(first + b, first + e, truth) for b, e in zip(begins, ends, strict=True)]

    def count(self, run: Run) -> list[Run]:
        """What is decided by a run of a child, for windows and for what joins children."""
        first, last = max(self.first, run.first - self.high), min(self.last, run.last - self.low)
        if first > last:
            return []
        if run.truth == self.decisive:
            return self.decide(first, last, run.truth)
        span = slice(first - self.first, last - self.first + 1)
        if run.first == run.last or self.low == self.high:
            self.waiting[span] -= 1
        else:
            at = np.arange(first, last + 1)
            within = np.minimum(at + self.high, run.last) - np.maximum(at + self.low, run.first)
            self.waiting[span] -= (within + 1).astype(np.int32)
        if first == last:
            ready = self.waiting[span.start] == 0
            return self.decide(first, last, run.truth) if ready else []
        part = self.truths[span]
        ready_at = (self.waiting[span] == 0) & (part == OPEN)
        return self._where(part, ready_at, first, run.truth)


class Decisions:
    """What is decided of some formulas, in positive normal form, at step 0."""

    def __init__(self, roots: Sequence[Formula]) -> None:
        spans = needed(roots)
        self._cells = {node: _cell(node, *span) for node, span in spans.items()}
        self._order = tuple(self._cells.values())
        for cell in self._order:
            for child in cell.node.children:
                self._cells[child].parents.append(cell)
        for cell in self._order:
            known = settled(cell.node)
            if known is not None:
                self.note(cell.node, cell.first, cell.last, HOLDS if known.holds else FAILS)

    def truth(self, root: Formula) -> int:
        """What is decided of one of the formulas."""
        return int(self._cells[root].truths[0])

    def span(self, node: Formula) -> tuple[int, int]:
        """The steps between which a sub-formula is asked for."""
        cell = self._cells[node]
        return cell.first, cell.last

    def note(self, node: Formula, first: int, last: int, truth: int) -> None:
        """Tell the truth of an atom at some steps; where it is known already it stays so."""
        cell = self._cells[node]
        first, last = max(first, cell.first), min(last, cell.last)
        if first <= last:
            _tell(cell, cell.decide(first, last, truth))

    def settle(self) -> None:
        """Decide what follows from all that was told."""
        for cell in self._order:
            if cell.inbox:
                runs, cell.inbox = cell.inbox, []
                _tell(cell, _decided(cell, runs, self._cells))


def _tell(cell: Cell, runs: Iterable[Run]) -> None:
    for parent in cell.parents:
        parent.inbox += runs


def _cell(node: Formula, first: int, last: int) -> Cell:
    steps = max(last - first + 1, 0)
    low, high, decisive, parts = 0, 0, 0, len(node.children)
    match node:
        case nodes.Eventually() | nodes.Always():
            low, high, parts = node.low, node.high, node.high - node.low + 1
    if isinstance(node, nodes.And | nodes.Always):
        decisive = FAILS
    if isinstance(node, nodes.Or | nodes.Eventually):
        decisive = HOLDS
    waiting = np.full(steps, parts, dtype=np.int32)
    return Cell(node, first, last, np.zeros(steps, dtype=np.int8), waiting, low, high, decisive)


def _decided(cell: Cell, runs: Sequence[Run], cells: dict[Formula, Cell]) -> list[Run]:
    node = cell.node
    if isinstance(node, nodes.Not):
        return [made for run in runs for made in cell.decide(run.first, run.last, -run.truth)]
    if not isinstance(node, nodes.Until | nodes.Release):
        return [made for run in runs for made in cell.count(run)]
    first = max(min(run.first for run in runs) - node.high, cell.first)
    last = min(max(run.last for run in runs), cell.last)
    if first > last:
        return []
    sides = (
        cells[node.left].between(first, last + max(node.high - 1, 0)),
        cells[node.right].between(first, last + node.high),
    )
    choices = (np.maximum, np.minimum)
    best, worst = choices if isinstance(node, nodes.Until) else choices[::-1]
    found = switched(sides, (node.low, node.high), best, worst)
    return cell.settle(first, found[: last - first + 1])
