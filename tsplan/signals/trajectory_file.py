"""Files of trajectories."""

from __future__ import annotations

from pathlib import Path

from tsplan.plans.plan_file import save_plan, text_of_result
from tsplan.plans.plan_text import TRAJECTORIES
from tsplan.signals.trajectory import Trajectory


def load_trajectory(path: str | Path) -> Trajectory:
    """Read a trajectory file; raises PlanError if it is missing, no ordinary file or not one."""
    return Trajectory.from_json(text_of_result(path, TRAJECTORIES), str(path))


def save_trajectory(trajectory: Trajectory, path: str | Path) -> None:
    """Write a trajectory file, whole or not at all; PlanError if the place cannot be written."""
    save_plan(trajectory, path)
