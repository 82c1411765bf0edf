"""Plans: the paths of all agents, their independent check, reading, writing and showing them."""

from tsplan.results.assigning import assign
from tsplan.results.checking import Report, certify, check, objective_values
from tsplan.results.flows import ClassFlow, decompose
from tsplan.results.groups import SubSwarm
from tsplan.results.moves import Move
from tsplan.results.plan import (
    AgentPlan,
    MissionRef,
    ModelSize,
    ObjectiveValue,
    Plan,
    SolverUse,
    Status,
    StoppedBy,
    Timings,
)
from tsplan.results.planfile import load_plan, save_plan

__all__ = [
    "AgentPlan",
    "ClassFlow",
    "MissionRef",
    "ModelSize",
    "Move",
    "ObjectiveValue",
    "Plan",
    "Report",
    "SolverUse",
    "Status",
    "StoppedBy",
    "SubSwarm",
    "Timings",
    "assign",
    "certify",
    "check",
    "decompose",
    "load_plan",
    "objective_values",
    "save_plan",
]
