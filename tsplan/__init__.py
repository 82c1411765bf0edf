"""Plans for many robots at once from a map, a team and a temporal-logic formula.

>>> import tsplan
>>> mission = tsplan.load_mission("mission.yaml")
>>> plan = tsplan.plan(mission)
>>> print(plan.status, plan.verified)
optimal True

Names are loaded when they are first used, so importing the package is quick and loads no solver.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

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

_HOMES = {
    "tsplan.run.problem": ("Problem",),
    "tsplan.errors": (
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
    "tsplan.explanation": ("Explanation",),
    "tsplan.explanation.whynot.explaining": ("explain",),
    "tsplan.logic": ("parse",),
    "tsplan.mission": ("Group", "Mission", "SolverChoice", "load_mission"),
    "tsplan.run.planner": ("plan",),
    "tsplan.checking.assignment": ("assign",),
    "tsplan.plans.moves": ("Move",),
    "tsplan.plans.plan": ("AgentPlan", "Plan"),
    "tsplan.plans.plan_file": ("load_plan", "save_plan"),
    "tsplan.plans.subswarms": ("SubSwarm",),
    "tsplan.checking.plan_check": ("check",),
    "tsplan.protocol.margin_size": ("margin_for",),
    "tsplan.protocol.simulation": ("Simulation", "simulate"),
    "tsplan.ts": ("Edge", "State", "TransitionSystem"),
    "tsplan.ts.io.map_files": ("load_map",),
}
_HOME = {name: module for module, names in _HOMES.items() for name in names}

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


def __getattr__(name: str) -> object:
    """Load a public name from its module on first use."""
    if name not in _HOME:
        raise AttributeError(f"module 'tsplan' has no attribute '{name}'")
    value: object = getattr(import_module(_HOME[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
