"""Reading weights after operators: a name, or numbers."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from tsplan.errors import nearest
from tsplan.logic.parser.reading import Reading, reach
from tsplan.logic.text_spans import Span, Way
from tsplan.logic.weight_values import Weight, weights_for
from tsplan.words import nfc


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


class Interval(NamedTuple):
    """The steps of an operator, if it has any, with their weights; and what is written of them.

    A `mark` holds weights for parts whose number is not known yet.
    """

    steps: tuple[Any, ...] = ()
    parts: Mapping[Way, Span] = MappingProxyType({})
    mark: Mark | None = None


class WeightReader(Reading):
    """Reads what stands after ^, and weighs parts and steps by it."""

    def read_weight(self, part: Any) -> Mark | None:
        """Read a name of weights that are given, or numbers."""
        if not part.name():
            values = [self.read(value) for value in part.value()]
            if None in values:
                return None
            return Mark(part, reach(part), None, tuple(values) if part.LBRACKET() else values[0])
        name, known = self.read(part.name()), self.given.weights
        if name is None:
            return None
        name = nfc(name)
        if name not in known:
            remedy = nearest(name, known) if known else "give them, or write numbers: ^[1, 2]"
            self.complain(part, f"no weights '{name}' are given", remedy)
            return None
        return Mark(part, reach(part), name, known[name])

    def read_value(self, part: Any) -> float:
        """Read a number with its sign."""
        return float("".join(part.getText().split()))

    def weighed(self, interval: Interval, mark: Mark, indices: range, what: str) -> Interval | None:
        """An interval with the weights of its steps, or one of no steps with those of parts."""
        try:
            weights = weights_for(mark.given, indices, what)
        except (TypeError, ValueError) as error:
            named = "" if mark.name is None else f"'{mark.name}' does not fit: "
            remedy = (
                f"give a number above 0 for each {what} from {indices[0]} to {indices[-1]}, "
                "or one number for all"
            )
            self.complain(mark.part, f"{named}{error}", remedy)
            return None
        return Interval((*interval.steps, weights), {**interval.parts, **mark.parts})
