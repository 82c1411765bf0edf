"""Formulas as they are written: where every occurrence of every part stands in the text.

Equal formulas are one object, however often they are written, so a place belongs to an occurrence:
the way to it from the whole formula, child by child.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

from tsplan.logic.nodes import Formula

Way: TypeAlias = "tuple[int | str, ...]"


class Span(NamedTuple):
    """Characters `begin` up to before `end` of a text."""

    begin: int
    end: int


@dataclass(frozen=True, eq=False, slots=True)
class Written:
    """One occurrence of a formula in a text, with those below it.

    `written[way]` is the span at the end of a way from here: numbers lead to children, and a
    name at its end to what the node itself has written: `interval`, `low` and `high` of a temporal
    operator, `weight` of one that has weights, `label`, `capability` and `bound` of a count,
    `duration`, `label` and `needs` of a task or limit. After `needs` (or `resources`), a number
    leads to a pair, and from there 0 to its name and 1 to its number; after `weight`, the name of
    weights leads to where it is written, after `signal` that of a signal to where a predicate has
    it first. What is said of a region is one occurrence, with `region`
    and `robot`.

    >>> from tsplan.logic import parse_with_places
    >>> formula, written = parse_with_places("b && F[0,12] sum(b) >= 3")
    >>> written[1], written[1, "high"], written[1, 0], written[1, 0, "bound"]
    (Span(begin=5, end=24), Span(begin=9, end=11), Span(begin=13, end=24), Span(begin=23, end=24))
    """

    formula: Formula
    span: Span
    children: tuple[Written, ...] = ()
    parts: Mapping[Way, Span] = field(default_factory=dict)

    def get(self, way: Way) -> Span | None:
        """The span at the end of a way; None where the text has nothing of its own for it."""
        here = self
        for depth, step in enumerate(way):
            if isinstance(step, str):
                return here.parts.get(way[depth:])
            if step >= len(here.children):
                return None
            here = here.children[step]
        return here.span

    def __getitem__(self, way: Way | int | str) -> Span:
        found = self.get(way if isinstance(way, tuple) else (way,))
        if found is None:
            raise KeyError(way)
        return found

    @property
    def stands_for(self) -> bool:
        """Whether it is written as a whole, and its formula has parts: as that of a region."""
        return bool(self.formula.children) and not self.children

    @property
    def weight_names(self) -> frozenset[str]:
        """The names of weights that are written anywhere in it."""
        ways = (way for here in self.occurrences() for way in here.parts if way[0] == "weight")
        return frozenset(str(name) for _, *names in ways for name in names)

    def occurrences(self) -> Iterator[Written]:
        """The occurrence itself and all below it, parents first, in the order of the text."""
        open_ = [self]
        while open_:
            here = open_.pop()
            yield here
            open_ += reversed(here.children)
