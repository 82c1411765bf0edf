"""Open-RMF: for every robot one request of a composed task.

What is written are messages `robot_task_request` (https://github.com/open-rmf/rmf_api_msgs) with
tasks of the category `compose`, whose phases are the activities `go_to_place`, `pickup`, `dropoff`
and `perform_action` (https://github.com/open-rmf/rmf_ros2, rmf_fleet_adapter/schemas).
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from typing import Any, TypeAlias

from tsplan.errors import Finding, PlanError
from tsplan.name_runs import Names
from tsplan.plans.cargo_rows import AgentLoads, carried_by, loads_of
from tsplan.plans.records import as_json
from tsplan.plans.supplies import Loads
from tsplan.ts import State
from tsplan.writers.handover import Handover
from tsplan.writers.journeys import Journey, Stop
from tsplan.writers.json_parts import array

_KEPT = 1024  # journeys whose phases are kept for the agents that follow
_MILLIS = 1000  # in a second

Activity: TypeAlias = "dict[str, Any]"
"""A `category` and its `description`."""


def write(handover: Handover) -> Iterator[str]:
    """A list of requests, one robot a line; its fleet is called as its class.

    A robot goes to every state of its path in turn, by the original name or number of the waypoint,
    else by the state's name. Where it stays it performs the action `wait`, of which the description
    says from and until when, and RMF how long that takes where the map knows it. Where it stays it
    drops off all that it carries, as what lies at a state is there for every task and every robot,
    and picks up what it takes along when it leaves; where it only comes by it does so with what it
    does not keep.

    Raises
    ------
    PlanError
        The plan has structures of modules, or parts of pieces are carried.

    """
    loads = loads_of(handover.plan.cargo)
    _refuse(handover, loads)
    bare = lru_cache(_KEPT)(lambda journey: _phases(handover, journey, ({},) * len(journey.visits)))

    def requests() -> Iterator[str]:
        for agent, journey in handover.journeys():
            carried = _carried(agent, journey, loads)
            loaded = any(carried)
            phases = _phases(handover, journey, carried) if loaded else bare(journey)
            yield _request(handover, agent, journey.class_name, phases)

    yield from array(requests())
    yield "\n"


def _refuse(handover: Handover, loads: AgentLoads) -> None:
    if handover.plan.structures:
        what = "the robots of the plan are built together, and RMF knows no robots that are"
        raise PlanError([Finding(what, "export as csv, geojson, graphml or nav2")])
    agents = Names.of([agent for agent, _ in handover.journeys()] if loads else [])
    parted = {
        row.resource
        for rows in loads.values()
        for row in rows
        if not float(row.amount).is_integer() and agents.among(row.names)
    }
    if parted:
        remedy = "choose a unit in which what is carried is whole, and say 'indivisible: true'"
        raise PlanError(
            Finding(f"parts of '{name}' are carried, and RMF carries whole pieces", remedy)
            for name in sorted(parted)
        )


def _carried(agent: str, journey: Journey, loads: AgentLoads) -> tuple[Loads, ...]:
    """What an agent carries from each of its visits on."""
    steps = (stop.last for stop in journey.visits)
    one = Names.of([agent])
    return tuple({} if step is None else carried_by(one, step, loads) for step in steps)


def _request(handover: Handover, agent: str, fleet: str, phases: str) -> str:
    name = handover.plan.mission.name
    head = as_json({"type": "robot_task_request", "robot": agent, "fleet": fleet})[:-1]
    task = as_json({"category": "tsplan", "detail": name})[:-1]
    labels = ["tsplan", *([f"mission={name}"] if name else [])]
    more = as_json({"requester": "tsplan", "labels": labels})[1:]
    return (
        f'{head}, "request": {{"category": "compose", "description": {task}, '
        f'"phases": {phases}}}, {more}}}'
    )


def _phases(handover: Handover, journey: Journey, carried: tuple[Loads, ...]) -> str:
    """The phases of a journey as JSON."""
    activities: list[Activity] = []
    for stop, (before, after) in zip(journey.visits, pairwise(({}, *carried)), strict=True):
        place = waypoint(handover.system.states[stop.state])
        stays = stop.first != stop.last
        activities.append({"category": "go_to_place", "description": place})
        activities += _transfer("dropoff", place, before, {} if stays else after)
        activities += _wait(handover, stop)
        activities += _transfer("pickup", place, after, {} if stays else before)
    return as_json([{"activity": activity} for activity in activities])


def waypoint(state: State) -> str | int:
    """How RMF knows a state: by the name or number of its waypoint.

    >>> [waypoint(State("q1", origin=origin)) for origin in ("lounge", 7, None)]
    ['lounge', 7, 'q1']
    """
    origin = state.origin
    if isinstance(origin, int):
        return origin if origin >= 0 else state.name
    return origin or state.name


def _transfer(category: str, place: str | int, more: Loads, kept: Loads) -> Iterator[Activity]:
    """A phase for what there is `more` of than is kept, if there is any."""
    moved = {name: amount - kept.get(name, 0.0) for name, amount in more.items()}
    payload = [{"sku": name, "quantity": int(n)} for name, n in moved.items() if n > 0]
    if payload:
        yield {"category": category, "description": {"place": place, "payload": payload}}


def _wait(handover: Handover, stop: Stop) -> Iterator[Activity]:
    if stop.first is None or stop.last is None or stop.last == stop.first:
        return
    when: dict[str, Any] = {"from_step": stop.first, "until_step": stop.last}
    action: dict[str, Any] = {"category": "wait", "description": when}
    begin, end = handover.seconds(stop.first), handover.seconds(stop.last)
    if begin is not None and end is not None:
        when |= {"from": begin, "until": end}
        action["unix_millis_action_duration_estimate"] = round((end - begin) * _MILLIS)
    yield {"category": "perform_action", "description": action}
