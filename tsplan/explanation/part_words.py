"""The parts of a mission in words, each with its place."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from tsplan.explanation.agent_numbers import many
from tsplan.explanation.explanation import Element, Part, Place
from tsplan.explanation.whynot.elements import formula_groups, leaf_of
from tsplan.explanation.whynot.formula_places import Sources
from tsplan.explanation.whynot.group_bounds import path_of, swarm_part
from tsplan.explanation.whynot.occurrences import Leaf, Way, conjuncts, node_at
from tsplan.explanation.whynot.waiting import WAITING, waiting_part

if TYPE_CHECKING:
    from tsplan.mission import Group, Mission


@dataclass(frozen=True)
class Wording:
    """Words and places for the elements of one mission."""

    mission: Mission

    @cached_property
    def sources(self) -> Sources:
        """The texts of the formula with their places."""
        return Sources(self.mission)

    def text(self, leaf: Leaf) -> str:
        """A part of the formula as it was written, on one line."""
        found = self.sources.of(leaf.way)
        if found is not None:
            source, way = found
            stretch = source.pair(Leaf(way, leaf.pair))
            if stretch is not None:
                return " ".join(source.text[stretch.begin : stretch.end].split())
        node = node_at(self.mission.formula, leaf.way)
        if leaf.pair is None:
            return str(node)
        name, amount = node.needs[leaf.pair]  # type: ignore[attr-defined]  # only these have pairs
        return f"({name}, {amount})"

    def conjunct(self, way: Way) -> Way:
        """The conjunct that a sub-formula belongs to."""
        return next(item for item in conjuncts(self.mission.formula) if way[: len(item)] == item)

    def part_of(self, leaf: Leaf) -> Part:
        """A leaf of the formula, said with the conjunct it belongs to."""
        whole = self.conjunct(leaf.way)
        text = self.text(leaf)
        if leaf != Leaf(whole):
            text = f"{text} in {self.text(Leaf(whole))}"
        element = Element("formula", tuple(leaf))
        return Part("formula", text, self.sources.place(leaf), frozenset({element}))

    def parts(self, elements: Iterable[Element]) -> tuple[Part, ...]:
        """The parts that elements make up; whole conjuncts are one part."""
        chosen = frozenset(elements)
        found: list[Part] = []
        for group in formula_groups(self.mission):
            members = [item for item in group if item in chosen]
            if len(members) == len(group):
                way = self.conjunct(leaf_of(group[0]).way)
                leaf = Leaf(way)
                place = self.sources.place(leaf)
                found.append(Part("formula", self.text(leaf), place, frozenset(group)))
            else:
                found += [self.part_of(leaf_of(item)) for item in members]
        others = [item for item in chosen if item.kind != "formula"]
        return (*found, *(self.fact(item) for item in sorted(others, key=_order)))

    def fact(self, element: Element) -> Part:
        """A bound beside the formula, as a named fact."""
        if element.kind == "capacity":
            return self._capacity(element)
        if element == WAITING:
            return waiting_part(self.mission, self._map(("map", "waiting")))
        if element.kind == "swarm":
            place = self.sources.at(path_of(self.mission, element))
            return swarm_part(self.mission, element, place)
        (number,) = element.key
        group = self.mission.team[number]
        if element.kind == "team":
            text = f"the team has {many(group.count, group.class_name)}"
            place = self._entry(number, "count")
        else:
            text = f"the agents of class {group.class_name} start at {starts_of(group)}"
            place = self._entry(number, "at")
        return Part(element.kind, text, place, frozenset({element}))

    def _capacity(self, element: Element) -> Part:
        system = self.mission.system
        if len(element.key) == 1:
            (name,) = element.key
            text = f"state '{name}' holds at most {system.states[name].capacity}"
            place = self._map(("map", "states", name, "capacity"))
        else:
            source, target = element.key
            edge = system.edges[source, target]
            both = " (both ways together)" if edge.both_ways else ""
            text = f"the edge from '{source}' to '{target}' holds at most {edge.capacity}{both}"
            place = self._map(("map", "edges"))
        return Part("capacity", text, place, frozenset({element}))

    def _map(self, path: tuple[str, ...]) -> Place:
        """The place of a part of the map, if the map stands in the mission file."""
        origin = self.mission.origin
        inline = origin is not None and isinstance(origin.data.get("map"), dict)
        return self.sources.at(path) if inline else Place()

    def _entry(self, number: int, key: str) -> Place:
        return self.sources.at(("team", number, key))


def starts_of(group: Group) -> str:
    """Where a group starts, in words."""
    if len(group.starts) == 1:
        return f"'{group.starts[0][0]}'"
    return ", ".join(f"'{state}' ({count})" for state, count in group.starts)


def _order(element: Element) -> tuple[int, tuple[str, ...]]:
    return _KINDS.index(element.kind), tuple(str(item) for item in element.key)


_KINDS = ("formula", "team", "start", "waiting", "capacity", "swarm")
