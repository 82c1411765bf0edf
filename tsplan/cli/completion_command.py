"""`tsplan completion`: a script by which a shell completes commands and options."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit, parser
from tsplan.cli.completion_scripts import SCRIPTS
from tsplan.cli.output import OUT
from tsplan.cli.parser_words import words_of

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Print the script."""
    OUT.write(SCRIPTS[options.shell](words_of(parser())))
    return Exit.DONE
