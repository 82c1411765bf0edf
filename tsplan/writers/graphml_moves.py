"""GraphML: the states of the map, and an edge for every stay and every move of an agent."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import chain
from xml.sax.saxutils import escape, quoteattr

from tsplan.errors import Finding, MapError
from tsplan.ts import State
from tsplan.ts.state_places import own_place
from tsplan.writers.handover import Handover
from tsplan.writers.journeys import Journey

_KEPT = 1024  # journeys whose edges are kept for the agents that follow
_NAME = "\0"  # where the agent's name comes; no name has it, as XML could not write it
_NAMESPACE = "http://graphml.graphdrawing.org/xmlns"
_FIELDS = {
    "node": {"labels": "string", "origin": "string", "x": "double", "y": "double"},
    "edge": {
        "agent": "string",
        "class": "string",
        "kind": "string",
        "from": "int",
        "to": "int",
        "from_seconds": "double",
        "to_seconds": "double",
    },
}
# what XML 1.0 has no way to write (https://www.w3.org/TR/xml/#charsets)
_UNWRITABLE = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def write(handover: Handover) -> Iterator[str]:
    """A directed graph with the states of the map as nodes and what agents do as edges.

    A stay is an edge from its state to itself, of the kind `stay`, and what lies between two stays
    one of the kind `move`; each has its `agent`, the agent's `class`, and the steps `from` and `to`
    (in seconds, too, where the map knows how long a step takes). Edges may be parallel.

    Raises
    ------
    MapError
        A name has a character that XML cannot write.

    """
    _refuse_unwritable(handover)
    yield f'<?xml version="1.0" encoding="utf-8"?>\n<graphml xmlns="{_NAMESPACE}">\n'
    for of, fields in _FIELDS.items():
        for field, kind in fields.items():
            names = {"id": f"{of}.{field}", "for": of, "attr.name": field, "attr.type": kind}
            yield _element("key", names)
    yield '<graph id="plan" edgedefault="directed">\n'
    for state in handover.system.states.values():
        yield _element("node", {"id": state.name}, _data("node", _node(state)))
    around = lru_cache(_KEPT)(lambda journey: _around(handover, journey))
    for agent, journey in handover.journeys():
        yield _text(agent).join(around(journey))
    yield "</graph>\n</graphml>\n"


def _element(name: str, attributes: Mapping[str, str], content: str = "") -> str:
    said = "".join(f" {key}={quoteattr(value)}" for key, value in attributes.items())
    return f"<{name}{said}>{content}</{name}>\n"


def _data(of: str, fields: Mapping[str, object]) -> str:
    """The fields of a node or an edge that say something."""
    return "".join(
        f'<data key="{of}.{field}">{_text(str(value))}</data>'
        for field, value in fields.items()
        if value is not None and value != ""
    )


def _text(text: str) -> str:
    return escape(text, {"\r": "&#13;"})  # a bare one would be read as the end of a line


def _node(state: State) -> dict[str, object]:
    x, y = own_place(state) or (None, None)
    return {"labels": ", ".join(sorted(state.labels)), "origin": state.origin, "x": x, "y": y}


def _around(handover: Handover, journey: Journey) -> tuple[str, ...]:
    """What stands before, between and after the places of the agent's name in its edges."""
    agent = _data("edge", {"agent": _NAME})
    edges = (
        _element("edge", {"source": source, "target": target}, agent + _data("edge", fields))
        for (source, target), fields in _edges(handover, journey)
    )
    return tuple("".join(edges).split(_NAME))


def _edges(
    handover: Handover, journey: Journey
) -> Iterator[tuple[tuple[str, str], dict[str, object]]]:
    """The stays and moves of a journey in their order."""
    legs = tuple(journey.legs)
    for place, (first, last, state) in enumerate(journey.stays):
        yield (state, state), _fields(handover, journey, "stay", first, last)
        for leg in legs[place : place + 1]:
            ends = leg.source, leg.target
            yield ends, _fields(handover, journey, "move", leg.left, leg.arrives)


def _fields(
    handover: Handover, journey: Journey, kind: str, first: int, last: int | None
) -> dict[str, object]:
    return {
        "class": journey.class_name,
        "kind": kind,
        "from": first,
        "to": last,
        "from_seconds": handover.seconds(first),
        "to_seconds": handover.seconds(last),
    }


def _named(handover: Handover) -> Iterator[str]:
    """The names of agents and of their classes."""
    for agent, journey in handover.journeys():
        yield agent
        yield journey.class_name


def _refuse_unwritable(handover: Handover) -> None:
    system = handover.system
    origins = (str(state.origin) for state in system.states.values())
    names = chain(system.states, system.labels, origins, _named(handover))
    found = dict.fromkeys(name for name in names if _UNWRITABLE.search(name))
    if found:
        raise MapError(
            Finding(
                f"the name {name!r} has a character that GraphML cannot hold",
                "give it another name, or export as csv or geojson",
            )
            for name in found
        )
