"""A mission together with own constraints, which the search for an explanation takes out like any.

Whatever is made of such a mission keeps them, so that all questions about it and about its changes
are questions about them, too. They keep their numbers: one that is taken out bounds nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from math import ceil
from typing import TYPE_CHECKING, Any

from tsplan.encode.expressions import Constraint
from tsplan.encode.quantities import OwnVariable
from tsplan.mission import Mission
from tsplan.run.own_terms import reach
from tsplan.run.problem import Problem, Tuning

if TYPE_CHECKING:
    from collections.abc import Iterable

DEFAULT = Tuning()


@dataclass(frozen=True)
class PosedMission(Mission):
    """A mission and own constraints."""

    own: tuple[Constraint, ...] = ()

    @classmethod
    def from_problem(cls, problem: Problem) -> PosedMission:
        """The mission of a problem with its own constraints; its objective does not matter here."""
        return cls(**_parts(problem.mission), own=problem.constraints)

    def over(self, problem: Problem) -> Problem:
        """The problem that another one becomes with this mission and these constraints."""
        return problem.with_constraints(Mission(**_parts(self)), self.own)


def _parts(mission: Mission) -> dict[str, Any]:
    return {item.name: getattr(mission, item.name) for item in fields(Mission)}


def own_of(mission: Mission) -> tuple[Constraint, ...]:
    """The own constraints of a mission."""
    return mission.own if isinstance(mission, PosedMission) else ()


def problem_of(mission: Mission, tuning: Tuning = DEFAULT) -> Problem:
    """The problem that a mission poses, with its own constraints."""
    return Problem.of(mission, own_of(mission), tuning)


def with_own(mission: Mission, own: Iterable[Constraint]) -> Mission:
    """The mission with other own constraints; one that has none stays as it is."""
    return replace(mission, own=tuple(own)) if isinstance(mission, PosedMission) else mission


def begun_later(mission: Mission, steps: int) -> Mission:
    """The mission whose own constraints are about so many steps later."""

    def later(item: Constraint) -> Constraint:
        terms = (
            (
                term if isinstance(term, OwnVariable) else replace(term, step=term.step + steps),
                factor,
            )
            for term, factor in item.terms
        )
        return replace(item, terms=tuple(terms))

    return with_own(mission, map(later, own_of(mission)))


def useful_robots(mission: Mission) -> int | None:
    """How many robots can be of use for own constraints; None where that has no bound.

    Where all agents in a constraint count alike, for more or for less, as many can as it asks for:
    whoever else is left out, it holds as before. Where they count against each other any number may
    be of use.
    """
    total = 0
    for item in own_of(mission):
        agents = [factor for term, factor in item.terms if not isinstance(term, OwnVariable)]
        if min(agents, default=0) < 0 < max(agents, default=0):
            return None
        sign = 1 if max(agents, default=0) > 0 else -1
        asked = item.lower if sign > 0 else None if item.upper is None else -item.upper
        if agents and asked is not None:
            beside = replace(
                item, terms=tuple(t for t in item.terms if isinstance(t[0], OwnVariable))
            )
            low, high = reach(beside, 0)
            most = asked - low if sign > 0 else asked + high
            total += max(0, ceil(most / min(map(abs, agents))))
    return total
