"""Why a trajectory satisfies its formula, or what became of what it may leave out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.explanation.why.predicate_demands import unadorned
from tsplan.explanation.why.witness_tree import explain_on
from tsplan.signals.motion_check import refuse_misfit

if TYPE_CHECKING:
    from tsplan.explanation.why.witness_tree import WitnessNode
    from tsplan.logic.nodes import Formula
    from tsplan.logic.traces import SignalTrace
    from tsplan.signals.signal_mission import SignalMission
    from tsplan.signals.trajectory import Trajectory


def explain_trajectory(trajectory: Trajectory, mission: SignalMission) -> WitnessNode:
    """The tree of the mission's formula; `str` of it names the critical predicates of each part.

    Weights are multiplied into the predicates, so that the robustness is that of the trajectory.
    Raises PlanError for a trajectory without signals or of another mission.
    """
    refuse_misfit(trajectory, mission)
    return _tree(mission, mission.formula, trajectory.trace())


def explain_wishes(trajectory: Trajectory, mission: SignalMission) -> dict[str, WitnessNode]:
    """The same for each formula that the mission prefers, by its name.

    Raises PlanError as `explain_trajectory`.
    """
    refuse_misfit(trajectory, mission)
    trace = trajectory.trace()
    return {wish.name: _tree(mission, wish.formula, trace) for wish in mission.prefer}


def _tree(mission: SignalMission, formula: Formula, trace: SignalTrace) -> WitnessNode:
    return explain_on(unadorned(mission, formula, trace), trace)
