"""From a point of a problem's model to the plan that it stands for, judged by the check."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.checking.plan_check import certify
from tsplan.plans.outcomes import MissionRef, ObjectiveValue, Status
from tsplan.plans.plan import Plan
from tsplan.run.paths import ways_of
from tsplan.stopping import StoppedBy

if TYPE_CHECKING:
    from tsplan.encode.encoded import Point, Setting
    from tsplan.mission import Mission


def plan_at(setting: Setting, point: Point, seed: int | None) -> Plan:
    """The verified plan of a point of which nothing else is known; the check measures its values.

    Raises SolverError where the check refuses it.
    """
    mission = setting.mission
    made = Plan(
        status=Status.FEASIBLE,
        stopped_by=StoppedBy.INTERRUPT,
        mission=MissionRef(mission.name, mission.digest),
        horizon=mission.horizon,
        objective=open_objective(mission),
        **ways_of(setting, point, seed),
    )
    return certify(mission, made)


def open_objective(mission: Mission) -> tuple[ObjectiveValue, ...]:
    """The objectives of a mission, nothing known of them: the check fills their values in."""
    return tuple(ObjectiveValue(name, None, None) for name in mission.objective)
