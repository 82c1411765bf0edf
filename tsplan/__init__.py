"""Plans for many robots at once from a map, a team and a temporal-logic formula.

>>> import tsplan
>>> mission = tsplan.load_mission("mission.yaml")
>>> plan = tsplan.plan(mission)
>>> print(plan.status, plan.verified)
optimal True

Names are loaded when they are first used, so importing the package is quick and loads no solver.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.lazy_names import lazily
from tsplan.version import VERSION

if TYPE_CHECKING:  # each under its own name, so that type checkers see it as public
    from tsplan.checking.assignment import assign as assign
    from tsplan.errors import Finding as Finding
    from tsplan.errors import FormulaError as FormulaError
    from tsplan.errors import InputError as InputError
    from tsplan.errors import MapError as MapError
    from tsplan.errors import MissionError as MissionError
    from tsplan.errors import PlanError as PlanError
    from tsplan.errors import SolverError as SolverError
    from tsplan.errors import SolverUnavailableError as SolverUnavailableError
    from tsplan.errors import TsplanError as TsplanError
    from tsplan.explanation import Explanation as Explanation
    from tsplan.explanation.whynot.diagnosis import explain as explain
    from tsplan.logic import parse as parse
    from tsplan.logic.evaluation import robustness as robustness
    from tsplan.mission import Group as Group
    from tsplan.mission import Mission as Mission
    from tsplan.mission import SolverChoice as SolverChoice
    from tsplan.mission import load_mission as load_mission
    from tsplan.plans.agent_plans import AgentPlan as AgentPlan
    from tsplan.plans.moves import Move as Move
    from tsplan.plans.plan import Plan as Plan
    from tsplan.plans.plan_file import load_plan as load_plan
    from tsplan.plans.plan_file import save_plan as save_plan
    from tsplan.plans.subswarms import SubSwarm as SubSwarm
    from tsplan.protocol.disturbances import DisturbedRuns as DisturbedRuns
    from tsplan.protocol.disturbances import simulate_disturbed as simulate_disturbed
    from tsplan.protocol.margin_size import margin_for as margin_for
    from tsplan.protocol.simulation import Simulation as Simulation
    from tsplan.protocol.simulation import simulate as simulate
    from tsplan.run.planner import plan as plan
    from tsplan.run.problem import Problem as Problem
    from tsplan.signals.controller import Controller as Controller
    from tsplan.signals.result_check import check as check
    from tsplan.signals.signal_files import load_signal_mission as load_signal_mission
    from tsplan.signals.signal_mission import SignalMission as SignalMission
    from tsplan.signals.synthesis import Synthesis as Synthesis
    from tsplan.signals.synthesiser import synthesise as synthesise
    from tsplan.signals.trajectory import Trajectory as Trajectory
    from tsplan.signals.trajectory_file import load_trajectory as load_trajectory
    from tsplan.signals.trajectory_file import save_trajectory as save_trajectory
    from tsplan.sweeps.sweep_rows import SweepResults as SweepResults
    from tsplan.sweeps.sweep_rows import SweepRow as SweepRow
    from tsplan.sweeps.sweeper import sweep as sweep
    from tsplan.ts import Action as Action
    from tsplan.ts import Edge as Edge
    from tsplan.ts import State as State
    from tsplan.ts import TransitionSystem as TransitionSystem
    from tsplan.ts.io.map_files import load_map as load_map
    from tsplan.writers.exporter import export as export

__version__ = VERSION
_HOMES = {
    "run.problem": ("Problem",),
    "errors": (
        "Finding",
        "FormulaError",
        "InputError",
        "MapError",
        "MissionError",
        "PlanError",
        "SolverError",
        "SolverUnavailableError",
        "TsplanError",
    ),
    "explanation": ("Explanation",),
    "explanation.whynot.diagnosis": ("explain",),
    "logic": ("parse",),
    "logic.evaluation": ("robustness",),
    "mission": ("Group", "Mission", "SolverChoice", "load_mission"),
    "run.planner": ("plan",),
    "checking.assignment": ("assign",),
    "plans.moves": ("Move",),
    "plans.agent_plans": ("AgentPlan",),
    "plans.plan": ("Plan",),
    "plans.plan_file": ("load_plan", "save_plan"),
    "plans.subswarms": ("SubSwarm",),
    "protocol.disturbances": ("DisturbedRuns", "simulate_disturbed"),
    "signals.result_check": ("check",),
    "protocol.margin_size": ("margin_for",),
    "protocol.simulation": ("Simulation", "simulate"),
    "signals.synthesiser": ("synthesise",),
    "signals.synthesis": ("Synthesis",),
    "signals.controller": ("Controller",),
    "signals.trajectory": ("Trajectory",),
    "signals.trajectory_file": ("load_trajectory", "save_trajectory"),
    "signals.signal_files": ("load_signal_mission",),
    "signals.signal_mission": ("SignalMission",),
    "sweeps.sweep_rows": ("SweepResults", "SweepRow"),
    "sweeps.sweeper": ("sweep",),
    "ts": ("Action", "Edge", "State", "TransitionSystem"),
    "ts.io.map_files": ("load_map",),
    "writers.exporter": ("export",),
}

__all__ = [name for names in _HOMES.values() for name in names]
__getattr__, __dir__ = lazily(__name__, _HOMES)
