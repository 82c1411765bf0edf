"""Reading the package's own map format."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, PlainValidator, RootModel

from tsplan.document import Document, Path, validated
from tsplan.document.digits import lost_digits
from tsplan.document.fields import Natural, Number, Point, Truth, Word, Words, complaint, shown
from tsplan.document.pause import collector_paused
from tsplan.errors import Finding, MapError
from tsplan.limits import MOST_STEPS
from tsplan.ts.edges import ByClass, Edge, State
from tsplan.ts.system import TransitionSystem
from tsplan.ts.validity import Problem, in_order, problems

_KEYS = {"source": "from", "target": "to"}
_PLACES = {"source": 0, "target": 1, "duration": 2}
_SWAPPED = {"source": "target", "target": "source"}


def _reference(value: Any) -> Any:
    """A state's name in an edge; names that look like numbers may stand without quotes."""
    if value is None or isinstance(value, dict | list):
        raise complaint(
            f"{shown(value)} is not the name of a state", "write a state's name", "edge"
        )
    return value


def _steps(value: Any) -> int:
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if isinstance(value, bool) or not isinstance(value, int) or value < 1:
        raise complaint(
            f"{shown(value)} is not a whole number from 1 on",
            "durations are whole numbers of steps, at least 1",
            about="duration",
        )
    if value > MOST_STEPS:
        what = f"{shown(value)} is more than {MOST_STEPS:,} steps"
        raise complaint(what, "write a shorter one", about="duration")
    return value


def _duration(value: Any) -> int | ByClass:
    if not isinstance(value, dict):
        return _steps(value)
    if not value:
        raise complaint("no class is listed", "write it as {class name: steps}", "duration")
    return ByClass({name: _steps(steps) for name, steps in value.items()})


_Reference = Annotated[Any, PlainValidator(_reference)]
_Duration = Annotated[Any, PlainValidator(_duration)]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class _StateEntry(_Strict):
    labels: Words = []
    at: Point | None = None
    shape: Annotated[list[Point], Field(min_length=3)] | None = None
    color: Word | None = None
    capacity: Natural | None = None
    needs: Words = []


class _EdgeEntry(_Strict):
    source: _Reference = Field(alias="from")
    target: _Reference = Field(alias="to")
    duration: _Duration
    cost: Annotated[Number, Field(ge=0)] | None = None
    capacity: Natural | None = None
    needs: Words = []
    both_ways: Truth = False


class _EdgeList(RootModel[tuple[_Reference, _Reference, _Duration]]):
    """The short form of an edge: from, to, duration."""


class _Map(_Strict):
    name: Word | None = None
    waiting: Truth = False
    states: dict[str, Any]
    edges: list[Any] = []


