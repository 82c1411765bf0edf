"""Worlds from files and from Python values, which are written down as a file and read like one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields, replace
from pathlib import Path
from typing import Any, TypedDict

from tsplan.document import Document, read_document, validated
from tsplan.document.kinds import WORLD
from tsplan.errors import InputError, PlanError
from tsplan.mission.values import common_entry, from_values
from tsplan.plans.worlds import World
from tsplan.replanning.world_schema import WorldFile


class Changes(TypedDict, total=False):
    """What is different from what was planned; see `tsplan.plans.worlds.World` for each.

    Places are states or pairs of states. Of `moved` agents a value is a state, or the edge that
    they are on, `{"from": "q1", "to": "q2", "arrives": 9}`. What is `closed` for a time only is
    written `{"place": "q1", "until": 9}`, and what is `opened` or takes another duration `{"from":
    "q1", "to": "q2", "duration": 3}`; `added` agents are `{"class": "scout", "at": "q1", "count":
    2}`, and `capacities` `{"place": "q1", "capacity": 2}`.
    """

    lost: Iterable[str]
    moved: Mapping[str, Any]
    late: Mapping[str, int]
    numbers: Mapping[str, Mapping[str, int]]
    stocks: Mapping[str, Mapping[str, float]]
    added: Iterable[Mapping[str, Any]]
    closed: Iterable[Any]
    opened: Iterable[Mapping[str, Any]]
    capacities: Iterable[Mapping[str, Any]]
    demanded: Iterable[str]
    withdrawn: Iterable[str]
    deadlines: Mapping[str, int]


def world_of(step: int, changes: Changes) -> World:
    """The world of Python values at a step. Raises PlanError for what makes none.

    >>> world_of(3, {"lost": ["scout-1"], "closed": ["q2", ("q1", "q2")]}).closed[1].place
    ('q1', 'q2')
    """
    lists = {key: _listed(value) for key, value in changes.items() if value}
    try:
        return from_values({"step": step, **lists}, common_entry, _read).world(step)
    except InputError as error:  # there is no file
        raise PlanError(replace(finding, source=None) for finding in error.findings) from None


def load_world(path: Path, step: int | None) -> World:
    """The world of a file, at the step that it names or at a given one.

    Raises PlanError with everything that is wrong with it, and where there is no step or two.
    """
    try:
        document = read_document(path)
        file = _read(document)
    except InputError as error:
        raise PlanError(error.findings) from None
    if file.step is None and step is None:
        raise PlanError([document.finding((), "'step' is missing", "add 'step: 12'")])
    if None not in (file.step, step) and file.step != step:
        what = f"the world is of step {file.step}, and step {step} is asked for"
        raise PlanError([document.finding(("step",), what, "name one step")])
    return file.world(file.step if step is None else step)  # type: ignore[arg-type]  # one is there


def with_changes(world: World, other: World) -> World:
    """A world in which what another one says is so, too."""
    joined: dict[str, Any] = {
        item.name: _both(getattr(world, item.name), getattr(other, item.name))
        for item in fields(world)
        if item.name != "step"
    }
    return replace(world, **joined)


def _both(one: Any, other: Any) -> Any:
    return {**one, **other} if isinstance(one, Mapping) else (*one, *other)


def _listed(value: Any) -> Any:
    return dict(value) if isinstance(value, Mapping) else list(value)


def _read(document: Document) -> WorldFile:
    strange = document.misfit((), WORLD)
    if strange is not None:
        raise PlanError([strange])
    file, findings = validated(document, WorldFile)
    if file is None:
        raise PlanError(findings)
    return file
