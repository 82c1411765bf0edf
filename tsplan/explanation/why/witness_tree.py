"""Why a plan satisfies its formula: the formula as a tree, with what settles each of its nodes.

The tree is that of the formula as it was written; a task or limit has the counts it stands for
below it. All values come from the evaluator and the counts of the plan.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.checking.fitting import refuse_misfit
from tsplan.explanation.why.requirements import measured, trace_of
from tsplan.explanation.why.witness_text import tree_text
from tsplan.logic.atoms import Count, Limit, Task
from tsplan.logic.catl import resolve_percent, translate
from tsplan.logic.causes import NO_STEPS, NONE, Steps, Values, cause_of
from tsplan.logic.evaluation import margins
from tsplan.logic.nodes import And, Formula, Implies, Or
from tsplan.logic.obligations import Obligation, obligations
from tsplan.logic.traversal import walk

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

MOST_IDS = 4
"""Agents that are named at one state; more are only counted."""


@dataclass(frozen=True, slots=True)
class Presence:
    """Agents at one state: how many, and the first few of them."""

    state: str
    count: int
    ids: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class WitnessNode:
    """One node of the formula, where it stands, and what settles it there.

    `steps` are those at which it is judged because the nodes above it rest on it there, and
    `availability` its robustness at each of them. `witness_steps` has, for each of these, the step
    that a temporal operator rests on: where an eventuality is met first and best, where an `always`
    is tightest, where an until changes over or a release sets free; None where there is none. A
    node that is not `needed` is a branch that nothing rests on, judged where its parent is (or
    nowhere, then `steps` is empty). For counts, `present` says who was there at the tightest step.
    """

    formula: Formula
    meaning: Formula
    steps: tuple[int, ...]
    availability: tuple[float, ...]
    witness_steps: tuple[int | None, ...] = ()
    needed: bool = True
    counts: tuple[int, ...] = ()
    present: tuple[Presence, ...] = ()
    children: tuple[WitnessNode, ...] = field(default=(), repr=False)

    @cached_property
    def tightest(self) -> int | None:
        """The earliest judged step with the least availability."""
        return _tightest(self.steps, self.availability)

    @property
    def worst(self) -> float | None:
        """The least availability over the judged steps; None if there are none."""
        return min(self.availability, default=None)

    @property
    def holds(self) -> bool | None:
        """Whether it holds at all judged steps; None if there are none."""
        return None if self.worst is None else self.worst >= 0

    def walk(self) -> Iterator[tuple[int, WitnessNode]]:
        """Every node with its depth, from the top, in the order of the text."""
        waiting = [(0, self)]
        while waiting:
            depth, node = waiting.pop()
            yield depth, node
            waiting += ((depth + 1, child) for child in reversed(node.children))

    def __str__(self) -> str:
        """The tree, one node a line."""
        return tree_text(self)


def _tightest(steps: tuple[int, ...], availability: Sequence[float] | Values) -> int | None:
    """The earliest of some steps with the least availability; None if there are none."""
    return steps[int(np.argmin(availability))] if steps else None


def explain(plan: Plan, mission: Mission) -> WitnessNode:
    """Why the plan satisfies the formula, or why it does not.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    return _Builder(plan, mission, mission.formula).tree()


