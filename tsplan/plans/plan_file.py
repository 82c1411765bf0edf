"""Plans as `tsplan-plan/1` JSON, both ways."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, replace
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tsplan.document.files import beginning, read_text, write_whole
from tsplan.errors import Finding, InputError, PlanError
from tsplan.plans.plan import (
    AgentPlan,
    MissionRef,
    ModelSize,
    ObjectiveValue,
    Plan,
    SolverUse,
    Stay,
    Timings,
    contradictions,
)
from tsplan.plans.plan_text import FORMAT, plan_file, refuse_other, spelled
from tsplan.plans.satisfaction import Depth, Fulfilment, Node, Satisfaction
from tsplan.plans.swarm_fields import groups_of, groups_text, moves_of, moves_text
from tsplan.stopping import StoppedBy

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tsplan.plans.plan_schema import Node as NodeFile
    from tsplan.plans.plan_schema import PlanFile
    from tsplan.plans.plan_schema import Satisfaction as PartialFile

LARGEST_PLAN = 1024**3  # bytes; a path takes some hundred
_GLANCE = 4096  # bytes by which a file that is no plan is known


def plan_to_json(plan: Plan) -> str:
    """The plan as JSON text, one top-level key, agent, move and sub-swarm a line."""
    entries: dict[str, Any] = {
        "format": FORMAT,
        "status": plan.status,
        "stopped_by": plan.stopped_by,
        "mission": asdict(plan.mission),
        "horizon": plan.horizon,
        "objective": [
            {"name": item.name, "value": _number(item.value), "bound": _number(item.bound)}
            for item in plan.objective
        ],
        "availability": _number(plan.availability),
        **_partial(plan),
        "verified": plan.verified,
        "moves": None,
        "groups": None,
        "agents": None,
        "solver": asdict(plan.solver),
        "size": asdict(plan.size),
        "timings": asdict(plan.timings),
        "notes": list(plan.notes),
    }
    if not plan.notes:
        del entries["notes"]
    large = {"moves": moves_text, "groups": groups_text, "agents": _agents}
    for key in large:
        if not getattr(plan, key):
            del entries[key]
    lines = [
        f"{json.dumps(key)}: {large[key](plan) if key in large else _dumped(value)}"
        for key, value in entries.items()
    ]
    return "{" + ",\n ".join(lines) + "}\n"


def _partial(plan: Plan) -> dict[str, Any]:
    """What the plan satisfies, where its mission does not demand everything."""
    entries: dict[str, Any] = {}
    if plan.satisfaction is not None:
        made = plan.satisfaction
        entries["satisfaction"] = {
            "order": made.order,
            **_fraction(made.fraction or Fraction(0)),
            "availability": _number(made.availability),
            "depths": [asdict(item) for item in made.depths],
            "nodes": [_node(node) for node in made.nodes],
        }
    if plan.preferences:
        entries["preferences"] = [_fulfilment(item) for item in plan.preferences]
    return entries


def _fulfilment(item: Fulfilment) -> dict[str, Any]:
    return {
        "name": item.name,
        "weight": _number(float(item.weight)),
        "level": item.level,
        "partial": item.partial,
        "met": item.met,
        **_fraction(item.fraction),
        "nodes": [_node(node) for node in item.nodes],
    }


def _node(node: Node) -> dict[str, Any]:
    return {
        "text": node.text,
        "depth": node.depth,
        "steps": [node.first, node.last],
        "met": node.met,
        **_fraction(node.fraction),
        "counted": node.counted,
    }


def _fraction(value: Fraction) -> dict[str, Any]:
    """A fraction as a number to read and as the exact one."""
    return {"fraction": _number(float(value)), "exact": str(value)}


def _agents(plan: Plan) -> str:
    """The list of agents; what agents on one path have in common is written out only once."""
    lines = [""] * len(plan.agents)
    for bundle in plan.bundles:
        common: dict[str, Any] = {
            "class": bundle.class_name,
            "capabilities": sorted(bundle.capabilities),
            "stays": bundle.stays,
        }
        if bundle.heading is not None:
            common["heading"] = bundle.heading
        tail = _dumped(common)[1:]
        for place in bundle.agents:
            lines[place] = f'{{"id": {json.dumps(plan.agents[place].id)}, {tail}'
    return "[\n  " + ",\n  ".join(lines) + "]"


def _dumped(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False, default=str)


def _number(value: float | None) -> float | int | None:
    """Whole numbers without a point, infinite ones as null."""
    if value is None or not math.isfinite(value):
        return None
    return int(value) if value == int(value) else value


def plan_from_json(text: str, source: str = "plan") -> Plan:
    """Read a plan; raises PlanError with every finding for a text that is not one."""
    file = plan_file(text, source)
    findings = [
        Finding(finding.message, finding.remedy, source)
        for finding in contradictions(
            file.status,
            StoppedBy(file.stopped_by) if file.stopped_by else None,
            paths=bool(file.agents or file.moves),
        )
    ]
    if file.verified and not (file.agents or file.moves):
        findings.append(Finding("a plan without paths cannot be verified", "", source))
    if findings:
        raise PlanError(findings)
    return _built(file)


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


def _refusal(message: str, remedy: str, source: str) -> PlanError:
    return PlanError([Finding(message, remedy, source)])


def _built(file: PlanFile) -> Plan:
    """The plan of a valid file. Equal paths become one object, which makes grouping cheap."""
    paths: dict[tuple[Stay, ...], tuple[Stay, ...]] = {}
    abilities: dict[tuple[str, ...], frozenset[str]] = {}
    agents = []
    for entry in file.agents or ():
        stays = tuple(entry.stays)
        able = abilities.setdefault(tuple(entry.capabilities), frozenset(entry.capabilities))
        path = paths.setdefault(stays, stays)
        agents.append(AgentPlan(entry.id, entry.class_name, able, path, entry.heading))
    return Plan(
        status=file.status,
        stopped_by=StoppedBy(file.stopped_by) if file.stopped_by else None,
        mission=MissionRef(file.mission.name, file.mission.sha256),
        horizon=file.horizon,
        objective=tuple(ObjectiveValue(o.name, o.value, o.bound) for o in file.objective),
        availability=file.availability,
        verified=file.verified,
        agents=tuple(agents),
        moves=moves_of(file),
        groups=groups_of(file),
        solver=SolverUse(file.solver.name, file.solver.version, file.solver.options),
        size=ModelSize(**file.size.model_dump()),
        timings=Timings(**file.timings.model_dump()),
        notes=tuple(file.notes),
        satisfaction=_satisfaction(file.satisfaction),
        preferences=tuple(
            Fulfilment(
                item.name,
                Fraction(str(item.weight)),
                item.level,
                item.partial,
                Fraction(item.exact),
                _nodes(item.nodes),
            )
            for item in file.preferences
        ),
    )


def _satisfaction(part: PartialFile | None) -> Satisfaction | None:
    if part is None:
        return None
    return Satisfaction(
        part.order,
        Fraction(part.exact),
        part.availability,
        tuple(Depth(item.depth, item.value, item.bound) for item in part.depths),
        _nodes(part.nodes),
    )


def _nodes(nodes: Iterable[NodeFile]) -> tuple[Node, ...]:
    return tuple(
        Node(item.text, item.depth, *item.steps, Fraction(item.exact), item.counted)
        for item in nodes
    )
