"""`tsplan help`: what a command does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit, parser
from tsplan.cli.output import OUT
from tsplan.cli.parser_words import commands_of

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Print what `--help` of a command prints, or of the whole."""
    top = parser()
    shown = top if options.topic is None else commands_of(top)[options.topic]
    OUT.write(shown.format_help())
    return Exit.DONE
