"""What a text may name that stands outside of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from tsplan.logic.weight_values import Weight


@dataclass(frozen=True, eq=False)
class Given:
    """The weights that a text may name."""

    weights: Mapping[str, Weight] = field(default_factory=dict)
