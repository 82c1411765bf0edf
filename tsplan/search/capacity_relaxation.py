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
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.enforced_capacities import Enforced
from tsplan.encode.model_objectives import Availability, Makespan, MovingAgents
from tsplan.encode.objective_kinds import StageObjective
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Priced, Travel
from tsplan.encode.switches import Switch
from tsplan.exact import relative_gap
from tsplan.logic import Execution, walk
from tsplan.milp.model import Floats
from tsplan.routing.crowd import Room
from tsplan.routing.duties import Sharing
from tsplan.routing.rerouting import CHEAP, CLEAR, Rerouting
from tsplan.routing.walks import Walk, point_of, walks_of
from tsplan.search.effort import Effort
from tsplan.search.learnt_bounds import LearntBounds
from tsplan.search.lexicographic import Outcome, Tell
from tsplan.search.question import FIRST_PLAN, NOTHING_KEPT, Kept
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
_LESSER = 1e-4  # what later objectives weigh in the price of an edge


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
    on = Switch.CAPACITIES in setting.switches and not setting.mission.system.timed
    return on and plain and limited and _columns(setting) > SMALL


def _columns(setting: Setting) -> int:
    """About how many flow columns the whole model has."""
    return setting.horizon * sum(len(item.graph.tail) for item in setting.classes)


