"""How many agents are short at least, and where, in one program: its first plan says it at once.

Every way to have more agents, or to ask for fewer, gets helpers of its own: robots that wait in a
depot beside the map, and of which as few as possible leave it. Helpers of a part of the team are
robots like it that start where it does. Helpers of a need have a capability that is asked for by
this need alone, and which everybody has who has the one that it asks for in the mission.

What is found is a guess: other questions prove it.

Source: the idea of elastic programs, J. Chinneck, "Feasibility and Infeasibility in Optimization"
(2008), chapter 6, and of the first phase of the simplex method; helpers are the columns that
stretch the rows, so that all that is known of agents still holds of them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from tsplan.encode.expressions import Expression
from tsplan.errors import MissionError
from tsplan.explanation.explanation import PartKind, SoftConstraint
from tsplan.explanation.whynot.occurrences import exchanged, node_at
from tsplan.explanation.whynot.relaxing import relaxed
from tsplan.logic import Count, Formula, Limit, Task, fold
from tsplan.mission import Group
from tsplan.run.events import Event, Incumbent
from tsplan.run.problem import Problem

if TYPE_CHECKING:
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.mission import Mission

_ANYBODY = "anybody"


@dataclass(frozen=True)
class Shortage:
    """The problem of the least number of helpers; each edit's helpers wait in one depot."""

    problem: Problem
    edits: tuple[Edit, ...]
    depots: tuple[tuple[str, int], ...]

    def enough(self, event: Event) -> bool:
        """Whether a plan with a single helper is known: with fewer there is none."""
        total = sum(count for _, count in self.depots)
        return isinstance(event, Incumbent) and (event.objective or 0) >= total - 1

    def steps(self, plan: Any) -> list[tuple[Edit, int]]:
        """How far each edit goes by a plan of the problem, as many helpers as left their depot."""
        left = plan.counts(states=[name for name, _ in self.depots])[:, -1].tolist()
        gone = [count - int(stay) for (_, count), stay in zip(self.depots, left, strict=True)]
        found = zip(self.edits, gone, strict=True)
        return [(edit, min(number, edit.most)) for edit, number in found if number]


def least_shortage(mission: Mission, edits: Sequence[Edit]) -> Shortage | None:
    """The problem of the fewest helpers over some edits; None where helpers are not told apart."""
    simple = mission.swarm is None and not mission.modular and not mission.resources
    if not edits or not simple or mission.books:
        return None
    helped = _named(mission)
    helpers: list[Group] = []
    dropped: list[tuple[PartKind, ...]] = []
    for number, edit in enumerate(edits):
        kind, key = edit.number
        if kind == "agents":
            helpers.append(replace(helped.team[key[0]], starts=((key[1], 1),), coming=()))
            dropped.append(("team",))
        else:
            helped, helper = _helper(helped, key, f"help {number}")
            helpers.append(helper)
            dropped.append(("team", "start"))
    first = len(helped.team)
    gone = [
        SoftConstraint(kind, (first + number,))
        for number, kinds in enumerate(dropped)
        for kind in kinds
    ]
    try:
        crowded = replace(helped, team=(*helped.team, *helpers))
    except MissionError:  # not all of them can start at the states of their edits
        return None
    problem = relaxed(crowded, gone)
    assert isinstance(problem, Problem)
    depots = tuple(group.starts[0] for group in problem.mission.team[first:])
    last = problem.mission.horizon
    problem.maximise(sum((problem.count(name, step=last) for name, _ in depots), Expression()))
    return Shortage(problem, tuple(edits), depots)


def _named(mission: Mission) -> Mission:
    """The mission in which whoever counts has a capability for it, so that helpers need not."""

    def named(node: Formula, below: tuple[Formula, ...]) -> Formula:
        if isinstance(node, Count) and node.capability is None:
            return replace(node, capability=_ANYBODY)
        if isinstance(node, Limit) and not node.needs:
            return Count("max", node.label, _ANYBODY, "<=", 0)
        return node.over(below) if below else node

    return _of(mission, fold(mission.formula, named), {_ANYBODY: None})


def _of(mission: Mission, formula: Formula, names: Mapping[str, str | None]) -> Mission:
    """The mission with another formula and new capabilities, of those who have another one."""
    team = [
        replace(group, capabilities=group.capabilities.union(new))
        for group in mission.team
        for new in [[name for name, old in names.items() if old in (None, *group.capabilities)]]
    ]
    return replace(mission, formula=formula, text=str(formula), team=tuple(team), warnings=())


def _helper(mission: Mission, key: tuple[Any, ...], name: str) -> tuple[Mission, Group]:
    """The mission in which a need asks for a capability of its own, and who else has it."""
    way, field = key
    node: Any = node_at(mission.formula, way)
    if isinstance(node, Task):
        needs = list(node.needs)
        old, amount = needs[field]
        needs[field] = (name, amount)
        node = replace(node, needs=tuple(needs))
    else:
        old = node.capability
        node = replace(node, capability=name)
    (state, *_) = mission.system.labels[node.label]
    mission = _of(mission, exchanged(mission.formula, {way: node}), {name: old})
    return mission, Group(name, frozenset({name}), ((state, 1),))
