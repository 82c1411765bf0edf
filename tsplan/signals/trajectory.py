"""The trajectory: what every signal is at every step, and what was proven about it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

import numpy as np
from pydantic import Field

from tsplan.limits import MOST_STEPS
from tsplan.logic.traces import SignalTrace
from tsplan.milp.model import Floats
from tsplan.plans.plan import MissionRef, ModelSize, ObjectiveValue, SolverUse, Status, Timings
from tsplan.plans.records import OPTIONAL, Finite, Record, Word
from tsplan.stopping import StoppedBy

Values = tuple[Finite, ...]


@dataclass(frozen=True, slots=True)
class PartValue(Record):
    """A part of the formula: by how much it holds, and how much of it does."""

    text: str
    robustness: Finite | None
    fraction: Finite


@dataclass(frozen=True)
class Trajectory(Record):
    """What synthesis ended with.

    `signals` have one value more than there are `controls`, unless there is no trajectory.
    `robustness` is the formula's, weighted as the mission says, `agm` the arithmetic-geometric
    mean robustness (None where a signal of the formula has no bounds). Where the formula may hold
    in part, `fraction` is how much does and `preference` the same with weights.
    """

    status: Status
    mission: MissionRef
    horizon: Annotated[int, Field(strict=True, ge=0, le=MOST_STEPS)]
    stopped_by: StoppedBy | None = None
    objective: tuple[ObjectiveValue, ...] = ()
    robustness: Finite | None = None
    agm: Finite | None = None
    fraction: Finite | None = field(default=None, metadata=OPTIONAL)
    preference: Finite | None = field(default=None, metadata=OPTIONAL)
    verified: Annotated[bool, Field(strict=True)] = False
    signals: Mapping[Word, Values] = field(default_factory=dict, hash=False)
    controls: Mapping[Word, Values] = field(default_factory=dict, hash=False)
    parts: tuple[PartValue, ...] = field(default=(), metadata=OPTIONAL)
    solver: SolverUse = field(default_factory=SolverUse)
    size: ModelSize = field(default_factory=ModelSize)
    timings: Timings = field(default_factory=Timings)
    notes: tuple[str, ...] = field(default=(), metadata=OPTIONAL)

    def __getitem__(self, name: str) -> Floats:
        """The values of a signal (T+1,) or a control (T,); KeyError for other names."""
        return np.array(self.signals[name] if name in self.signals else self.controls[name])

    @property
    def states(self) -> Floats:
        """All signals (n, T+1), in the order of the system."""
        return np.array(list(self.signals.values()))

    @property
    def has_signals(self) -> bool:
        """Whether there is a trajectory."""
        return bool(self.signals)

    def trace(self) -> SignalTrace:
        """What formulas are judged on: every signal and control over the steps 0..T.

        After the last step nothing is steered any more: a control is held there.
        """
        held = {name: (*values, *values[-1:]) for name, values in self.controls.items() if values}
        arrays = {**self.signals, **held}
        return SignalTrace({name: np.array(values) for name, values in arrays.items()})
