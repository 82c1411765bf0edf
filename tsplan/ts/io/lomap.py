"""LOMAP's `!Ts` YAML, read and written: a weighted, possibly undirected graph with propositions.

LOMAP (https://github.com/wasserfeder/lomap) dumps its class `Ts` as `name`, `directed`, `multi`,
`init`, `final` and `graph: {nodes: ..., edges: ...}`. What planning does not use (initial and final
states, controls on edges, other attributes) is kept in the system's `extras`. What LOMAP has no
word for is written under the attribute `tsplan` of a node or edge, and understood here.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from tsplan.document import Document, Path, validated
from tsplan.document.fields import Natural, Number, Positive, Truth, Word, Words
from tsplan.document.flow_style import flow, given, short, word
from tsplan.document.yaml_nodes import SET, TUPLE, Node
from tsplan.errors import MapError
from tsplan.ts.actions import Action, ActionFlaw, ActionKey
from tsplan.ts.edges import Edge, Pair, State
from tsplan.ts.io.map_draft import MapDraft, written_once
from tsplan.ts.system import Extras, TransitionSystem
from tsplan.ts.validity import CORNERS

FORMAT = "lomap"
_OWN_KEY = "tsplan"
_GO = "go"  # the name of an action without a control
_PLACE_KEYS = ("location", "position")
_USED = ("name", "graph", "directed")
_POSITIONS: dict[str, Path] = {"source": (0,), "target": (1,), "duration": (2, "weight")}


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
    closed: tuple[tuple[Natural, Natural], ...] = ()


class _EdgeMore(_StateMore):
    duration: dict[Word, Positive] | None = None
    cost: Annotated[Number, Field(ge=0)] | None = None
    success: Annotated[Number, Field(gt=0, le=1)] = 1.0
    both_ways: Truth = False


def is_lomap(document: Document, path: Path = ()) -> bool:
    """Whether the map at a path is LOMAP's: tagged `!Ts`, or with its `graph` at the top."""
    node = document.node(path)
    return node.tag == "!Ts" or (isinstance(node.value, dict) and "graph" in node.value)


def _native(node: Node) -> Any:
    """The value of a node with tuples and sets where the file has them."""
    if isinstance(node.children, dict):
        return {key: _native(child) for key, child in node.children.items()}
    if node.children is None:
        return node.value
    members = [_native(child) for child in node.children]
    if node.tag == TUPLE:
        return tuple(members)
    return frozenset(members) if node.tag == SET else members


