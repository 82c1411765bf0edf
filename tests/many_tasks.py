"""Missions of several tasks that compete for two kinds of agents."""

from __future__ import annotations

from random import Random

from tsplan.mission import Group, Mission
from tsplan.ts.builders import grid


def mission(seed: int, tasks: int = 6, formula: str = "", agents: int = 12) -> Mission:
    """Random tasks on a grid of six by six for agents of two kinds."""
    random = Random(seed)
    cells = [(row, column) for row in range(6) for column in range(6)]
    places = random.sample(cells, tasks)
    parts = [
        f"F[{begin},{begin + 8}] T({random.randint(0, 2)},l{number},"
        f"{{({random.choice('xy')},{random.randint(1, 3)})}})"
        for number in range(tasks)
        for begin in [random.randint(6, 14)]
    ]
    labels = {cell: f"l{number}" for number, cell in enumerate(places)}
    team = [
        Group.of("one", {"r0c0": agents}, {"x"}),
        Group.of("other", {"r5c5": agents}, {"y", "x"}),
    ]
    return Mission.of(
        map=grid(6, 6, labels=labels),
        team=team,
        formula=formula or " && ".join(parts),
        objective=["travel"],
    )
