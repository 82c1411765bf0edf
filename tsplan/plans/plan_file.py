"""Plans as `tsplan-plan/1` JSON, both ways."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from tsplan.document.files import beginning, read_text, write_whole
from tsplan.errors import InputError, PlanError
from tsplan.plans.plan import Plan
from tsplan.plans.plan_text import FORMAT, located, plan_data, refuse_other, spelled
from tsplan.plans.records import plain

LARGEST_PLAN = 1024**3  # bytes; a path takes some hundred
_GLANCE = 4096  # bytes by which a file that is no plan is known


def plan_to_json(plan: Plan) -> str:
    """The plan as JSON text, one top-level key, agent, move and sub-swarm a line."""
    first = {"format": FORMAT, "status": plan.status, "stopped_by": plan.stopped_by}
    entries = {**first, **plan.data()}
    large: Mapping[str, Callable[[Plan], str]] = {
        "moves": _moves,
        "groups": lambda plan: _lines(map(_text, plan.groups)),
        "agents": _agents,
    }
    lines = (
        f"{json.dumps(key)}: {large[key](plan) if key in large else _text(value)}"
        for key, value in entries.items()
    )
    return "{" + ",\n ".join(lines) + "}\n"


def _text(value: Any) -> str:
    return json.dumps(plain(value), ensure_ascii=False, allow_nan=False, default=str)


def _lines(values: Iterable[str]) -> str:
    return "[\n  " + ",\n  ".join(values) + "]"


def _moves(plan: Plan) -> str:
    """The moves of every swarm, one a line."""
    swarms = (f"{_text(name)}: {_lines(map(_text, moves))}" for name, moves in plan.moves.items())
    return "{" + ",\n  ".join(swarms) + "}"


def _agents(plan: Plan) -> str:
    """The list of agents; what agents on one path have in common is made only once."""
    lines = [""] * len(plan.agents)
    for bundle in plan.bundles:
        common = plan.agents[bundle.agents[0]].data()
        del common["id"]
        tail = _text({key: plain(value) for key, value in common.items()})[1:]
        for place in bundle.agents:
            lines[place] = f'{{"id": {json.dumps(plan.agents[place].id)}, {tail}'
    return _lines(lines)


@cache
def _reader() -> TypeAdapter[Plan]:
    return TypeAdapter(Plan)


def plan_from_json(text: str, source: str = "plan") -> Plan:
    """Read a plan; raises PlanError with every finding for a text that is not one.

    Equal paths become one object, which makes grouping cheap.
    """
    text = text.removeprefix("\ufeff")
    data = plan_data(text, source)
    try:
        return _reader().validate_python(data, context={})
    except ValidationError as error:
        raise PlanError(located(error, text, source)) from None


def load_plan(path: str | Path) -> Plan:
    """Read a plan file; raises PlanError if it is missing, no ordinary file or not a plan."""
    try:
        refuse_other(beginning(path, _GLANCE), str(path))
        text = read_text(path, most=LARGEST_PLAN)
    except PlanError:
        raise
    except InputError as error:
        raise PlanError(
            replace(item, message=f"cannot read the plan: {item.message}")
            for item in error.findings
        ) from None
    return plan_from_json(spelled(text), str(path))


def save_plan(plan: Plan, path: str | Path) -> None:
    """Write a plan file so that a reader sees the old file or the whole new one, never a part.

    Raises PlanError if the place cannot be written.
    """
    write_whole(Path(path), plan_to_json(plan).encode(), PlanError)
