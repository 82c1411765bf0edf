"""Writing maps, in the package's own format and in LOMAP's, so that reading gives the same map."""

from __future__ import annotations

import pathlib
from collections.abc import Iterator, Mapping
from typing import Any

from tsplan.ts.edges import Edge, State
from tsplan.ts.io.flow_style import flow, number, point, points, word
from tsplan.ts.io.lomap import FORMAT, OWN_KEY, PLACE_KEYS
from tsplan.ts.system import Extras, TransitionSystem


def map_to_yaml(system: TransitionSystem) -> str:
    """A map in the package's own format, one line for each state and edge.

    Waits are written out as edges. What only another format knows (`extras`) is left out.
    """
    lines = [f"name: {word(system.name)}"] if system.name else []
    lines.append("states:")
    lines += [f"  {word(state.name)}: {_own_state(state)}" for state in system.states.values()]
    edges = [f"  - {_own_edge(edge)}" for edge in _written_once(system)]
    lines += ["edges:", *edges] if edges else ["edges: []"]
    return "\n".join(lines) + "\n"


def _written_once(system: TransitionSystem) -> Iterator[Edge]:
    """Every edge, of those that go both ways only the direction that comes first."""
    done = set()
    for pair, edge in system.edges.items():
        if edge.both_ways and (edge.target, edge.source) in done:
            continue
        done.add(pair)
        yield edge


def _mapping(fields: Mapping[str, str]) -> str:
    return "{" + ", ".join(f"{key}: {text}" for key, text in fields.items()) + "}"


def _own_state(state: State) -> str:
    fields = {}
    if state.labels:
        fields["labels"] = flow(sorted(state.labels))
    if state.at is not None:
        fields["at"] = point(state.at)
    if state.shape is not None:
        fields["shape"] = points(state.shape)
    if state.color is not None:
        fields["color"] = word(state.color)
    if state.capacity is not None:
        fields["capacity"] = str(state.capacity)
    if state.needs:
        fields["needs"] = flow(sorted(state.needs))
    return _mapping(fields)


def _own_edge(edge: Edge) -> str:
    duration = flow(edge.duration)
    more = _limits(edge)
    if not more and not edge.both_ways:
        return f"[{word(edge.source)}, {word(edge.target)}, {duration}]"
    fields = {"from": word(edge.source), "to": word(edge.target), "duration": duration, **more}
    if edge.both_ways:
        fields["both_ways"] = "true"
    return _mapping(fields)


def _limits(edge: Edge) -> dict[str, str]:
    """The fields that most edges do not have."""
    fields = {}
    if edge.cost is not None:
        fields["cost"] = number(edge.cost)
    if edge.capacity is not None:
        fields["capacity"] = str(edge.capacity)
    if edge.needs:
        fields["needs"] = flow(sorted(edge.needs))
    return fields


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
    lines += [
        f"    {_id(s.name, extras)}: {_lomap_state(s, extras)}" for s in system.states.values()
    ]
    written = system.edges.values() if directed else _written_once(system)
    edges = [f"  - {text}" for edge in written for text in _lomap_edge(edge, extras, directed)]
    lines += ["  edges:", *edges] if edges else ["  edges: []"]
    return "\n".join(lines) + "\n"


def _id(name: str, extras: Extras) -> str:
    """A node's id as its file had it: a number, a tuple or a word."""
    ids = extras.system.get("ids", {})
    if name not in ids:
        return word(name)
    return flow(ids[name]) if isinstance(ids[name], tuple) else name


def _lomap_state(state: State, extras: Extras) -> str:
    kept = extras.states.get(state.name, {})
    fields: dict[str, str] = {}
    if state.labels:
        fields["prop"] = flow(state.labels)
    if state.at is not None and not any(key in kept for key in PLACE_KEYS):
        key = extras.system.get("place_keys", {}).get(state.name, PLACE_KEYS[0])
        fields[key] = f"!!python/tuple {point(state.at)}"
    if state.shape is not None:
        fields["shape"] = points(state.shape)
    if state.color is not None:
        fields["color"] = word(state.color)
    more: dict[str, Any] = {}
    if state.capacity is not None:
        more["capacity"] = state.capacity
    if state.needs:
        more["needs"] = sorted(state.needs)
    fields |= {word(key): flow(value) for key, value in kept.items()}
    if more:
        fields[OWN_KEY] = flow(more)
    return _mapping(fields)


def _lomap_edge(edge: Edge, extras: Extras, directed: bool) -> Iterator[str]:
    """The lines of an edge: one, or one for each of the parallel edges it stands for."""
    more = _limits(edge)
    if isinstance(edge.duration, Mapping):
        more["duration"] = flow(edge.duration)
    if edge.both_ways and directed:
        more["both_ways"] = "true"
    ends = f"{_id(edge.source, extras)}, {_id(edge.target, extras)}"
    for kept in extras.edges.get(edge.pair, ({},)):
        fields = {word(key): flow(value) for key, value in kept.items()}
        fields["weight"] = str(edge.shortest())
        if more:
            fields[OWN_KEY] = _mapping(more)
        yield f"[{ends}, {_mapping(fields)}]"


def save_map(system: TransitionSystem, path: str | pathlib.Path) -> None:
    """Write a map to a file, in the format it was read from; the own one for all others."""
    from_lomap = system.extras is not None and system.extras.format == FORMAT
    text = lomap_to_yaml(system) if from_lomap else map_to_yaml(system)
    pathlib.Path(path).write_text(text, encoding="utf-8")
