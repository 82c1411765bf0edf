"""Maps of uncertain moves for tests, and the best that agents can do on them by other means."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import tsplan
from tsplan.mission import Group, Mission
from tsplan.ts import Action, State, TransitionSystem

MOVES = {"up": (-1, 0), "down": (1, 0), "left": (0, -1), "right": (0, 1)}


def slippery_grid(size: int, slip: float = 0.2) -> TransitionSystem:
    """A grid whose moves fail with probability `slip`; whoever leaves the grid stays put."""
    cells = [(row, column) for row in range(size) for column in range(size)]
    labels = {(size - 1, size - 1): "goal", (size - 1, 0): "side"}
    name = "r{}c{}".format
    states = [
        State(name(*cell), frozenset({labels[cell]} if cell in labels else ())) for cell in cells
    ]
    actions = []
    for row, column in cells:
        for move, (down, right) in MOVES.items():
            ahead = row + down, column + right
            here = name(row, column)
            outcomes = ((name(*ahead), 1 - slip), (here, slip)) if ahead in cells else ((here, 1),)
            actions.append(Action(here, move, outcomes))
    return TransitionSystem.build(states, [], "grid", actions=actions)


def grid_mission(size: int, count: int, formula: str, **more: Any) -> Mission:
    """A mission of agents that start in the first corner of a slippery grid."""
    given = {"objective": ["availability"], "language": "mtl", **more}
    team = [Group.of("bot", {"r0c0": count})]
    return Mission.of(
        map=slippery_grid(size), team=team, formula=formula, dynamics="expected", **given
    )


def random_map(seed: int, *, durations: Sequence[int] = (1, 1, 2)) -> TransitionSystem:
    """A few states with labels A and B and one to three actions each, whose chances are eighths."""
    draw = random.Random(seed)
    names = [f"s{number}" for number in range(draw.randint(2, 4))]
    states = [State(name, frozenset(draw.sample("AB", draw.randint(0, 2)))) for name in names]
    states.append(State("end", frozenset({"A", "B"})))
    names.append("end")
    actions = []
    for name in names:
        for number in range(draw.randint(1, 3)):
            targets = draw.sample(names, draw.randint(1, min(3, len(names))))
            cuts = sorted(draw.sample(range(1, 8), len(targets) - 1))
            eighths = [b - a for a, b in zip([0, *cuts], [*cuts, 8], strict=True)]
            outcomes = {t: eighth / 8 for t, eighth in zip(targets, eighths, strict=True)}
            actions.append(Action(name, f"a{number}", outcomes, draw.choice(durations)))
    return TransitionSystem.build(states, [], f"random {seed}", actions=actions)


def most_likely(
    system: TransitionSystem, start: str, horizon: int, wanted: Callable[[str, int], bool]
) -> float:
    """The greatest probability that an agent is somewhere wanted at the horizon, by recursion."""

    @cache
    def value(state: str, step: int) -> float:
        if step == horizon:
            return float(wanted(state, step))
        return max(
            sum(
                chance * value(target, step + action.duration)
                for target, chance in action.outcomes
                if step + action.duration <= horizon
            )
            for action in system.actions.values()
            if action.state == state
        )

    return value(start, 0)


def availability(mission: Mission, **options: Any) -> float | None:
    """The best availability, None where there is no plan; the plan must be optimal and checked."""
    plan = tsplan.plan(mission, time_limit=60, **options)
    if plan.status == "infeasible":
        return None
    assert (plan.status, plan.verified) == ("optimal", True)
    assert tsplan.check(mission, plan).findings == ()
    return plan.availability
