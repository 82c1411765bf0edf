"""The parts of a mission in words, each with its place; and numbers of agents in words."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, get_args

from tsplan.encode.expressions import UNNAMED, Constraint
from tsplan.explanation.explanation import Part, PartKind, Place, SoftConstraint
from tsplan.explanation.whynot.amount_numbers import resource_of
from tsplan.explanation.whynot.formula_places import Sources
from tsplan.explanation.whynot.mission_numbers import MARGIN, TOGETHER, Number, value_text
from tsplan.explanation.whynot.occurrences import (
    Occurrence,
    Way,
    amounts_of,
    conjuncts,
    counts_of,
    node_at,
)
from tsplan.explanation.whynot.posed_mission import own_of
from tsplan.explanation.whynot.soft_constraints import (
    file_path,
    formula_groups,
    occurrence_of,
    of_occurrence,
)
from tsplan.logic.text import number_text
from tsplan.ts.io.map_settings import is_reference
from tsplan.ts.map_lint import listed
from tsplan.ts.waits import without_wait
from tsplan.words import many

if TYPE_CHECKING:
    from tsplan.document import Path
    from tsplan.mission import Group, Mission, Resource
    from tsplan.mission.resources import Carries
    from tsplan.ts.closures import Closed

_KINDS: tuple[PartKind, ...] = get_args(PartKind)
"""The order in which parts of a conflict are said."""


_BOOKED: Mapping[str, str] = MappingProxyType(
    {
        "exclusive": "an agent serves one task at a time, with one capability (booking: exclusive)",
        "per-label": "different labels of a state have different agents (booking: per-label)",
    }
)


def agents(number: int, capability: str | None) -> str:
    """A number of agents, with the capability they are counted for."""
    return many(number, "agent") + (f" with {capability}" if capability else "")


def room_of(margin: Fraction | int) -> str:
    """A head-room: agents, or a share of the swarm."""
    return value_text(margin) if isinstance(margin, Fraction) else agents(margin, None)


def swarm_words(mission: Mission, name: str) -> str:
    """A swarm; by its name where there are several."""
    assert mission.swarm is not None
    return f"the swarm '{name}'" if len(mission.swarm.each) > 1 else "the swarm"


@dataclass(frozen=True)
class Wording(ABC):
    """Words and places for the constraints of one mission."""

    mission: Any

    @cached_property
    def sources(self) -> Sources:
        """The texts of the formula with their places."""
        return Sources(self.mission)

    def text(self, part: Occurrence) -> str:
        """A part of the formula as it was written, on one line."""
        written = self.sources.text(part)
        if written is not None:
            return " ".join(written.split())
        node = node_at(self.mission.formula, part.way)
        if part.need is None:
            return str(node)
        counts = counts_of(node)
        if part.need < len(counts):
            return f"({counts[part.need].capability}, {counts[part.need].bound})"
        name, amount = amounts_of(node)[part.need - len(counts)]
        return f"({name}, {number_text(amount)})"

    def conjunct(self, way: Way) -> Way:
        """The conjunct that a sub-formula belongs to."""
        return next(item for item in conjuncts(self.mission.formula) if way[: len(item)] == item)

    def whole(self, way: Way) -> str:
        """The text of the conjunct that a sub-formula belongs to."""
        return self.text(Occurrence(self.conjunct(way)))

    def part_of(self, part: Occurrence) -> Part:
        """A part of the formula, said with the conjunct it belongs to."""
        text = self.text(part)
        if part != Occurrence(self.conjunct(part.way)):
            text = f"{text} in {self.whole(part.way)}"
        return Part("formula", text, self.sources.place(part), frozenset({of_occurrence(part)}))

    def parts(self, constraints: Iterable[SoftConstraint]) -> tuple[Part, ...]:
        """The parts that constraints make up; whole conjuncts are one part."""
        chosen = frozenset(constraints)
        found: list[Part] = []
        for group in formula_groups(self.mission):
            members = [item for item in group if item in chosen]
            if len(members) == len(group):
                whole = Occurrence(self.conjunct(occurrence_of(group[0]).way))
                place = self.sources.place(whole)
                found.append(Part("formula", self.text(whole), place, frozenset(group)))
            else:
                found += [self.part_of(occurrence_of(item)) for item in members]
        others = [item for item in chosen if item.kind != "formula"]
        return (*found, *(self.fact(item) for item in sorted(others, key=_order)))

    def fact(self, constraint: SoftConstraint) -> Part:
        """A bound beside the formula, as a named fact."""
        path = None if self.mission.origin is None else self.path(constraint)
        place = Place() if path is None else self.sources.at(path)
        text = self.bound_text(constraint)
        return Part(constraint.kind, text, place, frozenset({constraint}))

    @abstractmethod
    def path(self, constraint: SoftConstraint) -> Path | None:
        """Where the mission file says a bound; None where another file does."""

    @abstractmethod
    def bound_text(self, constraint: SoftConstraint) -> str:
        """A bound beside the formula in words."""


@dataclass(frozen=True)
class TeamWording(Wording):
    """Words and places for what bounds teams and swarms."""

    mission: Mission

    def path(self, constraint: SoftConstraint) -> Path | None:
        """Where the mission file says a bound; None where the map has a file of its own."""
        if constraint.kind == "own":
            return None
        path, origin = file_path(self.mission, constraint), self.mission.origin
        given = None if origin is None else origin.data["map"]
        inside = isinstance(given, dict) and not is_reference(given)
        apart = origin is None or (path[0] == "map" and not inside)
        return None if apart else path

    def bound_text(self, constraint: SoftConstraint) -> str:
        """A bound beside the formula in words."""
        kind, key = constraint
        if kind == "waiting":
            where = listed(without_wait(self.mission.system))
            return f"nobody can wait at {where}: no edge leads from there to itself"
        if kind == "booking":
            return _BOOKED[self.mission.booking]
        if kind == "swarm":
            return self._group_bound(*key)
        if kind in ("capacity", "zone"):
            number = Number("zone" if kind == "zone" else "capacity", key)
            both = len(key) > 1 and self.mission.system.edges[key].both_ways
            most = number.get(self.mission)
            return f"{room_words(number)} holds at most {most}{' (both ways together)' * both}"
        if kind in ("own", "stock"):
            return self._named_words(kind, key[0])
        return self._group_words(kind, self.mission.team[key[0]])

    def _named_words(self, kind: PartKind, which: Any) -> str:
        """What is said of an own constraint, by its number, or of a resource, by its name."""
        if kind == "own":
            return own_words(own_of(self.mission)[which])
        return stock_words(resource_of(self.mission, which))

    def _group_words(self, kind: PartKind, group: Group) -> str:
        """What is said of an entry of the team."""
        if kind == "carries":
            whose = f"each agent of class {group.class_name} carries at most"
            return f"{whose} {carries_words(group.carries)}"
        if kind == "team":
            return f"the team has {many(group.count, 'agent')} of class {group.class_name}"
        told = [(f"at '{state}'", count) for state, count in group.starts]
        told += [(f"{w.words}, there at step {w.arrives}", count) for w, count in group.coming]
        if len(told) == 1:
            return f"the agents of class {group.class_name} start {told[0][0]}"
        if not group.coming:
            told = [(words.removeprefix("at "), count) for words, count in told]
        where = ", ".join(f"{words} ({count})" for words, count in told)
        at = "" if group.coming else "at "
        return f"the agents of class {group.class_name} start {at}{where}"

    def _group_bound(self, name: str, which: str) -> str:
        bound = Number("swarm", (name, which)).get(self.mission)
        if (name, which) == MARGIN:
            return f"every demand is met with {room_of(bound)} to spare (margin)"
        whose = "all swarms together" if not name else swarm_words(self.mission, name)
        if which == "least":
            return f"every sub-swarm of {whose} has at least {agents(bound, None)}"
        have = "have" if (name, which) == TOGETHER else "has"
        return f"{whose} {have} at most {many(bound, 'sub-swarm')} at a step"


def own_title(item: Constraint) -> str:
    """Which own constraint is meant: by its name, and by where it was added."""
    if item.name == UNNAMED:
        return f"the own constraint of {item.place}" if item.place else "an own constraint"
    return f"own constraint '{item.name}'" + (f" ({item.place})" if item.place else "")


def own_words(item: Constraint) -> str:
    """An own constraint in words."""
    return f"{own_title(item)}: {item}"


def amount_words(amount: Fraction | float, name: str) -> str:
    """An amount of a resource."""
    return f"{number_text(float(amount))} {name}"


def stock_words(resource: Resource) -> str:
    """How much there is of a resource, and where."""
    lying = [(state, amount) for state, _, amount in resource.sources if amount]
    if not lying:
        return f"there is no {resource.name}"
    verb = "is" if resource.total == 1 else "are"
    total = amount_words(resource.total, resource.name)
    if len(lying) == 1:
        return f"there {verb} {total}, at '{lying[0][0]}'"
    where = ", ".join(f"{number_text(amount)} at '{state}'" for state, amount in lying)
    return f"there {verb} {total}: {where}"


def carries_words(carries: Carries) -> str:
    """What one robot carries at most."""
    if not isinstance(carries, tuple):
        return f"{number_text(carries)} of all resources together"
    return " and ".join(amount_words(amount, name) for name, amount in carries)


def ends_words(ends: tuple[str, ...]) -> str:
    """A state, or an edge by its two ends."""
    return f"state '{ends[0]}'" if len(ends) == 1 else f"the edge from '{ends[0]}' to '{ends[1]}'"


def closed_words(closed: Closed) -> str:
    """The steps at which a place is closed.

    >>> closed_words(((2, 2), (4, 9)))
    'at step 2 and from step 4 to 9'
    """
    each = [f"at step {a}" if a == b else f"from step {a} to {b}" for a, b in closed]
    return " and ".join(each)


def room_words(number: Number) -> str:
    """What has a capacity: a state, an edge or a zone."""
    return f"the zone '{number.key[0]}'" if number.kind == "zone" else ends_words(number.key)


def _order(constraint: SoftConstraint) -> tuple[int, tuple[str, ...]]:
    return _KINDS.index(constraint.kind), tuple(str(item) for item in constraint.key)
