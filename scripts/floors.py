"""Floors of rooms and corridors, and maps of MovingAI, for robots that cannot share a cell."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random

import tsplan
from tsplan import Mission
from tsplan.mission import Group
from tsplan.mission.scenarios import read_scenario
from tsplan.ts import Edge, State, TransitionSystem

_ROOM = 5  # cells on a side, of which one row and column in six is left for walls
_STATION = 3  # cells of a station, next to each other


@dataclass(frozen=True)
class Floor:
    """The sizes of a floor: rooms on a side, robots, stations to be visited, a limit on lanes.

    With `lanes` two robots cannot pass each other on the way between two cells.
    """

    rooms: int = 3
    robots: int = 5
    stations: int = 4
    lanes: bool = True


def floor(sizes: Floor, seed: int, objective: Sequence[str] = ("travel",)) -> Mission:
    """Robots of two kinds that begin in one corner and are wanted at stations all over a floor.

    Every cell holds one robot. Rooms have walls with a door or two, each a single cell; a part of
    the robots is wanted at each station at once, some for several steps.
    """
    random = Random(f"floor {sizes} {seed}")
    cells = _cells(sizes.rooms, random)
    stations, docks = _stations(sizes, cells, random)
    label_of = {cell: label for label, group in stations.items() for cell in group}
    label_of |= dict.fromkeys(docks, "dock")
    states = [
        State(_name(cell), frozenset(label_of.get(cell, "").split()), at=cell, capacity=1)
        for cell in sorted(cells)
    ]
    capacity = 1 if sizes.lanes else None
    edges = [Edge(state.name, state.name) for state in states]
    for cell in sorted(cells):
        for other in ((cell[0] + 1, cell[1]), (cell[0], cell[1] + 1)):
            if other in cells:
                there = Edge(_name(cell), _name(other), capacity=capacity, both_ways=sizes.lanes)
                edges += [there, there.reverse()]
    system = TransitionSystem.build(states, edges, name=f"floor of {len(cells)} cells")
    horizon = 6 * _ROOM * sizes.rooms
    parts = list(_tasks(sizes, list(stations), horizon, random))
    half = (len(docks) + 1) // 2
    team = [
        Group.of("carrier", {_name(cell): 1 for cell in docks[:half]}, {"lift"}),
        Group.of("watcher", {_name(cell): 1 for cell in docks[half:]}, {"see"}),
    ]
    return Mission.of(
        map=system,
        team=[group for group in team if group.starts],
        formula=" && ".join(parts),
        language="catl",
        objective=tuple(objective),
        horizon=horizon,
        name=f"{sizes} seed {seed}",
    )


def _name(cell: tuple[int, int]) -> str:
    return f"x{cell[0]}y{cell[1]}"


def _cells(rooms: int, random: Random) -> set[tuple[int, int]]:
    """The cells of rooms on a square, with one or two doors in each wall between two of them."""
    pitch = _ROOM + 1
    side = rooms * pitch - 1
    walls = {k * pitch - 1 for k in range(1, rooms)}
    cells = {(x, y) for x in range(side) for y in range(side) if not {x, y} & walls}
    for wall in walls:
        for room in range(rooms):
            for _ in range(2):
                place = room * pitch + random.randrange(_ROOM)
                cells |= {(wall, place)} if random.random() < 0.8 else set()
                cells |= {(place, wall)} if random.random() < 0.8 else set()
            cells |= {(wall, room * pitch + _ROOM // 2), (room * pitch + _ROOM // 2, wall)}
    return cells


def _stations(
    sizes: Floor, cells: set[tuple[int, int]], random: Random
) -> tuple[dict[str, list[tuple[int, int]]], list[tuple[int, int]]]:
    """Cells next to each other for each station, and the docks: those nearest to a corner."""
    docks = sorted(cells, key=lambda cell: (sum(cell), cell))[: sizes.robots]
    free = sorted(cells - set(docks))
    stations: dict[str, list[tuple[int, int]]] = {}
    while len(stations) < sizes.stations:
        x, y = random.choice(free)
        group = [(x + step, y) for step in range(_STATION)]
        if all(cell in free for cell in group):
            stations[f"s{len(stations)}"] = group
            free = [cell for cell in free if cell not in group]
    return stations, docks


def _tasks(sizes: Floor, labels: Sequence[str], horizon: int, random: Random) -> Iterator[str]:
    """One task for each station: some robots there at once, or for three steps."""
    both = sizes.robots > 1
    for number, label in enumerate(labels):
        begin = horizon * number // (2 * len(labels))
        width = horizon // 2
        many = random.randint(1, min(_STATION, max((sizes.robots + 1) // 2, 1)))
        wanted = f"sum({label},lift) >= {many}"
        if both and many < _STATION and random.random() < 0.5:
            wanted = f"({wanted} && sum({label},see) >= 1)"
        if random.random() < 0.5:
            wanted = f"G[0,3] ({wanted})"
        yield f"F[{begin},{min(begin + width, horizon - 4)}] {wanted}"


_SPARE = 1.5  # steps of the horizon for each that a robot may need from corner to corner


def scenario(
    map_file: Path, list_file: Path, robots: int, objective: Sequence[str] = ("travel",)
) -> Mission:
    """The first robots of a scenario of the MovingAI benchmarks, each at its own goal in the end.

    Every cell and the way between two cells hold one robot. R. Stern et al., "Multi-agent
    pathfinding: definitions, variants, and benchmarks", SoCS 2019.
    """
    system = tsplan.load_map(map_file)
    ways = read_scenario(list_file, system, robots)
    states = [replace(state, capacity=1) for state in system.states.values()]
    edges = [
        edge if edge.is_wait else replace(edge, capacity=1, both_ways=True)
        for edge in system.edges.values()
    ]
    rows = {name.split("c")[0] for name in system.states}
    last = round(_SPARE * (len(rows) + len(system.states) / len(rows)))
    return Mission.of(
        map=TransitionSystem.build(states, edges, name=map_file.stem),
        team=[Group.of(f"robot{n}", {way.start: 1}) for n, way in enumerate(ways)],
        formula=" && ".join(
            f"F[{last},{last}] sum({way.goal},robot{n}) >= 1" for n, way in enumerate(ways)
        ),
        language="mtl",
        objective=tuple(objective),
        horizon=last,
        name=f"{list_file.stem} {len(ways)} robots",
    )
