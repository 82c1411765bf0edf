"""Objectives of plans in which the parts that were chosen hold.

The parts are demanded, and other objectives are best among plans for these. Availability is told of
what holds, whichever parts that are, so it is bounded over all plans that reach what was settled:
once it is settled for the parts at hand, one more is asked of any. A plan that has it makes its
own parts the chosen ones, and all is begun anew.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from tsplan.checking.satisfaction_check import slack_of
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.model_objectives import Availability
from tsplan.encode.objective_kinds import StageObjective
from tsplan.encode.partial.partial_model import PartialModel
from tsplan.encode.read_back import counts_of
from tsplan.encode.switches import Switch
from tsplan.logic import conjunction
from tsplan.logic.evaluation import robustness
from tsplan.search.clique_cuts import with_clique_cuts
from tsplan.search.lexicographic import Found, Tell
from tsplan.search.question import Kept
from tsplan.search.search import Search
from tsplan.search.stages import Stages


@dataclass(eq=False)
class ChosenParts(Stages):
    """The objectives of plans for some parts; `better` is a plan in which other parts do better.

    `rivals` makes the model of all plans that reach what was settled, with so many agents to spare
    at what holds; None where that is not settled for sure, or nothing is said of it.
    """

    rivals: Callable[[int], PartialModel] | None = None
    better: Point | None = field(default=None, init=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.rivals is not None:
            self.tell = partial(_without_bounds, self.tell)

    def settled(self, objective: StageObjective, done: Found | None) -> float | None:
        """Settle one objective and keep what it reached; its bound."""
        if self.better is not None:  # all is begun anew
            return None
        before = self.kept
        bound = super().settled(objective, done)
        if self.rivals is None or not objective.built or bound is None or np.isinf(bound):
            return bound
        assert self.point is not None
        value = self.worth(objective, self.point)
        if spare(self.setting, self.point) > value:
            self.better = self.point
        elif bound == value and self._unrivalled(self.rivals, before, int(value) + 1):
            return bound
        return None

    def _unrivalled(self, rivals: Callable[[int], PartialModel], kept: Kept, level: int) -> bool:
        """Whether no plan has so many agents to spare; `better` is one that has."""
        with self.clock.timed("build"):
            model = rivals(level)
            encoded = kept.narrowed(self.setting, model.encoded)
        target = self._guide.target(self.setting, encoded)
        encoded = with_clique_cuts(encoded, target.vector, model.conflicts, self.clock)
        effort = replace(self.effort, switches=self.effort.switches - {Switch.CONTINUOUS})
        found = Search(encoded, target, effort, self.clock, lambda *_: None).minimise(first=True)
        if found.values is not None:
            columns = model.encoded.model.size.columns
            self.better = Point(model.encoded, found.values[:columns], tight=True)
        else:
            self.stopping(found.stopped_by)
        return found.values is None and found.proven


def _without_bounds(
    tell: Tell[Point], stage: str, point: Point | None, value: float | None, bound: float | None
) -> None:
    """Tell what is found, but of availability no bound that is one for the chosen parts only."""
    tell(stage, point, value, None if stage == Availability.name else bound)


def spare(setting: Setting, point: Point) -> float:
    """How many agents the plan of a point has to spare at all that holds in it."""
    mission = setting.mission
    trees = [mission.tree(wish.formula) for wish in mission.prefer]
    every = conjunction([mission.counted, mission.tree(mission.formula), *trees])
    trace = counts_of(setting, every, point)
    return slack_of(mission, trace, float(robustness(mission.counted, trace)[..., 0]))
