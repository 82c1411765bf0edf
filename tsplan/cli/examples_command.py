"""`tsplan examples`: the examples that come with the package."""

from __future__ import annotations

import shlex
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.output import say
from tsplan.errors import Finding, InputError
from tsplan.starting.shipped_examples import example, examples, files_of_example, place_of
from tsplan.starting.starting_folder import write_new

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

    from tsplan.starting.shipped_examples import Example

_WIDTH = 110
_DOES = {"sweep": "sweep", "map": "show"}  # what to do with a kind, but for planning it


def run(options: argparse.Namespace) -> Exit:
    """List all, or copy the one that is named with the files that it needs."""
    if options.example is not None:
        return _copy(options)
    if options.output is not None:
        raise InputError([Finding("-o says where to write an example", "name one, too")])
    for line in _listed(examples()):
        say(line)
    return Exit.DONE


def _copy(options: argparse.Namespace) -> Exit:
    item, folder = example(options.example), options.output or Path()
    files = files_of_example(item)
    write_new(folder, files)
    for name in files:
        say(f"wrote {folder / name}")
    place = shlex.quote(str(folder / place_of(item)))
    say(f"next: tsplan {_DOES.get(item.kind, 'plan')} {place}")
    return Exit.DONE


def _listed(found: tuple[Example, ...]) -> Iterator[str]:
    """One line each, below the kind."""
    broad = max((len(item.name) for item in found), default=0)
    kind = ""
    for item in found:
        if item.kind != kind:
            kind = item.kind
            yield f"{kind}:"
        room = _WIDTH - broad - 4
        yield f"  {item.name:{broad}}  {textwrap.shorten(item.words, room, placeholder=' ...')}"
