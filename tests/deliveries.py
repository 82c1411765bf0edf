"""A mission with resources and a plan of it, made by hand, for pictures and reasons."""

from __future__ import annotations

from dataclasses import replace

from tests.viewing import plan_of
from tsplan import Mission
from tsplan.mission import Group, Resource
from tsplan.plans.plan import Plan
from tsplan.plans.supplies import Cargo, ExecutedTask
from tsplan.ts import Edge, State, TransitionSystem

WALL = "T(1,wall,{(lay,1)},{(brick,3),(drill,1)})"
GARDEN = "T(0,garden,{},{(water,0.75)})"


def site() -> TransitionSystem:
    """Yard, wall and garden in a row, two steps and one step apart."""
    names = ("yard", "wall", "garden")
    shape = ((9.2, -0.6), (10.8, -0.6), (10.8, 0.6), (9.2, 0.6))
    states = [
        State(name, frozenset({name}), at=(5.0 * n, 0.0), shape=shape if n == 2 else None)
        for n, name in enumerate(names)
    ]
    ways = [("yard", "wall", 2), ("wall", "garden", 1)]
    edges = [Edge(name, name) for name in names]
    edges += [Edge(*ends, steps) for a, b, steps in ways for ends in ((a, b), (b, a))]
    return TransitionSystem.build(states, edges, "site")


def building() -> tuple[Mission, Plan]:
    """Two men and a cart bring bricks, a drill and water.

    One brick lies at the wall from the start. The men bring a brick each and the first the drill at
    step 2; the cart brings water to the garden at step 4. The wall is built at step 3, the garden
    watered at steps 4 and 6.
    """
    mission = Mission.of(
        map=site(),
        team=[
            Group.of("man", {"yard": 2}, ["lay"], carries={"brick": 1, "drill": 1}),
            Group.of("cart", {"yard": 1}, carries=4),
        ],
        resources=[
            Resource.of("brick", {"yard": 4, "wall": 1}, indivisible=True),
            Resource.of("water", {"yard": 2.5}),
            Resource.of("drill", {"yard": 1}, indivisible=True, consumed=False),
        ],
        formula=f"F[0,4] {WALL} && F[4,4] {GARDEN} && F[6,6] {GARDEN}",
        horizon=7,
        name="building",
    )
    men, cart = ((0, 0, "yard"), (2, 7, "wall")), ((0, 1, "yard"), (3, 3, "wall"), (4, 7, "garden"))
    plan = plan_of(mission, [(men, None), (men, None), (cart, None)])
    cargo = [
        Cargo("man-1", 0, "brick", 1.0),
        Cargo("man-1", 0, "drill", 1.0),
        Cargo("man-2", 0, "brick", 1.0),
        Cargo("cart-1", 1, "water", 1.5),
        Cargo("cart-1", 3, "water", 1.5),
    ]
    executions = [
        ExecutedTask(WALL, "wall", 3),
        ExecutedTask(GARDEN, "garden", 4),
        ExecutedTask(GARDEN, "garden", 6),
    ]
    return mission, replace(plan, cargo=tuple(cargo), executions=tuple(executions))
