"""Plans as `tsplan-plan/1` JSON, both ways."""

from __future__ import annotations

import json
import math
import os
import shutil
from dataclasses import asdict
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from tsplan.errors import Finding, PlanError
from tsplan.results.plan import (
    AgentPlan,
    MissionRef,
    ModelSize,
    ObjectiveValue,
    Plan,
    SolverUse,
    Stay,
    StoppedBy,
    Timings,
    contradictions,
)
from tsplan.results.satisfaction import Depth, Fulfilment, Node, Satisfaction
from tsplan.results.swarmfile import groups_of, groups_text, moves_of, moves_text

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tsplan.document import Document
    from tsplan.results.planschema import Node as NodeFile
    from tsplan.results.planschema import PlanFile
    from tsplan.results.planschema import Satisfaction as PartialFile

FORMAT = "tsplan-plan/1"
_LOCATED = 2_000_000  # characters up to which a faulty file is read again for lines and columns


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
    from pydantic import ValidationError  # noqa: PLC0415  (slow to import)

    from tsplan.results.planschema import PlanFile  # noqa: PLC0415  (needs pydantic)

    data = _parsed(text, source)
    if isinstance(data, dict) and data.get("format") != FORMAT:
        given = data.get("format")
        found = f"its format is {given!r}" if given is not None else "it names no format"
        raise _refusal(f"this is no plan: {found}", f'a plan has "format": "{FORMAT}"', source)
    try:
        file = PlanFile.model_validate(data)
    except ValidationError as error:
        raise PlanError(_located(error, text, source)) from None
    findings = [
        Finding(finding.message, finding.remedy, source)
        for finding in contradictions(
            file.status,
            StoppedBy(file.stopped_by) if file.stopped_by else None,
            paths=bool(file.agents or file.moves),
        )
    ]
    if findings:
        raise PlanError(findings)
    return _built(file)


def load_plan(path: str | Path) -> Plan:
    """Read a plan file; raises PlanError if it is missing, not UTF-8 or not a plan."""
    try:
        text = Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise _refusal("the file is not UTF-8", "save it as UTF-8", str(path)) from None
    except OSError as error:
        why = error.strerror or "it cannot be read"
        raise _refusal(f"cannot read the plan: {why}", "check the path", str(path)) from None
    return plan_from_json(text, str(path))


def save_plan(plan: Plan, path: str | Path) -> None:
    """Write a plan file so that a reader sees the old file or the whole new one, never a part.

    Raises PlanError if the place cannot be written.
    """
    write_whole(Path(path), plan_to_json(plan).encode())


def write_whole(path: Path, content: bytes) -> None:
    """Write a file beside its place and move it there at once; devices are written directly."""
    place = path.resolve()
    part = place.with_name(f".{place.name}.{os.getpid()}.part")
    try:
        if place.exists() and not place.is_file():
            place.write_bytes(content)
            return
        try:
            with part.open("xb") as stream:
                stream.write(content)
                stream.flush()
                os.fsync(stream.fileno())
            if place.exists():
                shutil.copymode(place, part)
            part.replace(place)
        finally:
            part.unlink(missing_ok=True)
    except OSError as error:
        why = error.strerror or "it cannot be written"
        raise _refusal(f"cannot write: {why}", "choose another file", str(path)) from None


def _parsed(text: str, source: str) -> Any:
    try:
        return json.loads(text, object_pairs_hook=_unrepeated, parse_constant=_not_json)
    except json.JSONDecodeError as error:
        place = Finding(f"this is not JSON: {error.msg}", "", source, error.lineno, error.colno)
        raise PlanError([place]) from None
    except RecursionError:
        raise _refusal("the JSON is nested too deeply for a plan", "", source) from None
    except ValueError as error:
        raise _refusal(str(error), "correct the file", source) from None


def _unrepeated(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    made = dict(pairs)
    if len(made) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"the key '{twice}' is there twice")
    return made


def _not_json(word: str) -> NoReturn:
    raise ValueError(f"{word} is not a JSON number")


def _located(error: Any, text: str, source: str) -> list[Finding]:
    """The schema's findings, with lines and columns unless the file is very large."""
    document = _document(text, source) if len(text) <= _LOCATED else None
    findings = []
    for item in error.errors(include_url=False, include_input=False):
        path = tuple(item["loc"])
        line, column = document.place(path) if document is not None else (None, None)
        where = "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in path)
        message = str(item["msg"]).removeprefix("Value error, ")
        message = message[:1].lower() + message[1:]
        findings.append(
            Finding(f"{where.lstrip('.') or 'plan'}: {message}", "", source, line, column)
        )
    return findings


def _document(text: str, source: str) -> Document | None:
    """JSON is YAML too, whose reader knows the place of every value."""
    from tsplan.document import parse_document  # noqa: PLC0415  (needed for faulty files only)
    from tsplan.errors import InputError  # noqa: PLC0415

    try:
        return parse_document(text, source)
    except InputError:
        return None


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
