"""The models of a synthesis: of all trajectories that lose nothing of what was reached."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Protocol

from tsplan.clock import Clock
from tsplan.encode.witness import WitnessRules
from tsplan.signals.signal_model import SignalModel, reference_model, signal_model
from tsplan.signals.signal_objectives import SignalObjective, SignalPoint
from tsplan.signals.signal_setting import SignalSetting

_KEPT = 1e-12  # of a robustness that is kept may get lost: what floats round


class Judge(Protocol):
    """The problem: what its models are made of, and whether the controls of a point do it."""

    def setting(self, margin: float = 0.0) -> SignalSetting:
        """What every model is made of; predicates hold by a margin, a share of their range."""

    @property
    def slack(self) -> float:
        """By how much equations make robustness look greater than it is, as they are taken."""

    def holds(self, point: SignalPoint) -> bool:
        """Whether what must hold does, on what the controls truly lead to."""


@dataclass(eq=False)
class KeptModels:
    """Makes the models of one problem and keeps the whole one until something more is reached.

    `least` is the robustness that a trajectory must have, `ideal` a bound on all there is. `tight`
    is False for the reference encoding; what need not hold as a whole is the tight one's always.
    """

    problem: Judge
    setting: SignalSetting
    clock: Clock
    least: float
    tight: bool
    kept: list[tuple[SignalObjective, float]] = field(default_factory=list, init=False)
    _whole: tuple[int, SignalModel] | None = field(default=None, init=False)

    def __post_init__(self) -> None:
        self.ideal = self.setting.ideal

    @property
    def level(self) -> tuple[float, float]:
        """From which robustness to which trajectories are looked for."""
        robust = [value for objective, value in self.kept if objective.plain_robustness]
        lost = self.problem.slack
        least = max([self.least, *(v - _KEPT * max(1.0, abs(v)) - lost for v in robust)])
        return least, max(self.ideal, least)

    def narrowed(self, made: SignalModel) -> SignalModel:
        """A model of those trajectories alone that lose nothing of what was reached."""
        for objective, value in self.kept:
            # what is chosen to hold does so in a model without choices
            if not objective.plain_robustness and not (objective.chooses and made.chosen):
                target = objective.target(self.setting, made)
                kept = target.kept(made.model, target.minimised(value), f"kept {objective.name}")
                made = replace(made, model=kept)
        return made

    def whole(self) -> SignalModel:
        """The model of all trajectories that lose nothing of what was reached; it is kept."""
        if self._whole is None or self._whole[0] != len(self.kept):
            made = self.narrowed(self.made(WitnessRules(), self.level))
            self._whole = len(self.kept), made
        return self._whole[1]

    def made(
        self,
        rules: WitnessRules,
        level: tuple[float, float],
        setting: SignalSetting | None = None,
    ) -> SignalModel:
        """A model by some rules, of the problem's setting or of another."""
        setting = self.setting if setting is None else setting
        with self.clock.timed("build"):
            if not self.tight and setting.soft is None:
                return reference_model(setting, level)
            return signal_model(setting, level, rules)
