"""One mission as the finders of facts see it: what it asks for, and who can be where when."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import Fact, PartKind, SoftConstraint
from tsplan.explanation.part_words import Wording
from tsplan.explanation.whynot.arrivals import Arrivals, latest_of
from tsplan.explanation.whynot.soft_constraints import of_occurrence, robot_entries
from tsplan.explanation.whynot.unconditional_demands import Demand, demands

if TYPE_CHECKING:
    from tsplan.mission import Mission


@dataclass(frozen=True)
class Context:
    """One mission as the finders see it.

    `pause` is called between parts of the work, and raises where that is to end.
    """

    mission: Mission
    wording: Wording
    arrivals: Arrivals
    pause: Callable[[], None]

    @classmethod
    def of(cls, mission: Mission, pause: Callable[[], None] = lambda: None) -> Context:
        """The context of a mission."""
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
            latest_of(self.arrivals.within((state,), need.capability), need.amount)
            for state in need.states
        ]
        return max(steps) if need.reach == "each" else min(steps)

    def fact(
        self, kind: str, text: str, demands: Iterable[Demand], *others: SoftConstraint
    ) -> Fact:
        """A fact about demands or other constraints; it stands where the first of them does."""
        parts = list(dict.fromkeys(demand.occurrence for demand in demands))
        said = self.wording.parts({*map(of_occurrence, parts), *others})
        place = self.wording.sources.place(parts[0]) if parts else said[0].place
        return Fact(kind, text, place, said)

    def team(self, capability: str | None, *kinds: PartKind) -> list[SoftConstraint]:
        """The constraints of the team's entries with a capability."""
        return [
            constraint
            for number, group in enumerate(self.mission.team)
            if capability is None or capability in group.capabilities
            for constraint in self.entry(number, *kinds)
        ]

    def entry(self, number: int, *kinds: PartKind) -> list[SoftConstraint]:
        """The constraints of one entry of the team, its size and its start; swarms have none."""
        robots = number in robot_entries(self.mission)
        return [SoftConstraint(kind, (number,)) for kind in kinds or ("team", "start") if robots]

    def having(self, capability: str | None) -> str:
        """How many the team has with a capability, and in which classes."""
        counts: dict[str, int] = {}
        for group in self.mission.team:
            if capability is None or capability in group.capabilities:
                counts[group.class_name] = counts.get(group.class_name, 0) + group.count
        inside = ", ".join(f"{count} {name}" for name, count in counts.items())
        return f"{sum(counts.values())} ({inside})" if inside else "none"
