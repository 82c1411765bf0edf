"""The best plan that is known of a problem, and what has been proven of all plans."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from tsplan.encode.encoded import Point, Setting
from tsplan.encode.objective_kinds import StageObjective
from tsplan.encode.priced_objectives import Priced, Travel
from tsplan.exact import relative_gap
from tsplan.milp.model import Floats
from tsplan.search.learnt_bounds import LearntBounds
from tsplan.search.lexicographic import Tell
from tsplan.search.question import FIRST_PLAN, NOTHING_KEPT, Kept

_LESSER = 1e-4  # what later objectives weigh in the price of an edge


@dataclass(eq=False)
class BestPlan:
    """What several searches of one problem know together; a relative `gap` may be enough."""

    setting: Setting
    objectives: Sequence[StageObjective]
    gap: float | None
    tell: Tell[Point]
    certified: bool = False  # whether all bounds that are heard are
    point: Point | None = field(default=None, init=False)
    learnt: LearntBounds = field(init=False)

    def __post_init__(self) -> None:
        """Nothing is known at first."""
        self.learnt = LearntBounds(self.objectives, self.certified)

    def take(self, point: Point) -> bool:
        """Keep a plan that is better than the one known, and tell of it."""
        if self.point is not None and not self._better(point, self.point):
            return False
        self.point = point
        first = self.objectives[0].name if self.objectives else FIRST_PLAN
        reached = self.learnt.of(self.values)
        self.tell(first, point, self.value(first), reached[0].bound if reached else None)
        return True

    def hear(self, stage: str, bound: float | None) -> None:
        """Take in a bound on the first objective, of plans that are better than the one known."""
        value = self.value(stage)
        if self.objectives and stage == self.objectives[0].name:
            self.learnt.hear(bound, value)
            self.tell(stage, None, value, self.learnt.first)
        else:
            self.tell(stage, None, value, None)

    def _better(self, point: Point, other: Point) -> bool:
        """Whether a plan is better in the first objective that tells two plans apart."""
        for objective in self.objectives:
            new, old = (objective.worth(self.setting, each) for each in (point, other))
            if new != old:
                return (new > old) is objective.rises
        return False

    def value(self, stage: str) -> float | None:
        """What the best plan is worth in an objective."""
        if self.point is None:
            return None
        named = (each for each in self.objectives if each.name == stage)
        return next((each.worth(self.setting, self.point) for each in named), None)

    @property
    def values(self) -> list[float | None]:
        """What the best plan is worth in every objective."""
        return [self.value(each.name) for each in self.objectives]

    @property
    def settled(self) -> bool:
        """Whether nothing is left to be found: all is proven, or as near as was asked for."""
        return self.point is not None and (self.proven or self.near)

    @property
    def proven(self) -> bool:
        """Whether no plan is better."""
        return self.point is not None and all(item.proven for item in self.learnt.of(self.values))

    @property
    def near(self) -> bool:
        """Whether the gap that was asked for is reached, in the first objective that is open."""
        open_ = next((item for item in self.learnt.of(self.values) if not item.proven), None)
        if not self.gap or open_ is None or open_.value is None or open_.bound is None:
            return False
        gap = relative_gap(open_.value, open_.bound)
        return gap is not None and gap <= self.gap

    @property
    def cutoff(self) -> Kept:
        """What plans have to be better than, where that is all that matters of them."""
        if self.point is None or len(self.objectives) != 1:
            return NOTHING_KEPT
        (objective,) = self.objectives
        if not isinstance(objective, Priced):
            return NOTHING_KEPT
        target = objective.target(self.setting, self.point.encoded)
        value = objective.minimised(self.setting, self.point)
        return Kept(((objective, value - target.step),)) if target.step else NOTHING_KEPT

    def prices(self) -> list[Floats]:
        """What every edge of each class costs in the objectives, the first of them above all."""
        priced = [each for each in self.objectives if isinstance(each, Priced)] or [Travel()]
        return [
            np.asarray(
                sum(each.price(item.graph) * _LESSER**place for place, each in enumerate(priced)),
                dtype=np.float64,
            )
            for item in self.setting.classes
        ]
