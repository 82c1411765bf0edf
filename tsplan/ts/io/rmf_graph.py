"""Navigation graphs of Open-RMF, YAML: vertices and directed lanes on the levels of a building.

What the keys mean, and how many seconds doors, docks and lifts take, is as in RMF's own reader,
`parse_graph` of rmf_fleet_adapter (https://github.com/open-rmf/rmf_ros2): a door opens for 4
seconds and closes for 4, a lift is called for 4, rides for 1 from one of its levels to the next,
and opens for 4; docking takes 5. A mutex group is a zone for one robot, and so is a lift with the
lanes that lead there and away.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from tsplan.document import Document, Path
from tsplan.document.fields import Number
from tsplan.ts.edges import State
from tsplan.ts.io.graph_draft import GraphDraft
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.ride_durations import Ride
from tsplan.ts.system import TransitionSystem

DOOR_SECONDS = 8.0  # to open and to close
LIFT_SECONDS, FLOOR_SECONDS = 4.0, 1.0
DOCK_SECONDS = 5.0
_ALIGNED = 0.1  # metres by which the places of a lift may differ from level to level

_FLAGS = {
    "is_charger": "charger",
    "is_holding_point": "holding_point",
    "is_parking_spot": "parking_spot",
    "is_cleaning_zone": "cleaning_zone",
    "pickup_dispenser": "pickup",
    "dropoff_ingestor": "dropoff",
}
"""Properties of vertices that give a label."""


class _Vertex(BaseModel):
    model_config = ConfigDict(extra="allow", defer_build=True)
    name: str | int | None = ""
    lift: str | int | None = ""
    mutex: str | int | None = ""


class _Lane(BaseModel):
    model_config = ConfigDict(extra="allow", defer_build=True)
    speed_limit: Annotated[Number, Field(ge=0)] = 0.0
    door_name: str | int | None = ""
    dock_name: str | int | None = ""
    mutex: str | int | None = ""
    orientation_constraint: str | None = ""


def is_rmf_graph(document: Document, path: Path) -> bool:
    """Whether what stands at a path has levels with vertices."""
    data = document.at(path)
    levels = data.get("levels") if isinstance(data, dict) else None
    return isinstance(levels, dict) and any(
        isinstance(level, dict) and "vertices" in level for level in levels.values()
    )


class _Draft(GraphDraft):
    PARTS = {"source": (0,), "target": (1,)}  # noqa: RUF012

    def read_vertex(self, key: tuple[str, int], path: Path, number: int, *, several: bool) -> None:
        """Take in a vertex; `number` is its number in the whole graph."""
        level, index = key
        entry = self.document.at(path)
        if not isinstance(entry, list) or not 2 <= len(entry) <= 3:  # noqa: PLR2004 - x, y, more
            self.refuse(path, "a vertex is not [x, y, {name: ...}]", "write it so")
            self.add_node(key, State(f"{level}_{index}"), path)  # lanes know it all the same
            return
        at = self.number((*path, 0)), self.number((*path, 1))
        more = self._options(_Vertex, (*path, 2), len(entry) > 2)  # noqa: PLR2004
        given = {} if more is None else more.model_dump()
        more = more or _Vertex()
        lift, name = str(more.lift or ""), str(more.name or "")
        labels = {label for key, label in _FLAGS.items() if given.get(key)}
        labels |= {lift} if lift else set()
        labels |= {level} if several else set()
        zone = str(more.mutex or "") or lift or None
        if zone is not None:
            self.zones[zone] = 1
        state = State(
            name or f"{level}_{index}",
            frozenset(labels),
            None if at[0] is None or at[1] is None else (at[0], at[1]),
            zone=zone,
            level=level,
            origin=name or number,
        )
        self.add_node(key, state, path)
        if lift:
            self.lifts.setdefault(lift, []).append((key, path))
            self.lift_of[key] = lift

    def _options(self, schema: type[Any], path: Path, given: bool) -> Any:
        """The properties of a vertex or a lane, which may be left out."""
        return self.part(schema, path) if given else schema()

    def read_lane(self, level: str, path: Path) -> bool:
        """Take in a lane; whether RMF's own reader puts a vertex of its own on it."""
        entry = self.document.at(path)
        if not isinstance(entry, list) or not 2 <= len(entry) <= 3:  # noqa: PLR2004
            self.refuse(path, "a lane is not [from, to, {...}]", "write it so")
            return False
        lane = self._options(_Lane, (*path, 2), len(entry) > 2)  # noqa: PLR2004
        keys = [(level, entry[0]), (level, entry[1])]
        ends = [self._end(key, (*path, place)) for place, key in enumerate(keys)]
        if lane is None:
            return False
        inside = [self.lift_of.get(key, "") if isinstance(key[1], int) else "" for key in keys]
        if inside[0] and inside[1] and inside[0] != inside[1]:
            what = f"a lane leads from the lift '{inside[0]}' into the lift '{inside[1]}'"
            self.refuse(path, what, "put a vertex between them")
        event = inside[0] != inside[1] or (not any(inside) and bool(lane.door_name))
        pause = DOCK_SECONDS if lane.dock_name else 0.0
        if inside[0] != inside[1]:
            pause += LIFT_SECONDS
        elif event:
            pause += DOOR_SECONDS
        if lane.orientation_constraint:
            where = (*path, 2, "orientation_constraint")
            self.drop("a lane has an orientation_constraint, which is not planned", where)
        zone = str(lane.mutex or "") or inside[0] or inside[1] or None
        if zone is not None:
            self.zones[zone] = 1
        length = self.distance(ends[0], ends[1])
        ride = Ride(length=length, limit=lane.speed_limit or None, pause=pause)
        self.add_ride((ends[0], ends[1]), ride, path, zone=zone)
        return event and bool(lane.dock_name)

    def _end(self, key: tuple[str, Any], path: Path) -> str | None:
        if isinstance(key[1], int) and key in self._names:
            return self._names[key]
        self.refuse(path, f"the level '{key[0]}' has no vertex {key[1]}", "they count from 0")
        return None

    def read_lift(self, name: str) -> None:
        """Connect the levels of a lift, one after the other as RMF does."""
        places = self.lifts[name]
        for (one, _), (two, path) in pairwise(places):
            ends = self._names[one], self._names[two]
            if self.distance(*ends) > _ALIGNED:
                what = f"the lift '{name}' is {self.distance(*ends):.2f} m away from where it was"
                self.refuse(path, what, f"its vertices lie within {_ALIGNED} m of each other")
            for pair in (ends, ends[::-1]):
                self.add_ride(pair, Ride(seconds=FLOOR_SECONDS), path, zone=name)
        _, path = places[0]
        what = f"the lift '{name}' has {len(places)} levels and carries one robot at a time"
        self.zones[name] = 1
        self.note(path, what)

    lifts: dict[str, list[tuple[tuple[str, int], Path]]]
    lift_of: dict[tuple[str, Any], str]

    def read_level(self, level: str, path: Path, first: int, *, several: bool) -> int:
        """Take in a level whose first vertex has a number; the number of the next level's first."""
        entry = self.document.at(path)
        for kind in ("walls", "measurements"):
            if kind in entry:
                what = f"the level '{level}' has {kind}, as files of the traffic editor do"
                self.refuse((*path, kind), what, "name the navigation graph that is made of it")
                return first
        vertices, lanes = entry.get("vertices") or [], entry.get("lanes") or []
        for key, given in (("vertices", vertices), ("lanes", lanes)):
            if not isinstance(given, list):
                self.refuse((*path, key), f"{key} is not a list", "write it as [...]")
                return first
        for index in range(len(vertices)):
            where = (*path, "vertices", index)
            self.read_vertex((level, index), where, first + index, several=several)
        added = [self.read_lane(level, (*path, "lanes", index)) for index in range(len(lanes))]
        return first + len(vertices) + sum(added)


def read_rmf_graph(document: Document, path: Path, settings: MapSettings) -> TransitionSystem:
    """A navigation graph; vertices without names are called by their level and number.

    Raises MapError with all that is wrong.
    """
    draft = _Draft(document, path, settings=settings)
    draft.lifts, draft.lift_of = {}, {}
    data, number = document.at(path), 0
    levels = data["levels"]
    for level, entry in levels.items():
        where = (*path, "levels", level)
        if isinstance(entry, dict):
            number = draft.read_level(level, where, number, several=len(levels) > 1)
        else:
            draft.refuse(where, f"the level '{level}' is not a mapping", "give it vertices")
    for name in draft.lifts:
        draft.read_lift(name)
    known = data.get("lifts")
    for name in known if isinstance(known, dict) else ():
        if name not in draft.lifts:
            draft.note((*path, "lifts", name), f"no vertex is in the lift '{name}'")
    name = data.get("building_name", data.get("name"))
    return draft.finished(name if isinstance(name, str) else "", frame=None)
