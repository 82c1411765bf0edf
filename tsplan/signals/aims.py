"""What a trajectory is optimised for: terms, and aims one after the other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

SENSES: Mapping[str, str] = MappingProxyType(
    {"robustness": "maximise", "state_effort": "minimise", "control_effort": "minimise"}
)
"""What may be weighed in a sum, and whether more of it is better."""

CHOSEN = ("satisfaction", "preferences")
"""Aims that say what is to hold; they stand alone and come first."""


@dataclass(frozen=True)
class Aim:
    """One objective: a single term by its name, or several in one weighted sum, called J.

    `weights` has a factor for each term, in order. `efforts` has, for an effort over some signals
    alone, the factor of each of them; without an entry all signals (or controls) count 1. J is
    maximised: robustness counts for it and efforts against it.
    """

    weights: tuple[tuple[str, float], ...]
    efforts: Mapping[str, Mapping[str, float]] = field(default_factory=dict, hash=False)

    @property
    def name(self) -> str:
        """The name of its value: that of the only term if it counts 1, else J."""
        ((name, factor), *others) = self.weights
        return name if not others and factor == 1 else "J"

    @property
    def rises(self) -> bool:
        """Whether more is better."""
        return SENSES.get(self.name, "maximise") == "maximise"
