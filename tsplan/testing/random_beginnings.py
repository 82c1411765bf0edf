"""Missions that begin in the middle of something: starts on edges, places closed for a time.

The same mission and seed give the same mission.
"""

from __future__ import annotations

from dataclasses import replace
from random import Random

from tsplan.errors import MissionError
from tsplan.mission import Group, Mission, UnderWay
from tsplan.ts.closures import Closed


def with_starts_under_way(mission: Mission, seed: int) -> Mission:
    """The mission, some of whose agents are on an edge when it begins.

    It is the same where that would leave it no agent, or not fit a capacity.

    >>> from tsplan.testing import random_mission
    >>> mission = random_mission(3, states=4, most_agents=3)
    >>> made = with_starts_under_way(mission, 1)
    >>> made.size == mission.size, any(group.coming for group in made.team)
    (True, True)
    """
    random = Random(f"under way {seed}")
    team = tuple(_on_the_way(random, mission, group) for group in mission.team)
    try:
        return replace(mission, team=team)
    except MissionError:
        return mission


def with_closures(mission: Mission, seed: int) -> Mission:
    """The mission on its map some of whose states and edges are closed for a time.

    It is the same where its agents could not start or arrive then.

    >>> from tsplan.testing import random_mission
    >>> made = with_closures(random_mission(3, states=4, most_agents=3), 1)
    >>> made.system.timed
    True
    """
    random = Random(f"closed {seed}")
    system = mission.system

    def closed(often: float) -> Closed:
        count = random.choice([1, 1, 2]) if random.random() < often else 0
        begins = [random.randint(0, max(mission.horizon, 1)) for _ in range(count)]
        return tuple((first, first + random.choice([0, 0, 1, 2, 9])) for first in begins)

    states = [replace(state, closed=closed(0.25)) for state in system.states.values()]
    both = {edge.pair: closed(0.25) for edge in system.edges.values()}
    edges = [
        replace(edge, closed=both[min(edge.pair, edge.pair[::-1])] if edge.both_ways else own)
        for edge in system.edges.values()
        for own in [both[edge.pair]]
    ]
    try:
        return replace(mission, system=system.rebuilt(states, edges))
    except MissionError:
        return mission


def _on_the_way(random: Random, mission: Mission, group: Group) -> Group:
    """A group, some of which are not at their start state, but on their way to it or from it."""
    size = mission.modular.modules(((group.configuration, 1),)) if group.configuration else 1
    begun: list[tuple[str | UnderWay, int]] = []
    for state, modules in group.starts:
        count = modules // size
        ways = [pair for pair in mission.system.edges if state in pair]
        ways += [(random.choice(list(mission.system.states)), state)]  # an edge that may be gone
        ways += [(state, state)] * (0 if group.configuration is None else 2)
        some = random.choice([0, 1, count, count])
        for _ in range(some):
            arrives = random.choice([1, 1, 1, 1, 2, 2, 3, mission.horizon + 1])
            load = tuple((item.name, 1.0) for item in mission.resources if random.random() < 0.4)
            start = UnderWay(*random.choice(ways), arrives, load)
            begun.append((start, size))
        begun += [(state, (count - some) * size)] if some < count else []
    swarm = mission.group_bounds(group.class_name) is not None
    if random.random() < (0.8 if swarm else 0.4) and begun:  # groups of swarms cannot be many
        begun = [(begun[0][0], group.count)]
    made = Group.of(group.class_name, begun, group.capabilities)
    return replace(group, starts=made.starts, coming=made.coming)
