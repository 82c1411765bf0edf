"""Missions: a map, a team, a formula and what to optimise."""

from tsplan.mission.data import (
    LANGUAGES,
    OBJECTIVES,
    ORDERS,
    TASK_INTERVALS,
    Agent,
    Group,
    Mission,
    Preference,
    SolverChoice,
)
from tsplan.mission.reading import load_mission, mission_from_text

__all__ = [
    "LANGUAGES",
    "OBJECTIVES",
    "ORDERS",
    "TASK_INTERVALS",
    "Agent",
    "Group",
    "Mission",
    "Preference",
    "SolverChoice",
    "load_mission",
    "mission_from_text",
]
