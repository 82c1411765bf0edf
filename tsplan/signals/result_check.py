"""Plans and trajectories alike: reading the file of either, and judging it against its mission."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TypeAlias

from tsplan.checking import plan_check
from tsplan.checking.check_report import Report, findings_of
from tsplan.document.files import beginning
from tsplan.errors import Finding, InputError, PlanError
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import load_plan
from tsplan.plans.plan_text import TRAJECTORIES
from tsplan.run.problem import Problem
from tsplan.signals import trajectory_check
from tsplan.signals.signal_files import mission_given
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.signals.trajectory_file import load_trajectory

AnyMission: TypeAlias = Mission | SignalMission
Result: TypeAlias = Plan | Trajectory

_GLANCE = 1000  # bytes within which a file says what it is


def check(mission: AnyMission | Problem | str | Path, result: Result | str | Path) -> Report:
    """Judge a plan or a trajectory against its mission by itself alone, without any solver.

    Both may be the paths of their files. Against a `Problem` its own constraints are judged, too,
    by the agents' paths and the plan's values of own variables, in exact arithmetic.
    Of a plan the agents' paths and the swarms' moves are followed over the map, of a trajectory
    the start and the controls are simulated; then the formula is evaluated as written. The report
    lists everything that is wrong at once. Raises PlanError where one is not of the other's kind,
    and InputError for files that cannot be read.

    >>> import tsplan
    >>> tsplan.save_plan(tsplan.plan("mission.yaml"), "plan.json")
    >>> tsplan.check("mission.yaml", "plan.json").verdict
    'the plan is accepted'
    """
    made = result_given(result)
    known = mission.mission if isinstance(mission, Problem) else mission_given(mission)
    if isinstance(known, Mission) and isinstance(made, Plan):
        report = plan_check.check(known, made)
        if not isinstance(mission, Problem) or report.availability is None:  # no paths to judge by
            return report
        return replace(report, findings=report.findings + findings_of(mission.broken(made)))
    if isinstance(known, SignalMission) and isinstance(made, Trajectory):
        return trajectory_check.check(known, made)
    raise PlanError([mixed_up(known, made)])


def mixed_up(mission: AnyMission, result: Result, source: str = "") -> Finding:
    """That a mission for a team does not go with a trajectory, or one over signals with a plan."""
    noun = "plan" if isinstance(result, Plan) else "trajectory"
    kind = "over signals" if isinstance(mission, SignalMission) else "for a team on a map"
    what = f"this is a {noun}, and the mission is one {kind}"
    return Finding(what, "name the mission that it was made for", source)


def result_given(given: Result | str | Path) -> Result:
    """The plan or trajectory of a file, for a path; or the one that is given."""
    return load_result(given) if isinstance(given, str | Path) else given


def load_result(path: str | Path) -> Result:
    """Read the file of a plan or a trajectory, whichever it says it is.

    Raises PlanError if it is missing, no ordinary file, or neither.
    """
    try:
        other = TRAJECTORIES.mark.partition("/")[0] in beginning(path, _GLANCE)
    except InputError:  # said in full by whoever reads it
        other = False
    return load_trajectory(path) if other else load_plan(path)
