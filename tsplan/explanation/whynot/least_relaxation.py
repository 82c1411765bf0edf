"""By how much numbers must at least move so that a mission over signals can be met, in one program.

The amount becomes a signal of its own that never changes, from 0 to the most, and what it relaxes
a comparison or a limit that names it. The planner then minimises its value: the least amount, over
all choices that the formula leaves.

Source: the idea of elastic programs, J. Chinneck, "Feasibility and Infeasibility in Optimization"
(2008), chapter 6; here one amount may stretch several rows.
"""

from __future__ import annotations

from dataclasses import replace
from math import isfinite
from typing import TYPE_CHECKING

import numpy as np

from tsplan.explanation.whynot.mission_numbers import moved
from tsplan.explanation.whynot.occurrences import exchanged, node_at
from tsplan.explanation.whynot.signal_constraints import bare, near, system_side
from tsplan.explanation.whynot.signal_numbers import MAX, alike, with_end, with_sides
from tsplan.logic import TRUE, Formula, Linear, fold, simplify, walk
from tsplan.logic.weights import unweighted
from tsplan.signals.linear_system import Dynamics, Limit, System
from tsplan.signals.reach import reach
from tsplan.signals.synthesis import Synthesis

if TYPE_CHECKING:
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.signals.signal_mission import SignalMission
    from tsplan.signals.signal_setting import SignalSetting
    from tsplan.signals.trajectory import Trajectory

_NAME = "relaxation"


class Relaxation(Synthesis):
    """The problem of the least amount.

    Its trajectories keep to the formula as a solver keeps to rows; nothing more is asked of them,
    since an amount on the border would be refused for what floats round. What is found says where
    to look, and other questions prove it.
    """

    def __init__(self, mission: SignalMission, amount: str) -> None:
        super().__init__(replace(mission, formula=TRUE, parts=(), text=""))
        self._wanted = simplify(near(mission.formula, mission.system))
        self.amount = amount

    def setting(self, margin: float = 0.0) -> SignalSetting:
        """What every model is made of."""
        return replace(super().setting(margin), goal=self._wanted)

    def found(self, trajectory: Trajectory) -> float:
        """The amount of a trajectory of the problem."""
        return float(trajectory[self.amount][0])


def _amount_name(mission: SignalMission) -> str:
    """What the signal of the amount is called: a name that nothing else has."""
    name = _NAME
    while name in mission.system.names:
        name += "'"
    return name


def relaxation(mission: SignalMission, edit: Edit) -> Relaxation | None:
    """The problem of the least amount of an edit; None for one by whole steps."""
    if edit.unit == 1:
        return None
    kind, key = edit.number
    amount, most = _amount_name(mission), float(edit.unit * edit.most)
    formula, system = mission.formula, mission.system
    began: tuple[str, int, float] | None = None
    if kind == "formula":
        node = node_at(formula, key[0])
        assert isinstance(node, Linear)
        formula = exchanged(formula, {key[0]: _looser(node, amount)})
    elif kind == "limit":
        limits = list(system.limits)
        limit = limits[key[0]]
        limits[key[0]] = replace(limit, terms=(*limit.terms, (amount, -1.0)))
        system = replace(system, limits=tuple(limits))
    elif kind == "side":
        system = _open_side(mission, key[0], key[1], amount, most)
    else:
        name, place = key
        end = system.initial[name][place]
        began = (name, place, end)
        begins = with_end(
            system.initial[name], place, moved(end, edit.sense * edit.unit * edit.most)
        )
        system = replace(system, initial={**system.initial, name: begins})
    return _minimised(bare(mission, formula, _with_amount(system, amount, most)), amount, began)


def _looser(atom: Linear, amount: str) -> Linear:
    """A comparison that may be missed by an amount."""
    sign = 1.0 if atom.relation in (">=", ">") else -1.0
    return replace(atom, terms=(*atom.terms, (amount, sign)))


def _open_side(mission: SignalMission, key: str, place: int, amount: str, most: float) -> System:
    """A system in which a bound may be exceeded by an amount."""
    sign = 1.0 if place == MAX else -1.0
    sides, limits = [], []
    for name in alike(mission, key):
        end = system_side(mission.system, name)[place]
        sides.append((name, place, end + sign * most))
        limits.append(Limit(((name, sign), (amount, -1.0)), (), sign * end))
    system = with_sides(mission.system, sides)
    return replace(system, limits=(*system.limits, *limits))


def _with_amount(system: System, amount: str, most: float) -> System:
    """A system with one signal more, which keeps the value that it begins with."""
    dynamics = system.dynamics
    if dynamics is not None:
        a, b, d = dynamics.arrays
        count, steered = b.shape
        a = np.block([[a, np.zeros((count, 1))], [np.zeros((1, count)), np.ones((1, 1))]])
        b = np.vstack([b, np.zeros((1, steered))])
        rows = [tuple(map(tuple, matrix.tolist())) for matrix in (a, b)]
        dynamics = Dynamics(rows[0], rows[1], (*d.tolist(), 0.0))
    signals = {**system.signals, amount: (0.0, most)}
    return replace(system, signals=signals, dynamics=dynamics)


def _minimised(
    mission: SignalMission, amount: str, began: tuple[str, int, float] | None = None
) -> Relaxation:
    """The problem of the least amount; a signal may begin beyond an end by it."""
    problem = Relaxation(mission, amount)
    value = problem.value(amount, 0)
    if mission.system.dynamics is None:
        for step in range(1, mission.horizon + 1):
            problem.add(problem.value(amount, step) == value, "one amount")
    if began is not None:
        name, place, end = began
        first = problem.value(name, 0)
        problem.add(first - value <= end if place == MAX else first + value >= end, "start")
    problem.minimise(value)
    return problem


def least_miss(mission: SignalMission) -> Relaxation | None:
    """The problem of the least amount by which the formula is missed.

    With its sign turned it is the greatest robustness there is, with the weights of the mission.
    None where signals have no bounds.
    """
    amount = _amount_name(mission)
    plain = near(mission.formula, mission.system)
    plain = unweighted(plain, mission.weighting, satisfied=False)
    reached = reach(mission.system, mission.horizon)
    short = [
        max(abs(end - node.bound) for side in reached.sides(node.terms) for end in side.tolist())
        for node in walk(plain)
        if isinstance(node, Linear)
    ]
    most = max(short, default=0.0)
    if not most or not isfinite(most) or reached.empty:
        return None

    def missed(node: Formula, below: tuple[Formula, ...]) -> Formula:
        return _looser(node, amount) if isinstance(node, Linear) else node.over(below)

    relaxed = bare(mission, fold(plain, missed), _with_amount(mission.system, amount, most))
    return _minimised(relaxed, amount)
