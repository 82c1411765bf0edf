"""`tsplan schema`: the JSON Schema of a kind of file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import refuse_place
from tsplan.cli.output import say_json
from tsplan.document.files import write_whole
from tsplan.starting.file_schemas import schema_text

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Print the schema, or write it to a file."""
    refuse_place(options.output, "the schema")
    text = schema_text(options.kind)
    if options.output is None:
        say_json(text)
    else:
        write_whole(options.output, text.encode())
    return Exit.DONE
