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

if TYPE_CHECKING:
    from tsplan.checking.assignment import assign
    from tsplan.checking.plan_check import check
    from tsplan.errors import (
        Finding,
        FormulaError,
        InputError,
        MapError,
        MissionError,
        PlanError,
        SolverError,
        SolverUnavailableError,
        TsplanError,
    )
    from tsplan.explanation import Explanation
    from tsplan.explanation.whynot.explaining import explain
    from tsplan.logic import parse
    from tsplan.mission import Group, Mission, SolverChoice, load_mission
    from tsplan.plans.moves import Move
    from tsplan.plans.plan import AgentPlan, Plan
    from tsplan.plans.plan_file import load_plan, save_plan
    from tsplan.plans.subswarms import SubSwarm
    from tsplan.protocol.margin_size import margin_for
    from tsplan.protocol.simulation import Simulation, simulate
    from tsplan.run.planner import plan
    from tsplan.run.problem import Problem
    from tsplan.ts import Edge, State, TransitionSystem
    from tsplan.ts.io.map_files import load_map

__version__ = "0.1.0"
__all__ = [
    "AgentPlan",
    "Edge",
    "Explanation",
    "Finding",
    "FormulaError",
    "Group",
    "InputError",
    "MapError",
    "Mission",
    "MissionError",
    "Move",
    "Plan",
    "PlanError",
    "Problem",
    "Simulation",
    "SolverChoice",
    "SolverError",
    "SolverUnavailableError",
    "State",
    "SubSwarm",
    "TransitionSystem",
    "TsplanError",
    "assign",
    "check",
    "explain",
    "load_map",
    "load_mission",
    "load_plan",
    "margin_for",
    "parse",
    "plan",
    "save_plan",
    "simulate",
]

__getattr__, __dir__ = lazily(
    __name__,
    {
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
        "explanation.whynot.explaining": ("explain",),
        "logic": ("parse",),
        "mission": ("Group", "Mission", "SolverChoice", "load_mission"),
        "run.planner": ("plan",),
        "checking.assignment": ("assign",),
        "plans.moves": ("Move",),
        "plans.plan": ("AgentPlan", "Plan"),
        "plans.plan_file": ("load_plan", "save_plan"),
        "plans.subswarms": ("SubSwarm",),
        "checking.plan_check": ("check",),
        "protocol.margin_size": ("margin_for",),
        "protocol.simulation": ("Simulation", "simulate"),
        "ts": ("Edge", "State", "TransitionSystem"),
        "ts.io.map_files": ("load_map",),
    },
)
