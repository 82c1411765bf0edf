"""The stages of planning teams and swarms: how each objective is settled.

Objectives that are linear in the columns are minimised as they stand. Those by levels are found by
bisection between the best plan known and a free bound; each question is whether any plan reaches a
level. The moves of every point are what its values are told by.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from tsplan.clock import Clock, Halted
from tsplan.encode.assemble import reference, tight
from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.model_objectives import Availability, Delay, ExpectedTravel, Splits
from tsplan.encode.objective_kinds import LevelObjective, StageObjective, TargetObjective
from tsplan.encode.planned_ways import Planned, planned_flows
from tsplan.encode.preparation import delayed
from tsplan.encode.priced_objectives import Travel
from tsplan.encode.switches import Switch
from tsplan.milp.model import Floats
from tsplan.milp.target import CLOSED
from tsplan.search.chained_witnesses import chain_model, first_flows
from tsplan.search.effort import Effort
from tsplan.search.group_search import GroupSearch
from tsplan.search.lexicographic import Found, Lexicographic, Tell
from tsplan.search.question import NOTHING_KEPT, Kept, Question, start_in
from tsplan.search.routes.route_plans import RoutePlans
from tsplan.search.search import Search
from tsplan.search.search_proof import COUNTING
from tsplan.search.still_bound import still_bound
from tsplan.search.straight_plans import StraightPlans
from tsplan.search.sub_teams import SubTeams
from tsplan.search.tidying import tidied

_CHAIN_SECONDS = 15.0
LARGE = 30_000
"""Nonzeros from which on missions with resources are first planned by straight ways."""
WIDE = 100_000
"""Nonzeros from which on goals of many parts are first planned by teams."""
_SHARE = 0.2  # of the time that is left, for one level of a large mission
_HOPE_SECONDS = 5.0  # for a plan of the best availability that single demands allow


@dataclass(eq=False)
class Stages(Lexicographic[Point, StageObjective]):
    """Runs the objectives of a problem in order.

    `known` are the flows of a plan that is known, and `planned` the ways of one that may be.

    Plans that lose something of what is `kept` from the beginning are not looked for.
    """

    setting: Setting
    objectives: tuple[StageObjective, ...]
    effort: Effort
    clock: Clock
    tell: Tell[Point]
    tight: bool = True
    known: Floats | None = None
    planned: Sequence[Planned] = ()
    kept: Kept = NOTHING_KEPT
    _made: Encoded | None = field(default=None, init=False)

    def __post_init__(self) -> None:
        super().__init__(self.clock)
        self._straight = StraightPlans(self.effort)
        self.setting = replace(self.setting, clock=self.clock)

    # --- stages --------------------------------------------------------------------------------

    @property
    def opening(self) -> TargetObjective | None:
        """The first objective, where a plan may be looked for by minimising it."""
        first = self.objectives[0] if self.objectives else None
        return first if isinstance(first, TargetObjective) and first.opens else None

    def opened(self, opening: StageObjective | None) -> Found:
        """Any plan; a first objective that may find one is minimised to its end at once."""
        if isinstance(opening, TargetObjective):
            return self._ask(Question(opening, self.kept, opening))
        return self._at_best() or self._ask(Question(self._guide, self.kept, None, first=True))

    def _at_best(self) -> Found | None:
        """A plan as available as can be hoped for, where there are resources and one is found soon.

        With more robots than are needed their room is no matter, so linear programs come to whole
        robots by themselves; with just enough of them they do not.
        """
        first = self.objectives[0] if self.objectives else None
        if not (self.setting.mission.resources and self.tight and isinstance(first, Availability)):
            return None
        ideal = first.ideal(self.setting)
        if not 0 < ideal < np.inf:
            return None
        kept = self.kept.and_also(first, ideal)
        if self._large(self._encoded(kept)):  # straight ways find a plan soon
            return None
        found = self._ask(Question(self._guide, kept, None, first=True, seconds=_HOPE_SECONDS))
        return None if found.values is None else found

    @property
    def _guide(self) -> TargetObjective:
        """What leads to a plan where any will do."""
        if self.setting.mission.expected is not None:
            return ExpectedTravel()
        return Travel() if self.setting.mission.swarm is None else Splits()

    def worth(self, objective: StageObjective, point: Point) -> float:
        """What the plan of a point is worth."""
        return objective.worth(self.setting, point)

    def told_bound(
        self, objective: StageObjective, value: float, bound: float | None
    ) -> float | None:
        """A bound that the value is not told apart from is the value."""
        return bound if bound is None else objective.matched(value, bound)

    def settled(self, objective: StageObjective, done: Found | None) -> float | None:
        """Settle one objective and keep what it reached; its bound."""
        if isinstance(objective, LevelObjective):
            ideal = objective.ideal(self.setting)
            if np.isinf(ideal):  # whatever the agents do
                return ideal
            self.backed(objective.name, _judged(ideal))
            if objective.by_levels(tight=self.tight):
                bound = self._by_levels(objective, ideal)
                self.setting = self._late(max(self.kept.built(Delay.name), self.setting.delay))
                return bound
        assert isinstance(objective, TargetObjective)
        found = done or self._ask(Question(objective, self.kept, objective))
        assert self.point is not None
        target = objective.target(self.setting, objective.extended(self.point.encoded))
        if not target.step:
            self.noted(f"{objective.name} is told apart to {CLOSED:.0e} of its size")
        value = objective.minimised(self.setting, self.point)
        self.kept = self.kept.and_also(objective, value)
        worth = objective.worth(self.setting, self.point)
        if np.isinf(worth) and (worth > 0) is objective.rises:
            return worth
        self.stopping(found.stopped_by)
        self.backed(objective.name, found)
        bound = value if found.proven else min(found.bound, value)
        return target.own(bound) if np.isfinite(bound) else None

    def _by_levels(self, objective: LevelObjective, bound: float) -> float:
        """Bisect between the value of the plan that is known and a bound."""
        assert self.point is not None
        value = objective.worth(self.setting, self.point)
        sign, ideal = 1 if objective.rises else -1, bound
        top = bound  # what is left open is not asked again
        while sign * (top - value) > 0 and not self.clock.over:
            probe = value + sign * ((abs(top - value) + 1) // 2)
            kept = self.kept.and_also(objective, probe)
            question = Question(self._guide, kept, objective, True, bound, self._patience)
            found = self.guarded(objective.name, partial(self._ask, question))
            if found is not None and found.values is not None:
                value = objective.worth(self.setting, self.point)
            elif found is not None and found.proven:
                bound = top = probe - sign
                self.backed(objective.name, found)
            else:
                self.stopping(found.stopped_by if found else None)
                top = probe - sign
            self.tell(objective.name, None, value, bound)
        self.kept = self.kept.and_also(objective, value if np.isfinite(value) else ideal)
        return sign * max(sign * bound, sign * value)

    @property
    def _reduced(self) -> frozenset[str]:
        """That maps were reduced, if they were."""
        maps = zip(self.setting.classes, self.setting.reduced, strict=True)
        some = any(item.graph is not short.graph for item, short in maps)
        return frozenset({"reduced maps"} if some else ())

    @property
    def _patience(self) -> float | None:
        """Seconds for one level of a large mission, whose whole program leaves none for others."""
        left, made = self.clock.left, self._made
        if left is None or made is None or not self._large(made):
            return None
        return _SHARE * left

    # --- questions -----------------------------------------------------------------------------

    def _ask(self, question: Question) -> Found:
        """The answer to one question: by the places of groups alone if these settle it."""
        self.tell(question.stage, None, None, None)
        encoded = self._encoded(question.kept)
        found = Found(None, None, -np.inf, proven=False)
        if encoded.occupied is not None:
            found = self._groups(encoded).answer(question)
            if found.values is not None or found.proven or self.clock.over:
                return replace(found, rests=found.rests | self._reduced)
        made = self._by_agents(question, encoded, found)
        return replace(made, rests=made.rests | found.rests | self._reduced)

    def _by_agents(self, question: Question, whole: Encoded, known: Found) -> Found:
        """Search the whole model, of which a bound is known."""
        with self.clock.timed("build"):
            narrow = question.kept.narrowed(self.setting, whole)
            encoded = question.objective.extended(narrow)
        target = question.objective.target(self.setting, encoded)
        columns = whole.model.size.columns

        def report(values: Floats | None, _value: float | None, bound: float | None) -> None:
            point = None if values is None else Point(whole, values[:columns], self.tight)
            self._hear(question, point, question.shown(target, bound))

        clock = self.clock if question.seconds is None else self.clock.within(question.seconds)
        effort = self._effort(whole)
        search = Search(encoded, target, effort, clock, report)
        search.know(known.bound, exact=known.certified)
        if (
            whole.shared
            and Switch.CHAINS in self.effort.switches
            and self.tight
            and not whole.swarms
        ):
            chained = partial(self._chained, question.kept, encoded)
            search.scout, search.rescue = (chained, None) if self.point is None else (None, chained)
        if self.known is not None and self.point is None:
            search.scout = lambda: self.known
        if self.planned and self.point is None:
            flows = planned_flows(encoded, self.planned, tight=self.tight)
            if flows is not None:
                search.adopt(flows)
        start = None if question.first else start_in(encoded, self.point)
        if self._large(whole):
            self._begin(search, question, encoded, clock)
        if self._many(whole) and search.scout is None:
            search.scout = lambda: SubTeams(self.effort).flows(whole, clock)
            routes = Switch.ROUTES in self.effort.switches and not self.effort.certified
            if routes and self.setting.untimed and not question.first:
                search.guide = RoutePlans(whole, target, self.effort, clock)
        found = search.minimise(start, first=question.first)
        if self.effort.record:
            question.note(self.effort.proofs, search.proof, places=False)
        return found

    def _begin(self, search: Search, question: Question, encoded: Encoded, clock: Clock) -> None:
        """Give a search of a large mission with resources plans and a bound to begin with."""
        for place, flows in enumerate(self._straight.flows(question, encoded, clock)):
            search.adopt(flows)
            certified = self.effort.certified
            if place == 0 and not (question.first or self.setting.changes or certified):
                target = question.objective.target(self.setting, encoded)
                search.know(still_bound(encoded, target, self.effort, clock))
            if search.done:
                break

    def _large(self, encoded: Encoded) -> bool:
        """Whether a plan is better looked for by straight ways first: of cargo or structures."""
        return (
            self.tight
            and Switch.STRAIGHT in self.effort.switches
            and bool(self.setting.mission.resources or self.setting.changes)
            and not encoded.setting.delay
            and not encoded.refuted
            and encoded.model.matrix.nnz > LARGE
        )

    def _many(self, encoded: Encoded) -> bool:
        """Whether a plan is better looked for by teams first: of a large model."""
        teams = self.tight and Switch.TEAMS in self.effort.switches and self.point is None
        return teams and not encoded.refuted and encoded.model.matrix.nnz > WIDE

    def _hear(self, question: Question, point: Point | None, bound: float | None) -> None:
        """Keep a point, and tell of it and of a bound in the own unit of what is told."""
        if point is not None:
            self.point = point
        value = None
        if self.point is not None and question.told is not None:
            value = question.told.worth(self.setting, self.point)
        if point is not None or bound is not None:
            self.tell(question.stage, point, value, bound)

    def _effort(self, encoded: Encoded) -> Effort:
        """How a whole model is searched.

        A tree on the witnesses leaves open where groups go and what is rebuilt: that is the
        solver's part, unless the tree is to do without.
        """
        switches = self.effort.switches if self.tight else frozenset()
        if self.effort.certified:
            return replace(self.effort, switches=switches | {Switch.TREE})
        if self.setting.mission.expected is not None:  # the others count whole agents
            switches &= set() if len(encoded.flows) else {Switch.DIVE, Switch.TREE}
        open_ = bool(encoded.swarms) or len(encoded.rebuilt) > 0
        return replace(self.effort, switches=switches - {Switch.TREE} if open_ else switches)

    def _groups(self, encoded: Encoded) -> GroupSearch:
        return GroupSearch(
            encoded.setting, encoded, self.effort, self.clock, self._hear, lambda: self.point
        )

    def finished(self, point: Point) -> Point:
        """The point with the shares of groups settled, in the model of all that was reached.

        Without swarms it is the point with what is carried in order.
        """
        if not point.encoded.swarms:
            return tidied(self.setting, point, self.effort, self.clock)
        whole = self._encoded(self.kept)
        if whole is not point.encoded:
            target = Travel().target(self.setting, whole)
            search = Search(whole, target, self.effort, self.clock, lambda *_: None)
            values = search.adopt(point.values[point.encoded.flows])
            if values is None:
                return point
            point = Point(whole, values, self.tight)
        return self._groups(whole).evened(point, self.kept)

    def _chained(self, kept: Kept, encoded: Encoded) -> Floats | None:
        """Flows of a plan found by way of the chained restriction, in a part of the time."""
        try:
            with self.clock.timed("build"):
                restricted = chain_model(encoded.setting, encoded.level)
        except Halted:  # the search hears of that by itself
            return None
        upper = restricted.model.upper.copy()
        upper[restricted.flows] = encoded.model.upper[encoded.flows]
        model = restricted.model.with_bounds(restricted.model.lower, upper)
        restricted = kept.narrowed(self.setting, replace(restricted, model=model))
        left = self.clock.left
        budget = _CHAIN_SECONDS if left is None else min(_CHAIN_SECONDS, left / 2)
        target = Travel().target(self.setting, restricted)
        return first_flows(restricted, target, self.effort, self.clock.within(budget))

    # --- models --------------------------------------------------------------------------------

    def _encoded(self, kept: Kept) -> Encoded:
        """The model of all plans at an availability and a delay; the last one is kept."""
        level = kept.built(Availability.name) if self.tight else 0
        delay = max(kept.built(Delay.name), self.setting.delay)
        made = self._made
        if made is None or (made.level, made.setting.delay) != (level, delay):
            made = self._made = None
            with self.clock.timed("build"):
                setting = self._late(delay)
                made = tight(setting, level) if self.tight else _reference(setting, level)
            size = made.model.size
            self.size = size.columns, size.integers, size.rows, size.nonzeros
            self._made = made
        return made

    def _late(self, delay: int) -> Setting:
        """The setting in which agents are so late."""
        return self.setting if delay == self.setting.delay else delayed(self.setting, delay)


def _judged(ideal: float) -> Found:
    """The bound that demands one by one allow for."""
    return Found(None, None, ideal, proven=False, certified=True, rests=frozenset({COUNTING}))


def _reference(setting: Setting, level: int) -> Encoded:
    most = max(Availability().ideal(setting), 0.0)
    return reference(setting, (level, level if np.isinf(most) else most))
