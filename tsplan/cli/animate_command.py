"""`tsplan animate`: a plan or a trajectory as a moving picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import result_to_show
from tsplan.cli.output import remark
from tsplan.viewer.animation import Pace, animate

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Write the moving picture."""
    plan, mission = result_to_show(options, "the moving picture")
    pace = Pace.of(plan.horizon, options.fps, options.seconds_per_step, options.size)
    animate(mission, plan, options.output, pace, remark)
    return Exit.DONE
