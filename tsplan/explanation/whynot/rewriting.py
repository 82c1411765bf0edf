"""A changed mission as a file: the original text with what differs exchanged in place.

What is written is read again and compared with the changed mission. Where the text cannot be
edited in place, the mission is written anew, and its comments are lost.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from tsplan.document.flow_style import flow
from tsplan.errors import InputError
from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.whynot.formula_places import Sources
from tsplan.explanation.whynot.mission_numbers import Number
from tsplan.explanation.whynot.occurrences import Way, amounts_of, node_at
from tsplan.explanation.whynot.signal_entries import FIELDS, entries
from tsplan.explanation.whynot.soft_constraints import file_path, group_bounds, robot_entries
from tsplan.logic import Formula
from tsplan.logic.text import number_text
from tsplan.mission import mission_from_text
from tsplan.mission.mission_writer import group_entry, margin_text, resource_entry
from tsplan.mission.module_entries import reconfiguration_entry
from tsplan.signals.signal_files import signal_mission_from_text
from tsplan.signals.signal_mission import SignalMission
from tsplan.ts.io.map_settings import is_reference
from tsplan.ts.io.tsplan_yaml import map_to_yaml

if TYPE_CHECKING:
    from tsplan import document
    from tsplan.document import Document
    from tsplan.mission import Mission
    from tsplan.signals.result_check import AnyMission

Exchange: TypeAlias = tuple[int, int, str]
"""Characters from one up to before another become a text."""

_FIELDS = (
    "team",
    "resources",
    "horizon",
    "objective",
    "swarm",
    "resources",
    "delay",
    "booking",
    "expected",
    "prefer",
    "satisfaction",
    "task_interval",
    "modular",
)
"""What two missions must agree on to be the same, beside formula and map."""


class Written(NamedTuple):
    """The text of a mission file, and whether some comments of the original are not in it."""

    text: str
    comments_lost: bool


def rewritten(original: Any, changed: Any, folder: Path, target: Path) -> Written:
    """The file of a changed mission. The original came from `folder`, the file goes to `target`."""
    if original.origin is None:
        return Written(changed.to_yaml(), comments_lost=False)
    content = text = original.origin.content
    exchanges = _exchanges(original, changed, original.origin, (folder, target))
    for begin, end, new in sorted(set(exchanges), reverse=True):
        text = text[:begin] + new + text[end:]
    if not _says(text, changed, target):
        text = changed.to_yaml()
    return Written(text, comments_lost=content.count("#") > text.count("#"))


def _says(text: str, changed: AnyMission, folder: Path) -> bool:
    """Whether a text is read as the changed mission."""
    read: Any
    try:
        if isinstance(changed, SignalMission):
            read = signal_mission_from_text(text)
            same = all(getattr(read, field) == getattr(changed, field) for field in FIELDS)
            return read.formula is changed.formula and same
        read = mission_from_text(text, folder=folder)
    except InputError:
        return False
    # of equal edges, one may be written in both directions at once: what counts is the same
    return (
        read.formula is changed.formula
        and all(getattr(read, field) == getattr(changed, field) for field in _FIELDS)
        and dict(read.system.states) == dict(changed.system.states)
        and dict(read.system.edges) == dict(changed.system.edges)
    )


def _exchanges(
    original: Any, changed: Any, document: Document, folders: tuple[Path, Path]
) -> Iterator[Exchange]:
    """What has to change in the original's text."""
    yield from _in_formula(original, changed)
    if isinstance(original, SignalMission):
        differ = entries(original, changed)
    else:
        differ = _entries(original, changed, document, folders)
    for path, text in differ:
        begin, end = document.span(path)
        kept = document.content[begin:end].rstrip()  # white space after a value stays
        yield begin, begin + len(kept), text


