"""`tsplan animate`: a plan as a moving picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import plan_to_show
from tsplan.cli.output import remark
from tsplan.viewer.animation import Pace, animate

if TYPE_CHECKING:
    import argparse


def run(asked: argparse.Namespace) -> Exit:
    """Write the moving picture."""
    plan, mission = plan_to_show(asked, "the moving picture")
    pace = Pace.of(plan.horizon, asked.fps, asked.seconds_per_step, asked.size)
    animate(mission, plan, asked.output, pace, remark)
    return Exit.DONE
