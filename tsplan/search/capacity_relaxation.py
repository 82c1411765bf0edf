"""Capacities where they matter only: plan without them, then around each other.

Without capacities maps are reduced to a few places, and what is proven there is a bound for every
plan. Most narrow places can then be passed one after the other at no cost: `tsplan.routing` looks
for such ways, and where it finds some that are worth what the bound says, they are the best plan.
Otherwise the places that stay too full are held to their capacities, and the mission is planned
again. In the end the whole model decides what is still open.

Source of the idea, that conflicts are few and are looked at when they come up: G. Sharon, R. Stern,
A. Felner, N. Sturtevant, "Conflict-based search for optimal multi-agent pathfinding", Artificial
Intelligence 219, 2015. Here a relaxation of all agents is tightened instead of a tree over single
agents.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from tsplan.clock import Clock, Halted
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.enforced_capacities import Enforced
from tsplan.encode.model_objectives import Availability, Makespan, MovingAgents
from tsplan.encode.objective_kinds import StageObjective
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.encode.switches import Switch
from tsplan.logic import Execution, walk
from tsplan.routing.appointments import agenda_of
from tsplan.routing.crowd import Room
from tsplan.routing.duties import Sharing
from tsplan.routing.rerouting import CHEAP, CLEAR, Rerouting
from tsplan.routing.walks import Walk, point_of, walks_of
from tsplan.search.appointed_plans import AppointedPlans
from tsplan.search.best_plan import BestPlan
from tsplan.search.effort import Effort
from tsplan.search.learnt_bounds import LearntBounds
from tsplan.search.lexicographic import Outcome, Tell
from tsplan.search.question import NOTHING_KEPT, Kept
from tsplan.search.stages import Stages
from tsplan.stopping import StoppedBy

SMALL = 20_000
"""Flow columns up to which the whole model is searched at once."""

LARGE = 1_000_000
"""Flow columns from which on, with a time limit, plans are improved instead at the end."""

_SHARE = 0.5  # of the time that is left, for planning with some capacities
_PATIENCE = 30, 200  # attempts in a row that may fail: at no cost, and at any
_ROUTING = 0.25  # of the time so far that finding ways for points on the way may take
_AGAIN = 2.0  # times what it took to find points without ways, for the rest of that round
_LEAST, _TAKING = 1.0, 0.5  # seconds, or of the time so far, that finding ways once may take


def relaxable(setting: Setting) -> bool:
    """Whether capacities can be left out first, and single agents be led around each other.

    Not where groups move together, structures are rebuilt, things are carried, tasks book agents or
    these may be late, where places are closed for a time, nor with constraints of the user's own.
    Small models need no help.
    """
    booked = any(isinstance(node, Execution) for node in walk(setting.goal))
    mission = setting.mission
    plain = setting.formula_alone and not (booked or mission.intended)
    plain = plain and "delay" not in mission.objective
    limited = bool(setting.arrays.capacity or setting.arrays.group_capacity)
    on = Switch.CAPACITIES in setting.switches and not mission.system.timed
    return on and plain and limited and _columns(setting) > SMALL


def _columns(setting: Setting) -> int:
    """About how many flow columns the whole model has."""
    return setting.horizon * sum(len(item.graph.tail) for item in setting.classes)


@dataclass(eq=False)
class CapacityRelaxation:
    """Runs the objectives of a problem whose map has capacities; `setting` has all of them.

    `start` is a plan that is known.
    """

    setting: Setting
    objectives: tuple[StageObjective, ...]
    effort: Effort
    clock: Clock
    tell: Tell[Point]
    start: Point | None = None
    _known: BestPlan = field(init=False)
    _free: LearntBounds = field(init=False)  # of plans that keep no capacities
    _appointed: AppointedPlans | None = field(default=None, init=False)
    _bounded: bool = field(default=False, init=False)
    _routes: tuple[Rerouting, int] | None = field(default=None, init=False)
    _routing: float = field(default=0.0, init=False)
    _round: int = field(default=0, init=False)
    _last: Outcome[Point] = field(default=Outcome(), init=False)

    def __post_init__(self) -> None:
        """Nothing is known at first."""
        gap, certified = self.effort.choice.gap, self.effort.certified
        self._known = BestPlan(self.setting, self.objectives, gap, self.tell, certified)
        self._free = LearntBounds(self.objectives, certified)

    def run(self) -> Outcome[Point]:
        """All objectives until they are settled or the time is up."""
        if self.start is not None:
            self._known.take(self.start)
        try:
            if self.setting.untimed and not self.effort.certified:  # their bounds are not
                self._by_appointments()
            if not self._done:
                outcome = self._by_rounds()
                if outcome is not None:
                    return outcome
            if not self._done:
                self._finish()
        except Halted as halted:
            self._last = replace(self._last, stopped_by=halted.reason)
        return self._outcome()

    @property
    def _done(self) -> bool:
        return self._known.settled or self.clock.over

    @property
    def _vast(self) -> bool:
        """Whether the whole model cannot be hoped to be of use in the time that there is."""
        return _columns(self.setting) > LARGE and self.clock.left is not None

    def _by_appointments(self) -> None:
        """Plans and a bound by tours and routes, where the goal is of that kind."""
        agenda = agenda_of(self.setting)
        if agenda is None:
            return
        seed = self.effort.choice.seed or 0
        self._appointed = AppointedPlans(self.setting, agenda, self._known, self.effort, seed)
        left = self.clock.left
        clock = self.clock if left is None else self.clock.within(_SHARE * left)
        self._appointed.search(clock)
        if self._vast and self._appointed.bounding:  # what is planned for all is far from a bound
            self._appointed.search(self.clock, patient=True)

    def _by_rounds(self) -> Outcome[Point] | None:
        """Plan with more and more capacities; the outcome where there is no plan even so."""
        held = Enforced()
        while True:
            outcome = self._last = self._relaxed(held)
            if outcome.infeasible and self._known.point is None:
                return outcome
            self._learn(outcome)
            if not held.any:
                self._free.add(outcome.reached)
                self._bounded = outcome.proven
            if outcome.point is None or self._known.settled:
                return None
            more = self._routed(outcome.point, held)
            if self._done or not held < more:
                return None
            held = replace(more, slack=self._slack)

    # --- planning --------------------------------------------------------------------------------

    def _relaxed(self, held: Enforced, *, again: bool = False) -> Outcome[Point]:
        """The outcome of planning where some capacities are held alone.

        Unless it is asked `again` for a bound, it ends soon after points for which there were no
        ways: other capacities matter more then than the best of such points.
        """
        self._round += 1
        left, began = self.clock.left, self.clock.elapsed
        clock = self.clock if left is None else self.clock.within(_SHARE * left)
        futile = np.inf  # seconds after which there were points, and no ways for them

        def enough() -> bool:
            return self.clock.stop() or self.clock.elapsed - began > max(_AGAIN * futile, _LEAST)

        if not again:
            clock = replace(clock, stop=enough)
        setting = prepare(
            self.setting.mission, (), self.setting.switches, clock=clock, enforced=held
        )

        def hear(
            stage: str, point: Point | None, _value: float | None, bound: float | None
        ) -> None:
            nonlocal futile
            if point is not None and self._may_route:
                self._routed(point, held)
                spent = self.clock.elapsed - began
                futile = min(futile, spent) if self._known.point is None else np.inf
            self._known.hear(stage, bound)
            if not held.any and self.objectives and stage == self.objectives[0].name:
                self._free.hear(bound, self._known.value(stage))

        return self._stages(setting, clock, hear, self._known.cutoff).run()

    def _learn(self, outcome: Outcome[Point]) -> None:
        """Take in what a relaxation proves."""
        known = self._known
        if outcome.infeasible and known.values:  # there is no better plan than the one known
            known.learnt.hear(known.values[0], known.values[0])
        known.learnt.add(outcome.reached)

    def _stages(
        self, setting: Setting, clock: Clock, tell: Tell[Point], kept: Kept = NOTHING_KEPT
    ) -> Stages:
        return Stages(setting, self.objectives, self.effort, clock, tell, kept=kept)

    @property
    def _slack(self) -> float:
        """How many steps of detours better plans can make, beyond the first relaxation's bound.

        Without a detour between two places that matter to the formula a plan travels less by that,
        and without capacities it stays one. So whoever makes longer detours makes no better plan.
        """
        (first,) = self.objectives if len(self.objectives) == 1 else (None,)
        bound = next((item.bound for item in self._free.of(self._known.values)), None)
        if not isinstance(first, Travel) or self._known.point is None or bound is None:
            return np.inf
        return first.worth(self.setting, self._known.point) - 1 - bound

    def _finish(self) -> None:
        """Let the whole model decide, or make the best of the time where it is far too large."""
        if self._known.point is not None and not self._bounded:
            self._learn(self._relaxed(Enforced(), again=True))
        if self._done:
            return
        if not self._vast or self._routes is None:
            self._whole()
            return
        routes, level = self._routes
        while not self._known.settled and routes.improve(self.clock, _PATIENCE[1]):
            self._known.take(point_of(self.setting, routes.walks, level))

    def _whole(self) -> None:
        """Plan with all capacities in the model."""

        def hear(stage: str, point: Point | None, value: float | None, bound: float | None) -> None:
            if point is not None:
                self._known.take(point)
            elif self._known.point is None or bound is not None:
                self.tell(stage, None, value, bound)

        outcome = self._stages(self.setting, self.clock, hear).run()
        self._last = outcome
        self._known.learnt.add(outcome.reached)
        if outcome.point is not None:
            self._known.take(outcome.point)

    # --- ways ------------------------------------------------------------------------------------

    @property
    def _may_route(self) -> bool:
        """Whether ways may be looked for while a relaxation is still being planned."""
        return self._known.point is None or self._routing < _ROUTING * self.clock.elapsed

    def _routed(self, point: Point, held: Enforced) -> Enforced:
        """Look for ways with room for everybody; what is to be held where there is none."""
        began = self.clock.elapsed
        routes = self._rerouting(point)
        before = routes.crowd.overfull()
        cheap, any_ = _PATIENCE
        clock = self.clock.within(max(_LEAST, _TAKING * began))
        fits = routes.repair(CHEAP, clock, cheap)
        crowded = routes.crowd.overfull()
        if not fits:
            least = routes.price
            routes = replace(routes, last=None, still=frozenset())
            clock = self.clock.within(max(_LEAST, _TAKING * began))
            if routes.repair(CLEAR, clock, any_):
                routes.improve(clock, cheap, least)
        if not routes.crowd.excess:
            level = point.encoded.level
            if self._known.take(point_of(self.setting, routes.walks, level)):
                self._routes = routes, level
        self._routing += self.clock.elapsed - began
        more = held.also(*crowded)
        return more if held < more else held.also(*before)

    def _rerouting(self, point: Point) -> Rerouting:
        """The ways of a point, to be changed where there is no room."""
        setting, walks = self.setting, walks_of(point)
        level = point.encoded.level
        if any(isinstance(objective, Availability) for objective in self.objectives):
            worth = Availability().worth(setting, point)
            level = int(worth) if np.isfinite(worth) else 0  # infinite where nothing is asked for
        sharing = Sharing(setting, walks, level)
        sharing.share(point)
        makespan = any(isinstance(objective, Makespan) for objective in self.objectives)
        last = int(Makespan().worth(setting, point)) if makespan else None
        few = any(isinstance(objective, MovingAgents) for objective in self.objectives)
        return Rerouting(
            setting,
            walks,
            sharing.duties,
            self._known.prices(),
            Room.of(setting, sharing.quotas),
            last=last,
            still=frozenset(n for n, walk in enumerate(walks) if few and not _moves(setting, walk)),
            seed=self._round + (self.effort.choice.seed or 0),
        )

    # --- what is known ---------------------------------------------------------------------------

    def _outcome(self) -> Outcome[Point]:
        stopped = self.clock.stopped_by or self._last.stopped_by or StoppedBy.PRECISION
        known = self._known
        if known.point is None:
            return replace(self._last, point=None, reached=(), proven=False, stopped_by=stopped)
        if known.near:
            stopped = StoppedBy.GAP
        return replace(
            self._last,
            point=known.point,
            reached=known.learnt.of(known.values),
            proven=known.proven,
            infeasible=False,
            stopped_by=None if known.proven else stopped,
        )


def _moves(setting: Setting, walk: Walk) -> bool:
    """Whether an agent ever goes anywhere."""
    return bool(setting.classes[walk.number].graph.travel[walk.edges].any())
