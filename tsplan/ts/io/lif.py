"""Layouts of the VDMA's Layout Interchange Format (LIF), JSON: nodes, directed edges and stations.

Read are the versions below 3 (https://github.com/Intralogistics-2X-LIF): up to 1 a file has
`layouts` and properties by `vehicleTypeId`, from 2 on layouts stand in `origins` and properties
name `mobileRobotTypes`. The types of vehicles are classes of robots. A station gives its name as a
label to the nodes from which it is worked at.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from tsplan.document import Document, Path
from tsplan.document.fields import Number, Word
from tsplan.ts.edges import DEFAULT, State
from tsplan.ts.io.graph_draft import GraphDraft
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.ride_durations import Ride
from tsplan.ts.system import TransitionSystem

VERSIONS = ("0", "1", "2")
_UNUSED = ("actions", "trajectory", "loadRestriction", "corridor")


class _Loose(BaseModel):
    model_config = ConfigDict(extra="ignore", defer_build=True)


class _Position(_Loose):
    x: Number
    y: Number


class _Node(_Loose):
    node_id: Word = Field(alias="nodeId")
    node_name: str = Field("", alias="nodeName")
    position: _Position = Field(alias="nodePosition")


class _Properties(_Loose):
    vehicle: Word | None = Field(None, alias="vehicleTypeId")
    robot: Word | None = Field(None, alias="mobileRobotTypeId")
    robots: list[dict[str, Any]] = Field([], alias="mobileRobotTypes")
    most: Annotated[Number, Field(gt=0)] | None = Field(None, alias="maxSpeed")

    @property
    def types(self) -> list[str]:
        """The types of vehicles that are meant."""
        series = [str(each.get("seriesName", "")) for each in self.robots]
        return [name for name in (self.vehicle, self.robot, *series) if name]


class _Edge(_Loose):
    source: Word = Field(alias="startNodeId")
    target: Word = Field(alias="endNodeId")
    vehicles: list[_Properties] = Field([], alias="vehicleTypeEdgeProperties")
    robots: list[_Properties] = Field([], alias="mobileRobotTypeEdgeProperties")

    @property
    def limits(self) -> dict[str, float | None]:
        """The most metres a second of every type that may go there; nothing where none is told."""
        each = (*self.vehicles, *self.robots)
        return {name: part.most for part in each for name in part.types}


class _Station(_Loose):
    station_id: Word = Field(alias="stationId")
    station_name: str = Field("", alias="stationName")
    nodes: list[Word] = Field([], alias="interactionNodeIds")


def is_layout(document: Document, path: Path) -> bool:
    """Whether what stands at a path has layouts of LIF."""
    data = document.at(path)
    if not isinstance(data, dict):
        return False
    return isinstance(data.get("layouts"), list) or (
        "metaInformation" in data and isinstance(data.get("origins"), list)
    )


def _layouts(document: Document, path: Path) -> Iterator[Path]:
    """Where the layouts stand."""
    data = document.at(path)
    for index, _ in enumerate(data.get("layouts") or ()):
        yield (*path, "layouts", index)
    for place, origin in enumerate(data.get("origins") or ()):
        layouts = origin.get("layouts") if isinstance(origin, dict) else None
        for index, _ in enumerate(layouts if isinstance(layouts, list) else ()):
            yield (*path, "origins", place, "layouts", index)


class _Draft(GraphDraft):
    PARTS = {"source": ("startNodeId",), "target": ("endNodeId",)}  # noqa: RUF012

    def listed(self, path: Path, key: str) -> Iterator[Path]:
        """The entries of a list of a layout, which may be missing."""
        layout = self.document.at(path)
        given = layout.get(key) if isinstance(layout, dict) else None
        if given is not None and not isinstance(given, list):
            self.refuse((*path, key), f"{key} is not a list", "write it as [...]")
            return
        yield from ((*path, key, index) for index in range(len(given or ())))

    def read_node(self, path: Path, level: str | None, stations: Mapping[str, set[str]]) -> None:
        """Take in a node, which is labelled by its stations and its name."""
        node = self.part(_Node, path)
        if node is None:
            return
        labels = stations.get(node.node_id, set()) | ({node.node_name} - {"", node.node_id})
        labels |= set() if level is None else {level}
        at = node.position.x, node.position.y
        state = State(node.node_id, frozenset(labels), at, level=level, origin=node.node_id)
        self.add_node(node.node_id, state, path)

    def read_edge(self, path: Path, types: frozenset[str]) -> None:
        """Take in an edge; of `types` are all vehicles of the file."""
        edge = self.part(_Edge, path)
        if edge is None:
            return
        ends = (
            self.name_of(edge.source, (*path, "startNodeId")),
            self.name_of(edge.target, (*path, "endNodeId")),
        )
        limits = edge.limits
        one = next(iter(limits.values()), None)
        alike = limits.keys() >= types and len(set(limits.values())) <= 1
        for part in (*_dicts(self.document.at(path), "vehicleTypeEdgeProperties"),):
            for key in _UNUSED:
                if part.get(key):
                    self.drop(f"an edge has {key}, which is not planned", path)
        limit: Any = one if alike or not limits else {**limits, **_others(limits, types)}
        self.add_ride(ends, Ride(length=self.distance(*ends), limit=limit), path)


def _others(limits: Mapping[str, float | None], types: frozenset[str]) -> dict[str, float | None]:
    """What classes that are no type of the file drive at, where every type may go: the slowest."""
    if not limits.keys() >= types:
        return {}
    told = [limit for limit in limits.values() if limit is not None]
    return {DEFAULT: min(told) if told else None}


def _dicts(entry: Any, key: str) -> Iterable[dict[str, Any]]:
    given = entry.get(key) if isinstance(entry, dict) else None
    return [part for part in given if isinstance(part, dict)] if isinstance(given, list) else []


def read_layout(document: Document, path: Path, settings: MapSettings) -> TransitionSystem:
    """The layouts of a file as one map; the states are called by the ids of the nodes.

    Raises MapError with all that is wrong.
    """
    draft = _Draft(document, path, settings=settings)
    data = document.at(path)
    meta = data.get("metaInformation")
    version = str(meta.get("lifVersion", "")) if isinstance(meta, dict) else ""
    if version and version.partition(".")[0] not in VERSIONS:
        where = (*path, "metaInformation", "lifVersion")
        draft.refuse(where, f"the version {version} is not known", "known: 0.x, 1.x and 2.x")
    layouts = list(_layouts(document, path))
    levels = [str(_of(document.at(place), "layoutLevelId", "layoutId")) for place in layouts]
    several = len(set(levels)) > 1
    stations: dict[str, set[str]] = {}
    worked: list[tuple[str, Path]] = []
    for place in layouts:
        for where in draft.listed(place, "stations"):
            station = draft.part(_Station, where)
            for number, node in enumerate(() if station is None else station.nodes):
                assert station is not None
                names = {station.station_id, station.station_name} - {""}
                stations.setdefault(node, set()).update(names)
                worked.append((node, (*where, "interactionNodeIds", number)))
    for place, level in zip(layouts, levels, strict=True):
        for where in draft.listed(place, "nodes"):
            draft.read_node(where, level if several else None, stations)
    for node, where in worked:
        draft.name_of(node, where)
    edges = [where for place in layouts for where in draft.listed(place, "edges")]
    types = frozenset(name for where in edges for name in _types(document.at(where)))
    for where in edges:
        draft.read_edge(where, types)
    name = meta.get("projectIdentification", meta.get("lifId")) if isinstance(meta, dict) else ""
    return draft.finished(name if isinstance(name, str) else "")


def _of(layout: Any, *keys: str) -> Any:
    """The first of some keys that a layout has."""
    given = layout if isinstance(layout, dict) else {}
    return next((given[key] for key in keys if given.get(key) not in (None, "")), "")


def _types(edge: Any) -> Iterator[str]:
    """The types of vehicles that the properties of an edge name."""
    for key in ("vehicleTypeEdgeProperties", "mobileRobotTypeEdgeProperties"):
        for part in _dicts(edge, key):
            for name in (part.get("vehicleTypeId"), part.get("mobileRobotTypeId")):
                if isinstance(name, str):
                    yield name
            yield from (str(each.get("seriesName")) for each in _dicts(part, "mobileRobotTypes"))
