"""Orders for missions of either kind, and the seconds that reading them took."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from tsplan.milp.solver_choice import SolverChoice
from tsplan.plans.plan import Plan
from tsplan.run.isolate import Order
from tsplan.signals.result_check import AnyMission
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory

ResultT = TypeVar("ResultT", Plan, Trajectory)

_SYNTHESISER = ("tsplan.signals.synthesiser", "synthesise_mission")
_LEAST = 1.0  # seconds that are left for the rest however long reading took


def order_for(
    mission: AnyMission, choice: SolverChoice, encoding: str, without: tuple[str, ...]
) -> Order:
    """What is asked of the planner of a mission's kind."""
    order = Order(mission, choice, encoding, without)
    if isinstance(mission, SignalMission):
        return replace(order, planner=_SYNTHESISER, kind=Trajectory)
    return order


def with_reading(result: ResultT, mission: AnyMission, loaded: float) -> ResultT:
    """A result with the seconds that reading its mission took, which the limit was for, too."""
    timings = replace(
        result.timings,
        load=loaded - mission.parse_seconds,
        parse=mission.parse_seconds,
        total=result.timings.total + loaded,
    )
    return replace(result, timings=timings)


def rest(limit: float | None, spent: float) -> float | None:
    """What is left of a limit in seconds, though never so little that nothing could be done.

    >>> rest(60.0, 2.0), rest(3.0, 2.9), rest(0.5, 0.4), rest(None, 2.0)
    (58.0, 1.0, 0.5, None)
    """
    return None if limit is None else max(limit - spent, min(limit, _LEAST))
