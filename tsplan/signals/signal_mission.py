"""The mission over signals: a system, a formula, and what to optimise."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from tsplan.errors import MissionError
from tsplan.logic import And, Formula
from tsplan.logic.weight_values import Weight
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.mission_parts import Preference
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import Dynamics, Range, System
from tsplan.signals.region import Region
from tsplan.signals.signal_checks import mission_faults
from tsplan.signals.signal_parts import SignalLanguage, SignalParts, Weighting
from tsplan.signals.signal_values import parts_of_values
from tsplan.signals.signal_writer import save_signals, signals_to_yaml
from tsplan.words import nfc

Parts: TypeAlias = "tuple[tuple[str, Formula], ...]"


@dataclass(frozen=True)
class SignalMission(SignalParts):
    """A system, a formula over its signals, and what to optimise.

    `formula` speaks of signals and controls alone: outputs and regions are replaced in it, weights
    are on its nodes; `weights` are those that its text names. `horizon` is the last step, at least
    the formula's own. `objective` is one aim after the other; without any, every satisfying
    trajectory is as good as another. `satisfaction` is the order in which a formula may hold in
    part (None: it must hold), `prefer` has formulas that are met as far as possible besides.
    `regions` are what the text names and pictures show, `parts` the texts of what the formula joins
    at its top, with their formulas. Where there are several robots, `copies` has their names: the
    signals of `a` begin with `a_`, and a region along `x` is one along `a_x` for it. `digest` is
    the SHA-256 of the text, `warnings` are what looks odd in it; a mission that was read from a
    file keeps its document as `origin`, for places in it.

    Raises MissionError with everything that does not fit together.
    """

    def __post_init__(self) -> None:
        """Bring everything into one form, and refuse what does not fit together."""
        errors = [fault.finding() for fault in mission_faults(self) if fault.serious]
        if errors:
            raise MissionError(errors)
        chosen = [aim.name for aim in self.objective]
        first = [
            Aim(((name, 1.0),))
            for name, wanted in (
                ("preferences", self.prefer),
                ("satisfaction", self.satisfaction is not None),
            )
            if wanted and name not in chosen
        ]
        order = self.satisfaction or ("weighted" if "satisfaction" in chosen else None)
        changed = {
            "parts": _fitting(self.parts, self.formula, self.text),
            "text": nfc(self.text or str(self.formula)),
            "name": nfc(self.name),
            "objective": (*first, *self.objective),
            "satisfaction": order,
        }
        for name, value in changed.items():
            object.__setattr__(self, name, value)

    @classmethod
    def of(
        cls,
        *,
        system: System | None = None,
        signals: Mapping[str, Any] | None = None,
        controls: Mapping[str, Any] | None = None,
        dynamics: Dynamics | Mapping[str, Any] | None = None,
        outputs: Mapping[str, str] | None = None,
        limits: Sequence[str] | None = None,
        start: Mapping[str, float | Range] | None = None,
        regions: Mapping[str, Region | Mapping[str, Range]] | None = None,
        copies: Mapping[str, Any] | None = None,
        formula: str | bool | Formula | Sequence[str | bool | Formula] | None = None,
        must: str | bool | Formula | Sequence[str | bool | Formula] | None = None,
        prefer: Iterable[Preference | Mapping[str, Any]] = (),
        language: SignalLanguage | None = None,
        weights: Mapping[str, Weight] | None = None,
        weighting: Weighting = "product",
        objective: Any = None,
        horizon: int | None = None,
        solver: SolverChoice | Mapping[str, Any] | None = None,
        name: str = "",
    ) -> SignalMission:
        """A mission from Python values, with the same checks as a file.

        The system is a `system`, or `signals`, `controls`, `dynamics`, `outputs` and `limits` as a
        file has them; `start` says where signals begin. `formula` is a text, a formula or several
        (their conjunction), `must` another word for it beside what to `prefer`; `weights` may be
        functions, too. Everything else is as in a file. Raises MissionError with all findings.

        >>> from tsplan.signals import Region, double_integrator
        >>> goal = Region(x=(7, 8), y=(8, 9))
        >>> mission = SignalMission.of(
        ...     system=double_integrator(("x", "y"), position=(0, 10), speed=1, push=0.5),
        ...     start={"x": 1, "y": 2},
        ...     formula=goal.inside().eventually(0, 20),
        ...     objective=["robustness", "control_effort"],
        ... )
        >>> mission.horizon, mission.system.begins("y"), mission.system.begins("vy")
        (20, (2.0, 2.0), (0.0, 0.0))
        """
        spec = {
            "language": language,
            "formula": formula,
            "must": must,
            "prefer": list(prefer) or None,
            "weights": weights,
            "weighting": weighting,
        }
        values = {
            "signals": signals,
            "controls": controls,
            "dynamics": dynamics,
            "outputs": outputs,
            "limits": limits,
            "regions": regions,
            "copies": copies,
            "objective": objective,
            "horizon": horizon,
            "solver": solver,
            "name": name,
        }
        return cls(**vars(parts_of_values(values, spec, system, start or {})))

    @property
    def partial(self) -> bool:
        """Whether the formula may hold in part."""
        return self.satisfaction is not None

    def to_yaml(self) -> str:
        """The mission as a file, which is read as the same mission."""
        return signals_to_yaml(self)

    def save(self, path: str | Path) -> None:
        """Write a file, at once or not at all.

        Raises MissionError where the place cannot be written.
        """
        save_signals(self, Path(path))


def _fitting(parts: Parts, formula: Formula, text: str) -> Parts:
    """The parts, if they are what the formula joins at its top; else parts with their own texts."""
    joined = formula.children if isinstance(formula, And) else (formula,)
    if tuple(part for _, part in parts) == joined:
        return parts
    if len(joined) == 1 and text:
        return ((text, formula),)
    return tuple((str(part), part) for part in joined)
