"""GeoJSON: for every agent the line that it goes, with the steps of its points."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from tsplan.errors import Finding, MapError
from tsplan.plans.records import as_json
from tsplan.ts.state_places import Point
from tsplan.writers.handover import Handover
from tsplan.writers.journeys import Journey
from tsplan.writers.json_parts import document

_KEPT = 1024  # journeys whose lines are kept for the agents that follow


def write(handover: Handover) -> Iterator[str]:
    """A collection of features (RFC 7946), each a line with `steps`, `states` and `seconds`.

    A stay of several steps has two points, where it begins and where it ends. Who is seen at one
    step alone has a point instead of a line.

    Raises
    ------
    MapError
        A state that somebody comes to has no coordinates.

    """
    refuse_placeless(handover)
    shared = lru_cache(_KEPT)(lambda journey: _parts(handover, journey))
    head = {"type": "FeatureCollection", "name": handover.plan.mission.name}
    yield from document(head, {"features": _features(handover, shared)})


def refuse_placeless(handover: Handover) -> None:
    """Raise MapError for the states without coordinates."""
    lost = [state for state in handover.states if handover.place(state) is None]
    if lost:
        remedy = "give it coordinates, as in 'at: [2.5, 1]', or name another file with --map"
        raise MapError(Finding(f"the state '{name}' has no coordinates", remedy) for name in lost)


def _features(handover: Handover, shared: Any) -> Iterator[str]:
    for agent, journey in handover.journeys():
        geometry, properties = shared(journey)
        told = f"{as_json({'agent': agent})[:-1]}, {properties[1:]}"
        yield f'{{"type": "Feature", "geometry": {geometry}, "properties": {told}}}'


def _parts(handover: Handover, journey: Journey) -> tuple[str, str]:
    """The geometry of a journey and its properties, but for the agent's name, as JSON."""
    seen: list[tuple[int, str, Point]] = []
    for first, last, state in journey.stays:
        place = handover.place(state)
        assert place is not None, "refused before"
        seen += [(step, state, place) for step in dict.fromkeys((first, last))]
    line = [list(place) for _, _, place in seen]
    single = len(line) == 1
    geometry = {"type": "Point" if single else "LineString"}
    properties: dict[str, Any] = {
        "class": journey.class_name,
        "steps": [step for step, _, _ in seen],
        "states": [state for _, state, _ in seen],
    }
    if handover.timed:
        properties["seconds"] = [handover.seconds(step) for step, _, _ in seen]
    if journey.heading is not None:
        properties["heading"] = journey.heading
    return as_json({**geometry, "coordinates": line[0] if single else line}), as_json(properties)
