"""How the atoms of a formula are encoded: one encoder for each class of atoms.

The encodings of formulas know no agents. They ask the encoder of an atom's class which bounds the
atom means, what these could be at best, and by how much they hold. Where a margin is a level, it is
added to the bounds' amounts; where it is a column, `Slack` is compared with it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy as np

from tsplan.logic import Execution, Formula
from tsplan.milp.model import Floats, Ints

Site: TypeAlias = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Bound:
    """At least (or, if `upper`, at most) `amount` agents with a capability at a set of states."""

    states: Site
    capability: str | None
    upper: bool
    amount: int


@dataclass(frozen=True, slots=True)
class Executed:
    """A task is executed at a state."""

    task: Execution
    state: int


@dataclass(frozen=True, slots=True)
class Requirement:
    """Bounds that must all hold, or of which one must, in the form of the atom's class."""

    bounds: tuple[Any, ...]
    every: bool

    @property
    def visit(self) -> Bound | None:
        """The one bound, where it is enough that a single agent comes by."""
        (first, *others) = self.bounds
        if not self.every or others or not isinstance(first, Bound):
            return None
        return first if not first.upper and first.amount == 1 else None


class Slack(NamedTuple):
    """By how much a bound holds: the columns times `factor`, and `constant`: `low` to `high`.

    There is one factor for all columns, or one for each.
    """

    columns: Ints
    factor: float | Floats
    constant: float
    low: float
    high: float


class AtomEncoder(Protocol):
    """Encodes the atoms of one class."""

    @property
    def grain(self) -> float:
        """The least distance of two different slacks: 1 where they are whole, 0 of real numbers."""

    def requirement(self, atom: Any) -> Requirement:
        """The bounds an atom means."""

    def best(self, bound: Any) -> Floats:
        """By how much a bound holds at best, at every step."""

    def worst(self, bound: Any) -> Floats | None:
        """By how much it holds in any case, at every step; None where that is not known."""

    def slack(self, bound: Any, step: int) -> Slack:
        """By how much a bound holds at a step."""


@dataclass(frozen=True, eq=False)
class Atoms:
    """The atoms of a problem with steps `0 .. horizon`, and their encoders by class."""

    encoders: Mapping[type[Formula], AtomEncoder]
    horizon: int
    joint: Callable[[Formula, Atoms], float] | None = None  # the most a conjunction can hold by

    @cached_property
    def _read(self) -> dict[Formula, tuple[AtomEncoder, Requirement]]:
        return {}

    def of(self, node: Formula) -> tuple[AtomEncoder, Requirement]:
        """The encoder of an atom, and what it means; TypeError for what no encoder knows."""
        if node not in self._read:
            if type(node) not in self.encoders:
                raise TypeError(f"no encoding is registered for {type(node).__name__}")
            encoder = self.encoders[type(node)]
            self._read[node] = encoder, encoder.requirement(node)
        return self._read[node]

    def __contains__(self, node: object) -> bool:
        return type(node) in self.encoders

    def best(self, atom: Formula) -> Floats:
        """By how much an atom holds at best, at every step."""
        encoder, needed = self.of(atom)
        values = np.array([encoder.best(bound) for bound in needed.bounds])
        return np.asarray(values.min(axis=0) if needed.every else values.max(axis=0))

    def worst(self, atom: Formula) -> Floats:
        """By how much an atom holds in any case, at every step."""
        encoder, needed = self.of(atom)
        known = [encoder.worst(bound) for bound in needed.bounds]
        values = np.array([np.full(self.horizon + 1, -np.inf) if v is None else v for v in known])
        return np.asarray(values.min(axis=0) if needed.every else values.max(axis=0))