@dataclass
class _Draft(MapDraft):
    """What has been read so far, and what is kept for writing the file back."""

    STATES, EDGES = ("graph", "nodes"), ("graph", "edges")

    directed: bool = True
    uncertain: bool = False  # edges have probabilities
    state_extras: dict[str, dict[str, Any]] = field(default_factory=dict)
    edge_extras: dict[Pair, list[dict[str, Any]]] = field(default_factory=dict)
    ids: dict[str, Any] = field(default_factory=dict)
    place_keys: dict[str, str] = field(default_factory=dict)
    _known: dict[Pair, Edge] = field(default_factory=dict)
    _drawn: dict[ActionKey, tuple[Path, Action]] = field(default_factory=dict)

    def edge_part(self, path: Path, part: str) -> Path:
        return (*path, *_POSITIONS.get(part, ()))

    def read_state(self, name: str) -> None:
        path = self.state_path(name)
        node = self.document.node(path)
        parts = node.children if isinstance(node.children, dict) else {}
        kept = _native(node) or {}
        labels = frozenset(self._labels(path, parts["prop"]) if "prop" in parts else ())
        kept.pop("prop", None)
        more = self._more(_StateMore, path, kept)
        at, shape = self._place(name, kept), _polygon(kept)
        color = kept.pop("color") if isinstance(kept.get("color"), str) else None
        self.states.append(State(name, labels, at, shape, color, **more))
        if kept:
            self.state_extras[name] = kept

    def _more(self, schema: type[BaseModel], path: Path, kept: dict[str, Any]) -> dict[str, Any]:
        """The fields that stand under this package's own attribute, if it is there."""
        if kept.pop(_OWN_KEY, None) is None:
            return {}
        return dict(self.part(schema, (*path, _OWN_KEY)) or ())

    def _labels(self, path: Path, node: Node) -> list[str]:
        """The propositions of a node: a set, a list, a mapping's keys or one word."""
        if isinstance(node.children, dict):
            return list(node.children)
        if node.children is None:
            return [] if node.value is None else [str(node.text)]
        texts = [child.text for child in node.children]
        if None in texts:
            message, remedy = "prop: a proposition is not a word", "write it as [a, b]"
            self.refuse((*path, "prop"), message, remedy)
        return [text for text in texts if text is not None]

    def _place(self, name: str, kept: dict[str, Any]) -> tuple[float, float] | None:
        """The node's coordinates; further dimensions stay among what is kept."""
        for key in _PLACE_KEYS:
            point = _numbers(kept.get(key))
            if point is not None and len(point) >= 2:  # noqa: PLR2004 - x and y
                if len(point) == 2:  # noqa: PLR2004
                    del kept[key]
                    self.place_keys[name] = key
                return point[0], point[1]
        return None

    def read_edge(self, index: int) -> None:
        """Take in an edge; a parallel one that is equal to the first adds its attributes only."""
        path = self.edge_path(index)
        node = self.document.node(path)
        parts = node.children if isinstance(node.children, list) else []
        # from, to, and perhaps attributes
        if len(parts) not in (2, 3) or not all(isinstance(part.value, dict) for part in parts[2:]):
            self.refuse(path, "an edge is not [from, to, {weight: ...}]", "write it so")
            return
        source, target = self._name(parts[0]), self._name(parts[1])
        kept = _native(parts[2]) if parts[2:] else {}
        if self.uncertain:
            self._read_outcome((source, target), kept, path)
            return
        fields = self._more(_EdgeMore, (*path, 2), kept)
        self.findings += self.document.lost_digits((*path, 2, _OWN_KEY, "cost"), fields.get("cost"))
        weight = kept.pop("weight", 1)
        # 2.0 is whole, anything else is left for the checks to refuse
        whole = isinstance(weight, float) and weight.is_integer()
        fields["duration"] = fields.get("duration") or (int(weight) if whole else weight)
        back = not self.directed and source != target
        fields["both_ways"] = fields.get("both_ways", False) or back
        edge = Edge(source, target, **fields)
        if self._known.get(edge.pair) != edge:
            self.add_edge(edge, path, back=back)
        for one in [edge, edge.reverse()] if back else [edge]:
            self._known.setdefault(one.pair, one)
            self.edge_extras.setdefault(one.pair, []).append(kept)

    def _read_outcome(self, ends: Pair, kept: dict[str, Any], path: Path) -> None:
        """Take in an edge of a Markov decision process: an outcome of the action `control`."""
        key = (ends[0], str(kept.get("control", _GO)))
        weight = kept.get("weight", 1)
        duration = int(weight) if isinstance(weight, float) and weight.is_integer() else weight
        first = (path, Action(*key, (), duration, kept.get("cost")))
        path, action = self._drawn.setdefault(key, first)
        if action.duration != duration:
            what = f"'{key[1]}' at '{key[0]}' has another weight with another outcome"
            self.refuse((*path, 2, "weight"), what, "an action takes as long wherever it leads")
        outcome = (ends[1], kept.get("prob", 1))
        self._drawn[key] = path, replace(action, outcomes=(*action.outcomes, outcome))

    def drawn(self) -> None:
        """Make actions of the outcomes that were read."""
        self.actions += [action for _, action in self._drawn.values()]

    def action_path(self, flaw: ActionFlaw) -> Path:
        return self._drawn[flaw.action.key][0]

    def _name(self, node: Node) -> str:
        """The name of a node in an edge; numbers and tuples become their text."""
        text, value = node.text, _native(node)
        if text is None:
            members = node.children if isinstance(node.children, list) else []
            text = "(" + ", ".join(str(member.text) for member in members) + ")"
            value = tuple(value) if members else text
        if not isinstance(value, str):
            self.ids[text] = value
        return text

    def extras(self) -> Extras:
        """Everything that is kept for writing the file back."""
        keys = [key for key in self.document.at(self.path) if key not in _USED]
        system = {
            "attributes": {key: _native(self.document.node((*self.path, key))) for key in keys},
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
    if not all(type(number) in (int, float) and math.isfinite(number) for number in value):
        return None
    return tuple(float(number) for number in value)


def _polygon(kept: dict[str, Any]) -> tuple[tuple[float, float], ...] | None:
    """The node's shape, where it is a polygon; anything else stays among what is kept."""
    corners = kept.get("shape")
    if not isinstance(corners, list | tuple) or len(corners) < CORNERS:
        return None
    points = [_numbers(corner) for corner in corners]
    if not all(point is not None and len(point) == 2 for point in points):  # noqa: PLR2004
        return None
    del kept["shape"]
    return tuple((point[0], point[1]) for point in points if point is not None)


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
    uncertain = any(_has_chance(edge) for edge in content.graph.edges)
    draft = _Draft(document, path, directed=content.directed, uncertain=uncertain)
    for name in content.graph.nodes:
        draft.read_state(name)
    for index in range(len(content.graph.edges)):
        draft.read_edge(index)
    draft.drawn()
    return draft.system(content.name, extras=draft.extras())


def _has_chance(edge: Any) -> bool:
    """Whether an edge is one of a Markov decision process."""
    return isinstance(edge, list) and isinstance(edge[-1], dict) and "prob" in edge[-1]


def lomap_to_yaml(system: TransitionSystem) -> str:
    """A map as LOMAP's `!Ts`, with what was kept of a LOMAP file it came from.

    A map all of whose moves go both ways is written undirected. Capacities, costs, needs and
    durations by class stand under the attribute `tsplan`, which LOMAP passes over.
    """
    extras = system.extras
    if extras is None or extras.format != FORMAT:
        extras = Extras(FORMAT)
    moves = [edge for edge in system.edges.values() if not edge.is_wait]
    directed = not all(edge.both_ways for edge in moves)
    if not moves:
        directed = extras.system.get("directed", True)
    attributes = {"multi": False, "init": [], "final": [], **extras.system.get("attributes", {})}
    lines = ["!Ts", f"name: {word(system.name)}", f"directed: {flow(directed)}"]
    lines += [f"{word(key)}: {flow(value)}" for key, value in attributes.items()]
    lines += ["graph:", "  nodes:"]
    lines += [f"    {_id(s.name, extras)}: {_state(s, extras)}" for s in system.states.values()]
    if system.actions:
        lines[2] = "directed: true"
        lines += ["  edges:", *(f"  - {text}" for text in _outcomes(system, extras))]
        return "\n".join(lines) + "\n"
    written = system.edges.values() if directed else written_once(system)
    edges = [f"  - {text}" for edge in written for text in _edge(edge, extras, directed)]
    lines += ["  edges:", *edges] if edges else ["  edges: []"]
    return "\n".join(lines) + "\n"


def _id(name: str, extras: Extras) -> str:
    """A node's id as its file had it: a number, a tuple or a word."""
    ids = extras.system.get("ids", {})
    if name not in ids:
        return word(name)
    return flow(ids[name]) if isinstance(ids[name], tuple) else name


def _state(state: State, extras: Extras) -> str:
    kept = extras.states.get(state.name, {})
    place = extras.system.get("place_keys", {}).get(state.name, _PLACE_KEYS[0])
    at = None if any(key in kept for key in _PLACE_KEYS) else short(state.at)
    fields = given(
        prop=state.labels,
        **{place: at and tuple(at)},
        shape=short(state.shape),
        color=state.color,
    )
    closed = [list(span) for span in state.closed]
    own = given(capacity=state.capacity, needs=sorted(state.needs), closed=closed)
    return flow(fields | {**kept} | given(**{_OWN_KEY: own}))


def _outcomes(system: TransitionSystem, extras: Extras) -> Iterator[str]:
    """The lines of all actions: an edge for every outcome."""
    for action in system.actions.values():
        for target, chance in action.outcomes:
            attributes = {"weight": action.duration, "control": action.name, "prob": short(chance)}
            more = given(cost=short(action.cost))
            ends = f"{_id(action.state, extras)}, {_id(target, extras)}"
            yield f"[{ends}, {flow(attributes | more)}]"


def _edge(edge: Edge, extras: Extras, directed: bool) -> Iterator[str]:
    """The lines of an edge: one, or one for each of the parallel edges it stands for."""
    own = given(
        cost=short(edge.cost),
        success=None if edge.success == 1 else edge.success,
        capacity=edge.capacity,
        needs=sorted(edge.needs),
        duration=edge.duration if isinstance(edge.duration, Mapping) else None,
        both_ways=(edge.both_ways and directed) or None,
        closed=[list(span) for span in edge.closed],
    )
    ends = f"{_id(edge.source, extras)}, {_id(edge.target, extras)}"
    for kept in extras.edges.get(edge.pair, ({},)):
        attributes = kept | {"weight": edge.shortest()} | given(**{_OWN_KEY: own})
        yield f"[{ends}, {flow(attributes)}]"
