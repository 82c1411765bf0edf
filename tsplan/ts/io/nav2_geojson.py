"""Route graphs of Nav2, GeoJSON: points are nodes, lines are directed edges between their ids.

The format is described at https://docs.nav2.org/configuration/packages/configuring-route-server.html.
Edges are straight whatever their geometry says, as Nav2's own reader takes them. Of the metadata of
an edge `abs_time_taken` is how long it takes, in seconds, `abs_speed_limit` the most metres a
second there, and `speed_limit` the share of its speed that a robot drives at.
"""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from tsplan.document import Document, Path
from tsplan.document.fields import Natural, Number, Truth, Word
from tsplan.ts.edges import State
from tsplan.ts.io.graph_draft import GraphDraft
from tsplan.ts.io.label_areas import metadata_labels
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.ride_durations import Ride
from tsplan.ts.system import TransitionSystem

_LINES = ("LineString", "MultiLineString")
_FRAME = "map"  # the frame of nodes that name none
_PERCENT = 100.0


class _Loose(BaseModel):
    model_config = ConfigDict(extra="ignore", defer_build=True)


class _Node(_Loose):
    id: Natural
    frame: Word = _FRAME
    metadata: dict[str, Any] = {}
    operations: Any = None


class _Edge(_Loose):
    id: Natural | None = None
    startid: Natural
    endid: Natural
    cost: Number = 0.0
    overridable: Truth = True
    metadata: dict[str, Any] = {}
    operations: Any = None


class _Point(_Loose):
    coordinates: Annotated[list[Number], Field(min_length=2)]


def is_route_graph(document: Document, path: Path) -> bool:
    """Whether what stands at a path is GeoJSON with an edge between ids, or a node with one."""
    data = document.at(path)
    if not isinstance(data, dict) or data.get("type") != "FeatureCollection":
        return False
    features = data.get("features")
    return isinstance(features, list) and any(
        isinstance(feature, dict)
        and isinstance(feature.get("properties"), dict)
        and ("startid" in feature["properties"] or "id" in feature["properties"])
        for feature in features
    )


class _Draft(GraphDraft):
    PARTS = {"source": ("properties", "startid"), "target": ("properties", "endid")}  # noqa: RUF012

    def read_node(self, path: Path) -> str | None:
        """Take in a node; its frame."""
        point = self.part(_Point, (*path, "geometry"))
        node = self.part(_Node, (*path, "properties"))
        if node is None:
            return None
        at = None if point is None else (point.coordinates[0], point.coordinates[1])
        labels = frozenset(metadata_labels(node.metadata))
        self.add_node(node.id, State(str(node.id), labels, at, origin=node.id), path)
        if node.operations:
            self.drop("a node has operations, which are not planned", (*path, "properties"))
        return node.frame

    def read_edge(self, path: Path) -> None:
        properties = (*path, "properties")
        edge = self.part(_Edge, properties)
        if edge is None:
            return
        ends = (
            self.name_of(edge.startid, (*properties, "startid")),
            self.name_of(edge.endid, (*properties, "endid")),
        )
        for key in ("operations", "penalty", "class"):
            if key == "operations" and edge.operations:
                self.drop("an edge has operations, which are not planned", properties)
            elif key in edge.metadata:
                where = (*properties, "metadata", key)
                self.drop(f"an edge has a {key}, which is not used", where)
        fixed = edge.cost > 0 or not edge.overridable
        fields = {"cost": edge.cost} if fixed else {}
        self.add_ride(ends, self._ride(ends, edge.metadata, properties), path, **fields)

    def _ride(
        self, ends: tuple[str | None, str | None], metadata: dict[str, Any], path: Path
    ) -> Ride:
        """How long an edge takes, by its length and by what its metadata say."""
        numbers = {
            key: self.number((*path, "metadata", key), above=0.0)
            for key in ("abs_time_taken", "abs_speed_limit", "speed_limit")
            if key in metadata
        }
        share = numbers.get("speed_limit") or 1.0
        return Ride(
            length=self.distance(*ends),
            seconds=numbers.get("abs_time_taken"),
            limit=numbers.get("abs_speed_limit"),
            share=share / _PERCENT if share > 1 else share,
        )


def read_route_graph(document: Document, path: Path, settings: MapSettings) -> TransitionSystem:
    """A route graph; the states are called by the nodes' ids.

    Raises MapError with all that is wrong.
    """
    draft = _Draft(document, path, settings=settings)
    features = document.at((*path, "features"))
    kinds = [_kind(feature) for feature in features]
    frames: dict[str, None] = {}
    for index, kind in enumerate(kinds):
        where = (*path, "features", index)
        if kind == "Point":
            frame = draft.read_node(where)
            frames |= {} if frame is None else {frame: None}
        elif kind not in _LINES:
            draft.drop(
                f"a feature is a {kind or 'thing without geometry'}, which is not used", where
            )
    for index, kind in enumerate(kinds):
        if kind in _LINES:
            draft.read_edge((*path, "features", index))
    if len(frames) > 1:
        draft.note(path, f"the nodes are in several frames ({', '.join(frames)}), taken for one")
    name = document.at(path).get("name")
    return draft.finished(name if isinstance(name, str) else "", frame=next(iter(frames), None))


def _kind(feature: Any) -> str | None:
    """What the geometry of a feature is called."""
    geometry = feature.get("geometry") if isinstance(feature, dict) else None
    kind = geometry.get("type") if isinstance(geometry, dict) else None
    return kind if isinstance(kind, str) else None
