"""What forbids every plan and can be seen without a solver.

Each finder looks at what the formula asks for in any case (`demands`) and at when robots can be
where on their own (`Arrivals`). What it reports is a proof: any team that did better would break
the arithmetic it quotes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING

from tsplan.explanation.agent_numbers import agents
from tsplan.explanation.explanation import Element, Fact
from tsplan.explanation.part_words import Wording
from tsplan.explanation.whynot.arrivals import Arrival, Arrivals, latest_of
from tsplan.explanation.whynot.elements import of_leaf
from tsplan.explanation.whynot.unconditional_demands import Demand, demands

if TYPE_CHECKING:
    from tsplan.mission import Mission

MOST_FACTS = 20
"""Facts that are listed; the rest would only repeat them."""

MOST_DEMANDS = 200
"""Demands that are compared with each other."""


@dataclass(frozen=True)
class View:
    """One mission as the finders see it.

    `pause` is called between parts of the work, and raises where that is to end.
    """

    mission: Mission
    wording: Wording
    arrivals: Arrivals
    pause: Callable[[], None]

    @classmethod
    def of(cls, mission: Mission, pause: Callable[[], None] = lambda: None) -> View:
        """The view of a mission."""
        return cls(mission, Wording(mission), Arrivals(mission, pause), pause)

    @cached_property
    def all_demands(self) -> tuple[Demand, ...]:
        """What the formula asks for in any case."""
        return demands(self.mission)

    @cached_property
    def needs(self) -> tuple[Demand, ...]:
        """The lower bounds among the demands that ask for somebody."""
        return tuple(item for item in self.all_demands if not item.upper and item.amount > 0)

    @cached_property
    def limits(self) -> tuple[Demand, ...]:
        """The upper bounds among the demands."""
        return tuple(item for item in self.all_demands if item.upper)

    def ready(self, need: Demand) -> float:
        """The earliest step at which a need can begin to be met, by travel times alone."""
        if need.reach == "together":
            return latest_of(self.arrivals.within(need.states, need.capability), need.amount)
        steps = [
            latest_of(self.arrivals.at(state, need.capability), need.amount)
            for state in need.states
        ]
        return max(steps) if need.reach == "each" else min(steps)

    def fact(self, kind: str, text: str, demands: Iterable[Demand], *others: Element) -> Fact:
        """A fact about some demands or other elements; it stands where the first of them does."""
        leaves = list(dict.fromkeys(item.leaf for item in demands))
        parts = self.wording.parts({*(of_leaf(leaf) for leaf in leaves), *others})
        place = self.wording.sources.place(leaves[0]) if leaves else parts[0].place
        return Fact(kind, text, place, parts)

    def team(self, capability: str | None, *kinds: str) -> list[Element]:
        """The elements of the team's entries with a capability."""
        if self.mission.swarm is not None:
            return []
        return [
            Element(kind, (number,))  # type: ignore[arg-type]  # kinds are words
            for number, group in enumerate(self.mission.team)
            if capability is None or capability in group.capabilities
            for kind in kinds
        ]

    def having(self, capability: str | None) -> str:
        """How many the team has with a capability, and in which classes."""
        total = self.mission.having(capability)
        counts: dict[str, int] = {}
        for group in self.mission.team:
            if capability is None or capability in group.capabilities:
                counts[group.class_name] = counts.get(group.class_name, 0) + group.count
        inside = ", ".join(f"{count} {name}" for name, count in counts.items())
        return f"{total} ({inside})" if inside else "none"


Finder = Callable[[View], Iterator[Fact]]


def find_facts(view: View) -> tuple[Fact, ...]:
    """All facts that forbid every plan, those of the simplest kinds first."""
    return tuple(facts_of(view))


def facts_of(view: View) -> Iterator[Fact]:
    """The same one by one, as they are found."""
    from tsplan.explanation.whynot.supply import scarcity  # noqa: PLC0415  (all import this module)
    from tsplan.explanation.whynot.swarm_edits import divided  # noqa: PLC0415
    from tsplan.explanation.whynot.time_conflicts import contradictions, crowding, room  # noqa: PLC0415
    from tsplan.explanation.whynot.waiting import restless, stuck  # noqa: PLC0415

    finders: tuple[Finder, ...] = (
        stuck,
        scarcity,
        divided,
        unreachable,
        restless,
        crowding,
        contradictions,
        room,
    )
    known: set[tuple[str, str]] = set()
    for finder in finders:
        view.pause()
        for fact in finder(view):
            if (fact.kind, fact.text) not in known:
                known.add((fact.kind, fact.text))
                yield fact
            if len(known) >= MOST_FACTS:
                return


def unreachable(view: View) -> Iterator[Fact]:
    """Places that too few robots with the capability can reach before it is too late."""
    for need in view.needs:
        view.pause()
        if view.mission.having(need.capability) < need.amount:
            continue  # too few wherever they are: that is scarcity
        late = [
            (state, arrivals)
            for state, arrivals in _places(view, need)
            if latest_of(arrivals, need.amount) > need.span.last
        ]
        if late and (need.reach != "one" or len(late) == len(need.states)):
            state, arrivals = late[0]
            text = _too_late(view, need, state, arrivals)
            able = view.team(need.capability, "start", "team")
            yield view.fact("reach", text, [need], *able)


def _places(view: View, need: Demand) -> list[tuple[str, list[Arrival]]]:
    if need.reach == "together":
        nearest = view.arrivals.within(need.states, need.capability)
        return [(need.states[0], nearest)]
    return [(state, view.arrivals.at(state, need.capability)) for state in need.states]


def _too_late(view: View, need: Demand, state: str, arrivals: list[Arrival]) -> str:
    where = f"'{state}' ({need.label})" if need.reach != "together" else f"any {need.label} state"
    last = need.span.last
    inside = sum(item.robots for item in arrivals if item.step <= last)
    who = f"with {need.capability} " if need.capability else ""
    wanted = agents(need.amount, need.capability)
    known = f"only {inside} of the agents {who}" if inside else f"nobody {who}"
    text = f"{known.rstrip()} can be at {where} by step {last}, when {wanted} must be there"
    missing = next(item for item in arrivals if item.step > last)
    group = view.mission.team[missing.entry]
    if missing.step == inf:
        return f"{text}: there is no way for class {group.class_name} from '{missing.start}'"
    target = state
    if need.reach == "together":
        distance = {s: view.arrivals.between(group, missing.start, s) for s in need.states}
        target = min(need.states, key=lambda name: distance[name])
    way = view.arrivals.way(group, missing.start, target)
    which = "next" if inside else "first"
    return (
        f"{text}: the {which} is one of class {group.class_name} from '{missing.start}', at step "
        f"{int(missing.step)} by {_shown(way)}"
    )


def _shown(way: list[str]) -> str:
    """A way in words, its middle left out where it is long."""
    most = 6
    if len(way) <= most:
        return " > ".join(way)
    return " > ".join([*way[:3], f"... {len(way) - 5} more ...", *way[-2:]])
