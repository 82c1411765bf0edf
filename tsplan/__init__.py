"""Plans for many robots at once from a map, a team and a temporal-logic formula.

>>> import tsplan
>>> plan = tsplan.plan("mission.yaml")
>>> print(plan.status, plan.verified, plan.value("travel"))
optimal True 2.0

What there is, in groups and each with an example, is in docs/library.md. Names are loaded when they
are first used, so importing the package is quick and loads no solver.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.lazy_names import lazily
from tsplan.public_names import GROUPS, public_names
from tsplan.version import VERSION

if TYPE_CHECKING:  # each under its own name, so that type checkers see it as public
    from tsplan.checking.assignment import assign as assign
    from tsplan.checking.check_report import Report as Report
    from tsplan.draw.picture_files import save_picture as save_picture
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
    from tsplan.logic import Formula as Formula
    from tsplan.logic import horizon as horizon
    from tsplan.logic import parse as parse
    from tsplan.logic import simplify as simplify
    from tsplan.logic.evaluation import CountTrace as CountTrace
    from tsplan.logic.evaluation import SignalTrace as SignalTrace
    from tsplan.logic.evaluation import holds as holds
    from tsplan.logic.evaluation import robustness as robustness
    from tsplan.mission import Configuration as Configuration
    from tsplan.mission import Group as Group
    from tsplan.mission import Mission as Mission
    from tsplan.mission import Preference as Preference
    from tsplan.mission import Reconfiguration as Reconfiguration
    from tsplan.mission import Resource as Resource
    from tsplan.mission import SolverChoice as SolverChoice
    from tsplan.mission import UnderWay as UnderWay
    from tsplan.mission import load_mission as load_mission
    from tsplan.mission import mission_from_text as mission_from_text
    from tsplan.monitoring.monitor import Monitor as Monitor
    from tsplan.monitoring.verdict import Verdict as Verdict
    from tsplan.plans.agent_plans import AgentPlan as AgentPlan
    from tsplan.plans.moves import Move as Move
    from tsplan.plans.outcomes import Status as Status
    from tsplan.plans.plan import Plan as Plan
    from tsplan.plans.plan_file import load_plan as load_plan
    from tsplan.plans.plan_file import save_plan as save_plan
    from tsplan.plans.plan_frame import FrameUnavailableError as FrameUnavailableError
    from tsplan.plans.subswarms import SubSwarm as SubSwarm
    from tsplan.protocol.disturbances import DisturbedRuns as DisturbedRuns
    from tsplan.protocol.disturbances import simulate_controlled as simulate_controlled
    from tsplan.protocol.disturbances import simulate_disturbed as simulate_disturbed
    from tsplan.protocol.margin_size import margin_for as margin_for
    from tsplan.protocol.simulation import Simulation as Simulation
    from tsplan.protocol.simulation import simulate as simulate
    from tsplan.replanning.execution_trial import Trial as Trial
    from tsplan.replanning.execution_trial import execute as execute
    from tsplan.replanning.receding_horizon import plan_in_pieces as plan_in_pieces
    from tsplan.replanning.replanner import replan as replan
    from tsplan.replanning.replanner import rest_mission as rest_mission
    from tsplan.run.events import Event as Event
    from tsplan.run.problem import Problem as Problem
    from tsplan.signals import Region as Region
    from tsplan.signals import System as System
    from tsplan.signals import double_integrator as double_integrator
    from tsplan.signals import free_signals as free_signals
    from tsplan.signals import single_integrator as single_integrator
    from tsplan.signals.controller import Controller as Controller
    from tsplan.signals.planning import plan as plan
    from tsplan.signals.result_check import check as check
    from tsplan.signals.signal_files import load_any_mission as load_any_mission
    from tsplan.signals.signal_files import load_signal_mission as load_signal_mission
    from tsplan.signals.signal_mission import SignalMission as SignalMission
    from tsplan.signals.synthesis import Synthesis as Synthesis
    from tsplan.signals.synthesiser import synthesise as synthesise
    from tsplan.signals.trajectory import Trajectory as Trajectory
    from tsplan.signals.trajectory_file import load_trajectory as load_trajectory
    from tsplan.signals.trajectory_file import save_trajectory as save_trajectory
    from tsplan.stopping import StoppedBy as StoppedBy
    from tsplan.sweeps.sweep_rows import SweepResults as SweepResults
    from tsplan.sweeps.sweep_rows import SweepRow as SweepRow
    from tsplan.sweeps.sweeper import sweep as sweep
    from tsplan.ts import Action as Action
    from tsplan.ts import Edge as Edge
    from tsplan.ts import State as State
    from tsplan.ts import TransitionSystem as TransitionSystem
    from tsplan.ts.builders import cell_name as cell_name
    from tsplan.ts.builders import from_networkx as from_networkx
    from tsplan.ts.builders import grid as grid
    from tsplan.ts.io.lomap import lomap_to_yaml as lomap_to_yaml
    from tsplan.ts.io.map_files import load_map as load_map
    from tsplan.ts.io.map_files import map_text as map_text
    from tsplan.ts.io.map_files import save_map as save_map
    from tsplan.ts.product import product as product
    from tsplan.ts.product import unit_steps as unit_steps
    from tsplan.viewer.animation import animate as animate
    from tsplan.viewer.movie import Movie as Movie
    from tsplan.writers.exporter import export as export


__version__ = VERSION
__all__ = [name for group in GROUPS.values() for names in group.values() for name in names]
__getattr__, __dir__ = lazily(__name__, public_names())
