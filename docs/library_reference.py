"""The references: directives for the names of a group and for the commands, docstrings as written.

Docstrings here end with their examples, without a heading, and a property's is a sentence, which
may have a colon. Napoleon would take the first for more errors and the second for a type.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, ClassVar

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

import tsplan
from tsplan.cli.arguments import parser
from tsplan.cli.parser_words import commands_of
from tsplan.public_names import GROUPS

if TYPE_CHECKING:
    from argparse import ArgumentParser
    from collections.abc import Iterator

    from sphinx.application import Sphinx

_SENTENCES = ("property", "attribute", "data")
_KEPT: dict[str, list[str]] = {}


class PublicNames(SphinxDirective):
    """All names of one group of `tsplan/public_names.py`, in the order of the alphabet."""

    required_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar = {}

    def run(self) -> list[nodes.Node]:
        """What autodoc makes of the names."""
        lines = StringList(list(_lines(self.arguments[0])), source="public_names.py")
        holder = nodes.container()
        self.state.nested_parse(lines, self.content_offset, holder)
        return holder.children


def _lines(group: str) -> Iterator[str]:
    names = {name: home for home, names in GROUPS[group].items() for name in names}
    for name in sorted(names, key=lambda name: (name.lower(), name)):
        kind = _kind(getattr(tsplan, name))
        yield f".. auto{kind}:: tsplan.{name}"
        yield ""


def _kind(value: object) -> str:
    """What autodoc calls a value."""
    if not isinstance(value, type):
        return "function" if callable(value) else "data"
    return "exception" if issubclass(value, BaseException) else "class"


class Commands(SphinxDirective):
    """Every command of the command line, with what `tsplan help COMMAND` prints."""

    def run(self) -> list[nodes.Node]:
        """A section for each command."""
        return [_section(name, command) for name, command in commands_of(parser()).items()]


def _section(name: str, command: ArgumentParser) -> nodes.Node:
    command.formatter_class = partial(command.formatter_class, width=88)
    text = command.format_help()
    title = f"tsplan {name}"
    section = nodes.section(ids=[nodes.make_id(title)])
    section += [nodes.title("", title), nodes.literal_block(text, text, language="none")]
    return section


def _with_heading(
    _: Sphinx, what: str, name: str, __: object, ___: object, lines: list[str]
) -> None:
    """Give the examples a heading; keep what is said of a property."""
    if what in _SENTENCES and not any(line.startswith("---") for line in lines):
        _KEPT[name] = list(lines)
        return
    first = next((at for at, line in enumerate(lines) if line.startswith(">>> ")), None)
    if first is not None and any(line.startswith("---") for line in lines[:first]):
        lines[first:first] = ["Examples", "--------"]


def _as_written(_: Sphinx, ____: str, name: str, __: object, ___: object, lines: list[str]) -> None:
    """Take back what became of a sentence."""
    if name in _KEPT:
        lines[:] = _KEPT.pop(name)


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive, and the functions before and after napoleon's."""
    app.add_directive("public-names", PublicNames)
    app.add_directive("command-line", Commands)
    app.connect("autodoc-process-docstring", _with_heading, priority=400)
    app.connect("autodoc-process-docstring", _as_written, priority=600)
    return {"parallel_read_safe": True}
