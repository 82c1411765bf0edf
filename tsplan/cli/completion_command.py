"""`tsplan completion`: a script by which a shell completes commands and options."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit, parser
from tsplan.cli.completion_scripts import SCRIPTS
from tsplan.cli.output import OUT
from tsplan.cli.parser_words import words_of
from tsplan.milp.solver import SOLVERS
from tsplan.starting.shipped_examples import examples
from tsplan.writers.plan_formats import FORMATS

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Print the script."""
    known = {
        "example": [item.name for item in examples()],
        "solver": SOLVERS,
        "to": FORMATS,
    }
    OUT.write(SCRIPTS[options.shell](words_of(parser(), known)))
    return Exit.DONE
