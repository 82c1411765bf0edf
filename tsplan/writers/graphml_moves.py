"""GraphML: the states of the map, and an edge for every stay and every move of an agent."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Mapping
from itertools import chain
from xml.sax.saxutils import XMLGenerator
from xml.sax.xmlreader import AttributesImpl

from tsplan.errors import Finding, MapError
from tsplan.ts import State
from tsplan.ts.state_places import own_place
from tsplan.writers.handover import Handover
from tsplan.writers.journeys import Journey

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


class _Xml:
    """XML that is handed on in parts."""

    def __init__(self) -> None:
        self._stream = io.StringIO()
        self._xml = XMLGenerator(self._stream, "utf-8", short_empty_elements=True)

    def part(self) -> str:
        """What was written since the last part."""
        text = self._stream.getvalue()
        self._stream.seek(0)
        self._stream.truncate()
        return text

    def begin(self) -> None:
        self._xml.startDocument()
        self.open("graphml", xmlns=_NAMESPACE)

    def open(self, name: str, **attributes: str) -> None:
        self._xml.startElement(name, AttributesImpl(attributes))

    def close(self, name: str) -> None:
        self._xml.endElement(name)
        self._xml.characters("\n")

    def element(self, name: str, data: Mapping[str, object], **attributes: str) -> None:
        """A node or an edge with those of its fields that say something."""
        self.open(name, **attributes)
        for field, value in data.items():
            if value is not None and value != "":
                self.open("data", key=f"{name}.{field}")
                self._xml.characters(str(value))
                self._xml.endElement("data")
        self.close(name)


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
    xml = _Xml()
    xml.begin()
    for of, fields in _FIELDS.items():
        for field, kind in fields.items():
            names = {"for": of, "attr.name": field, "attr.type": kind}
            xml.open("key", id=f"{of}.{field}", **names)
            xml.close("key")
    xml.open("graph", id="plan", edgedefault="directed")
    for state in handover.system.states.values():
        xml.element("node", _node(state), id=state.name)
    yield xml.part()
    for agent, journey in handover.journeys():
        for (source, target), data in _edges(handover, journey):
            xml.element("edge", {"agent": agent, **data}, source=source, target=target)
        yield xml.part()
    xml.close("graph")
    xml.close("graphml")
    yield xml.part()


def _node(state: State) -> dict[str, object]:
    x, y = own_place(state) or (None, None)
    return {"labels": ", ".join(sorted(state.labels)), "origin": state.origin, "x": x, "y": y}


def _edges(
    handover: Handover, journey: Journey
) -> Iterator[tuple[tuple[str, str], dict[str, object]]]:
    """The stays and moves of a journey in their order."""
    legs = tuple(journey.legs)
    for place, (first, last, state) in enumerate(journey.stays):
        yield (state, state), _data(handover, journey, "stay", first, last)
        for leg in legs[place : place + 1]:
            ends = leg.source, leg.target
            yield ends, _data(handover, journey, "move", leg.left, leg.arrives)


def _data(
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
