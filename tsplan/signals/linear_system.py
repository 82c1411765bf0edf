"""Linear systems in discrete time, and signals that move freely between bounds.

`x(k+1) = A x(k) + B u(k) + D`, with bounds on every signal and control at every step, a range for
where the signals begin, and limits that are linear but for absolute values.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from types import MappingProxyType
from typing import Any

import numpy as np

from tsplan.logic.text import number_text, sum_text
from tsplan.milp.model import Floats

Range = tuple[float, float]
Terms = tuple[tuple[str, float], ...]


def ordered(terms: Terms) -> Terms:
    """The terms of a sum by name, each once and none that is 0.

    >>> ordered((("y", 1.0), ("x", 2.0), ("y", -3.0)))
    (('x', 2.0), ('y', -2.0))
    """
    merged: dict[str, float] = {}
    for name, factor in terms:
        merged[name] = merged.get(name, 0.0) + factor
    return tuple((name, merged[name]) for name in sorted(merged) if merged[name])


@dataclass(frozen=True)
class Limit:
    """At every step `sum of the terms + sum of factor * |terms| <= bound`.

    The factors of absolute values are positive, so the limit is one of a convex set. Where it
    names a control, it holds at the steps at which there is one.

    >>> print(Limit((), ((1.0, (("u1", 1.0),)), (1.0, (("u2", 1.0),))), 1.0))
    |u1| + |u2| <= 1
    """

    terms: Terms
    absolute: tuple[tuple[float, Terms], ...]
    bound: float

    def __post_init__(self) -> None:
        """Bring what means the same into one form: a sum is as large as its opposite."""
        sized = [(factor, ordered(terms)) for factor, terms in self.absolute]
        turned = tuple(
            (factor, tuple((name, -each) for name, each in terms) if first < 0 else terms)
            for factor, terms in sized
            if (first := next((each for _, each in terms), 0.0))
        )
        object.__setattr__(self, "terms", ordered(self.terms))
        object.__setattr__(self, "absolute", turned)

    @property
    def names(self) -> tuple[str, ...]:
        """The signals and controls that it names, in the order of the text."""
        sums = (self.terms, *(terms for _, terms in self.absolute))
        return tuple(name for terms in sums for name, _ in terms)

    def __str__(self) -> str:
        parts = [sum_text(self.terms)] if self.terms else []
        parts += [
            ("" if factor == 1 else f"{number_text(factor)}*") + f"|{sum_text(terms)}|"
            for factor, terms in self.absolute
        ]
        return f"{' + '.join(parts) or '0'} <= {number_text(self.bound)}"


@dataclass(frozen=True)
class Dynamics:
    """`x(k+1) = a x(k) + b u(k) + d`: matrices by rows, in the order of signals and controls."""

    a: tuple[tuple[float, ...], ...]
    b: tuple[tuple[float, ...], ...]
    d: tuple[float, ...]

    @property
    def arrays(self) -> tuple[Floats, Floats, Floats]:
        """The three as arrays (n, n), (n, m) and (n,)."""
        count = len(self.a)
        b = np.array(self.b, dtype=np.float64).reshape(count, -1)
        return np.array(self.a, dtype=np.float64), b, np.array(self.d, dtype=np.float64)


@dataclass(frozen=True)
class System:
    """Signals with bounds, controls with bounds, and how the signals go on.

    `signals` and `controls` give the least and greatest value of each, infinite for none, in the
    order of the rows and columns of the dynamics. `initial` has the range in which a signal begins,
    for those whose beginning is not free. Without dynamics signals move freely. `outputs` names
    linear expressions over signals and controls, each with a constant.
    """

    signals: Mapping[str, Range] = field(hash=False)
    controls: Mapping[str, Range] = field(default_factory=dict, hash=False)
    dynamics: Dynamics | None = None
    initial: Mapping[str, Range] = field(default_factory=dict, hash=False)
    limits: tuple[Limit, ...] = ()
    outputs: Mapping[str, tuple[Terms, float]] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        sums = {name: (ordered(terms), more) for name, (terms, more) in self.outputs.items()}
        object.__setattr__(self, "outputs", sums)
        for name in ("signals", "controls", "initial", "outputs"):
            object.__setattr__(self, name, MappingProxyType(dict(getattr(self, name))))

    def __reduce__(self) -> tuple[type[System], tuple[Any, ...]]:
        """Pickle with plain dicts, so that a system can be sent to another process."""
        values = (getattr(self, item.name) for item in fields(self))
        plain = (dict(value) if isinstance(value, Mapping) else value for value in values)
        return System, tuple(plain)

    @property
    def names(self) -> tuple[str, ...]:
        """All signals, then all controls."""
        return (*self.signals, *self.controls)

    def begins(self, name: str) -> Range:
        """The range in which a signal begins."""
        low, high = self.signals[name]
        first, last = self.initial.get(name, (low, high))
        return max(low, first), min(high, last)

    def led(self, state: Mapping[str, float], control: Mapping[str, float]) -> dict[str, float]:
        """The signals one step after a state, as a control leads them.

        Raises ValueError for a system without dynamics, KeyError for values that are missing.

        >>> cart = System({"p": (0, 9)}, {"u": (-1, 1)}, Dynamics(((1,),), ((1,),), (0,)))
        >>> cart.led({"p": 2.0}, {"u": 0.5})
        {'p': 2.5}
        """
        steered = np.array([[control[name]] for name in self.controls]).reshape(-1, 1)
        later = self.simulated([state[name] for name in self.signals], steered)[:, 1]
        return dict(zip(self.signals, later.tolist(), strict=True))

    def simulated(self, start: Sequence[float], controls: Floats) -> Floats:
        """The signals (n, T+1) from a start by controls (m, T), step by step in floats.

        Raises ValueError for a system without dynamics.

        >>> cart = System({"p": (0, 9)}, {"u": (-1, 1)}, Dynamics(((1,),), ((1,),), (0,)))
        >>> cart.simulated([2.0], np.array([[1.0, -0.5]])).tolist()
        [[2.0, 3.0, 2.5]]
        """
        if self.dynamics is None:
            raise ValueError("signals without dynamics cannot be simulated")
        a, b, d = self.dynamics.arrays
        states = [np.asarray(start, dtype=np.float64)]
        for control in controls.T:
            states.append(a @ states[-1] + b @ control + d)
        return np.array(states).T
