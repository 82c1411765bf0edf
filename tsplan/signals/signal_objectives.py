"""Objectives over signals in a model, and what a point of it is worth in them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import lcm

import numpy as np

from tsplan.checking.satisfaction_check import least_spare
from tsplan.encode.expressions import Expression
from tsplan.logic.evaluation import robustness
from tsplan.logic.traces import SignalTrace
from tsplan.logic.witness_steps import levels
from tsplan.milp.model import Floats
from tsplan.milp.target import Target
from tsplan.signals.aims import SENSES, Aim
from tsplan.signals.linear_system import System
from tsplan.signals.signal_model import SignalModel
from tsplan.signals.signal_setting import SignalSetting

_UNIT = Fraction(1)
_CLOSE = 1e-6  # relative distance at which values of one sum count as equal: solvers' tolerance


@dataclass(frozen=True, eq=False)
class SignalPoint:
    """A point of a model over signals."""

    made: SignalModel
    values: Floats

    @classmethod
    def of(cls, rows: Floats) -> SignalPoint:
        """A point with these values of every signal and control, of no model."""
        return cls(SignalModel.given(rows), rows.ravel())

    @cached_property
    def rows(self) -> Floats:
        """Every signal and control (names, T+1), controls held after the last step."""
        return self.values[self.made.columns]

    def trace(self, system: System) -> SignalTrace:
        """What the formula is judged on."""
        return SignalTrace(dict(zip(system.names, self.rows, strict=True)))


def efforts_of(aims: tuple[Aim, ...], system: System) -> tuple[tuple[tuple[str, float], ...], ...]:
    """The sums of absolute values that some aims weigh, each once."""
    named = {effort_of(aim, name, system): None for aim in aims for name, _ in aim.weights}
    return tuple(effort for effort in named if effort is not None)


def effort_of(aim: Aim, name: str, system: System) -> tuple[tuple[str, float], ...] | None:
    """The factors of an effort's signals or controls: 1 each where the aim names none.

    None for what is no effort.
    """
    if not name.endswith("_effort"):
        return None
    every = system.controls if name == "control_effort" else system.signals
    chosen = aim.efforts.get(name)
    return tuple(chosen.items()) if chosen else tuple((one, 1.0) for one in every)


class SignalObjective(ABC):
    """What is optimised in a model over signals.

    `sign` is -1 for what is maximised, 1 for what is minimised; `plain_robustness` says that it is
    the robustness alone, for which a bound is known, `chooses` that it is what is to hold.
    """

    name: str
    sign: float
    plain_robustness: bool = False
    chooses: bool = False

    @abstractmethod
    def target(self, setting: SignalSetting, made: SignalModel) -> Target:
        """What is minimised in a model."""

    @abstractmethod
    def worth(self, setting: SignalSetting, point: SignalPoint) -> float:
        """What a point is worth by its signals, whatever its other columns say."""

    def ideal(self, setting: SignalSetting) -> float | None:
        """A bound on all values that costs nothing, None where there is none."""
        return None

    def close(self, value: float) -> float:
        """Values this close to another count as the same."""
        return _CLOSE * max(1.0, abs(value))


@dataclass(frozen=True, eq=False)
class AimObjective(SignalObjective):
    """An aim: a sum of the robustness and of efforts."""

    aim: Aim

    def __post_init__(self) -> None:
        object.__setattr__(self, "name", self.aim.name)
        object.__setattr__(self, "sign", -1.0 if self.aim.rises else 1.0)
        object.__setattr__(self, "plain_robustness", self.aim.name == "robustness")

    def _factors(self) -> list[tuple[str, float]]:
        """The factor of each term as it is summed: efforts count against J."""
        if self.name != "J":
            return [(name, 1.0) for name, _ in self.aim.weights]
        return [
            (name, factor if SENSES[name] == "maximise" else -factor)
            for name, factor in self.aim.weights
        ]

    def target(self, setting: SignalSetting, made: SignalModel) -> Target:
        """The robustness's column and those of absolute values, with their factors."""
        vector = np.zeros(made.model.size.columns)
        for name, factor in self._factors():
            effort = effort_of(self.aim, name, setting.system)
            if effort is None:
                vector[made.rho] += factor if made.rho >= 0 else 0.0
                continue
            columns, factors = made.efforts[setting.efforts.index(effort)]
            np.add.at(vector, columns, factor * factors)
        return Target(self.sign * vector, _UNIT if self.sign > 0 else -_UNIT, step=0.0)

    def worth(self, setting: SignalSetting, point: SignalPoint) -> float:
        """The robustness as the evaluator tells it, and the efforts of the values."""
        total = 0.0
        for name, factor in self._factors():
            effort = effort_of(self.aim, name, setting.system)
            if effort is None:
                total += factor * spare_of(setting, point)
                continue
            for one, size in effort:
                last = setting.reach.horizon + (one in setting.system.signals)
                row = point.rows[setting.system.names.index(one), :last]
                total += factor * size * float(np.abs(row).sum())
        return total

    def ideal(self, setting: SignalSetting) -> float | None:
        """Of the robustness alone, that of a formula whose parts are judged each on its own."""
        return setting.ideal if self.plain_robustness else None


