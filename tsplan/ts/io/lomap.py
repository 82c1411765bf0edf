"""Reading LOMAP's `!Ts` YAML: a weighted, possibly undirected graph with propositions on its nodes.

LOMAP (https://github.com/wasserfeder/lomap) dumps its class `Ts` as `name`, `directed`, `multi`,
`init`, `final` and `graph: {nodes: ..., edges: ...}`. What planning does not use (initial and final
states, controls on edges, other attributes) is kept in the system's `extras`. What LOMAP has no
word for is written under the attribute `tsplan` of a node or edge, and understood here.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from tsplan.document import Document, Path, validated
from tsplan.document.compose import SET, TUPLE
from tsplan.document.digits import lost_digits
from tsplan.document.fields import Natural, Number, Positive, Truth, Word, Words
from tsplan.document.pause import collector_paused
from tsplan.errors import Finding, MapError
from tsplan.ts.edges import Edge, State
from tsplan.ts.system import Extras, Pair, TransitionSystem
from tsplan.ts.validity import CORNERS, Problem, in_order, problems

FORMAT = "lomap"
OWN_KEY = "tsplan"
PLACE_KEYS = ("location", "position")
_POSITIONS = {"source": 0, "target": 1}


class _Graph(BaseModel):
    model_config = ConfigDict(extra="forbid")
    nodes: dict[str, dict[str, Any] | None]
    edges: list[Any] = []


class _File(BaseModel):
    """The keys that are used; others are kept as they are."""

    model_config = ConfigDict(extra="allow")
    name: str = ""
    directed: Truth = True
    graph: _Graph


class _StateMore(BaseModel):
    model_config = ConfigDict(extra="forbid")
    capacity: Natural | None = None
    needs: Words = []


class _EdgeMore(BaseModel):
    model_config = ConfigDict(extra="forbid")
    duration: dict[Word, Positive] | None = None
    cost: Annotated[Number, Field(ge=0)] | None = None
    capacity: Natural | None = None
    needs: Words = []
    both_ways: Truth = False


def is_lomap(document: Document, path: Path = ()) -> bool:
    """Whether the map at a path is LOMAP's: tagged `!Ts`, or with its `graph` at the top."""
    data = document.at(path)
    return document.tag(path) == "!Ts" or (isinstance(data, dict) and "graph" in data)


def native(document: Document, path: Path) -> Any:
    """The value at a path with tuples and sets where the file has them."""
    data, tag = document.at(path), document.tag(path)
    if isinstance(data, dict):
        return {key: native(document, (*path, key)) for key in data}
    if not isinstance(data, list):
        return data
    members = [native(document, (*path, index)) for index in range(len(data))]
    if tag == TUPLE:
        return tuple(members)
    return frozenset(members) if tag == SET else members


