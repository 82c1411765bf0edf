"""The atoms that a plan's availability hangs on: where the minima and maxima are attained.

They are read off the witness tree: of what settles the formula, what has no more to spare than the
whole. Of several parts of an `or` that would do, the tree rests on the first.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from tsplan.explanation.why.requirements import runs, trace_of
from tsplan.explanation.why.witness_tree import explain
from tsplan.explanation.whynot.occurrences import Occurrence, Way, monotone, numbered_counts

if TYPE_CHECKING:
    from tsplan.explanation.why.witness_tree import WitnessNode
    from tsplan.logic import Count
    from tsplan.logic.time_horizon import Span
    from tsplan.logic.traces import CountTrace
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

MOST_ATOMS = 20
"""Atoms that are listed."""


@dataclass(frozen=True, slots=True)
class CriticalAtom:
    """An atom with no more to spare than the whole formula, with states and runs of steps.

    `atom` is None for a part of the formula that is not looked into, `count` the agents there.
    """

    occurrence: Occurrence
    atom: Count | None
    place: str
    count: int
    steps: tuple[Span, ...]


def critical_atoms(mission: Mission, plan: Plan) -> tuple[CriticalAtom, ...]:
    """What keeps the availability of this plan from being higher, in the order of the text."""
    top = explain(plan, mission)
    trace = trace_of(plan, mission, top.meaning)
    found: dict[tuple[Occurrence, Count | None, str, int], set[int]] = {}
    for occurrence, atom, node in settling(top):
        for step, value in zip(node.steps, node.availability, strict=True):
            if value == top.worst:
                for place, count in _places(mission, trace, atom, step):
                    found.setdefault((occurrence, atom, place, count), set()).add(step)
    listed = [
        CriticalAtom(*key, runs(np.array(sorted(steps), dtype=np.int64)))
        for key, steps in found.items()
    ]
    listed.sort(key=lambda c: (c.occurrence.way, c.occurrence.need or 0, c.steps, c.place))
    return tuple(listed[:MOST_ATOMS])


def settling(top: WitnessNode) -> Iterator[tuple[Occurrence, Count | None, WitnessNode]]:
    """The nodes that the formula rests on at which the descent ends, and the counts they are."""
    open_: list[tuple[Way, WitnessNode]] = [((), top)]
    while open_:
        way, node = open_.pop()
        if not node.needed:
            continue
        if monotone(node.formula):
            open_ += (((*way, number), child) for number, child in enumerate(node.children))
            continue
        atoms = {count: occurrence for occurrence, count in numbered_counts(node.formula, way)}
        atoms = {count: part for count, part in atoms.items() if count.relation in (">=", "<=")}
        if not atoms:
            yield Occurrence(way), None, node
        for child in node.children or (node,):
            if child.formula in atoms:
                yield atoms[child.formula], child.formula, child


def _places(
    mission: Mission, trace: CountTrace, atom: Count | None, step: int
) -> Iterator[tuple[str, int]]:
    """The label or the states that decide an atom at a step, with the agents there."""
    if atom is None:
        yield "", 0
        return
    there = trace.at(atom.label, atom.capability, upper=atom.upper)
    present = there[:, step].astype(int).tolist()
    if atom.function == "sum":
        yield f"'{atom.label}'", sum(present)
        return
    deciding = min(present) if atom.function == "min" else max(present)
    for state, count in zip(mission.system.labels[atom.label], present, strict=True):
        if count == deciding:
            yield f"'{state}'", count
