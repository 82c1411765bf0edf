"""`tsplan view`: a plan as a page that plays in the browser."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import files_of, fitted, refuse_place
from tsplan.cli.output import say
from tsplan.plans.plan_file import load_plan
from tsplan.viewer.browser import open_page, write_page

if TYPE_CHECKING:
    import argparse


def run(asked: argparse.Namespace) -> Exit:
    """Write the page; without a file to write it to, also open it."""
    plan, mission = fitted(asked.plan, load_plan(asked.plan), asked.mission)
    refuse_place(asked.output, "the page", [asked.plan, *files_of(mission)])
    path = write_page(mission, plan, asked.output)
    if asked.output is None:
        opened = open_page(path)
        words = "opened" if opened else "no browser was found; open this file in one:"
        say(f"{words} {path}")
    return Exit.DONE
