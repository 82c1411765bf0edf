"""Which parts of a tree hold on a trace, and when: what a fraction is made of.

Trees are those of `tsplan.logic.fraction.tree_of`. A *pair* is a sub-formula and a step at which
it is judged; what counts as a whole is one pair, with none below it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf
from typing import NamedTuple, TypeAlias

from tsplan.logic.fraction import Shares, changes, is_even, portions, shares
from tsplan.logic.nodes import (
    Always,
    And,
    Eventually,
    Formula,
    Or,
    Until,
    Whole,
    conjunction,
)
from tsplan.logic.simplification import simplify
from tsplan.logic.time_horizon import Span, lookahead
from tsplan.logic.traces import Trace
from tsplan.logic.traversal import fold, fold_all

Pair: TypeAlias = "tuple[Formula, int]"

MOST_PARTS = 5_000
"""Parts that are told of one tree; written out, a small formula with many <=> may have millions."""

MOST_PAIRS = 200_000
"""Pairs of a tree that are told apart by their depth; a formula with more is too large for that."""


@dataclass(frozen=True, slots=True)
class Part:
    """One sub-formula of a tree where it stands: how much of it holds, and when.

    It is judged where the best witnesses of the eventualities above it say, and `fraction` is the
    mean over these steps; `first` and `last` are the steps between which its atoms are looked at.
    A part that is not `counted` belongs to an alternative that is not the best one, and does not
    enter the root's fraction.
    """

    node: Formula
    depth: int
    first: int
    last: int
    fraction: Fraction
    counted: bool = True

    @property
    def met(self) -> bool:
        """Whether the part holds wherever it is judged."""
        return self.fraction == 1


class _Place(NamedTuple):
    """A sub-formula where it stands, with the steps at which it is judged."""

    node: Formula
    depth: int
    steps: tuple[int, ...]
    counted: bool


def parts(tree: Formula, trace: Trace) -> tuple[Part, ...]:
    """Every sub-formula of a tree, parents before their children, in the order of the text.

    Of a tree with more than `MOST_PARTS` the last ones are left out.
    """
    values = shares(tree, trace)
    places: list[_Place] = []
    stack = [_Place(tree, 0, (0,), counted=True)]
    while stack and len(places) < MOST_PARTS:
        places.append(stack.pop())
        stack += reversed(list(_below(places[-1], values)))
    found = []
    for place, span in zip(places, _spans(places), strict=True):
        node = place.node
        total = sum((values[node][step].fraction for step in place.steps), Fraction(0))
        found.append(Part(node, place.depth, *span, total / len(place.steps), place.counted))
    return tuple(found)


def _spans(places: Sequence[_Place]) -> list[Span]:
    """Between which steps the atoms of each place are judged; parents stand before children."""
    spans: list[Span] = []
    below: dict[int, Span] = {}  # of the children seen since their last parent
    for place in reversed(places):
        ahead = fold(place.node, _ahead) if isinstance(place.node, Whole) else (0, 0)
        own = (place.steps[0] + ahead[0], place.steps[-1] + ahead[1])
        span = below.pop(place.depth + 1, own)
        first, last = below.get(place.depth, span)
        below[place.depth] = (min(first, span[0]), max(last, span[1]))
        spans.append(span)
    return spans[::-1]


def _ahead(node: Formula, below: tuple[Span, ...]) -> Span:
    """Between which steps from now the atoms of a formula are judged."""
    spans = [
        (first + one[0], last + one[1])
        for (first, last), one in zip(lookahead(node), below, strict=True)
        if last >= 0  # or else the left side of an until does not matter
    ]
    return min((first for first, _ in spans), default=0), max(
        (last for _, last in spans), default=0
    )


def _below(place: _Place, values: Mapping[Formula, Shares]) -> Iterator[_Place]:
    """The children of a place and where they are judged; alternatives that lose included."""
    node = place.node
    judged: list[set[int]] = [set() for _ in node.children]
    for step in place.steps:
        for number, later in witness_steps(node, step, values):
            judged[number].add(later)
    for child, steps in zip(node.children, judged, strict=True):
        if steps:
            yield _Place(child, place.depth + 1, tuple(sorted(steps)), place.counted)
        elif isinstance(node, Or):
            yield _Place(child, place.depth + 1, place.steps, counted=False)


def witness_steps(
    node: Formula, step: int, values: Mapping[Formula, Shares], *, weighted: bool = False
) -> Iterator[tuple[int, int]]:
    """Which children, at which steps, the fraction of a node at a step is the mean or maximum of.

    Of alternatives only the best is named, the first of them where several are. If `weighted`, the
    values are preferences.
    """
    below = [values[child] for child in node.children]
    if isinstance(node, And):
        yield from ((number, step) for number in range(len(below)))
    elif isinstance(node, Or):
        each = portions(node, weighted=weighted)
        yield max(range(len(below)), key=lambda at: below[at][step].scaled(each[at])), step
    elif isinstance(node, Always):
        yield from ((0, later) for later in range(step + node.low, step + node.high + 1))
    elif isinstance(node, Eventually):
        each, first = portions(node, weighted=weighted), step + node.low
        window = range(first, step + node.high + 1)
        yield 0, max(window, key=lambda later: below[0][later].scaled(each[later - first]))
    elif isinstance(node, Until):
        each = portions(node, weighted=weighted)
        switch, _ = max(changes(node, step, below, each), key=lambda change: change[1])
        yield from ((0, later) for later in range(step, switch))
        yield 1, switch


def satisfied(tree: Formula, trace: Trace) -> tuple[Pair, ...]:
    """The pairs that hold and that a tree's preference is made of, the topmost ones alone.

    Whatever makes all of them hold has at least the same preference. Of alternatives that count
    differently, the one is named that holds.
    """
    values = shares(tree, trace, weighted=True)
    settled = fold_all(tree, _is_settled)
    found: list[Pair] = []
    seen: set[Pair] = {(tree, 0)}
    stack: list[Pair] = [(tree, 0)]
    while stack:
        node, step = stack.pop()
        if settled[node] and values[node][step].fraction == 1:
            found.append((node, step))
            continue
        for number, later in witness_steps(node, step, values, weighted=True):
            pair = (node.children[number], later)
            if pair not in seen:
                seen.add(pair)
                stack.append(pair)
    return tuple(found)


def is_settled(tree: Formula) -> bool:
    """Whether a tree has the preference 1 wherever it holds, since no alternative counts less.

    >>> from tsplan.logic import parse
    >>> [is_settled(parse(text, "wmtl")) for text in ("F[0,2] (a &&^[1, 2] b)", "a ||^[1, 2] b")]
    [True, False]
    """
    return fold(tree, _is_settled)


def _is_settled(node: Formula, below: tuple[bool, ...]) -> bool:
    """Whether a formula has the preference 1 wherever it holds."""
    return all(below) and (isinstance(node, And | Always) or is_even(node))


def demanded(pairs: Iterable[Pair]) -> Formula:
    """The formula that holds at step 0 exactly where all pairs hold, simplified.

    >>> from tsplan.logic import parse
    >>> print(demanded([(parse("a"), 2), (parse("b"), 0), (parse("a"), 3)]))
    G[2,3] a && b
    """
    steps: dict[Formula, list[int]] = {}
    for node, step in pairs:
        steps.setdefault(node, []).append(step)
    return simplify(
        conjunction(
            Always(first, last, node)
            for node, times in steps.items()
            for first, last in _runs(sorted(set(times)))
        )
    )


def _runs(steps: list[int]) -> Iterator[tuple[int, int]]:
    """Consecutive steps, as first and last of each run."""
    begin = 0
    for place in range(1, len(steps) + 1):
        if place == len(steps) or steps[place] != steps[place - 1] + 1:
            yield steps[begin], steps[place - 1]
            begin = place


class Occurrence(NamedTuple):
    """A sub-formula where it stands in a tree, and every step at which it may matter.

    `parent` is the number of its parent's occurrence, -1 for the root, and `child` its place there.
    """

    node: Formula
    depth: int
    parent: int
    child: int
    steps: tuple[int, ...]


def occurrences(tree: Formula) -> list[Occurrence]:
    """Every place in a tree, parents first; what counts as a whole has no places below.

    Raises ValueError for a tree with more than `MOST_PAIRS` pairs.
    """
    found = [Occurrence(tree, 0, -1, 0, (0,))]
    pairs = 1
    for number, occurrence in enumerate(found):  # it grows while it is walked
        whole = isinstance(occurrence.node, Whole)
        for child, below in enumerate(() if whole else occurrence.node.children):
            steps = {
                later for step in occurrence.steps for later in reach(occurrence.node, child, step)
            }
            pairs += len(steps)
            if pairs > MOST_PAIRS:
                raise ValueError(
                    f"the formula has more than {MOST_PAIRS:,} parts at their steps; "
                    "ask for the weighted order"
                )
            if steps:
                found.append(
                    Occurrence(below, occurrence.depth + 1, number, child, tuple(sorted(steps)))
                )
    return found


def reach(node: Formula, child: int, step: int) -> range:
    """The steps at which a child may matter to its parent at `step`."""
    first, last = lookahead(node)[child]
    return range(step + first, step + last + 1)


class Levels(NamedTuple):
    """How many pairs of each depth hold without any of their ancestors, and which they are.

    `spare` is the least robustness of these, infinite where there are none.
    """

    counts: tuple[int, ...]
    pairs: tuple[Pair, ...]
    spare: float


def levels(tree: Formula, trace: Trace) -> Levels:
    """The pairs of a tree that hold while no ancestor of theirs does, counted by depth.

    A pair's ancestors are all pairs of the tree in whose windows it lies. Two places in the tree
    count apart even where the same formula stands there.
    """
    values = shares(tree, trace)
    everywhere = occurrences(tree)
    counts = [0] * (1 + max(occurrence.depth for occurrence in everywhere))
    pairs: dict[Pair, None] = {}
    covered: list[set[int]] = []
    for occurrence in everywhere:
        above = _covered_from_above(occurrence, everywhere, covered)
        held = {step for step in occurrence.steps if values[occurrence.node][step].fraction == 1}
        topmost = held - above
        counts[occurrence.depth] += len(topmost)
        pairs.update(((occurrence.node, step), None) for step in sorted(topmost))
        covered.append(held | above)
    spare = min((values[node][step].spare for node, step in pairs), default=inf)
    return Levels(tuple(counts), tuple(pairs), spare)


def _covered_from_above(
    occurrence: Occurrence, everywhere: list[Occurrence], covered: list[set[int]]
) -> set[int]:
    """Steps of a occurrence that lie in the window of a pair that is covered itself."""
    if occurrence.parent < 0:
        return set()
    parent = everywhere[occurrence.parent].node
    return {
        later
        for step in covered[occurrence.parent]
        for later in reach(parent, occurrence.child, step)
    }
