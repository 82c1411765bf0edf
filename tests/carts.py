"""A cart in the plane, missions for it, and a trajectory that fulfils them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tsplan.logic import Formula
from tsplan.plans.outcomes import MissionRef, ObjectiveValue
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import Dynamics, Limit, System
from tsplan.signals.region import Region
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory

REF = MissionRef("cart", "0" * 64)
PUSH = ((1.0, (("ux", 1.0),)), (1.0, (("uy", 1.0),)))
CART = System(
    {"x": (0, 10), "y": (0, 10), "vx": (-1, 1), "vy": (-1, 1)},
    {"ux": (-0.5, 0.5), "uy": (-0.5, 0.5)},
    Dynamics(
        ((1, 0, 1, 0), (0, 1, 0, 1), (0, 0, 1, 0), (0, 0, 0, 1)),
        ((0, 0), (0, 0), (1, 0), (0, 1)),
        (0, 0, 0, 0),
    ),
    {"x": (1, 1), "y": (2, 2), "vx": (0, 0), "vy": (0, 0)},
    (Limit((), PUSH, 0.75),),
)
GOAL, WALL = Region(x=(3, 5), y=(2, 3)), Region(x=(1.5, 2.5), y=(3.25, 9))
ARRIVAL, CLEARANCE = GOAL.inside().eventually(0, 5), WALL.outside().always(0, 5)
CONTROLS = {"ux": (0.5, 0.25, 0, -0.25, -0.5), "uy": (0, 0.25, 0, -0.25, 0)}
# x = 1, 1, 1.5, 2.25, 3, 3.5 and y = 2, 2, 2, 2.25, 2.5, 2.5
SUM = Aim((("robustness", 1.0), ("state_effort", 0.01), ("control_effort", 0.1)))


def cart_mission(*parts: Formula, **changed: object) -> SignalMission:
    """A mission of the cart over five steps; without parts, to the goal past the wall."""
    given = parts or (ARRIVAL, CLEARANCE)
    formula = given[0] if len(given) == 1 else given[0] & given[1]
    mission = SignalMission(
        CART,
        formula,
        5,
        (Aim((("robustness", 1.0),)),),
        regions={"goal": GOAL, "wall": WALL},
        parts=tuple((str(part), part) for part in given),
        name="cart",
        digest=REF.sha256,
    )
    return replace(mission, **changed)


def cart_run(*claims: ObjectiveValue, **changed: object) -> Trajectory:
    """What a search might return: controls, and signals that are a little off."""
    start = [CART.begins(name)[0] for name in CART.signals]
    led = CART.simulated(start, np.array(list(CONTROLS.values())))
    shaken = led + 1e-8 * np.sin(np.arange(led.size).reshape(led.shape))
    found = Trajectory(
        "optimal",
        REF,
        5,
        objective=claims,
        signals=dict(zip(CART.signals, shaken, strict=True)),
        controls=CONTROLS,
    )
    return replace(found, **changed)
