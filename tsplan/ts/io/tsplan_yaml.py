"""The package's own map format, read and written."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, PlainValidator, RootModel

from tsplan.document import Document, Path
from tsplan.document.fields import Natural, Number, Point, Truth, Word, Words, complaint, shown
from tsplan.document.flow_style import flow, given, short, word
from tsplan.document.written import Written
from tsplan.errors import MapError
from tsplan.limits import MOST_STEPS
from tsplan.ts.actions import Action, ActionFlaw, missing_stays
from tsplan.ts.closures import Closed, is_span, spans
from tsplan.ts.edges import ByClass, Edge, State, missing_waits
from tsplan.ts.io.map_draft import MapDraft, written_once
from tsplan.ts.system import TransitionSystem
from tsplan.ts.validity import CORNERS, steps_fault

_KEYS = {"source": "from", "target": "to"}
_PLACES = {"source": 0, "target": 1, "duration": 2}
_OUTCOMES = "to"  # the key of an action's outcomes, where they do not stand beside its fields
_FIELDS = ("duration", "cost")  # of an action; what else it names is an outcome


def _reference(value: Any) -> Any:
    """A state's name in an edge; names that look like numbers may stand without quotes."""
    if value is None or isinstance(value, dict | list):
        raise complaint(
            f"{shown(value)} is not the name of a state", "write a state's name", "edge"
        )
    return value


def _steps(value: Any) -> int:
    steps = int(value) if isinstance(value, float) and value.is_integer() else value
    fault = steps_fault(steps)
    if fault is not None:
        raise complaint(f"{shown(steps)} is {fault.what}", fault.remedy, about="duration")
    return int(steps)


def _duration(value: Any) -> int | ByClass:
    if not isinstance(value, dict):
        return _steps(value)
    if not value:
        raise complaint("no class is listed", "write it as {class name: steps}", "duration")
    return ByClass({name: _steps(steps) for name, steps in value.items()})


def _origin(value: Any) -> str | int:
    if isinstance(value, bool) or not isinstance(value, str | int):
        raise complaint(f"{shown(value)} is neither a name nor a whole number", "put it in quotes")
    return value


def _closed(value: Any) -> Any:
    """Spans of steps; one by itself may stand without a list around it."""
    alone = isinstance(value, list) and bool(value) and not any(isinstance(v, list) for v in value)
    given = [value] if alone else value
    if not isinstance(given, list) or not all(isinstance(span, list) for span in given):
        raise complaint(f"{shown(value)} is no list of spans", "write it as [[4, 9]]", "closed")
    found = spans(given)
    for span in found:
        if not is_span(span) or span[1] > MOST_STEPS:
            what = f"{list(span)} is not a first and a last step"
            raise complaint(what, f"write whole numbers from 0 to {MOST_STEPS}", "closed")
    return found


_Step = Annotated[int, Field(ge=0, le=MOST_STEPS)]
_Span = tuple[_Step, _Step]
_Closed = Annotated[Any, PlainValidator(_closed), Written(_Span | list[_Span])]
_Steps = Annotated[int, Field(ge=1, le=MOST_STEPS)]
_ByClass = Annotated[dict[str, _Steps], Field(min_length=1)]
_Reference = Annotated[Any, PlainValidator(_reference), Written(str | float | bool)]
_Duration = Annotated[Any, PlainValidator(_duration), Written(_Steps | _ByClass)]
_Origin = Annotated[Any, PlainValidator(_origin), Written(str | int)]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class _StateEntry(_Strict):
    labels: Words = []
    at: Point | None = None
    shape: Annotated[list[Point], Field(min_length=CORNERS), AfterValidator(tuple)] | None = None
    color: Word | None = None
    capacity: Natural | None = None
    needs: Words = []
    zone: Word | None = None
    level: Word | None = None
    origin: _Origin | None = None
    closed: _Closed = ()


