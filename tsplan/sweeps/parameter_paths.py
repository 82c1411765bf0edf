"""Paths into missions, as in `team.0.count`: read, and looked up with what is near."""

from __future__ import annotations

import re
from collections.abc import Iterable

from tsplan.document import Document, Path
from tsplan.document.kinds import SIGNALS, kind_of_data
from tsplan.document.validation import known_keys
from tsplan.document.yaml_nodes import Node
from tsplan.errors import nearest
from tsplan.mission.mission_schema import MissionFile
from tsplan.signals.signal_schema import SignalFile
from tsplan.words import nfc

_STEP = re.compile(r'"([^"]*)"|([^."]+)')
_WHOLE = re.compile(r'(?:(?:"[^"]*"|[^."]+)(?:\.(?!$)|$))+')


class NoPathError(LookupError):
    """A text is no path into a mission: what is wrong with it, and what to do."""

    def __init__(self, what: str, remedy: str) -> None:
        super().__init__(what)
        self.what, self.remedy = what, remedy


def steps_of(text: str) -> tuple[str, ...] | None:
    """The steps of a path; None for what is none. A step with a dot in it stands in quotes.

    >>> steps_of('map.states."dock.1".capacity'), steps_of("team..count")
    (('map', 'states', 'dock.1', 'capacity'), None)
    """
    if not _WHOLE.fullmatch(text):
        return None
    return tuple(nfc(quoted or plain) for quoted, plain in _STEP.findall(text))


def located_path(document: Document, text: str) -> Path:
    """The path of a text in a mission; raises NoPathError for one that names nothing.

    The last key may be one that the mission does without and could have.
    """
    steps = steps_of(text)
    if steps is None:
        raise NoPathError(f"'{text}' is no path", "write it as in team.0.count")
    node = document.root
    path: Path = ()
    for place, step in enumerate(steps):
        key = _key(node, step)
        last = place == len(steps) - 1
        if key is None and last and step in _possible(document, path, node):
            return (*path, step)
        if key is None:
            raise _nothing(text, step, path, _known(document, path, node, last=last))
        path = (*path, key)
        node = document.node(path)
    return path


def _key(node: Node, step: str) -> str | int | None:
    """The key or position that a step means in a node; None if there is none."""
    if isinstance(node.children, dict):
        return step if step in node.children else None
    if isinstance(node.children, list) and step.isdecimal() and int(step) < len(node.children):
        return int(step)
    return None


def _possible(document: Document, path: Path, node: Node) -> list[str]:
    """The keys that a mission could have in a mapping."""
    if not isinstance(node.children, dict):
        return []
    signals = kind_of_data(document.data) == SIGNALS
    return known_keys(SignalFile if signals else MissionFile, path)


def _known(document: Document, path: Path, node: Node, *, last: bool) -> Iterable[str]:
    """The steps that would lead on from a node."""
    if isinstance(node.children, list):
        return map(str, range(len(node.children)))
    own = node.children or {}
    return {*own, *(_possible(document, path, node) if last else ())}


def _nothing(text: str, step: str, path: Path, known: Iterable[str]) -> NoPathError:
    where = f" in '{'.'.join(map(str, path))}'" if path else ""
    what = f"'{text}' names nothing in the mission: there is no '{step}'{where}"
    return NoPathError(what, nearest(step, known))
