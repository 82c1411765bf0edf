"""A swarm of twelve on a map of three states, and a plan of it that can be followed by hand."""

from __future__ import annotations

from dataclasses import replace

from tsplan.mission import Mission
from tsplan.plans.moves import Move
from tsplan.plans.outcomes import MissionRef, ObjectiveValue
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem

# p -> q takes 3 steps, p -> r and r -> q one; only at p and q agents can wait
SYSTEM = TransitionSystem.build(
    [
        State("p", frozenset({"home"})),
        State("q", frozenset({"goal"}), capacity=12),
        State("r", frozenset({"side"})),
    ],
    [
        Edge("p", "p"),
        Edge("q", "q"),
        Edge("p", "q", 3, capacity=5),
        Edge("p", "r", 1),
        Edge("r", "q", 1),
        Edge("q", "p", 2),
    ],
)
# 12 agents wait a step; 4 take the long way, 8 the short one, of which 2 wait a step at p
MOVES = (
    Move(0, "p", "p", 12),
    Move(1, "p", "p", 2),
    Move(1, "p", "q", 4),
    Move(1, "p", "r", 6),
    Move(2, "p", "r", 2),
    Move(2, "r", "q", 6),
    Move(3, "q", "q", 6),
    Move(3, "r", "q", 2),
    Move(4, "q", "q", 12),
)
DURATIONS = {pair: edge.duration for pair, edge in SYSTEM.edges.items()}
VALUES = {"splits": 2, "travel": 12 + 16, "moves": 5, "balance": 2, "makespan": 4}


def mission(formula="F[0,5] sum(goal) >= 100%", most=4, least=2, **options):
    swarm = {"size": 12, "at": "p", "max_subswarms": most, "min_subswarm": least}
    return Mission.of(
        map=SYSTEM, swarm=swarm, formula=formula, **({"objective": list(VALUES)} | options)
    )


def plan(moves=MOVES, **changes):
    made = Plan(
        "feasible",
        MissionRef("m", ""),
        5,
        "time_limit",
        objective=tuple(ObjectiveValue(name, None) for name in VALUES),
        moves=moves if isinstance(moves, dict) else {"swarm": tuple(moves)},
    )
    return replace(made, **changes)
