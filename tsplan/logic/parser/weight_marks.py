"""Weights as they are written after operators: a name, or numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from tsplan.logic.text_spans import Span, Way
from tsplan.logic.weight_values import Weight


class Mark(NamedTuple):
    """A weight after an operator: where it stands, its name if it has one, and what it is."""

    part: Any
    span: Span
    name: str | None
    given: Weight

    @property
    def key(self) -> object:
        """What two marks have in common that mean the same weights."""
        return self.given if self.name is None else self.name

    @property
    def parts(self) -> Mapping[Way, Span]:
        """What is written of it, as `Written` keeps it."""
        named: dict[Way, Span] = {} if self.name is None else {("weight", self.name): self.span}
        return {("weight",): self.span, **named}
