"""`tsplan animate`: a plan as a moving picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import files_of, fitted, refuse_place
from tsplan.cli.output import remark
from tsplan.plans.plan_file import load_plan
from tsplan.viewer.animation import Pace, animate

if TYPE_CHECKING:
    import argparse


def run(asked: argparse.Namespace) -> Exit:
    """Write the moving picture."""
    plan, mission = fitted(asked.plan, load_plan(asked.plan), asked.mission)
    pace = Pace.of(plan.horizon, asked.fps, asked.seconds_per_step, asked.size)
    refuse_place(asked.output, "the moving picture", [asked.plan, *files_of(mission)])
    animate(mission, plan, asked.output, pace, remark)
    return Exit.DONE