@dataclass(eq=False)
class CapacityRelaxation:
    """Runs the objectives of a problem whose map has capacities; `setting` has all of them.

    `known` is a plan that is known.
    """

    setting: Setting
    objectives: tuple[StageObjective, ...]
    effort: Effort
    clock: Clock
    tell: Tell[Point]
    known: Point | None = None
    _best: Point | None = field(default=None, init=False)
    _learnt: LearntBounds = field(init=False)
    _bounded: bool = field(default=False, init=False)
    _loosest: float | None = field(default=None, init=False)
    _routes: tuple[Rerouting, int] | None = field(default=None, init=False)
    _routing: float = field(default=0.0, init=False)
    _round: int = field(default=0, init=False)
    _last: Outcome[Point] = field(default=Outcome(), init=False)

    def __post_init__(self) -> None:
        """Nothing is known at first."""
        self._learnt = LearntBounds(self.objectives, self.effort.certified)

    def run(self) -> Outcome[Point]:
        """All objectives until they are settled or the time is up."""
        held = Enforced()
        if self.known is not None:
            self._take(self.known)
        try:
            while True:
                outcome = self._last = self._relaxed(held)
                if outcome.infeasible and self._best is None:
                    return outcome
                self._learn(outcome)
                if not held.any:
                    self._bounded = outcome.proven
                    self._loosest = next((o.bound for o in self._learnt.of(self._values)), None)
                if outcome.point is None or self._settled:
                    break
                more = self._routed(outcome.point, held)
                if self._settled or self.clock.over or not held < more:
                    break
                held = replace(more, slack=self._slack)
            if not self._settled and not self.clock.over:
                self._finish()
        except Halted as halted:
            self._last = replace(self._last, stopped_by=halted.reason)
        return self._outcome()

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
                futile = min(futile, spent) if self._best is None else np.inf
            value = self._value(stage)
            if self.objectives and stage == self.objectives[0].name:
                self._learnt.hear(bound, value)
                self.tell(stage, None, value, self._learnt.first)
            else:
                self.tell(stage, None, value, None)

        return self._stages(setting, clock, hear, self._cutoff).run()

    def _learn(self, outcome: Outcome[Point]) -> None:
        """Take in what a relaxation proves."""
        if outcome.infeasible and self._values:  # there is no better plan than the one known
            value = self._values[0]
            self._learnt.hear(value, value)
        self._learnt.add(outcome.reached)

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
        bound = self._loosest
        if not isinstance(first, Travel) or self._best is None or bound is None:
            return np.inf
        return first.worth(self.setting, self._best) - 1 - bound

    @property
    def _cutoff(self) -> Kept:
        """What plans have to be better than, where that is all that matters of them."""
        if self._best is None or len(self.objectives) != 1:
            return NOTHING_KEPT
        (objective,) = self.objectives
        if not isinstance(objective, Priced):
            return NOTHING_KEPT
        target = objective.target(self.setting, self._best.encoded)
        value = objective.minimised(self.setting, self._best)
        return Kept(((objective, value - target.step),)) if target.step else NOTHING_KEPT

    def _finish(self) -> None:
        """Let the whole model decide, or make the best of the time where it is far too large."""
        if self._best is not None and not self._bounded:
            self._learn(self._relaxed(Enforced(), again=True))
        if self._settled or self.clock.over:
            return
        if _columns(self.setting) <= LARGE or self.clock.left is None or self._routes is None:
            self._whole()
            return
        routes, level = self._routes
        while not self._settled and routes.improve(self.clock, _PATIENCE[1]):
            self._take(point_of(self.setting, routes.walks, level))

    def _whole(self) -> None:
        """Plan with all capacities in the model."""

        def hear(stage: str, point: Point | None, value: float | None, bound: float | None) -> None:
            if point is not None:
                self._take(point)
            elif self._best is None or bound is not None:
                self.tell(stage, None, value, bound)

        outcome = self._stages(self.setting, self.clock, hear).run()
        self._last = outcome
        self._learnt.add(outcome.reached)
        if outcome.point is not None:
            self._take(outcome.point)

    # --- ways ------------------------------------------------------------------------------------

    @property
    def _may_route(self) -> bool:
        """Whether ways may be looked for while a relaxation is still being planned."""
        return self._best is None or self._routing < _ROUTING * self.clock.elapsed

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
            if self._take(point_of(self.setting, routes.walks, level)):
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
            [self._prices(item.graph) for item in setting.classes],
            Room.of(setting, sharing.quotas),
            last=last,
            still=frozenset(n for n, walk in enumerate(walks) if few and not _moves(setting, walk)),
            seed=self._round + (self.effort.choice.seed or 0),
        )

    def _prices(self, graph: ClassGraph) -> Floats:
        """What every edge of a class costs in the objectives, the first of them above all."""
        priced = [each for each in self.objectives if isinstance(each, Priced)]
        parts = [each.price(graph) for each in priced or [Travel()]]
        return np.asarray(sum(part * _LESSER**place for place, part in enumerate(parts)))

    # --- what is known ---------------------------------------------------------------------------

    def _take(self, point: Point) -> bool:
        """Keep a plan that is better than the one known, and tell of it."""
        if self._best is not None and not self._better(point, self._best):
            return False
        self._best = point
        first = self.objectives[0].name if self.objectives else FIRST_PLAN
        reached = self._learnt.of(self._values)
        self.tell(first, point, self._value(first), reached[0].bound if reached else None)
        return True

    def _better(self, point: Point, other: Point) -> bool:
        """Whether a plan is better in the first objective that tells two plans apart."""
        for objective in self.objectives:
            new, old = (objective.worth(self.setting, each) for each in (point, other))
            if new != old:
                return (new > old) is objective.rises
        return False

    def _value(self, stage: str) -> float | None:
        """What the best plan is worth in an objective."""
        if self._best is None:
            return None
        named = (each for each in self.objectives if each.name == stage)
        return next((each.worth(self.setting, self._best) for each in named), None)

    @property
    def _values(self) -> list[float | None]:
        """What the best plan is worth in every objective."""
        return [self._value(each.name) for each in self.objectives]

    @property
    def _settled(self) -> bool:
        """Whether nothing is left to be found: all is proven, or as near as was asked for."""
        return self._best is not None and (self._proven or self._near)

    @property
    def _proven(self) -> bool:
        return self._best is not None and all(item.proven for item in self._learnt.of(self._values))

    @property
    def _near(self) -> bool:
        """Whether the gap that was asked for is reached, in the first objective that is open."""
        wanted = self.effort.choice.gap
        open_ = next((item for item in self._learnt.of(self._values) if not item.proven), None)
        if not wanted or open_ is None or open_.value is None or open_.bound is None:
            return False
        gap = relative_gap(open_.value, open_.bound)
        return gap is not None and gap <= wanted

    def _outcome(self) -> Outcome[Point]:
        stopped = self.clock.stopped_by or self._last.stopped_by or StoppedBy.PRECISION
        if self._best is None:
            return replace(self._last, point=None, reached=(), proven=False, stopped_by=stopped)
        if self._near:
            stopped = StoppedBy.GAP
        return replace(
            self._last,
            point=self._best,
            reached=self._learnt.of(self._values),
            proven=self._proven,
            infeasible=False,
            stopped_by=None if self._proven else stopped,
        )


def _moves(setting: Setting, walk: Walk) -> bool:
    """Whether an agent ever goes anywhere."""
    return bool(setting.classes[walk.number].graph.travel[walk.edges].any())
