"""The atoms that a plan's availability hangs on: where the minima and maxima are attained."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from tsplan.explanation.whynot.occurrences import Leaf, Way, monotone
from tsplan.logic import (
    Always,
    Count,
    Eventually,
    Formula,
    Limit,
    Release,
    Task,
    Until,
    capabilities,
    robustness,
    translate,
)
from tsplan.logic.evaluation import CountTrace
from tsplan.plans.presence import counted

if TYPE_CHECKING:
    import numpy.typing as npt

    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

MOST_ATOMS = 20
"""Atoms that are listed."""


@dataclass(frozen=True, slots=True)
class Critical:
    """An atom with no more to spare than the whole formula, with states and runs of steps.

    `atom` is None for a part of the formula that is not looked into, `count` the agents there.
    """

    leaf: Leaf
    atom: Count | None
    place: str
    count: int
    steps: tuple[tuple[int, int], ...]


def critical_atoms(mission: Mission, plan: Plan) -> tuple[Critical, ...]:
    """What keeps the availability of this plan from being higher, in the order of the text."""
    return _Search(mission, plan).found()


class _Search:
    """Descends from the root to the atoms where its value comes from."""

    def __init__(self, mission: Mission, plan: Plan) -> None:
        self._mission = mission
        self._states = tuple(mission.system.states)
        row = {state: number for number, state in enumerate(self._states)}
        labels = {
            label: np.array([row[state] for state in members], dtype=np.int64)
            for label, members in mission.system.labels.items()
        }
        formula = translate(mission.formula, interval=mission.task_interval)
        counts = {
            name: counted(plan, self._states, name)
            for name in (None, *sorted(capabilities(formula)))
        }
        self._counts = counts
        self._trace = CountTrace(counts, labels)
        self._values: dict[Formula, npt.NDArray[np.float64]] = {}
        self._steps: dict[tuple[Leaf, Count | None, str, int], set[int]] = {}
        self._level = float(self._value(mission.formula)[0])

    def found(self) -> tuple[Critical, ...]:
        """All critical atoms."""
        open_: list[tuple[Way, Formula, int]] = [((), self._mission.formula, 0)]
        seen = set(open_)
        while open_:
            way, node, step = open_.pop()
            if not monotone(node):
                self._note(way, node, step)
                continue
            for number, later in self._deciding(node, step):
                item = ((*way, number), node.children[number], later)
                if item not in seen:
                    seen.add(item)
                    open_.append(item)
        listed = [
            Critical(leaf, atom, place, count, _runs(steps))
            for (leaf, atom, place, count), steps in self._steps.items()
        ]
        listed.sort(key=lambda item: (item.leaf.way, item.leaf.pair or 0, item.steps, item.place))
        return tuple(listed[:MOST_ATOMS])

    def _value(self, node: Formula) -> npt.NDArray[np.float64]:
        if node not in self._values:
            plain = translate(node, interval=self._mission.task_interval)
            self._values[node] = np.asarray(robustness(plain, self._trace), dtype=np.float64)
        return self._values[node]

    def _deciding(self, node: Formula, step: int) -> list[tuple[int, int]]:
        """Children and steps at which the value of a node is attained."""
        children = node.children
        if isinstance(node, Always | Eventually):
            span = range(step + node.low, step + node.high + 1)
            here = [(0, k) for k in span if self._value(children[0])[k] == self._level]
            return here if isinstance(node, Always) else here[:1]
        if isinstance(node, Until | Release):
            return self._switching(node, step)
        return [
            (number, step)
            for number, child in enumerate(children)
            if self._value(child)[step] == self._level
        ]

    def _switching(self, node: Until | Release, step: int) -> list[tuple[int, int]]:
        """The step at which an until (or a release) changes over, and what decides there."""
        right = self._value(node.children[1])
        # for no step the left side is never asked, and plans need not be long enough for it
        left = self._value(node.children[0]) if node.high else right
        found = []
        for change in range(step + node.low, step + node.high + 1):
            parts = [(0, k) for k in range(step, change)] + [(1, change)]
            values = [(left if side == 0 else right)[k] for side, k in parts]
            best = min(values) if isinstance(node, Until) else max(values)
            if best == self._level:
                here = [p for p, v in zip(parts, values, strict=True) if v == self._level]
                if isinstance(node, Until):
                    return here
                found += here[:1]
        return found

    def _note(self, way: Way, node: Formula, step: int) -> None:
        """Keep an atom with the states that decide; other leaves as they are."""
        atoms = _atoms(node, self._mission.task_interval == "half-open")
        if atoms is None:
            self._steps.setdefault((Leaf(way), None, "", 0), set()).add(step)
            return
        for pair, (atom, lasts) in enumerate(atoms):
            leaf = Leaf(way, pair if len(atoms) > 1 else None)
            for later in range(step, step + lasts + 1):
                if self._value(atom)[later] == self._level:
                    self._at_states(leaf, atom, later)

    def _at_states(self, leaf: Leaf, atom: Count, step: int) -> None:
        members = self._mission.system.labels[atom.label]
        table = self._counts[atom.capability]
        present = [int(table[self._states.index(state), step]) for state in members]
        if atom.function == "sum":
            key = (leaf, atom, f"'{atom.label}'", sum(present))
            self._steps.setdefault(key, set()).add(step)
            return
        deciding = min(present) if atom.function == "min" else max(present)
        for state, count in zip(members, present, strict=True):
            if count == deciding:
                self._steps.setdefault((leaf, atom, f"'{state}'", count), set()).add(step)


def _atoms(node: Formula, half_open: bool) -> list[tuple[Count, int]] | None:
    """The counts that a leaf means and for how many steps more; None for other leaves."""
    if isinstance(node, Task):
        lasts = node.duration - half_open
        return [(Count("min", node.label, name, ">=", m), lasts) for name, m in node.needs]
    if isinstance(node, Limit):
        needs = node.needs or ((None, 0),)
        return [(Count("max", node.label, name, "<=", m), 0) for name, m in needs]
    if isinstance(node, Count) and node.relation in (">=", "<="):
        return [(node, 0)]
    return None


def _runs(steps: set[int]) -> tuple[tuple[int, int], ...]:
    """Steps that follow each other, as (first, last)."""
    runs: list[list[int]] = []
    for step in sorted(steps):
        if runs and runs[-1][1] == step - 1:
            runs[-1][1] = step
        else:
            runs.append([step, step])
    return tuple((first, last) for first, last in runs)
