"""Two systems that move at once, and moves split into single steps.

The synchronous product is the usual one of transition systems (C. Baier and J.-P. Katoen,
Principles of Model Checking, 2008, section 2.2.6): both components take an edge at once.
Here an edge takes time, so both must take equally long.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from tsplan.errors import Finding, MapError
from tsplan.exact import exact
from tsplan.ts.edges import Edge, State
from tsplan.ts.system import TransitionSystem


def product(first: TransitionSystem, second: TransitionSystem) -> TransitionSystem:
    """The synchronous product: its states are pairs, and in every move both systems take an edge.

    The state `a|b` carries the labels and needs of both its parts. A joint edge takes the duration
    that both its parts share and needs what either needs; its cost is the sum of theirs. Waits are
    edges, so a system stands still only where it has one.

    Raises
    ------
    MapError
        The edges of the two systems do not all have one duration in common: a component would
        arrive while the other is still on its way. `unit_steps` makes every duration 1. Also for
        capacities, which bound each part's agents and have no meaning for pairs.

    >>> states, edges = [State("on"), State("off")], [Edge("on", "off"), Edge("off", "on")]
    >>> light = TransitionSystem.build(states, edges)
    >>> next(iter(product(light, light).edges))
    ('on|on', 'off|off')

    """
    faults = [*_without_capacities(first), *_without_capacities(second)]
    durations = {edge.duration for system in (first, second) for edge in system.edges.values()}
    if len(durations) > 1 or not all(isinstance(duration, int) for duration in durations):
        message = "the product is defined only where all edges of both systems take equally long"
        faults.append(Finding(message, "apply unit_steps to both systems first"))
    if faults:
        raise MapError(dict.fromkeys(faults))
    states = [
        State(_joint(one.name, two.name), one.labels | two.labels, needs=one.needs | two.needs)
        for one in first.states.values()
        for two in second.states.values()
    ]
    edges = [
        Edge(
            _joint(one.source, two.source),
            _joint(one.target, two.target),
            one.duration,
            float(exact(_cost(one)) + exact(_cost(two))),
            needs=one.needs | two.needs,
        )
        for one in first.edges.values()
        for two in second.edges.values()
    ]
    name = _joint(first.name, second.name) if first.name or second.name else ""
    return TransitionSystem.build(states, edges, name)


def _joint(one: str, two: str) -> str:
    return f"{one}|{two}"


def _cost(edge: Edge) -> float:
    # the durations are the same for every class here, so the class does not matter
    return edge.cost_for("")


def _without_capacities(system: TransitionSystem) -> Iterator[Finding]:
    states = any(state.capacity is not None for state in system.states.values())
    if states or system.capacity_groups or system.zones:
        message = f"the product is not defined for capacities, which '{system.name}' has"
        yield Finding(message, "build the systems without capacities")
    if system.timed:
        message = f"the product is not defined for places that are closed, as '{system.name}' has"
        yield Finding(message, "build the systems without them")


def unit_steps(system: TransitionSystem, class_name: str | None = None) -> TransitionSystem:
    """The same map with every move split into moves of one step each.

    An edge of duration w passes through w - 1 new states without labels, which only it uses: an
    agent there counts nowhere, as one on the edge does. The whole cost is paid and all is risked
    on entering it.
    Waits that take longer than one step are split in the same way.

    Parameters
    ----------
    system
        The map.
    class_name
        The class whose durations are meant, for maps where they differ; edges it cannot use are
        left out.

    Raises
    ------
    MapError
        Durations differ by class and none is named, or an edge that takes longer than one step
        has a capacity, which its single steps could not share.

    """
    faults: list[Finding] = []
    states, edges = list(system.states.values()), list[Edge]()
    for edge in system.edges.values():
        duration = edge.duration if class_name is None else edge.duration_for(class_name)
        if duration is None:
            continue
        if not isinstance(duration, int):
            message = f"the duration from '{edge.source}' to '{edge.target}' differs by class"
            faults.append(Finding(message, "name the class"))
        elif duration == 1:
            edges.append(replace(edge, duration=1))
        elif edge.closed:
            message = f"the edge from '{edge.source}' to '{edge.target}' is closed for a time"
            faults.append(Finding(message, "give it duration 1"))
        elif edge.zone is not None:
            # on the edge, an agent is in the zone from when it leaves, as it is at the states
            between = _between(edge, duration)
            states += (State(name, zone=edge.zone) for name in between)
            edges += _through(edge, between, edge.cost_for(class_name or ""))
        elif edge.capacity is not None:
            message = f"the edge from '{edge.source}' to '{edge.target}' has a capacity"
            faults.append(Finding(message, "drop its capacity, or give it duration 1"))
        else:
            between = _between(edge, duration)
            states += map(State, between)
            edges += _through(edge, between, edge.cost_for(class_name or ""))
    if faults:
        raise MapError(faults)
    return system.rebuilt(states, edges)


def _between(edge: Edge, duration: int) -> list[str]:
    """The names of the states that an edge passes through in single steps."""
    return [f"{edge.source}->{edge.target}@{step}" for step in range(1, duration)]


def _through(edge: Edge, between: Sequence[str], cost: float) -> Iterator[Edge]:
    """An edge in single steps through other states; the first has all of its cost and its risk."""
    success = edge.success
    for pair in pairwise([edge.source, *between, edge.target]):
        yield Edge(*pair, 1, cost, needs=edge.needs, success=success, zone=edge.zone)
        cost, success = 0.0, 1.0
