"""What a plan file says of swarms: their moves and their sub-swarms."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from tsplan.plans.moves import Move
from tsplan.plans.subswarms import SubSwarm

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tsplan.plans.plan import Plan
    from tsplan.plans.plan_schema import PlanFile


def moves_text(plan: Plan) -> str:
    """The moves of every swarm as JSON, one a line."""
    swarms = (f"{_dumped(name)}: {_lines(moves)}" for name, moves in plan.moves.items())
    return "{" + ",\n  ".join(swarms) + "}"


def groups_text(plan: Plan) -> str:
    """The sub-swarms as JSON, one a line."""
    return _lines(_entry(group) for group in plan.groups)


def _entry(group: SubSwarm) -> dict[str, Any]:
    place = {"edge": group.edge} if group.edge is not None else {"state": group.state}
    return {
        "id": group.id,
        "swarm": group.swarm,
        "from": group.first,
        "to": group.last,
        **place,
        "size": group.size,
        "parents": group.parents,
        "children": group.children,
    }


def _lines(values: Iterable[Any]) -> str:
    return "[\n  " + ",\n  ".join(_dumped(value) for value in values) + "]"


def _dumped(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def moves_of(file: PlanFile) -> dict[str, tuple[Move, ...]]:
    """The moves of a valid file, sorted."""
    return {
        swarm: tuple(sorted(Move(*move) for move in moves)) for swarm, moves in file.moves.items()
    }


def groups_of(file: PlanFile) -> tuple[SubSwarm, ...]:
    """The sub-swarms of a valid file."""
    return tuple(
        SubSwarm(
            entry.id,
            entry.swarm,
            entry.first,
            entry.last,
            entry.size,
            entry.state,
            entry.edge,
            tuple(entry.parents),
            tuple(entry.children),
        )
        for entry in file.groups
    )
