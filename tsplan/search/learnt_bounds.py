"""What relaxations of a problem have proven, and what that says of a plan of the problem itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from math import isfinite

from tsplan.encode.objective_kinds import StageObjective
from tsplan.plans.outcomes import CERTIFIED, ObjectiveValue


@dataclass(eq=False)
class LearntBounds:
    """Bounds on objectives that are settled in order, from several relaxations."""

    objectives: Sequence[StageObjective]
    certified: bool = False  # whether all that is heard is
    first: float | None = field(default=None, init=False)
    _reached: list[tuple[ObjectiveValue, ...]] = field(default_factory=list, init=False)

    def add(self, reached: tuple[ObjectiveValue, ...]) -> None:
        """Take in what one relaxation reached and proved."""
        self._reached.append(reached)

    def hear(self, bound: float | None, value: float | None) -> None:
        """Take in a bound on the first objective, which holds for every plan.

        Where only plans better than a known `value` were looked for, it says no more than that one.
        """
        if bound is None or not isfinite(bound):
            return
        sign = self._sign(self.objectives[0])
        bounds = [sign * each for each in (bound, self.first) if each is not None]
        best = min(bounds) if value is None else max(min(bounds), sign * value)
        self.first = sign * best

    def of(self, values: Sequence[float | None]) -> tuple[ObjectiveValue, ...]:
        """The values of a plan, and the best bounds on what any plan could be worth.

        What is proven of an objective, for plans that lose nothing of what was reached in the ones
        before, holds for plans that lose nothing of the given values if these are as good.
        """
        found = []
        trusted = list(self._reached)
        for place, (objective, value) in enumerate(zip(self.objectives, values, strict=True)):
            sign = self._sign(objective)
            trusted = [reached for reached in trusted if place < len(reached)]
            told = [reached[place].bound for reached in trusted]
            told += [self.first] if place == 0 else []
            bounds = [sign * bound for bound in told if bound is not None]
            bound = sign * min(bounds) if bounds else None
            vouching = [reached[place] for reached in trusted if reached[place].bound == bound]
            if value is not None and bound is not None:
                bound = objective.matched(value, bound)
            found.append(self._vouched(ObjectiveValue(objective.name, value, bound), vouching))
            trusted = [item for item in trusted if _as_good(value, item[place].value, sign)]
        return tuple(found)

    def _vouched(self, item: ObjectiveValue, vouching: Sequence[ObjectiveValue]) -> ObjectiveValue:
        """An objective's bound with who vouches for it."""
        sure = [other for other in vouching if other.proof == CERTIFIED]
        if item.bound is None or not (sure or self.certified):
            return item
        rests = {*(sure[0].rests if sure else ()), "capacities left out"}
        return replace(item, proof=CERTIFIED, rests=tuple(sorted(rests)))

    def _sign(self, objective: StageObjective) -> float:
        return 1.0 if objective.rises else -1.0


def _as_good(value: float | None, other: float | None, sign: float) -> bool:
    """Whether a value is as good as another; both are known."""
    return value is not None and other is not None and sign * value >= sign * other