class _EdgeEntry(_Strict):
    source: _Reference = Field(alias="from")
    target: _Reference = Field(alias="to")
    duration: _Duration
    cost: Annotated[Number, Field(ge=0)] | None = None
    success: Annotated[Number, Field(gt=0, le=1)] = 1.0
    capacity: Natural | None = None
    needs: Words = []
    both_ways: Truth = False
    zone: Word | None = None
    closed: _Closed = ()


_ActionEntry = dict[str, Number | dict[str, Number]]


class _EdgeList(RootModel[tuple[_Reference, _Reference, _Duration]]):
    """The short form of an edge: from, to, duration."""


class MapFile(_Strict):
    """A whole map; its states, edges and actions are read one by one."""

    name: Word | None = None
    waiting: Truth = False
    step: Annotated[Number, Field(gt=0)] | None = None
    frame: Word | None = None
    zones: dict[str, Natural] = {}
    states: dict[str, Annotated[Any, Written(_StateEntry | None)]]
    edges: list[Annotated[Any, Written(_EdgeEntry | _EdgeList)]] = []
    actions: dict[str, dict[str, Annotated[dict[str, Any], Written(_ActionEntry)]]] = {}


class _Draft(MapDraft):
    STATES, EDGES = ("states",), ("edges",)

    def edge_part(self, path: Path, part: str) -> Path:
        if isinstance(self.document.at(path), list):
            return (*path, _PLACES.get(part, 0))
        return (*path, _KEYS.get(part, part))

    def read_state(self, name: str) -> None:
        path = self.state_path(name)
        empty = self.document.at(path) is None
        entry = _StateEntry() if empty else self.part(_StateEntry, path)
        # of a faulty one the name is known all the same: edges to it are not reported as well
        self.states.append(State(name, **dict(entry or ())))

    def read_edge(self, index: int, entry: Any) -> None:
        path = self.edge_path(index)
        listed = isinstance(entry, list)
        if listed and len(entry) != len(_PLACES):
            message = f"an edge is [from, to, duration], not {len(entry)} entries"
            self.refuse(path, message, "write three, or {from: a, to: b, duration: 1, ...}")
            return
        part = self.part(_EdgeList if listed else _EdgeEntry, path)
        if part is None:
            return
        fields = (
            dict(zip(_PLACES, part.root, strict=True))
            if isinstance(part, _EdgeList)
            else dict(part)
        )
        for end in _KEYS:
            if not isinstance(fields[end], str):
                fields[end] = str(self.document.text(self.edge_part(path, end)))
        self.findings += self.document.lost_digits((*path, "cost"), fields.get("cost"))
        edge = Edge(**fields)
        self.add_edge(edge, path, back=edge.both_ways and not edge.is_wait)

    def read_action(self, state: str, name: str, entry: dict[str, Any]) -> None:
        """Take in an action: its outcomes, beside its fields or under a key of their own."""
        apart = isinstance(entry.get(_OUTCOMES), dict)
        outcomes = entry[_OUTCOMES] if apart else {k: entry[k] for k in entry if k not in _FIELDS}
        path = (*self.path, "actions", state, name)
        for key in entry if apart else ():
            if key not in (_OUTCOMES, *_FIELDS):
                message = f"an action has no '{key}' beside its outcomes"
                self.findings.append(self.document.key_finding((*path, key), message, "remove it"))
        fields = {key: entry[key] for key in _FIELDS if key in entry}
        self.actions.append(Action(state, name, tuple(outcomes.items()), **fields))

    def action_path(self, flaw: ActionFlaw) -> Path:
        entry = (*self.path, "actions", *flaw.action.key)
        outcome = bool(flaw.path) and flaw.path[0] not in _FIELDS
        apart = outcome and isinstance(self.document.at(entry).get(_OUTCOMES), dict)
        return (*entry, _OUTCOMES, *flaw.path) if apart else (*entry, *flaw.path)


