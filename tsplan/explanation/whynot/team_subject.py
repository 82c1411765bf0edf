"""Missions of teams and swarms, as the search for an explanation asks about them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.edits import candidates, rank, touched
from tsplan.explanation.whynot.fact_finders import facts_of
from tsplan.explanation.whynot.mission_numbers import ORDER
from tsplan.explanation.whynot.relaxing import any_plan, bounded_above, relaxed
from tsplan.explanation.whynot.shortages import undeliverable
from tsplan.explanation.whynot.soft_constraints import named_facts, robot_entries
from tsplan.explanation.whynot.subject import Subject
from tsplan.mission import Mission
from tsplan.run.planner import plan

if TYPE_CHECKING:
    from tsplan.explanation.explanation import Fact, SoftConstraint
    from tsplan.explanation.part_words import Wording
    from tsplan.explanation.whynot.mission_numbers import Edit, Number
    from tsplan.explanation.whynot.subject import Constraints, Question
    from tsplan.plans.plan import Plan
    from tsplan.run.problem import Problem


@dataclass(frozen=True, eq=False)
class Teams(Subject[Mission]):
    """A mission of a team, of swarms, or of both."""

    orders: ClassVar = (ORDER, tuple(kind for kind in ORDER if kind != "add_agents"))

    @cached_property
    def context(self) -> Context:
        """The mission as the finders of facts see it."""
        return Context(self.mission, self.pause)

    @property
    def restrained(self) -> bool:
        """Whether more agents can be in the way of limits or capacities."""
        return bounded_above(self.mission)

    @property
    def bounds(self) -> tuple[SoftConstraint, ...]:
        """Entries of the team, waits, bounds of swarms and capacities."""
        return named_facts(self.mission)

    @property
    def wording(self) -> Wording:
        """Words and places for what can be taken out."""
        return self.context.wording

    def plain(self) -> Mission:
        """The mission that asks for no more than that its formula holds, as a whole."""
        return any_plan(self.mission)

    def without(self, gone: Iterable[SoftConstraint]) -> Mission | Problem:
        """The plain mission without some of its constraints."""
        return relaxed(self.mission, gone)

    def planned(
        self, question: Mission | Problem, time_limit: float | None, solver: str | None
    ) -> Plan:
        """What the planner finds in some seconds."""
        return plan(question, time_limit=time_limit, solver=solver)

    def facts(self) -> Iterator[Fact]:
        """Arithmetic on who is needed where, and on who can be there when."""
        return facts_of(self.context)

    def measured(self, ask: Callable[[Question], Any]) -> Iterator[Fact]:
        """How much of the resources that tasks need can be there in time at best."""
        return undeliverable(self.context, ask)

    def candidates(self, conflict: Constraints) -> list[Edit]:
        """Everything that can be tried against one conflict; of entries, those of the mission."""
        entries = robot_entries(self.mission)  # others were added by changes
        known = (c for c in conflict if c.kind not in ("team", "start") or c.key[0] in entries)
        return candidates(self.context, frozenset(known))

    def touched(self, number: Number) -> Constraints:
        """What an edit of a number weakens at most; nothing where that cannot be said."""
        return touched(self.mission, number)

    def rank(self, number: Number) -> int:
        """More agents of one entry are tried where it starts first."""
        return rank(self.mission, number)
