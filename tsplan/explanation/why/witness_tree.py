"""Why a plan satisfies its formula: the formula as a tree, with what settles each of its nodes.

The tree is that of the formula as it was written; a task or limit has the counts it stands for
below it. All values come from the evaluator and the counts of the plan.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.checking.fitting import refuse_misfit
from tsplan.explanation.why.requirements import measured, trace_of
from tsplan.logic.atoms import Count, Limit, Task
from tsplan.logic.catl import resolve_percent, translate
from tsplan.logic.causes import NO_STEPS, NONE, Steps, Values, cause_of, settled
from tsplan.logic.evaluation import margins
from tsplan.logic.nodes import And, Formula, Implies, Or
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
    `availability` its robustness at each of them. `chosen` has, for each of these steps, the step
    that a temporal operator rests on: where an eventuality is met first and best, where an `always`
    is tightest, where an until changes over or a release sets free; None where there is none. A
    node that is not `needed` is a branch that nothing rests on, judged where its parent is (or
    nowhere, then `steps` is empty). For counts, `present` says who was there at the tightest step.
    """

    formula: Formula
    meaning: Formula
    steps: tuple[int, ...]
    availability: tuple[float, ...]
    chosen: tuple[int | None, ...] = ()
    needed: bool = True
    counts: tuple[int, ...] = ()
    present: tuple[Presence, ...] = ()
    children: tuple[WitnessNode, ...] = field(default=(), repr=False)

    @cached_property
    def tightest(self) -> int | None:
        """The earliest judged step with the least availability."""
        if not self.steps:
            return None
        return self.steps[int(np.argmin(self.availability))]

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
        from tsplan.explanation.why.witness_text import tree_text  # noqa: PLC0415  (imports this module)

        return tree_text(self)


def explain(plan: Plan, mission: Mission) -> WitnessNode:
    """Why the plan satisfies the formula, or why it does not.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    return _Explaining(plan, mission, mission.formula).tree()


def explain_preferred(plan: Plan, mission: Mission) -> dict[str, WitnessNode]:
    """The same for each formula that the mission prefers, by its name.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    return {wish.name: _Explaining(plan, mission, wish.formula).tree() for wish in mission.prefer}


class _Place(NamedTuple):
    """A node with the steps it is asked for; equal places have equal evidence."""

    formula: Formula
    steps: tuple[int, ...]
    needed: bool


class _Explaining:
    """The explanation of one formula; built without recursion, since formulas may be deep."""

    def __init__(self, plan: Plan, mission: Mission, formula: Formula) -> None:
        self._plan = plan
        self._meaning = meanings(mission, formula)
        goal = self._meaning[formula]
        self._root = formula
        self._trace = trace_of(plan, mission, goal)
        self._margins = margins(goal, self._trace)
        self._carriers = mission.system.labels

    def tree(self) -> WitnessNode:
        """The evidence of every place, children before their parents."""
        done: dict[_Place, WitnessNode] = {}
        below: dict[_Place, tuple[_Place, ...]] = {}
        top = _Place(self._root, (0,), needed=True)
        waiting = [top]
        while waiting:
            place = waiting[-1]
            if place not in below:
                below[place] = self._below(place)
                waiting += (p for p in below[place] if p not in done)
                continue
            waiting.pop()
            if place not in done:
                done[place] = self._evidence(place, tuple(done[p] for p in below[place]))
        return done[top]

    def _below(self, place: _Place) -> tuple[_Place, ...]:
        """The places below a place."""
        node, steps = place.formula, _array(place.steps)
        if isinstance(node, Task | Limit):
            used = settled(self._meaning[node], steps, self._margins)
            atoms = [part for part in walk(self._meaning[node]) if isinstance(part, Count)]
            return tuple(_Place(atom, _tuple(used[atom]), place.needed) for atom in atoms)
        made = []
        for child, wanted in zip(node.children, self._wanted(node, steps), strict=True):
            needed = place.needed and bool(wanted.size)
            # a branch that was not taken is judged where it was offered
            offered = not wanted.size and isinstance(node, And | Or | Implies)
            made.append(_Place(child, _tuple(steps if offered else wanted), needed))
        return tuple(made)

    def _wanted(self, node: Formula, steps: Steps) -> tuple[Steps, ...]:
        """The steps at which each child, as written, settles a node."""
        if not node.children:
            return ()
        if not steps.size:
            return tuple(NO_STEPS for _ in node.children)
        return cause_of(self._meaning[node], steps, self._margins).below

    def _evidence(self, place: _Place, children: tuple[WitnessNode, ...]) -> WitnessNode:
        node = place.formula
        meaning = self._meaning.get(node, node)
        steps = _array(place.steps)
        values = self._margins[meaning][steps]
        chosen: tuple[int | None, ...] = ()
        if node.children and steps.size:
            found = cause_of(meaning, steps, self._margins).chosen
            if found is not None:
                chosen = tuple(None if step == NONE else step for step in found.tolist())
        atom = meaning if isinstance(meaning, Count) else None
        return WitnessNode(
            formula=node,
            meaning=meaning,
            steps=place.steps,
            availability=tuple(values.tolist()),
            chosen=chosen,
            needed=place.needed,
            counts=_tuple(measured(atom, self._trace)[steps]) if atom is not None else (),
            present=self._present(atom, steps, values) if atom is not None else (),
            children=children,
        )

    def _present(self, atom: Count, steps: Steps, values: Values) -> tuple[Presence, ...]:
        """Who is at the states with an atom's label at its tightest step."""
        if not steps.size:
            return ()
        step = int(steps[int(np.argmin(values))])
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


def _array(steps: tuple[int, ...]) -> Steps:
    return np.array(steps, dtype=np.int64)


def _tuple(steps: Steps) -> tuple[int, ...]:
    return tuple(steps.tolist())
