"""Missions: a map, a team, a formula and what to optimise."""

from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.configurations import Configuration, ModuleRules, Reconfiguration
from tsplan.mission.mission import Mission
from tsplan.mission.mission_parts import Preference
from tsplan.mission.objectives import OBJECTIVES, Objective, register
from tsplan.mission.read import load_mission, mission_from_text
from tsplan.mission.resources import Resource
from tsplan.mission.team import (
    Agent,
    Expectation,
    Group,
    Rank,
    SwarmBounds,
    SwarmRules,
    UnderWay,
)
from tsplan.mission.vocabulary import LANGUAGES, ORDERS, TASK_INTERVALS

__all__ = [
    "LANGUAGES",
    "OBJECTIVES",
    "ORDERS",
    "TASK_INTERVALS",
    "Agent",
    "Configuration",
    "Expectation",
    "Group",
    "Mission",
    "ModuleRules",
    "Objective",
    "Preference",
    "Rank",
    "Reconfiguration",
    "Resource",
    "SolverChoice",
    "SwarmBounds",
    "SwarmRules",
    "UnderWay",
    "load_mission",
    "mission_from_text",
    "register",
]
