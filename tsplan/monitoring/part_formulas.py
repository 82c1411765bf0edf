"""The parts of a mission that are told of one by one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from tsplan.logic import And, Formula, positive, resolve_percent, simplify
from tsplan.mission import Mission


@dataclass(frozen=True)
class MissionPart:
    """A part as it is written, and what it asks of counts, in positive normal form."""

    text: str
    goal: Formula
    required: bool = True


def parts_of(mission: Mission) -> tuple[MissionPart, ...]:
    """What the mission's formula asks for together, and what is preferred, in their order."""
    parts = [MissionPart(str(node), _goal(mission, node)) for node in _conjuncts(mission.formula)]
    wishes = [
        MissionPart(each.name, _goal(mission, each.formula), False) for each in mission.prefer
    ]
    return (*parts, *wishes)


def _conjuncts(formula: Formula) -> Iterator[Formula]:
    waiting = [formula]
    while waiting:
        node = waiting.pop()
        if isinstance(node, And):
            waiting += reversed(node.children)
        else:
            yield node


def _goal(mission: Mission, formula: Formula) -> Formula:
    counted = mission.translated(formula)
    if mission.swarm is not None:
        counted = resolve_percent(counted, mission.having)
    return simplify(positive(counted))
