"""Nav2: for every robot the nodes of a route graph that it visits, and when.

The ids are those of the route graph's nodes: `start_id` and `goal_id` of Nav2's action
`ComputeAndTrackRoute` (https://docs.nav2.org, package nav2_msgs), whole numbers of 16 bits.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import pairwise
from typing import Any

from tsplan.errors import Finding, MapError
from tsplan.plans.records import as_json
from tsplan.ts import State
from tsplan.writers.handover import Handover
from tsplan.writers.journeys import Journey
from tsplan.writers.json_parts import document

MOST_ID = 2**16 - 1
"""The largest id that Nav2's actions can name."""

_KEPT = 1024  # journeys whose routes are kept for the agents that follow


def write(handover: Handover) -> Iterator[str]:
    """One robot a line: `robot`, `class`, its `nodes`, its `visits`, and its `goals`.

    A visit has the `node` and the name of its `state`, its coordinates, and the steps at which the
    robot arrives and leaves, in seconds, too, where the map knows how long a step takes; a robot
    that is there when the plan ends leaves never. The goal of a number leads from the visit of that
    number to the next, and is what `ComputeAndTrackRoute` is asked for when that visit is over.

    Raises
    ------
    MapError
        A state has no id of Nav2's, or two have the same.

    """
    ids = node_ids(handover)
    shared = lru_cache(_KEPT)(lambda journey: as_json(_route(handover, ids, journey)))
    head = {
        "format": "tsplan-nav2/1",
        "mission": handover.plan.mission.name,
        "horizon": handover.plan.horizon,
        "step_seconds": handover.system.step_seconds,
    }
    yield from document(head, {"robots": _robots(handover, shared)})


def node_ids(handover: Handover) -> Mapping[str, int]:
    """The ids of the states that are visited; MapError for those that have none of their own."""
    findings: list[Finding] = []
    ids: dict[str, int] = {}
    named: dict[int, str] = {}
    for name in handover.states:
        number = _node_id(handover.system.states[name])
        if number is None:
            what = f"the state '{name}' has no id of a node (a whole number 0..{MOST_ID:,})"
            remedy = "name the route graph that the map was made from with --map, or write 'origin'"
            findings.append(Finding(what, remedy))
        elif (other := named.setdefault(number, name)) != name:
            what = f"the states '{other}' and '{name}' have the same id {number}"
            findings.append(Finding(what, "give each node an id of its own"))
        else:
            ids[name] = number
    if findings:
        raise MapError(findings)
    return ids


def _node_id(state: State) -> int | None:
    """The original id of a state, else its name if that is a number; None for no id of Nav2's."""
    number: str | int = state.name if state.origin is None else state.origin
    if isinstance(number, str):
        plain = number.isascii() and number.isdecimal() and len(number) <= len(str(MOST_ID))
        number = int(number) if plain else -1
    return number if 0 <= number <= MOST_ID else None


def _robots(handover: Handover, shared: Any) -> Iterator[str]:
    for agent, journey in handover.journeys():
        yield f"{as_json({'robot': agent})[:-1]}, {shared(journey)[1:]}"


def _route(handover: Handover, ids: Mapping[str, int], journey: Journey) -> dict[str, Any]:
    """What is said of a robot after its name."""
    visits, end = [], handover.plan.horizon
    for stop in journey.visits:
        x, y = handover.place(stop.state) or (None, None)
        left = None if stop.last is None or stop.last >= end else stop.last
        visit = {"node": ids[stop.state], "state": stop.state, "x": x, "y": y}
        visit |= {"arrive_step": stop.first, "leave_step": left}
        if handover.timed:
            visit |= {"arrive": handover.seconds(stop.first), "leave": handover.seconds(left)}
        visits.append(visit)
    nodes = [visit["node"] for visit in visits]
    asked = {"use_start": False, "use_poses": False}
    return {
        "class": journey.class_name,
        "nodes": nodes,
        "visits": visits,
        "goals": [{"start_id": one, "goal_id": two, **asked} for one, two in pairwise(nodes)],
    }
