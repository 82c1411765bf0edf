"""`tsplan animate`: a plan as a moving picture."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import fitted
from tsplan.results.planfile import load_plan
from tsplan.viewer.animation import Pace, animate

if TYPE_CHECKING:
    import argparse


def run(asked: argparse.Namespace) -> Exit:
    """Write the moving picture."""
    plan, mission = fitted(asked.plan, load_plan(asked.plan), asked.mission)
    pace = Pace.of(plan.horizon, asked.fps, asked.seconds_per_step, asked.size)
    animate(mission, plan, asked.output, pace, lambda words: sys.stderr.write(f"{words}\n"))
    return Exit.DONE
