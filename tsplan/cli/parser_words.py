"""What may be written on a command line, read off its parser."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Value:
    """What may stand somewhere: one of some words, or a file."""

    words: tuple[str, ...] = ()
    file: bool = False


@dataclass(frozen=True)
class Option:
    """An option by its names; without a value it is a flag."""

    names: tuple[str, ...]
    help: str
    value: Value | None


@dataclass(frozen=True)
class Command:
    """A command: what stands in its places, and its options."""

    name: str
    help: str
    value: Value
    options: tuple[Option, ...]


def commands_of(top: argparse.ArgumentParser) -> Mapping[str, argparse.ArgumentParser]:
    """The parsers of the commands by their names."""
    return _subparsers(top).choices


Known = Mapping[str, Iterable[str]]
"""Words for arguments that may be others, too, by the names of these in the parser."""


def words_of(top: argparse.ArgumentParser, known: Known) -> tuple[Command, ...]:
    """The commands of a parser, with all that may be written behind each."""
    subparsers = _subparsers(top)
    helps = {action.dest: action.help or "" for action in subparsers._choices_actions}  # noqa: SLF001
    return tuple(
        _command(name, helps.get(name, ""), parser._actions, known)  # noqa: SLF001
        for name, parser in subparsers.choices.items()
    )


def _subparsers(
    top: argparse.ArgumentParser,
) -> argparse._SubParsersAction[argparse.ArgumentParser]:
    """Where the commands are, which argparse does not tell by itself."""
    kind = argparse._SubParsersAction  # noqa: SLF001
    return next(action for action in top._actions if isinstance(action, kind))  # noqa: SLF001


def _command(name: str, words: str, actions: Iterable[argparse.Action], known: Known) -> Command:
    named = [action for action in actions if action.option_strings]
    placed = [_value(action, known) for action in actions if not action.option_strings]
    return Command(
        name,
        words,
        Value(
            tuple(word for value in placed for word in value.words),
            any(value.file for value in placed),
        ),
        tuple(
            Option(
                tuple(action.option_strings),
                (action.help or "").replace("%%", "%"),
                None if action.nargs == 0 else _value(action, known),
            )
            for action in named
        ),
    )


def _value(action: argparse.Action, known: Known) -> Value:
    words = action.choices or known.get(action.dest, ())
    return Value(tuple(map(str, words)), action.type is Path)