def explain_preferred(plan: Plan, mission: Mission) -> dict[str, WitnessNode]:
    """The same for each formula that the mission prefers, by its name.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    return {soft.name: _Builder(plan, mission, soft.formula).tree() for soft in mission.prefer}


class _Place(NamedTuple):
    """A formula with the steps it is asked for; equal places have equal witness nodes."""

    formula: Formula
    steps: tuple[int, ...]
    needed: bool


class _Builder:
    """Makes the tree of one formula; without recursion, since formulas may be deep."""

    def __init__(self, plan: Plan, mission: Mission, formula: Formula) -> None:
        self._plan = plan
        self._meaning = meanings(mission, formula)
        self._top = _Place(formula, (0,), needed=True)
        self._trace = trace_of(plan, mission, self._meaning[formula])
        self._margins = margins(self._meaning[formula], self._trace)
        self._carriers = mission.system.labels

    def tree(self) -> WitnessNode:
        """The node of every place, children before their parents."""
        done: dict[_Place, WitnessNode] = {}
        below: dict[_Place, tuple[_Place, ...]] = {}
        waiting = [self._top]
        while waiting:
            place = waiting[-1]
            if place not in below:
                below[place] = self._below(place)
                waiting += (child for child in below[place] if child not in done)
                continue
            waiting.pop()
            if place not in done:
                done[place] = self._node(place, tuple(done[child] for child in below[place]))
        return done[self._top]

    def _below(self, place: _Place) -> tuple[_Place, ...]:
        """The places below a place."""
        node, steps = place.formula, np.array(place.steps, dtype=np.int64)
        if isinstance(node, Task | Limit):
            owed = obligations(self._meaning[node], Obligation(None, steps), self._margins)
            counts = (
                (part, one.steps) for (part, _), one in owed.items() if isinstance(part, Count)
            )
            return tuple(_Place(atom, tuple(at.tolist()), place.needed) for atom, at in counts)
        # where nobody asks for a node, nothing below it settles anything
        wanted = [NO_STEPS] * len(node.children)
        if node.children and steps.size:
            wanted = [*cause_of(self._meaning[node], steps, self._margins).below]
        made = []
        for child, own in zip(node.children, wanted, strict=True):
            # a branch that was not taken is judged where it was offered
            offered = not own.size and isinstance(node, And | Or | Implies)
            judged = place.steps if offered else tuple(own.tolist())
            made.append(_Place(child, judged, place.needed and bool(own.size)))
        return tuple(made)

    def _node(self, place: _Place, children: tuple[WitnessNode, ...]) -> WitnessNode:
        meaning = self._meaning.get(place.formula, place.formula)
        steps = np.array(place.steps, dtype=np.int64)
        values = self._margins[meaning][steps]
        rests: Steps | None = None
        if place.formula.children and steps.size:
            rests = cause_of(meaning, steps, self._margins).witness_steps
        chosen = () if rests is None else rests.tolist()
        atom = meaning if isinstance(meaning, Count) else None
        return WitnessNode(
            formula=place.formula,
            meaning=meaning,
            steps=place.steps,
            availability=tuple(values.tolist()),
            witness_steps=tuple(None if step == NONE else step for step in chosen),
            needed=place.needed,
            counts=() if atom is None else tuple(measured(atom, self._trace)[steps].tolist()),
            present=()
            if atom is None
            else self._present(atom, _tightest(place.steps, values.tolist())),
            children=children,
        )

    def _present(self, atom: Count, step: int | None) -> tuple[Presence, ...]:
        """Who is at the states with an atom's label at a step; nobody if there is none."""
        if step is None:
            return ()
        states = self._carriers[atom.label]
        counts = self._trace.at(atom.label, atom.capability)[:, step].astype(np.int64).tolist()
        ids: dict[str | None, list[str]] = {state: [] for state in states}
        for bundle in self._plan.bundles:
            if atom.capability is None or atom.capability in bundle.capabilities:
                agents = self._plan.agents
                known = ids.get(agents[bundle.agents[0]].state_at(step), [])
                known += (agents[place].id for place in bundle.agents[: MOST_IDS - len(known)])
        return tuple(
            Presence(state, count, tuple(ids[state]))
            for state, count in zip(states, counts, strict=True)
        )


def meanings(mission: Mission, formula: Formula) -> Mapping[Formula, Formula]:
    """What each sub-formula of a mission's formula as written says in counts and numbers alone."""
    found: dict[Formula, Formula] = {}
    for node in walk(formula):
        if node.children:
            found[node] = node.over(found[child] for child in node.children)
            continue
        plain = translate(node, interval=mission.task_interval)
        found[node] = resolve_percent(plain, mission.having)
    return found
