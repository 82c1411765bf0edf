"""Random missions whose places hold few robots each, and maps on which robots meet."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from random import Random

from tsplan import Mission
from tsplan.errors import MissionError
from tsplan.mission import Group
from tsplan.testing import random_mission
from tsplan.ts import Edge, State, TransitionSystem


def narrow(mission: Mission, seed: int) -> Mission | None:
    """The mission with capacities on most states and edges; None if not all may begin there."""
    random = Random(f"narrow {seed}")
    begin: Counter[str] = Counter()
    for group in mission.team:
        begin.update(dict(group.starts))
    states = [_room(state, begin, random) for state in mission.system.states.values()]
    edges = _lanes(mission.system, random)
    most = max(random.randint(1, 2), begin.total())
    zones = {"hall": most} if random.random() < 0.2 else {}
    zones |= {"room": 1} if random.random() < 0.3 else {}
    for zone in zones:
        free = [n for n, s in enumerate(states) if s.zone is None and s.name not in begin]
        for number in random.sample(free, min(len(free), random.randint(0, 2))):
            states[number] = replace(states[number], zone=zone)
        single = [p for p, e in edges.items() if (e.capacity, e.zone, e.both_ways) == _OPEN]
        for pair in random.sample(single, min(len(single), random.randint(0, 3))):
            edges[pair] = replace(edges[pair], zone=zone)
    try:
        system = TransitionSystem.build(states, edges.values(), name="narrow", zones=zones)
        return replace(mission, system=system)
    except MissionError:
        return None


_OPEN = (None, None, False)


def _room(state: State, begin: Counter[str], random: Random) -> State:
    capacity = random.choice([None, 1, 1, 1, 2, 0])
    if capacity is not None:
        capacity = max(capacity, begin[state.name])
    return replace(state, capacity=capacity)


def _lanes(system: TransitionSystem, random: Random) -> dict[tuple[str, str], Edge]:
    """Edges with capacities, of which those of both directions may be one."""
    edges = dict(system.edges)
    for pair, edge in system.edges.items():
        back = system.edges.get(pair[::-1])
        if edge.is_wait or edge.both_ways or (back is not None and pair[::-1] < pair):
            continue
        edges[pair] = replace(edge, capacity=random.choice([None, 1, 1, 2]))
        if back is not None and back == edge.reverse() and random.random() < 0.7:
            edges[pair] = replace(edges[pair], both_ways=edges[pair].capacity is not None)
            edges[pair[::-1]] = edges[pair].reverse()
    return edges


def narrow_mission(seed: int, *, states: int, most_agents: int, steps: int) -> Mission | None:
    """A random mission of a team with capacities nearly everywhere."""
    return narrow(random_mission(seed, states=states, most_agents=most_agents, steps=steps), seed)


def sliding(seed: int, steps: int = 9) -> Mission:
    """Robots on a few cells that hold one each: every robot has goals of its own, by turns.

    They have to make room for each other, by detours, and often there is no plan at all.
    """
    random = Random(f"sliding {seed}")
    rows, columns = random.choice([(2, 3), (1, 4), (2, 4), (3, 3), (2, 2)])
    cells = [(row, column) for row in range(rows) for column in range(columns)]
    cells = random.sample(cells, max(len(cells) - random.randint(0, 2), 3))
    names = {cell: f"r{cell[0]}c{cell[1]}" for cell in sorted(cells)}
    robots = random.randint(2, min(4, len(cells) - 1))
    states = [
        State(name, frozenset({f"at_{name}"}), capacity=random.choice([1, 1, 1, 1, 2]))
        for name in names.values()
    ]
    edges = [Edge(name, name) for name in names.values()]
    swaps = random.random() < 0.3
    for (row, column), name in names.items():
        for other in ((row + 1, column), (row, column + 1)):
            if other in names:
                duration = random.choice([1, 1, 1, 2])
                ends = name, names[other]
                limited = not swaps or random.random() < 0.5
                lane = Edge(*ends, duration, capacity=1 if limited else None, both_ways=limited)
                edges += [lane, lane.reverse()]
    starts = random.sample(list(names.values()), robots)
    kinds = random.choice([robots, robots, 1])
    team = [Group.of(f"k{n}", {start: 1}, {f"c{n % kinds}"}) for n, start in enumerate(starts)]
    parts = []
    for number in range(robots):
        for _ in range(random.choice([1, 1, 2])):
            goal, begin = random.choice(list(names.values())), random.randint(0, steps - 3)
            window = f"[{begin},{random.randint(begin, steps - 1)}]"
            need = f"sum(at_{goal},c{number % kinds}) >= 1"
            parts.append(f"{random.choice('FFFG')}{window} ({need})")
            if parts[-1].startswith("G"):
                parts[-1] = f"F[0,{begin}] G[0,1] ({need})"
    if random.random() < 0.3:
        parts.append(f"G[2,{steps - 1}] (sum(at_{random.choice(list(names.values()))}) <= 0)")
    objective = random.choice(
        [
            ("travel",),
            ("travel",),
            ("makespan", "travel"),
            ("agents", "travel"),
            ("travel", "agents"),
        ]
    )
    return Mission.of(
        map=TransitionSystem.build(states, edges, name="sliding"),
        team=team,
        formula=" && ".join(parts),
        language="mtl",
        objective=objective,
        horizon=steps,
        name=f"sliding {seed}",
    )
