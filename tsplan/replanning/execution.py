"""Carrying out a plan step by step, and planning again where it does not work any more."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import TYPE_CHECKING, TypeAlias

from tsplan.checking.plan_check import certify, with_values
from tsplan.checking.replanned_check import left_over, whole
from tsplan.errors import SolverError
from tsplan.exact import digits
from tsplan.history.changed_formula import changed_formula
from tsplan.history.changed_map import Maps
from tsplan.history.joined_plan import ended_plan, joined_plan, unjudged
from tsplan.history.module_places import bodies_now
from tsplan.history.past_paths import Past, really, whereabouts
from tsplan.history.past_structures import Built
from tsplan.history.rest_mission import NobodyLeftError, accounted
from tsplan.name_runs import RunMap
from tsplan.plans.outcomes import Status
from tsplan.plans.worlds import OnEdge, World
from tsplan.replanning.catching_up import catching_up
from tsplan.replanning.orders import assembly, orders_at
from tsplan.replanning.replanner import Left, left, planned_again
from tsplan.replanning.robot_fleet import Assembly, Fleet, Order, Seen, difference

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan
    from tsplan.replanning.replanner import Planner

Keep = Callable[[Seen, "Plan | None"], object]
"""Hears what was seen at a step, and after that the plan from there on, if it is another one."""


@dataclass(frozen=True)
class Executed:
    """What came of carrying out a plan: the `plan` says where everybody was at every step.

    `availability` is that of the formula on what happened, `satisfaction` how much of it held if it
    may hold in part, and `preferences` how much of each formula that is preferred. `replanned` has
    the seconds that each time took at which the mission was planned again, and `stuck` says how
    often there was no plan.
    """

    plan: Plan
    availability: float
    satisfaction: Fraction | None = None
    preferences: tuple[Fraction, ...] = ()
    adapted: int = 0
    replanned: tuple[float, ...] = ()
    stuck: int = 0

    @property
    def met(self) -> bool:
        """Whether the formula held, as a whole."""
        return self.availability >= 0

    @property
    def verdict(self) -> str:
        """What held, in words."""
        if self.satisfaction is not None:
            return f"{digits(self.satisfaction)} of the formula held"
        held = "the formula held" if self.met else "the formula did not hold"
        return f"{held}, with availability {self.availability:g}"


@dataclass(eq=False)
class Execution:
    """Carries out a plan by a fleet; `planner`, if there is one, plans again where that is needed.

    What differs from the plan is taken in at once: everybody follows the plan as soon as it can,
    and where the check says that this still works nothing else is done, unless less would hold of
    what may hold in part and of what is preferred.
    """

    mission: Mission
    plan: Plan
    fleet: Fleet
    planner: Planner | None = None
    keep: Keep = field(default=lambda _seen, _plan: None)
    step: int = field(init=False)
    _adapted: int = field(default=0, init=False)
    _seconds: list[float] = field(default_factory=list, init=False)
    _stuck: int = field(default=0, init=False)
    _hopeless: bool = field(default=False, init=False)

    def __post_init__(self) -> None:
        """Begin where the plan was planned again last: what comes before has happened."""
        self.step = self.plan.replanned[-1].step if self.plan.replanned else 0

    def run(self) -> Executed:
        """Go on to the end."""
        self.fleet.begin(self.step, dict(self._places(self.step)), self._built())
        while self.step < self.plan.horizon:
            seen = self.fleet.advance(self.step, list(self.orders()))
            self.keep(seen, None)
            self.take(seen)
        self.fleet.end()
        return self.outcome()

    def take(self, seen: Seen) -> None:
        """Take in what is seen at the next step."""
        self.step = seen.step
        built = Built.of(self.plan, seen.step)
        parts = {name for each in built.under_way(seen.step) for name in each.parts}
        world = difference(seen.step, dict(self._places(seen.step)), seen, parts)
        if world is not None:
            self.plan = self._adjusted(world)
            self.keep(seen, self.plan)

    def outcome(self) -> Executed:
        """What came of it."""
        plan = self.plan if self.plan.verified else self._as_it_was()
        held = whole(self.mission, plan)
        return Executed(
            plan,
            held.availability,
            held.satisfaction,
            held.preferences,
            self._adapted,
            tuple(self._seconds),
            self._stuck,
        )

    def _as_it_was(self) -> Plan:
        """The plan with what was executed and carried of what it has, and what that is worth."""
        mission, plan = self.mission, self.plan
        end = plan.horizon + 1
        worlds = (*plan.replanned, World(end))
        past, amounts = accounted(mission, Past.of(mission, plan, end), worlds, mission.formula)
        stocks = amounts.stocks
        plan = replace(plan, executions=past.executions, cargo=past.cargo, stocks=stocks)
        if not plan.replanned:
            plan = with_values(mission, unjudged(plan))
        elif (left := left_over(mission, plan)).rest is not None:
            made = with_values(left.rest.mission, unjudged(left.plan))
            plan = joined_plan(left.rest, made, plan)
        else:
            return plan
        try:
            return certify(mission, plan)
        except SolverError:  # it has not met the formula
            return plan

    def orders(self) -> Iterator[Order]:
        """Who is to set out now, and for where, and what is to be rebuilt."""
        return orders_at(self.step, self.mission, self.plan)

    def _places(self, step: int) -> Iterator[tuple[str, str | OnEdge]]:
        """Where everybody who is not lost is by the plan: robots and structures."""
        worlds = (*self.plan.replanned, World(step))
        past = Past.of(self.mission, self.plan, step)
        maps = Maps(self.mission.system, worlds)
        for now in whereabouts(self.mission, past.agents, worlds, maps):
            yield from ((name, now.place) for name in now.names.names())
        for body in bodies_now(self.mission, past, worlds, maps, RunMap()):
            if body.id:
                yield body.id, body.place

    def _built(self) -> list[Assembly]:
        """The structures that there are, or that are being made."""
        built = Built.of(self.plan, self.step)
        return [assembly(each) for each in built.structures if each.last >= self.step]

    def _adjusted(self, world: World) -> Plan:
        """The plan from a world on: the one there is, if it works, else another one."""
        try:
            found = left(self.mission, self.plan, world)
        except NobodyLeftError:
            return self._ended(world)
        rest = found.rest
        followed = catching_up(rest, self.plan)
        self._adapted += 1
        try:
            kept = joined_plan(rest, certify(rest.mission, followed), self.plan)
        except SolverError:  # it does not work any more
            made = self._replanned(found)
            return joined_plan(rest, followed, self.plan) if made is None else made
        if _soft_worth(kept) >= _soft_worth(self.plan):
            return kept
        made = self._replanned(found)
        return kept if made is None or _soft_worth(made) <= _soft_worth(kept) else made

    def _ended(self, world: World) -> Plan:
        """The plan where nobody is left: what has happened."""
        mission, worlds = self.mission, (*self.plan.replanned, world)
        past = really(mission, self.plan, world, Maps(mission.system, worlds))
        past = past._replace(built=past.built.by(self.plan.horizon))
        past, _ = accounted(mission, past, worlds, changed_formula(mission, worlds))
        return ended_plan(self.plan, past, world)

    def _replanned(self, found: Left) -> Plan | None:
        """Another plan, if one is asked for and found.

        Where it was proven that there is none there will be none, unless something opens.
        """
        self._hopeless = self._hopeless and not found.rest.worlds[-1].opened
        if self.planner is None or self._hopeless:
            return None
        began = time.perf_counter()
        made = planned_again(self.mission, self.plan, found, planner=self.planner)
        self._seconds.append(time.perf_counter() - began)
        if made.has_paths:
            return made
        self._stuck += 1
        self._hopeless = made.status is Status.INFEASIBLE
        return None


_Worth: TypeAlias = "tuple[int | Fraction, ...]"


def _soft_worth(plan: Plan) -> tuple[_Worth, ...]:
    """What a plan is worth by what may hold in part and what is preferred, more is better."""
    found: list[_Worth] = []
    for name in (item.name for item in plan.objective):
        if name == "satisfaction" and plan.satisfaction is not None:
            depths = [item.value for item in plan.satisfaction.depths]
            while depths and not depths[-1]:  # deeper parts that there may or may not be
                depths.pop()
            found.append(tuple(depths) or (plan.satisfaction.worth or 0,))
        if name == "preferences":
            levels = sorted({wish.level for wish in plan.preferences}, reverse=True)
            worth = [sum(w.worth for w in plan.preferences if w.level == n) for n in levels]
            found.append(tuple(worth))
    return tuple(found)
