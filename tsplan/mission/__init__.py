"""Missions: a map, a team, a formula and what to optimise."""

from tsplan.mission.data import (
    LANGUAGES,
    OBJECTIVES,
    TASK_INTERVALS,
    Agent,
    Group,
    Mission,
    SolverChoice,
)
from tsplan.mission.reading import load_mission, mission_from_text

__all__ = [
    "LANGUAGES",
    "OBJECTIVES",
    "TASK_INTERVALS",
    "Agent",
    "Group",
    "Mission",
    "SolverChoice",
    "load_mission",
    "mission_from_text",
]