@dataclass
class _Draft:
    """What has been read so far, and where in the document each edge comes from."""

    document: Document
    path: Path
    states: list[State] = field(default_factory=list)
    edges: list[Edge] = field(default_factory=list)
    origins: list[tuple[Path, bool]] = field(default_factory=list)  # bool: the reverse direction
    findings: list[Finding] = field(default_factory=list)

    def add_state(self, name: str) -> None:
        path = (*self.path, "states", name)
        entry: _StateEntry | None = _StateEntry()
        if self.document.at(path) is not None:
            entry, found = validated(self.document, _StateEntry, path)
            self.findings += found
        if entry is None:
            # its name is known all the same, so that edges to it are not reported as well
            self.states.append(State(name))
            return
        self.states.append(
            State(
                name,
                frozenset(entry.labels),
                entry.at,
                tuple(entry.shape) if entry.shape else None,
                entry.color,
                entry.capacity,
                frozenset(entry.needs),
            )
        )

    def add_edge(self, index: int, given: Any) -> None:
        path = (*self.path, "edges", index)
        listed = isinstance(given, list)
        edge = self._from_list(path, given) if listed else self._from_mapping(path)
        if edge is None:
            return
        self._append(edge, path, reverse=False)
        if edge.both_ways and not edge.is_wait:
            self._append(edge.reverse(), path, reverse=True)

    def _append(self, edge: Edge, path: Path, *, reverse: bool) -> None:
        self.edges.append(edge)
        self.origins.append((path, reverse))

    def _from_list(self, path: Path, given: list[Any]) -> Edge | None:
        if len(given) != len(_PLACES):
            message = f"an edge is [from, to, duration], not {len(given)} entries"
            remedy = "write three, or {from: a, to: b, duration: 1, ...}"
            self.findings.append(self.document.finding(path, message, remedy))
            return None
        entry, found = validated(self.document, _EdgeList, path)
        self.findings += found
        if entry is None:
            return None
        source, target, duration = entry.root
        return Edge(self._name(source, (*path, 0)), self._name(target, (*path, 1)), duration)

    def _from_mapping(self, path: Path) -> Edge | None:
        entry, found = validated(self.document, _EdgeEntry, path)
        self.findings += found
        if entry is None:
            return None
        self.findings += lost_digits(self.document, (*path, "cost"), entry.cost)
        return Edge(
            self._name(entry.source, (*path, "from")),
            self._name(entry.target, (*path, "to")),
            entry.duration,
            entry.cost,
            entry.capacity,
            frozenset(entry.needs),
            entry.both_ways,
        )

    def _name(self, value: Any, path: Path) -> str:
        return value if isinstance(value, str) else str(self.document.text(path))

    def locate(self, problem: Problem) -> Finding:
        """A problem with its place in the document."""
        if problem.kind == "system":
            path: Path = (*self.path, "states")
        elif problem.kind == "state":
            path = (*self.path, "states", self.states[problem.index].name)
            return self.document.key_finding(path, problem.message, problem.remedy)
        else:
            path = self._edge_path(problem)
        message = problem.message
        if problem.first is not None and problem.kind == "edge":
            line, _ = self.document.place(self.origins[problem.first][0])
            message = f"{message}, the first in line {line}"
        return self.document.finding(path, message, problem.remedy)

    def _edge_path(self, problem: Problem) -> Path:
        path, reverse = self.origins[problem.index]
        if problem.part is None:
            return path
        part = _SWAPPED.get(problem.part, problem.part) if reverse else problem.part
        if isinstance(self.document.at(path), list):
            return (*path, _PLACES.get(part, 0))
        return (*path, _KEYS.get(part, part))


@collector_paused()
def read_own(document: Document, path: Path = ()) -> TransitionSystem:
    """A map in the package's own format, at `path` of a document.

    Raises
    ------
    MapError
        Everything that is wrong, each with its place.

    """
    if document.at(path) is None:
        raise MapError([document.finding(path, "the map is empty", "write its states and edges")])
    content, findings = validated(document, _Map, path)
    if content is None:
        # a wrong or unknown key at the top does not hide what is wrong below
        data = document.at(path)
        content = _Map.model_construct(
            states=_or_empty(data, "states", dict), edges=_or_empty(data, "edges", list)
        )
    draft = _Draft(document, path, findings=findings)
    for name in content.states:
        draft.add_state(name)
    for index, given in enumerate(content.edges):
        draft.add_edge(index, given)
    if draft.findings:
        if content.states:
            draft.findings += map(draft.locate, problems(draft.states, draft.edges))
        raise MapError(in_order(draft.findings))
    edges = draft.edges
    if content.waiting:
        looping = {edge.source for edge in edges if edge.is_wait}
        edges = edges + [Edge(s.name, s.name) for s in draft.states if s.name not in looping]
    return TransitionSystem.build(draft.states, edges, content.name or "", locate=draft.locate)


def _or_empty(data: Any, key: str, kind: type[Any]) -> Any:
    """The part of a faulty map that can still be looked at."""
    part = data.get(key) if isinstance(data, Mapping) else None
    return part if isinstance(part, kind) else kind()
