"""What formulas are judged on: counts of agents, or signals, over steps."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.errors import nearest
from tsplan.words import nfc

Floats: TypeAlias = npt.NDArray[np.float64]
Values: TypeAlias = npt.NDArray[Any]

_STATES_AND_STEPS = 2  # the last two axes of an array of counts


@dataclass(frozen=True, eq=False)
class CountTrace:
    """How many agents are where, at every step.

    `counts[capability]` is an array (..., states, steps) of whole numbers, `counts[None]` that of
    all agents; a capability that is absent counts 0 everywhere. `labels[label]` holds the places of
    the label's states along the states axis. Axes before these two are a batch. `executions` has,
    by the text of a task, where and when it is executed: Booleans of that shape.
    `most` are the counts that bounds from above are held against, where these are others, as where
    agents may be late: then `counts` are those that are sure and `most` those that are possible.
    """

    counts: Mapping[str | None, Values]
    labels: Mapping[str, Values]
    executions: Mapping[str, Values] = field(default_factory=dict)
    most: Mapping[str | None, Values] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for part in ("counts", "most"):
            named = {name and nfc(name): array for name, array in getattr(self, part).items()}
            object.__setattr__(self, part, named)
        object.__setattr__(self, "labels", {nfc(name): at for name, at in self.labels.items()})
        shapes = {np.shape(array) for array in (*self.counts.values(), *self.most.values())}
        if not self.counts:
            raise ValueError("a trace of counts needs the counts of all agents, under the key None")
        if len(shapes) > 1 or len(min(shapes)) < _STATES_AND_STEPS:
            raise ValueError(
                f"counts must all have one shape (..., states, steps), not {sorted(shapes)}"
            )

    @property
    def batch(self) -> tuple[int, ...]:
        """Shape of the batch of traces: () for a single one."""
        return np.shape(next(iter(self.counts.values())))[:-_STATES_AND_STEPS]

    @property
    def steps(self) -> int:
        """Number of steps, the first and the last included."""
        return int(np.shape(next(iter(self.counts.values())))[-1])

    def at(self, label: str, capability: str | None, *, upper: bool = False) -> Floats:
        """Counts (..., states with the label, steps) as floats; ValueError if that is unknown.

        With `upper` those that a bound from above is held against.
        """
        places = self._places(label)
        counts = self.most if upper and self.most else self.counts
        if capability not in counts:
            if capability is None:
                raise ValueError("the trace does not count all agents (the key None)")
            return np.zeros((*self.batch, places.size, self.steps))
        array = np.asarray(counts[capability])
        return _floats(array[..., places, :])

    def executed(self, task: str, label: str) -> Values:
        """Whether a task is executed at all states with a label: Booleans (..., steps)."""
        if task not in self.executions:
            return np.zeros((*self.batch, self.steps), dtype=np.bool_)
        here = np.asarray(self.executions[task])[..., self._places(label), :]
        return np.asarray(here.all(axis=-2))

    def _places(self, label: str) -> Values:
        """Where the states with a label are; ValueError if there is none."""
        places = np.asarray(self.labels.get(label, ()), dtype=np.int64)
        if not places.size:
            known = [name for name, states in self.labels.items() if len(states)]
            raise ValueError(f"no state has the label '{label}'; {nearest(label, known)}")
        return places


@dataclass(frozen=True, eq=False)
class SignalTrace:
    """Real signals: `signals[name]` is an array (..., steps); further axes are a batch."""

    signals: Mapping[str, Values]

    def __post_init__(self) -> None:
        signals = {nfc(name): array for name, array in self.signals.items()}
        object.__setattr__(self, "signals", signals)
        shapes = {np.shape(array) for array in self.signals.values()}
        if len(shapes) != 1 or not min(shapes):
            raise ValueError(f"signals must all have one shape (..., steps), not {sorted(shapes)}")

    @property
    def batch(self) -> tuple[int, ...]:
        """Shape of the batch of traces: () for a single one."""
        return np.shape(next(iter(self.signals.values())))[:-1]

    @property
    def steps(self) -> int:
        """Number of steps, the first and the last included."""
        return int(np.shape(next(iter(self.signals.values())))[-1])

    def signal(self, name: str) -> Floats:
        """One signal (..., steps); ValueError if it is unknown."""
        if name not in self.signals:
            raise ValueError(f"the trace has no signal '{name}'; {nearest(name, self.signals)}")
        return _floats(np.asarray(self.signals[name]))

    def total(self, terms: Iterable[tuple[str, float]]) -> Floats:
        """A weighted sum of signals (..., steps); ValueError if one is unknown."""
        return sum((factor * self.signal(name) for name, factor in terms), np.zeros(self.steps))


def _floats(values: Values) -> Floats:
    """Values as floats; ValueError where one is beyond all that these can hold."""
    try:
        return values.astype(np.float64, copy=False)
    except OverflowError:
        raise ValueError("a number of the trace is beyond 1e308, where floats end") from None


Trace: TypeAlias = CountTrace | SignalTrace
