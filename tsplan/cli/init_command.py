"""`tsplan init`: a small mission to begin with."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.output import say
from tsplan.starting.starting_folder import files_of_kind, schema_files, write_new

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Write the files, and say what to do with them."""
    kinds = ("signals",) if options.kind == "signals" else ("mission", "map")
    files = files_of_kind(options.kind)
    write_new(options.folder, files, schema_files(*kinds))
    for name in files:
        say(f"wrote {options.folder / name}")
    say(f"next: tsplan plan {shlex.quote(str(options.folder / 'mission.yaml'))}")
    return Exit.DONE
