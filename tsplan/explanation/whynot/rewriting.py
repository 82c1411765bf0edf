"""A changed mission as a file: the original text with what differs exchanged in place.

What is written is read again and compared with the changed mission. Where the text cannot be
edited in place, the mission is written anew, and its comments are lost.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from tsplan.errors import InputError
from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.whynot.formula_places import Sources
from tsplan.explanation.whynot.mission_numbers import Number
from tsplan.explanation.whynot.occurrences import Occurrence, Way
from tsplan.explanation.whynot.soft_constraints import file_path, group_bounds, robot_entries
from tsplan.logic import Count, Formula, Release, Until, Window
from tsplan.logic.text import quoted
from tsplan.mission import mission_from_text
from tsplan.mission.mission_writer import group_entry, margin_text
from tsplan.ts.io.flow_style import flow
from tsplan.ts.io.tsplan_yaml import map_to_yaml

if TYPE_CHECKING:
    from tsplan.document import Document
    from tsplan.mission import Group, Mission


class Written(NamedTuple):
    """The text of a mission file, and whether some comments of the original are not in it."""

    text: str
    comments_lost: bool


@dataclass(frozen=True, slots=True)
class _Edit:
    """Characters `begin` up to before `end` become `text`."""

    begin: int
    end: int
    text: str


def rewritten(original: Mission, changed: Mission, folder: Path, target: Path) -> Written:
    """The file of a changed mission. The original came from `folder`, the file goes to `target`."""
    content = original.origin.content if original.origin is not None else ""
    text = changed.to_yaml()
    if original.origin is not None:
        edits = _edits(original, changed, original.origin, (folder, target))
        edited = _edited(content, edits)
        text = edited if _says(edited, changed, target) else text
    return Written(text, comments_lost=content.count("#") > text.count("#"))


def _says(text: str, changed: Mission, folder: Path) -> bool:
    """Whether a text is read as the changed mission."""
    try:
        read = mission_from_text(text, folder=folder)
    except InputError:
        return False
    # of equal edges, one may be written in both directions at once: what counts is the same
    return (
        read.formula is changed.formula
        and read.team == changed.team
        and read.horizon == changed.horizon
        and read.objective == changed.objective
        and read.swarm == changed.swarm
        and (read.prefer, read.satisfaction) == (changed.prefer, changed.satisfaction)
        and read.task_interval == changed.task_interval
        and dict(read.system.states) == dict(changed.system.states)
        and dict(read.system.edges) == dict(changed.system.edges)
    )


def _edited(content: str, edits: list[_Edit]) -> str:
    """The text after edits that do not overlap."""
    for edit in sorted(edits, key=lambda item: -item.begin):
        content = content[: edit.begin] + edit.text + content[edit.end :]
    return content


def _edits(
    original: Mission, changed: Mission, document: Document, folders: tuple[Path, Path]
) -> list[_Edit]:
    """What has to change in the original's text."""
    return [
        *_formula_edits(original, changed),
        *_team_edits(original, changed, document),
        *_swarm_edits(original, changed, document),
        *_map_edits(original, changed, document, folders),
        *_horizon_edits(original, changed, document),
    ]


# --- the formula -----------------------------------------------------------------------------


def _formula_edits(original: Mission, changed: Mission) -> Iterator[_Edit]:
    sources = Sources(original)
    for way, node in _differences(original.formula, changed.formula):
        windowed = isinstance(node, Window | Until | Release)
        span = sources.span((*way, "interval") if windowed else way)
        if span is not None:
            yield _Edit(*span, _text(node, sources.text(Occurrence(way)) or ""))


def _differences(old: Formula, new: Formula) -> Iterator[tuple[Way, Formula]]:
    """The new nodes that differ themselves from the old ones at the same ways."""
    open_: list[tuple[Way, Formula, Formula]] = [((), old, new)]
    while open_:
        way, before, after = open_.pop()
        if before is after:
            continue
        alike = type(before) is type(after) and len(before.children) == len(after.children)
        if not alike or not after.children:
            yield way, after
            continue
        if before.parameters != after.parameters:
            yield way, after
        pairs = zip(before.children, after.children, strict=True)
        open_ += [((*way, n), *pair) for n, pair in enumerate(pairs)]


def _text(node: Formula, old: str) -> str:
    """The new text of an operator's interval, or of an atom in place of an old one."""
    if isinstance(node, Window | Until | Release):
        return f"[{node.low},{node.high}]"
    if not isinstance(node, Count):
        return str(node)
    compared = any(sign in old for sign in "<>=")
    # a bare label or a limit binds tighter than the comparison that takes its place
    return _comparison(node) if compared else f"({_comparison(node)})"


def _comparison(node: Count) -> str:
    inside = quoted(node.label) + (f",{quoted(node.capability)}" if node.capability else "")
    return f"{node.function}({inside}) {node.relation} {node.bound}"


# --- team, map, horizon ----------------------------------------------------------------------


def _team_edits(original: Mission, changed: Mission, document: Document) -> Iterator[_Edit]:
    """Entries of the team; the sizes and starts of swarms are never changed."""
    numbers = robot_entries(original)
    if numbers and len(original.team) != len(changed.team):
        yield _exchanged(document, ("team",), _team(changed))
        return
    for number in numbers:
        if original.team[number] != changed.team[number]:
            path = file_path(original, SoftConstraint("team", (number,)))
            yield _exchanged(document, path[:-1], _member(changed.team[number]))


def _swarm_edits(original: Mission, changed: Mission, document: Document) -> Iterator[_Edit]:
    """Bounds of swarms."""
    for constraint in group_bounds(original):
        bound = Number("swarm", constraint.key)
        if bound.get(original) != bound.get(changed):
            path = file_path(original, constraint)
            yield _exchanged(document, path, _bound(bound.get(changed)))


def _bound(value: Fraction | int | None) -> str:
    """A bound as a mission file says it; a fraction of the swarm as a percentage."""
    return "null" if value is None else margin_text(value)


def _team(mission: Mission) -> str:
    """The team in flow style, one entry a line."""
    members = [_member(mission.team[number]) for number in robot_entries(mission)]
    return "[\n" + "".join(f"    {member},\n" for member in members) + "  ]"


def _member(group: Group) -> str:
    return flow(group_entry(group))


def _map_edits(
    original: Mission, changed: Mission, document: Document, folders: tuple[Path, Path]
) -> Iterator[_Edit]:
    """A changed map is written into the mission; a path is kept right for another folder."""
    if original.system != changed.system:
        text = "".join(f"\n  {line}" for line in map_to_yaml(changed.system).splitlines())
        yield _exchanged(document, ("map",), text + "\n")
        return
    given = document.at(("map",))
    before, after = (folder.resolve() for folder in folders)
    if isinstance(given, str) and before != after and not Path(given).is_absolute():
        moved = Path(os.path.relpath(before / given, after)).as_posix()
        yield _exchanged(document, ("map",), json.dumps(moved, ensure_ascii=False))


def _horizon_edits(original: Mission, changed: Mission, document: Document) -> Iterator[_Edit]:
    written = isinstance(document.data, dict) and document.data.get("horizon") is not None
    if written and original.horizon != changed.horizon:
        yield _exchanged(document, ("horizon",), str(changed.horizon))


def _exchanged(document: Document, path: tuple[str | int, ...], text: str) -> _Edit:
    """The value at a path, without the white space after it, becomes another text."""
    begin, end = document.span(path)
    kept = document.content[begin:end].rstrip()
    return _Edit(begin, begin + len(kept), text)