@dataclass
class _Draft:
    """What has been read so far, and which entry of `graph.edges` each edge comes from."""

    document: Document
    path: Path
    directed: bool
    states: list[State] = field(default_factory=list)
    edges: list[Edge] = field(default_factory=list)
    origins: list[int] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    state_extras: dict[str, dict[str, Any]] = field(default_factory=dict)
    edge_extras: dict[Pair, list[dict[str, Any]]] = field(default_factory=dict)
    ids: dict[str, Any] = field(default_factory=dict)
    place_keys: dict[str, str] = field(default_factory=dict)
    _known: dict[Pair, Edge] = field(default_factory=dict)

    def add_state(self, name: str, given: Mapping[str, Any]) -> None:
        path = (*self.path, "graph", "nodes", name)
        kept = {key: native(self.document, (*path, key)) for key in given}
        labels = self._labels((*path, "prop")) if "prop" in given else ()
        kept.pop("prop", None)
        more = self._more(_StateMore, path, kept)
        self.states.append(
            State(
                name,
                frozenset(labels),
                self._place(name, kept),
                _polygon(kept),
                kept.pop("color") if isinstance(kept.get("color"), str) else None,
                more.capacity,
                frozenset(more.needs),
            )
        )
        if kept:
            self.state_extras[name] = kept

    def _more(self, schema: type[Any], path: Path, kept: dict[str, Any]) -> Any:
        """What stands under this package's own attribute, if it is there."""
        if kept.pop(OWN_KEY, None) is None:
            return schema()
        more, found = validated(self.document, schema, (*path, OWN_KEY))
        self.findings += found
        return more or schema()

    def _labels(self, path: Path) -> list[str]:
        """The propositions of a node: a set, a list, a mapping's keys or one word."""
        data = self.document.at(path)
        if data is None:
            return []
        if isinstance(data, dict):
            return list(data)
        if not isinstance(data, list):
            return [str(self.document.text(path))]
        if self.document.tag(path) == SET:
            return [str(label) for label in data]
        texts = [self.document.text((*path, index)) for index in range(len(data))]
        if None in texts:
            message = "prop: a proposition is not a word"
            self.findings.append(self.document.finding(path, message, "write it as [a, b]"))
        return [text for text in texts if text is not None]

    def _place(self, name: str, kept: dict[str, Any]) -> tuple[float, float] | None:
        """The node's coordinates; further dimensions stay among what is kept."""
        for key in PLACE_KEYS:
            point = _numbers(kept.get(key))
            if point is not None and len(point) >= 2:  # noqa: PLR2004 - x and y
                if len(point) == 2:  # noqa: PLR2004
                    del kept[key]
                    self.place_keys[name] = key
                return point[0], point[1]
        return None

    def add_edge(self, index: int, given: Any) -> None:
        path = (*self.path, "graph", "edges", index)
        if not self._well_formed(path, given):
            return
        source, target = self._name((*path, 0)), self._name((*path, 1))
        kept = native(self.document, (*path, 2)) if len(given) > 2 else {}  # noqa: PLR2004
        more = self._more(_EdgeMore, (*path, 2), kept)
        self.findings += lost_digits(self.document, (*path, 2, OWN_KEY, "cost"), more.cost)
        both_ways = more.both_ways or (not self.directed and source != target)
        edge = Edge(
            source,
            target,
            more.duration or _weight(kept.pop("weight", 1)),
            more.cost,
            more.capacity,
            frozenset(more.needs),
            both_ways,
        )
        kept.pop("weight", None)
        self._append(edge, index, kept)
        if not self.directed and source != target:
            self._append(edge.reverse(), index, kept)

    def _well_formed(self, path: Path, given: Any) -> bool:
        if (
            isinstance(given, list)
            and len(given) in (2, 3)
            and (len(given) == 2 or isinstance(given[2], dict))  # noqa: PLR2004
        ):
            return True
        message = "an edge is not [from, to, {weight: ...}]"
        self.findings.append(self.document.finding(path, message, "write it so"))
        return False

    def _append(self, edge: Edge, index: int, kept: dict[str, Any]) -> None:
        """Take an edge in; a parallel edge that is equal to the first adds its attributes only."""
        if self._known.get(edge.pair) != edge:
            self._known.setdefault(edge.pair, edge)
            self.edges.append(edge)
            self.origins.append(index)
        self.edge_extras.setdefault(edge.pair, []).append(kept)

    def _name(self, path: Path) -> str:
        """The name of a node in an edge; numbers and tuples become their text."""
        text = self.document.text(path)
        value = native(self.document, path)
        if text is None:
            members = range(len(value)) if isinstance(value, list | tuple) else range(0)
            parts = [str(self.document.text((*path, member))) for member in members]
            text = "(" + ", ".join(parts) + ")"
            value = tuple(value) if members else text
        if not isinstance(value, str):
            self.ids[text] = value
        return text

    def locate(self, problem: Problem) -> Finding:
        """A problem with its place in the document."""
        path: Path = (*self.path, "graph", "nodes")
        if problem.kind == "state":
            path = (*path, self.states[problem.index].name)
        elif problem.kind == "edge":
            path = (*self.path, "graph", "edges", self.origins[problem.index])
            if problem.part == "duration":
                path = (*path, 2, "weight")
            elif self.directed and problem.part in _POSITIONS:
                path = (*path, _POSITIONS[problem.part])
        message = problem.message
        if problem.first is not None and problem.kind == "edge":
            first = (*self.path, "graph", "edges", self.origins[problem.first])
            message = f"{message}, the first in line {self.document.place(first)[0]}"
        return self.document.finding(path, message, problem.remedy)

    def extras(self) -> Extras:
        """Everything that is kept for writing the file back."""
        top = self.document.at(self.path)
        own = ("name", "graph", "directed")
        attributes = {
            key: native(self.document, (*self.path, key)) for key in top if key not in own
        }
        system = {
            "attributes": attributes,
            "directed": self.directed,
            "ids": self.ids,
            "place_keys": self.place_keys,
        }
        edges = {pair: tuple(kept) for pair, kept in self.edge_extras.items() if any(kept)}
        return Extras(FORMAT, system, self.state_extras, edges)


def _numbers(value: Any) -> tuple[float, ...] | None:
    """A list or tuple of finite numbers, or None."""
    if not isinstance(value, list | tuple):
        return None
    if not all(type(item) in (int, float) and math.isfinite(item) for item in value):
        return None
    return tuple(float(item) for item in value)


def _polygon(kept: dict[str, Any]) -> tuple[tuple[float, float], ...] | None:
    """The node's shape, where it is a polygon; anything else stays among what is kept."""
    corners = kept.get("shape")
    if not isinstance(corners, list | tuple) or not corners:
        return None
    points = [_numbers(corner) for corner in corners]
    flat = all(point is not None and len(point) == 2 for point in points)  # noqa: PLR2004
    if len(points) < CORNERS or not flat:
        return None
    del kept["shape"]
    return tuple((point[0], point[1]) for point in points if point is not None)


def _weight(value: Any) -> Any:
    """A duration; a number such as 2.0 is whole, anything else is left for the checks to refuse."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


@collector_paused()
def read_lomap(document: Document, path: Path = ()) -> TransitionSystem:
    """A map in LOMAP's format, at `path` of a document.

    An edge of an undirected graph becomes two, one in each direction. Parallel edges must agree in
    everything planning uses, since a transition system has one edge for each ordered pair.

    Raises
    ------
    MapError
        Everything that is wrong, each with its place.

    """
    content, findings = validated(document, _File, path)
    if content is None:
        raise MapError(findings)
    draft = _Draft(document, path, directed=content.directed)
    for name, given in content.graph.nodes.items():
        draft.add_state(name, given or {})
    for index, given in enumerate(content.graph.edges):
        draft.add_edge(index, given)
    if draft.findings:
        draft.findings += map(draft.locate, problems(draft.states, draft.edges))
        raise MapError(in_order(draft.findings))
    return TransitionSystem.build(
        draft.states, draft.edges, content.name, extras=draft.extras(), locate=draft.locate
    )
