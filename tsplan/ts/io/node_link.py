"""Graphs as nodes and links: networkx's node-link JSON, and what GraphML is read into.

The attributes are those of `builders.map_of_graph`: a duration in steps, else a length in metres,
else the way between the coordinates of the ends, else one step.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from tsplan.document import Document, Path
from tsplan.ts.edges import State
from tsplan.ts.graph_attributes import (
    LENGTHS,
    OF_EDGES,
    OF_STATES,
    USUAL,
    Misfit,
    fields_of,
    length_of,
)
from tsplan.ts.io.graph_draft import GraphDraft
from tsplan.ts.io.graphml import TAG
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.ride_durations import Ride
from tsplan.ts.system import TransitionSystem

_EDGES = ("links", "edges")
_ENDS = ("source", "target")


def is_node_link(document: Document, path: Path) -> bool:
    """Whether what stands at a path has a list of nodes and one of links or edges."""
    data = document.at(path)
    lists = isinstance(data, dict) and isinstance(data.get("nodes"), list)
    return lists and any(isinstance(data.get(key), list) for key in _EDGES)


class _Draft(GraphDraft):
    PARTS = {"source": ("source",), "target": ("target",)}  # noqa: RUF012

    def _misfits(self, path: Path, misfits: Iterable[Misfit]) -> None:
        for each in misfits:
            message = f"{each.attribute}: {each.message}"
            self.refuse((*path, each.attribute), message, each.remedy)

    def _entry(self, path: Path, keys: Iterable[str]) -> Mapping[str, Any] | None:
        """The entry of a node or a link, if it has its keys."""
        entry = self.document.at(path)
        missing = [key for key in keys if not isinstance(entry, dict) or key not in entry]
        for key in missing:
            self.refuse(path, f"'{key}' is missing", f"write each as {{{key}: ...}}")
        return None if missing else entry

    def read_node(self, path: Path) -> None:
        entry = self._entry(path, ("id",))
        if entry is None:
            return
        fields, misfits = fields_of(entry, OF_STATES, USUAL)
        self._misfits(path, misfits)
        if self.document.node(self.path).tag == TAG:  # GraphML has no lists
            words = (word.strip() for text in fields.get("labels", ()) for word in text.split(","))
            fields["labels"] = frozenset(word for word in words if word)
        key = _key(entry["id"])
        origin = key if isinstance(key, str | int) else None
        self.add_node(key, State(str(key), **fields, origin=origin), path)

    def read_link(self, path: Path, *, directed: bool) -> None:
        entry = self._entry(path, _ENDS)
        if entry is None:
            return
        ends = [self.name_of(_key(entry[end]), (*path, end)) for end in _ENDS]
        fields, misfits = fields_of(entry, OF_EDGES, USUAL)
        length, wrong = length_of(entry, LENGTHS)
        self._misfits(path, [*misfits, *wrong])
        if length is None:
            length = self.distance(ends[0], ends[1])
        both = not bool(entry.get("directed", directed)) and ends[0] != ends[1]
        self.add_ride((ends[0], ends[1]), Ride(length), path, **fields, both_ways=both)


def _key(value: Any) -> Any:
    """The id of a node as something that can be looked up: of lists, the tuple that they were."""
    return tuple(map(_key, value)) if isinstance(value, list) else value


def read_node_link(document: Document, path: Path, settings: MapSettings) -> TransitionSystem:
    """A graph of nodes and links; an undirected link goes both ways.

    Raises MapError with all that is wrong.
    """
    draft = _Draft(document, path, settings=settings)
    data = document.at(path)
    for index in range(len(data["nodes"])):
        draft.read_node((*path, "nodes", index))
    key = next(key for key in _EDGES if isinstance(data.get(key), list))
    for index in range(len(data[key])):
        draft.read_link((*path, key, index), directed=data.get("directed") is True)
    whole = data.get("graph")
    whole = whole if isinstance(whole, dict) else {}
    zones = whole.get("zones")
    draft.zones = zones if isinstance(zones, dict) else {}
    name = whole.get("name", "")
    return draft.finished(name if isinstance(name, str) else "")