def _in_formula(original: AnyMission, changed: AnyMission) -> Iterator[Exchange]:
    """The numbers of the formula that differ; a whole atom where its number is not written."""
    sources = Sources(original)
    for way, before, after in _differences(original.formula, changed.formula):
        old, new = _numbers(before), _numbers(after)
        moved = [part for part, value in new.items() if old.get(part) != value]
        spans = [sources.span((*way, *part)) for part in moved]
        if old.keys() == new.keys() and None not in spans:
            yield from (
                (*span, str(new[part])) for part, span in zip(moved, spans, strict=True) if span
            )
            continue
        # what is said of a region is one text: all of it is exchanged
        inner = next(n for n in range(len(way), -1, -1) if n == 0 or sources.span(way[:n]))
        if (whole := sources.span(way[:inner])) is not None:
            # a bare label or a limit binds tighter than the comparison that takes its place
            yield *whole, f"({node_at(changed.formula, way[:inner])})"


def _numbers(node: Any) -> dict[tuple[str | int, ...], Any]:
    """The numbers of a node by where they are written in it."""
    fields = ("low", "high", "duration", "bound")
    found: dict[tuple[str | int, ...], Any] = {
        (field,): getattr(node, field) for field in fields if hasattr(node, field)
    }
    needs = getattr(node, "needs", ())
    found |= {("needs", n, 1): number for n, (_, number) in enumerate(needs)}
    amounts = enumerate(amounts_of(node))
    return found | {("resources", n, 1): number_text(number) for n, (_, number) in amounts}


def _differences(old: Formula, new: Formula) -> Iterator[tuple[Way, Formula, Formula]]:
    """The nodes that differ themselves at the same ways."""
    open_: list[tuple[Way, Formula, Formula]] = [((), old, new)]
    while open_:
        way, before, after = open_.pop()
        if before is after:
            continue
        pairs = list(zip(before.children, after.children, strict=False))
        if not pairs or (type(before), before.parameters) != (type(after), after.parameters):
            yield way, before, after
        open_ += [((*way, n), *pair) for n, pair in enumerate(pairs)]


def _team_entries(original: Mission, changed: Mission) -> Iterator[tuple[document.Path, str]]:
    """What the entries of the team have to say, all of them where there are more than before."""
    entries = robot_entries(original)
    if entries and len(original.team) != len(changed.team):
        members = (flow(group_entry(changed.team[n])) for n in robot_entries(changed))
        yield ("team",), "[\n" + "".join(f"    {member},\n" for member in members) + "  ]"
    else:
        for number in entries:
            if original.team[number] != changed.team[number]:
                path = file_path(original, SoftConstraint("team", (number,)))[:-1]
                yield path, flow(group_entry(changed.team[number]))


def _rebuilding_entries(original: Mission, changed: Mission) -> Iterator[tuple[document.Path, str]]:
    """What the reconfigurations have to say that are not what they were."""
    rules = changed.modular.reconfigurations
    for number, (rule, old) in enumerate(
        zip(rules, original.modular.reconfigurations, strict=True)
    ):
        if rule != old:
            yield ("reconfigure", number), flow(reconfiguration_entry(rule))


def _entries(
    original: Mission, changed: Mission, document: Document, folders: tuple[Path, Path]
) -> Iterator[tuple[document.Path, str]]:
    """What other entries of the file have to say; sizes and starts of swarms never change."""
    yield from _team_entries(original, changed)
    for number, resource in enumerate(changed.resources):
        if resource != original.resources[number]:
            yield ("resources", number), flow(resource_entry(resource))
    yield from _rebuilding_entries(original, changed)
    for constraint in group_bounds(original):
        bound = Number("swarm", constraint.key)
        if (value := bound.get(changed)) != bound.get(original):
            text = "null" if value is None else margin_text(value)
            yield file_path(original, constraint), text
    if original.booking != changed.booking:
        yield ("booking",), changed.booking
    if original.system != changed.system:  # a changed map is written into the mission
        lines = map_to_yaml(changed.system).splitlines()
        yield ("map",), "".join(f"\n  {line}" for line in lines) + "\n"
    else:
        where = ("map", "file") if is_reference(document.at(("map",))) else ("map",)
        given = document.at(where)
        before, after = (folder.resolve() for folder in folders)
        if isinstance(given, str) and before != after and not Path(given).is_absolute():
            moved = Path(os.path.relpath(before / given, after)).as_posix()
            yield where, json.dumps(moved, ensure_ascii=False)
    if document.data.get("horizon") is not None and original.horizon != changed.horizon:
        yield ("horizon",), str(changed.horizon)
