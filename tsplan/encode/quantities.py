"""What own constraints and objectives are about: counts, flows, and variables of the user's own."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar, TypeAlias


@dataclass(frozen=True, slots=True)
class CountTerm:
    """Agents with a capability (None: all) at the states of a label, or at one state, at a step."""

    place: str
    capability: str | None
    step: int

    whole: ClassVar[bool] = True

    def __str__(self) -> str:
        able = "" if self.capability is None else f", {self.capability!r}"
        return f"count({self.place!r}{able}, step={self.step})"


@dataclass(frozen=True, slots=True)
class FlowTerm:
    """Agents with a capability (None: all) that enter an edge, named by its ends, at a step."""

    edge: tuple[str, str]
    capability: str | None
    step: int

    whole: ClassVar[bool] = True

    def __str__(self) -> str:
        able = "" if self.capability is None else f", {self.capability!r}"
        return f"flow({self.edge!r}{able}, step={self.step})"


@dataclass(frozen=True, slots=True)
class OwnVariable:
    """A number between two others that a plan chooses; a whole one where it is `whole`."""

    name: str
    low: Fraction
    high: Fraction
    whole: bool = True

    def __str__(self) -> str:
        return self.name

    def complaint(self, value: Fraction | None) -> str:
        """What is wrong with a value of it, in words; nothing where it may have that."""
        if value is None:
            return "has no value"
        if not self.low <= value <= self.high:
            return f"is {value}, outside {self.low}..{self.high}"
        return f"is {value}, no whole number" if self.whole and value.denominator > 1 else ""


Occupation: TypeAlias = CountTerm | FlowTerm
"""What agents' paths say: who is where, and who enters what."""

Quantity: TypeAlias = Occupation | OwnVariable
"""Whatever an own constraint can be about."""
