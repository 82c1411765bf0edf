"""Objectives over signals in a model, and what a point of it is worth in them."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np

from tsplan.logic.evaluation import robustness
from tsplan.logic.traces import SignalTrace
from tsplan.milp.model import Floats
from tsplan.milp.target import Target
from tsplan.signals.aims import SENSES, Aim
from tsplan.signals.linear_system import System
from tsplan.signals.signal_model import SignalModel, SignalSetting

_UNIT = Fraction(1)
_CLOSE = 1e-6  # relative distance at which values of one sum count as equal: solvers' tolerance


@dataclass(frozen=True, eq=False)
class SignalPoint:
    """A point of a model over signals."""

    made: SignalModel
    values: Floats

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
    return tuple(effort for effort in named if effort)


def effort_of(aim: Aim, name: str, system: System) -> tuple[tuple[str, float], ...]:
    """The factors of an effort's signals or controls: 1 each where the aim names none."""
    if not name.endswith("_effort"):
        return ()
    every = system.controls if name == "control_effort" else system.signals
    chosen = aim.efforts.get(name)
    return tuple(chosen.items()) if chosen else tuple((one, 1.0) for one in every)


@dataclass(frozen=True, eq=False)
class SignalObjective:
    """An aim on the model side: a sum of the robustness and of efforts."""

    aim: Aim

    @property
    def name(self) -> str:
        """What the objective is called."""
        return self.aim.name

    @property
    def plain_robustness(self) -> bool:
        """Whether it is the robustness alone, for which a bound is known."""
        return self.name == "robustness"

    @property
    def sign(self) -> float:
        """-1 for what is maximised, 1 for what is minimised."""
        return -1.0 if self.aim.rises else 1.0

    def _factors(self) -> list[tuple[str, float]]:
        """The factor of each term as it is summed: efforts count against J."""
        if self.name != "J":
            return [(name, 1.0) for name, _ in self.aim.weights]
        return [
            (name, factor if SENSES[name] == "maximise" else -factor)
            for name, factor in self.aim.weights
        ]

    def target(self, setting: SignalSetting, made: SignalModel) -> Target:
        """What is minimised in a model."""
        vector = np.zeros(made.model.size.columns)
        for name, factor in self._factors():
            effort = effort_of(self.aim, name, setting.system)
            if not effort:
                vector[made.rho] += factor if made.rho >= 0 else 0.0
                continue
            columns, factors = made.efforts[setting.efforts.index(effort)]
            np.add.at(vector, columns, factor * factors)
        return Target(self.sign * vector, _UNIT if self.sign > 0 else -_UNIT, step=0.0)

    def worth(self, setting: SignalSetting, point: SignalPoint) -> float:
        """What a point is worth by its signals, whatever its other columns say."""
        total = 0.0
        for name, factor in self._factors():
            effort = effort_of(self.aim, name, setting.system)
            if effort:
                place = {one: row for row, one in enumerate(setting.system.names)}
                for one, size in effort:
                    last = setting.reach.horizon + (one in setting.system.signals)
                    total += factor * size * float(np.abs(point.rows[place[one], :last]).sum())
            else:
                trace = point.trace(setting.system)
                total += factor * float(robustness(setting.goal, trace)[0])
        return total

    def close(self, value: float) -> float:
        """Values this close to another count as the same."""
        return _CLOSE * max(1.0, abs(value))


@dataclass(frozen=True, eq=False)
class OwnTerms:
    """A user's own sum of values at steps, minimised."""

    terms: tuple[tuple[str, int, float], ...]
    constant: float = 0.0

    name = "own"
    sign = 1.0
    plain_robustness = False

    def target(self, setting: SignalSetting, made: SignalModel) -> Target:
        """What is minimised in a model."""
        vector = np.zeros(made.model.size.columns)
        place = {one: row for row, one in enumerate(setting.system.names)}
        for name, step, factor in self.terms:
            vector[made.columns[place[name], step]] += factor
        return Target(vector, constant=Fraction(self.constant), step=0.0)

    def worth(self, setting: SignalSetting, point: SignalPoint) -> float:
        """What a point is worth by its signals."""
        place = {one: row for row, one in enumerate(setting.system.names)}
        values = (factor * point.rows[place[name], step] for name, step, factor in self.terms)
        return self.constant + float(sum(values))

    def close(self, value: float) -> float:
        """Values this close to another count as the same."""
        return _CLOSE * max(1.0, abs(value))
