"""`tsplan view`: a plan or a trajectory as a page that plays in the browser."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import executed_plan, refuse_place, result_to_show
from tsplan.cli.output import say
from tsplan.draw.focus import Focus
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.viewer.browser import open_page, page_link, write_page

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Write the page; without a file to write it to, also open it."""
    result, mission = result_to_show(options, "the page")
    team = mission if isinstance(mission, Mission) else None
    executed = executed_plan(options.executed, team)
    refuse_place(options.output, "the page", [options.executed])
    if isinstance(result, Plan):
        Focus(options.step, (), executed).refuse_beyond(result)
    path = write_page(mission, result, options.output, executed)
    if options.output is None:
        opened = open_page(path, options.step)
        words = "opened" if opened else "no browser was found; open this file in one:"
        say(f"{words} {path}")
    elif options.step is not None:
        say(f"it opens at step {options.step:g} by the address {page_link(path, options.step)}")
    return Exit.DONE
