"""A map of another program while it is read: nodes by their ids, and rides between them."""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

from tsplan.document import Path
from tsplan.document.fields import shown
from tsplan.document.validation import SchemaT
from tsplan.errors import Nearest
from tsplan.limits import is_number
from tsplan.ts.edges import Edge, State, missing_waits
from tsplan.ts.io.map_draft import MapDraft
from tsplan.ts.io.map_settings import PLAIN, MapSettings
from tsplan.ts.parallel_edges import choices, chosen
from tsplan.ts.ride_durations import Ride, steps_of
from tsplan.ts.system import TransitionSystem
from tsplan.ts.validity import is_point
from tsplan.words import nfc

_FARTHEST = 1e300  # metres: beyond, floats know no numbers; it is too far in any case
_NOTHING: Mapping[str, Path] = {}


@dataclass
class GraphDraft(MapDraft):
    """What has been read so far of a graph, each part with its place in the document.

    A format may say in `PARTS` where the fields of an edge stand below its entry.
    """

    STATES, EDGES = (), ()
    PARTS: ClassVar[Mapping[str, Path]] = _NOTHING

    settings: MapSettings = PLAIN
    _places: dict[str, Path] = field(default_factory=dict)
    _names: dict[Hashable, str] = field(default_factory=dict)
    _points: dict[str, tuple[float, float] | None] = field(default_factory=dict)
    _dropped: dict[str, tuple[int, Path]] = field(default_factory=dict)
    _closest: Nearest | None = None

    def state_path(self, name: str) -> Path:
        """Where the node of a state is written."""
        return self._places.get(nfc(name), self.path)

    def edge_part(self, path: Path, part: str) -> Path:
        """Where a field of an edge stands."""
        return (*path, *self.PARTS.get(part, ()))

    def add_node(self, key: Hashable, state: State, path: Path) -> None:
        """Take in the node that files call `key`; a state whose name is taken gets another one."""
        if not self._is_id(key, path):
            return
        if key in self._names:
            line, _ = self.document.place(self._places[self._names[key]])
            what = f"the id '{key}' is taken: it is that of the node in line {line}"
            self.refuse(path, what, "give each node an id of its own")
            return
        name, number = state.name, 2
        while name in self._places:
            name, number = f"{state.name}_{number}", number + 1
        self._names[key], self._places[name] = name, path
        self._points[name] = state.at if is_point(state.at) else None
        self.states.append(state if name == state.name else replace(state, name=name))

    def name_of(self, key: Hashable, path: Path) -> str | None:
        """The state of the node that files call `key`; a finding where there is none."""
        if not self._is_id(key, path):
            return None
        if key not in self._names:
            if self._closest is None:
                self._closest = Nearest(map(str, self._names))
            self.refuse(path, f"no node has the id '{key}'", self._closest(str(key)))
            return None
        return self._names[key]

    def _is_id(self, key: Hashable, path: Path) -> bool:
        """Whether something can be an id; a finding where it cannot."""
        try:
            hash(key)
        except TypeError:
            self.refuse(path, f"{shown(key)} is no id", "write a text or a whole number")
            return False
        return True

    def part(self, schema: type[SchemaT], path: Path) -> SchemaT | None:
        """A part of the document by a schema; None, and findings, where it does not fit."""
        try:
            return super().part(schema, path)
        except KeyError:
            self.refuse(path[:-1], f"'{path[-1]}' is missing", "add it")
            return None

    def add_ride(
        self, ends: tuple[str | None, str | None], ride: Ride, path: Path, **fields: Any
    ) -> None:
        """Take in an edge whose duration is that of a ride; nothing where an end is not known."""
        source, target = ends
        if source is None or target is None:
            return
        duration = steps_of(ride, self.settings.seconds, self.settings.pace)
        edge = Edge(source, target, **{"duration": duration, **fields})
        self.add_edge(edge, path, back=edge.both_ways and not edge.is_wait)

    def distance(self, source: str | None, target: str | None) -> float:
        """The way straight from one state to another; 0 where one of them has no coordinates."""
        one, two = self._points.get(source or ""), self._points.get(target or "")
        return 0.0 if one is None or two is None else min(math.dist(one, two), _FARTHEST)

    def drop(self, what: str, path: Path) -> None:
        """Note that something is not used; the same words are counted, and placed at the first."""
        count, first = self._dropped.get(what, (0, path))
        self._dropped[what] = count + 1, first

    def note(self, path: Path, message: str, remedy: str = "") -> None:
        """Note something that was chosen."""
        self.notes.append(self.document.finding(path, message, remedy))

    def number(self, path: Path, *, above: float | None = None) -> float | None:
        """The number at a path, None and a finding where there is none or it is too small."""
        value = self.document.at(path)
        if not is_number(value):
            self.refuse(path, f"{path[-1]}: {shown(value)} is not a number", "write one")
            return None
        if above is not None and value <= above:
            what = f"{path[-1]}: {shown(value)} should be more than {above:g}"
            self.refuse(path, what, "correct it, or leave it out")
            return None
        return float(value)

    def finished(self, name: str, *, frame: str | None = None) -> TransitionSystem:
        """The map: of parallel edges one is kept, and agents can wait unless that is refused."""
        for what, (count, path) in self._dropped.items():
            times = f" ({count} times)" if count > 1 else ""
            self.note(path, f"{what}{times}")
        self._keep_best()
        waits = self.settings.waiting is not False
        more = missing_waits(self.states, self.edges) if waits else ()
        seconds = self.settings.seconds
        return self.system(name, more, step_seconds=seconds, frame=frame)

    def _keep_best(self) -> None:
        made = list(choices(self.edges))
        for choice in made:
            path, reverse = self._origins[choice.dropped[0]]
            if not reverse:
                self.note(path, *choice.words(self.edges))
        left = chosen(self.edges, made)
        self.edges = list(left.values())
        self._origins = [self._origins[number] for number in left]
