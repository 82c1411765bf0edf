"""Missions of teams and swarms, as the search for an explanation asks about them."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from tsplan.encode.switches import Switch
from tsplan.explanation.change_kinds import ORDER
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.edits import candidates, rank, touched
from tsplan.explanation.whynot.fact_finders import facts_of
from tsplan.explanation.whynot.fulfilment import broken_by
from tsplan.explanation.whynot.least_shortage import Shortage, least_shortage
from tsplan.explanation.whynot.posed_mission import problem_of
from tsplan.explanation.whynot.relaxing import any_plan, bounded_above, can_idle, needless, relaxed
from tsplan.explanation.whynot.shortages import undeliverable
from tsplan.explanation.whynot.soft_constraints import named_facts, robot_entries
from tsplan.explanation.whynot.subject import Subject
from tsplan.explanation.whynot.tight_needs import about, tightest
from tsplan.logic import Always, Eventually, walk
from tsplan.mission import Mission
from tsplan.run.planner import plan
from tsplan.run.problem import Problem
from tsplan.stopping import StoppedBy

if TYPE_CHECKING:
    from tsplan.explanation.explanation import Fact, Likely, SoftConstraint
    from tsplan.explanation.part_words import Wording
    from tsplan.explanation.whynot.mission_numbers import Edit, Number
    from tsplan.explanation.whynot.subject import Constraints, Question
    from tsplan.logic import Formula
    from tsplan.plans.plan import Plan
    from tsplan.run.events import Event

_UNCHAINED = 5.0  # seconds without a search for a first plan that proves nothing


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

    def broken_by(self, gone: Constraints, question: Mission | Problem, found: Plan) -> Constraints:
        """Those of some constraints that a plan without them breaks, or may break."""
        return broken_by(self.mission, self.groups, gone, question, found)

    def planned(
        self,
        question: Mission | Problem,
        time_limit: float | None,
        solver: str | None,
        enough: Callable[[Event], bool] | None = None,
    ) -> Plan:
        """What the planner finds in some seconds, or until something it tells is `enough`.

        Most questions have no plan, so that what looks for a first one by a restriction, and proves
        nothing, has to wait.
        """
        problem = question if isinstance(question, Problem) else problem_of(question)
        asked: Any = {"solver": solver, "on_event": enough, "certified": self.certified}
        if not _has_chains(problem.mission.goal):
            return plan(problem, time_limit=time_limit, **asked)
        without = problem.tuning.without | {Switch.CHAINS}
        plain = problem.tuned(replace(problem.tuning, without=without))
        long = time_limit is None or time_limit > _UNCHAINED
        first = _UNCHAINED if long else time_limit
        began = time.perf_counter()
        found = plan(plain, time_limit=first, **asked)
        if not long or found.stopped_by is not StoppedBy.TIME_LIMIT:
            return found
        left = None if time_limit is None else time_limit - (time.perf_counter() - began)
        if left is not None and left <= 0:
            return found
        return plan(problem, time_limit=left, **asked)

    def needless(self, gone: Constraints) -> Constraints:
        """Whose numbers and starts say nothing once some constraints are taken out."""
        return needless(self.mission, gone) if self._idle else frozenset()

    @cached_property
    def _idle(self) -> bool:
        return can_idle(self.mission)

    def facts(self) -> Iterator[Fact]:
        """Arithmetic on who is needed where, and on who can be there when."""
        return facts_of(self.context)

    def measured(self, ask: Callable[[Question], Any]) -> Iterator[Fact]:
        """How much of the resources that tasks need can be there in time at best."""
        return undeliverable(self.context, ask)

    def suspected(self) -> Iterator[Likely]:
        """The needs that leave least to spare, in numbers or in time."""
        yield from tightest(self.context)

    def guesses(self, steps: Iterable[tuple[Edit, int]]) -> Iterator[Constraints]:
        """All that asks for one capability that more agents would have; then for any of them.

        Without such agents, a few parts of the formula: several first without where anybody starts,
        which is no part of most conflicts. If they are refuted so, that need not be proven again.
        """
        entries = {edit.number.key[0] for edit, _ in steps if edit.number.kind == "agents"}
        able = sorted({name for n in entries for name in self.mission.team[n].capabilities})
        for names in [{name} for name in able] + ([set(able)] if len(able) > 1 else []):
            yield about(self.mission, self.groups, names) | frozenset(self.bounds)
        few = [] if able else list(super().guesses(steps))
        several = [g for g in few if sum(not g.isdisjoint(group) for group in self.groups) > 1]
        yield from (guess for guess in few if guess not in several)
        starts = {fact for fact in self.bounds if fact.kind == "start"}
        yield from (guess.difference(starts) for guess in several)
        yield from several

    def shortage(self, edits: Sequence[Edit]) -> Shortage | None:
        """By how few agents more, or fewer needed, some edits may do together."""
        return least_shortage(self.mission, edits)

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


def _has_chains(goal: Formula) -> bool:
    """Whether something is to happen again and again, so that first plans are looked for apart."""
    return any(
        isinstance(below, Eventually)
        for node in walk(goal)
        if isinstance(node, Always)
        for below in walk(node)
    )
