"""`tsplan view`: a plan or a trajectory as a page that plays in the browser."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import result_to_show
from tsplan.cli.output import say
from tsplan.viewer.browser import open_page, write_page

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Write the page; without a file to write it to, also open it."""
    result, mission = result_to_show(options, "the page")
    path = write_page(mission, result, options.output)
    if options.output is None:
        opened = open_page(path)
        words = "opened" if opened else "no browser was found; open this file in one:"
        say(f"{words} {path}")
    return Exit.DONE
