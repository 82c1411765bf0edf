"""What a text may name that stands outside of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields
from typing import TypeAlias

from tsplan.logic.boxes import Box
from tsplan.logic.weight_values import Weight
from tsplan.words import nfc

Definition: TypeAlias = "tuple[Mapping[str, float] | Iterable[tuple[str, float]], float]"
"""A linear expression: the factor of each signal, and a constant."""


@dataclass(frozen=True, eq=False)
class Given:
    """The weights, regions and linear expressions that a text may name, each by its name."""

    weights: Mapping[str, Weight] = field(default_factory=dict)
    regions: Mapping[str, Box] = field(default_factory=dict)
    definitions: Mapping[str, Definition] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Bring names into the form in which names are compared."""
        for item in fields(self):
            named = {nfc(name): value for name, value in getattr(self, item.name).items()}
            object.__setattr__(self, item.name, named)