def spare_of(setting: SignalSetting, point: SignalPoint) -> float:
    """The robustness of what must hold, and of what does where not all must.

    No more than the greatest there can be, where nothing can fail.
    """
    trace, soft = point.trace(setting.system), setting.soft
    if soft is None:
        return float(robustness(setting.goal, trace)[0])
    trees = [(wish.tree, wish.partial) for wish in soft.wishes]
    demanded = float(robustness(soft.demand, trace)[0])
    return min(least_spare(trees, trace, demanded), setting.ideal)


@dataclass(frozen=True, eq=False)
class WishObjective(SignalObjective):
    """How much of some wishes holds, weighted: `(number of the wish, weight)`, maximised."""

    name: str
    entries: tuple[tuple[int, Fraction], ...]
    sign = -1.0
    chooses = True

    def target(self, setting: SignalSetting, made: SignalModel) -> Target:
        """The columns that wishes are worth, in whole units."""
        assert setting.soft is not None
        total = Expression.total((made.worth[number], weight) for number, weight in self.entries)
        wishes = setting.soft.wishes
        units = lcm(*(wishes[n].denominator * weight.denominator for n, weight in self.entries))
        count = made.model.size.columns
        return Target.of(
            dict(total.terms), count, total.constant, maximise=True, unit=Fraction(1, units)
        )

    def worth(self, setting: SignalSetting, point: SignalPoint) -> float:
        """What wishes are worth on the trajectory."""
        assert setting.soft is not None
        trace, total = point.trace(setting.system), Fraction(0)
        for number, weight in self.entries:
            total += weight * setting.soft.wishes[number].worth(trace)
        return float(total)

    def ideal(self, setting: SignalSetting) -> float | None:
        """All that wishes can be worth."""
        return float(sum((weight for _, weight in self.entries), Fraction(0)))


@dataclass(frozen=True, eq=False)
class DepthObjective(SignalObjective):
    """How much of a wish holds at one depth of its tree without what is around it, maximised."""

    depth: int
    name = "satisfaction"
    sign = -1.0
    chooses = True

    def target(self, setting: SignalSetting, made: SignalModel) -> Target:
        """The claims of the depth."""
        terms = {int(column): _UNIT for column in made.claims[self.depth]}
        return Target.of(terms, made.model.size.columns, maximise=True, unit=_UNIT)

    def worth(self, setting: SignalSetting, point: SignalPoint) -> float:
        """How many pairs hold at the depth."""
        assert setting.soft is not None
        counts = levels(setting.soft.wishes[0].tree, point.trace(setting.system)).counts
        return float(counts[self.depth])


@dataclass(frozen=True, eq=False)
class OwnTerms(SignalObjective):
    """A user's own sum of values at steps, minimised."""

    terms: tuple[tuple[str, int, float], ...]
    constant: float = 0.0
    name = "own"
    sign = 1.0

    def target(self, setting: SignalSetting, made: SignalModel) -> Target:
        """The columns of the values."""
        vector = np.zeros(made.model.size.columns)
        for name, step, factor in self.terms:
            vector[made.columns[setting.system.names.index(name), step]] += factor
        return Target(vector, constant=Fraction(self.constant), step=0.0)

    def worth(self, setting: SignalSetting, point: SignalPoint) -> float:
        """What the values add up to."""
        names = setting.system.names
        values = (factor * point.rows[names.index(one), step] for one, step, factor in self.terms)
        return self.constant + float(sum(values))