def read_own(document: Document, path: Path = ()) -> TransitionSystem:
    """A map in the package's own format, at `path` of a document.

    Raises
    ------
    MapError
        Everything that is wrong, each with its place.

    """
    if document.at(path) is None:
        raise MapError([document.finding(path, "the map is empty", "write its states and edges")])
    draft = _Draft(document, path)
    content = draft.part(MapFile, path)
    if content is None:
        # a wrong or unknown key at the top does not hide what is wrong below
        data = document.at(path)
        content = MapFile.model_construct(
            states=_or_empty(data, "states", dict),
            edges=_or_empty(data, "edges", list),
            actions={},
            zones={
                name: room if type(room) is int and room >= 0 else 0  # which is told of already
                for name, room in _or_empty(data, "zones", dict).items()
            },
        )
    draft.zones = content.zones
    for name in content.states:
        draft.read_state(name)
    for index, entry in enumerate(content.edges):
        draft.read_edge(index, entry)
    for state, entries in content.actions.items():
        for name, action in entries.items():
            draft.read_action(state, name, action)
    if content.waiting and draft.actions:
        draft.actions += missing_stays(draft.states, draft.actions)
    more = missing_waits(draft.states, draft.edges) if content.waiting and not draft.actions else ()
    return draft.system(content.name or "", more, step_seconds=content.step, frame=content.frame)


def _or_empty(data: Any, key: str, kind: type[Any]) -> Any:
    """The part of a faulty map that can still be looked at."""
    part = data.get(key) if isinstance(data, Mapping) else None
    return part if isinstance(part, kind) else kind()


def map_to_yaml(system: TransitionSystem) -> str:
    """A map in the package's own format, one line for each state and edge.

    Waits are written out as edges. What only another format knows (`extras`) is left out.
    """
    head = given(
        name=system.name,
        step=short(system.step_seconds),
        frame=system.frame,
        zones=dict(system.zones),
    )
    lines = [f"{key}: {flow(value)}" for key, value in head.items()]
    lines.append("states:")
    named = {name: word(name) for name in system.states}  # each of them stands in several edges
    lines += [f"  {named[name]}: {flow(_state(state))}" for name, state in system.states.items()]
    if system.actions:
        return "\n".join([*lines, "actions:", *_action_lines(system)]) + "\n"
    edges = [f"  - {_edge(edge, named)}" for edge in written_once(system)]
    lines += ["edges:", *edges] if edges else ["edges: []"]
    return "\n".join(lines) + "\n"


def _action_lines(system: TransitionSystem) -> Iterator[str]:
    """The actions of every state, one a line."""
    by_state: dict[str, list[Action]] = defaultdict(list)
    for action in system.actions.values():
        by_state[action.state].append(action)
    for state, actions in by_state.items():
        yield f"  {word(state)}:"
        yield from (f"    {word(action.name)}: {flow(_action(action))}" for action in actions)


def _action(action: Action) -> dict[str, Any]:
    outcomes = {state: short(chance) for state, chance in action.outcomes}
    fields = given(
        duration=None if action.duration == 1 else action.duration, cost=short(action.cost)
    )
    apart = fields or outcomes.keys() & {_OUTCOMES, *_FIELDS}
    return {_OUTCOMES: outcomes, **fields} if apart else outcomes


def _state(state: State) -> dict[str, Any]:
    return given(
        labels=sorted(state.labels),
        at=short(state.at),
        shape=short(state.shape),
        color=state.color,
        capacity=state.capacity,
        needs=sorted(state.needs),
        zone=state.zone,
        level=state.level,
        origin=state.origin,
        closed=_spans(state.closed),
    )


def _spans(closed: Closed) -> list[list[int]]:
    return [list(span) for span in closed]


def _edge(edge: Edge, named: Mapping[str, str]) -> str:
    source, target, duration = named[edge.source], named[edge.target], flow(edge.duration)
    more = given(
        cost=short(edge.cost),
        success=None if edge.success == 1 else edge.success,
        capacity=edge.capacity,
        needs=sorted(edge.needs),
        both_ways=edge.both_ways or None,
        zone=edge.zone,
        closed=_spans(edge.closed),
    )
    if not more:
        return f"[{source}, {target}, {duration}]"
    return f"{{from: {source}, to: {target}, duration: {duration}, {flow(more)[1:]}"
