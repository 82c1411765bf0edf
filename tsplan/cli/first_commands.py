"""Commands for those who begin; nothing here imports more than argparse needs."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TypeAlias

Commands: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"  # noqa: SLF001

NEW = ("team", "swarm", "signals", "fleet")
FILES = ("mission", "map", "signals", "sweep", "world", "plan", "trajectory")
SHELLS = ("bash", "zsh", "fish")


def add_first_commands(commands: Commands) -> None:
    """Add what makes files to begin with, and what helps with the command line itself."""
    words = "begin: write a small mission and its map, with comments, for editors too"
    new = commands.add_parser("init", help=words)
    new.add_argument("kind", choices=NEW, metavar="NAME", help=", ".join(NEW))
    new.add_argument("folder", type=Path, nargs="?", default=Path(), metavar="DIR", help=_FOLDER)

    copied = commands.add_parser("examples", help="list the shipped examples, or copy one")
    copied.add_argument("example", nargs="?", metavar="NAME", help="example to copy")
    copied.add_argument("-o", "--output", type=Path, metavar="DIR", help=_FOLDER)

    schema = commands.add_parser("schema", help="print the JSON Schema of a kind of file")
    schema.add_argument("kind", choices=FILES, metavar="KIND", help=", ".join(FILES))
    schema.add_argument("-o", "--output", type=Path, metavar="FILE", help="write it here instead")

    words = "print a script by which a shell completes commands and options"
    completion = commands.add_parser("completion", help=words, epilog=_LOADED)
    completion.add_argument("shell", choices=SHELLS, metavar="SHELL", help=", ".join(SHELLS))

    topic = commands.add_parser("help", help="say what a command does, as COMMAND --help")
    topic.add_argument("topic", nargs="?", choices=commands.choices, metavar="COMMAND")


_FOLDER = "where to write, made if it is missing (default: this folder)"
_LOADED = (
    "load it by 'source <(tsplan completion bash)', likewise for zsh, or "
    "'tsplan completion fish | source', in the file that your shell reads at its start"
)
