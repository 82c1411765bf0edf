"""The agents of a plan as its file has them: one an entry, or of many a bundle an entry.

A bundle has `ids` in place of an `id`: runs `[stem, first, last, place]`, which stand for the
agents named stem + first up to stem + last, the first of which is the agent number `place` of the
plan, counted from 0. A name without a number has null for first and last.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from operator import itemgetter
from typing import Annotated, Any, NamedTuple, Self, TypeAlias

from pydantic import (
    AfterValidator,
    BeforeValidator,
    GetCoreSchemaHandler,
    GetPydanticSchema,
    model_validator,
)
from pydantic_core.core_schema import CoreSchema, no_info_after_validator_function

from tsplan.limits import MOST_ROBOTS
from tsplan.name_runs import Run, joined_runs
from tsplan.plans.agent_plans import Able, Stays, stays_somewhere
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.records import OPTIONAL, Record, Whole, Word, as_json, json_lines

MOST_LISTED = 1000
"""Agents up to which a file has an entry for every one, unless it is asked to have that anyway."""

Counted: TypeAlias = tuple[str, Whole, Whole]
"""Names that count on, as a file has them: `[stem, first, last]`."""

_Ids: TypeAlias = tuple[str, Whole | None, Whole | None, Whole]


def sound(names: Counted) -> Counted:
    """Names that are spelled in one way alone, and no more than any team has."""
    stem, first, last = names
    if first > last:
        raise ValueError(f"the numbers {first} to {last} are out of order")
    if Run.of(f"{stem}{first}").stem != stem:
        raise ValueError(f"the number {first} does not begin behind '{stem}'")
    if last - first >= MOST_ROBOTS:
        raise ValueError(f"'{stem}' has more than the {MOST_ROBOTS:,} agents of any team")
    return names


def _sound(ids: _Ids) -> _Ids:
    stem, first, last, _ = ids
    if first is not None and last is not None:
        sound((stem, first, last))
    elif first != last:
        raise ValueError(f"the numbers {first} to {last} are out of order")
    elif not stem or Run.of(stem).counted:
        raise ValueError(f"'{stem}' is no name without a number")
    return ids


@dataclass(frozen=True, slots=True)
class _Entry(Record):
    """An agent, or a bundle of agents."""

    class_name: Word
    stays: Stays
    capabilities: Able = frozenset()
    id: Word | None = field(default=None, metadata=OPTIONAL)
    ids: tuple[Annotated[_Ids, AfterValidator(_sound)], ...] = ()
    heading: Word | None = field(default=None, metadata=OPTIONAL)
    coming: Word | None = field(default=None, metadata=OPTIONAL)

    @model_validator(mode="after")
    def _named(self) -> Self:
        stays_somewhere(self.stays, self.coming, self.heading)
        if (self.id is None) != bool(self.ids):
            raise ValueError("an agent has an id, and a bundle of agents has ids")
        return self


class _Placed(NamedTuple):
    """Agents of a file in a row: the place of the first one in the plan, and their path."""

    place: int
    names: Run
    path: Bundle

    def continued(self, after: _Placed) -> _Placed | None:
        """Both as one, if the other goes on where this one ends."""
        if after.path is not self.path or after.place != self.place + self.names.size:
            return None
        both = self.names.continued(after.names)
        return None if both is None else _Placed(self.place, both, self.path)


def _agents_of(entries: tuple[_Entry, ...]) -> Agents:
    """The agents that a file lists, one by one or in bundles."""
    placed = sorted(joined_runs(_placed(entries)), key=itemgetter(0))
    before = 0
    for place, names, _ in placed:
        if place != before:
            raise ValueError(f"agent {names.name()} has place {place}, and {before} come before it")
        before += names.size
    if before > MOST_ROBOTS:
        raise ValueError(f"there are {before:,} agents, more than the {MOST_ROBOTS:,} of any team")
    return Agents.along(each[1:] for each in placed)


def _placed(entries: tuple[_Entry, ...]) -> Iterator[_Placed]:
    """Rows of agents; an agent by itself comes after all that is before it in the file."""
    paths: dict[tuple[object, ...], Bundle] = {}
    after = 0
    for entry in entries:
        ends = entry.heading, entry.coming
        key = (entry.class_name, entry.capabilities, id(entry.stays), *ends)
        path = paths.get(key)
        if path is None:
            own = entry.class_name, entry.capabilities, entry.stays, entry.heading
            path = paths[key] = Bundle(*own, coming=entry.coming)
        if entry.id is not None:
            yield _Placed(after, Run.of(entry.id), path)
            after += 1
        for stem, first, last, place in entry.ids:
            names = Run(stem) if first is None or last is None else Run(stem, first, last)
            yield _Placed(place, names, path)
            after = place + names.size


def _listing(given: object) -> object:
    """The entries of a file, which may be none."""
    return () if given is None else given


def _read(_: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
    listed = handler.generate_schema(Annotated[tuple[_Entry, ...], BeforeValidator(_listing)])
    return no_info_after_validator_function(_agents_of, listed)


READ_AGENTS = GetPydanticSchema(_read)
"""How the agents of a plan are read: from entries, with findings at their places there."""


def agents_json(agents: Agents, *, each: bool = False) -> str:
    """The agents in JSON, every one by itself if they are few or with `each`."""
    if each or len(agents) <= MOST_LISTED:
        return json_lines(_listed(agents))
    return json_lines(_bundled(agents))


def _listed(agents: Agents) -> Iterator[str]:
    """An entry for every agent; what agents on one path have in common is made only once."""
    tails = {id(path): _tail(path) for path in agents.bundles}
    for names, path in agents.stretches:
        stem, tail = as_json(names.stem).removesuffix('"'), tails[id(path)]
        if names.counted:
            numbers = range(names.first, names.last + 1)
            yield from [f'{{"id": {stem}{number}"{tail}' for number in numbers]
        else:
            yield f'{{"id": {stem}"{tail}'


def _bundled(agents: Agents) -> Iterator[str]:
    """An entry for every bundle."""
    ids: dict[int, list[_Ids]] = {number: [] for number in range(len(agents.bundles))}
    place = 0
    for names, number in agents.order:
        numbers = (names.first, names.last) if names.counted else (None, None)
        ids[number].append((names.stem, *numbers, place))
        place += names.size
    for number, path in enumerate(agents.bundles):
        yield f'{{"ids": {as_json(ids[number])}{_tail(path)}'


def _tail(path: Bundle) -> str:
    return as_json(path.agent("")).removeprefix('{"id": ""')
