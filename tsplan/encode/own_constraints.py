"""Own constraints in a model: what the quantities in them are there, and their rows."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, floor
from typing import NamedTuple

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Setting
from tsplan.encode.expressions import Constraint
from tsplan.encode.flow_network import Network
from tsplan.encode.quantities import CountTerm, FlowTerm, Occupation, OwnVariable, Quantity
from tsplan.milp.model import INFINITY, Bools, Draft, Ints
from tsplan.ts import TransitionSystem

PART = "own variables"
"""The name of these columns among the parts of a model."""

_BASE = 10**4
"""The largest factor in a row: a solver that lets rows be broken by 1e-6 of their largest factor
still tells whole numbers apart by a wide margin."""


def terms_of(constraints: Iterable[Constraint]) -> set[Quantity]:
    """All quantities that some constraint speaks about."""
    return {term for constraint in constraints for term, _ in constraint.terms}


def occupations_of(constraints: Iterable[Constraint]) -> set[Occupation]:
    """Those of them that agents' paths say."""
    return {term for term in terms_of(constraints) if not isinstance(term, OwnVariable)}


def states_of(term: CountTerm, system: TransitionSystem, arrays: MapArrays) -> Ints:
    """Numbers of the states meant: a state of this name, else all states with the label."""
    if term.place in arrays.number:
        return np.array([arrays.number[term.place]], dtype=np.int64)
    return arrays.states_with(system, term.place)


def edges_of(term: FlowTerm, arrays: MapArrays, graph: ClassGraph) -> Bools:
    """Which edges of a class's map are the edge meant: in the modes of late agents, several are."""
    source, target = (arrays.number[end] for end in term.edge)
    place = np.arange(len(graph.start)) if graph.modes is None else graph.modes.place
    found = (place[graph.tail] == source) & (place[graph.head] == target)
    found[len(graph.rides) :] = False
    return np.asarray(found)


def variable_columns(constraints: Iterable[Constraint], draft: Draft) -> dict[OwnVariable, int]:
    """A column for every own variable: by how much it is above its least value."""
    found = {term for term in terms_of(constraints) if isinstance(term, OwnVariable)}
    return {
        item: int(draft.columns(1, upper=float(item.high - item.low), integer=item.whole)[0])
        for item in sorted(found, key=lambda item: item.name)
    }


@dataclass(frozen=True, eq=False)
class Quantities:
    """What counts, flows and own variables are in a model over a network."""

    setting: Setting
    network: Network
    variables: Mapping[OwnVariable, int]

    def columns(self, term: Quantity) -> tuple[Ints, int | Fraction]:
        """Columns whose sum, with the returned constant, is a quantity."""
        if isinstance(term, OwnVariable):
            return np.array([self.variables[term]], dtype=np.int64), term.low
        if isinstance(term, FlowTerm):
            every = self.setting.classes, self.setting.reduced, self.network.classes
            able = self.network.having(term.capability)
            parts = [
                self._entering(term, item.graph, short.paths, laid)
                for item, short, laid in zip(*every, strict=True)
                if any(laid is other for other in able)
            ]
            return np.concatenate([*parts, np.empty(0, dtype=np.int64)]), 0
        states = states_of(term, self.setting.mission.system, self.setting.arrays)
        return self.network.present(states, term.capability, term.step, settled=False)

    def most(self, term: Quantity) -> int | Fraction:
        """What those columns sum to at most."""
        if isinstance(term, OwnVariable):
            return term.high - term.low
        return self.network.agents(term.capability)

    def _entering(
        self, term: FlowTerm, graph: ClassGraph, paths: Sequence[Ints], laid: ClassColumns
    ) -> Ints:
        """Columns of a class by which an edge of its map is entered, on whatever way."""
        meant = edges_of(term, self.setting.arrays, graph)
        if laid.graph is graph:
            return laid.entries(np.flatnonzero(meant), np.full(int(meant.sum()), term.step))
        ways, steps = [], []
        for number, path in enumerate(paths):
            places = np.flatnonzero(meant[path])
            if len(places):
                duration = graph.duration[path]
                begun = np.cumsum(duration) - duration
                ways += [number] * len(places)
                steps += (term.step - begun[places]).tolist()
        return laid.entries(np.array(ways, dtype=np.int64), np.array(steps, dtype=np.int64))


class _Part(NamedTuple):
    """A summand of a row: a sum of columns between 0 and `most`, times a factor."""

    columns: Ints
    factor: int
    most: int


def constraint_rows(
    constraints: Sequence[Constraint], quantities: Quantities, draft: Draft
) -> None:
    """Rows for every constraint that bounds anything: one, or a few where numbers are large."""
    for constraint in constraints:
        if not constraint.bounds:
            continue
        constant = Fraction(0)
        for term, factor in constraint.terms:
            constant += factor * quantities.columns(term)[1]
        low, high = (
            None if bound is None else bound - constant
            for bound in (constraint.lower, constraint.upper)
        )
        if all(term.whole for term, _ in constraint.terms):
            parts = [
                _Part(quantities.columns(term)[0], int(factor), int(quantities.most(term)))
                for term, factor in constraint.terms
            ]
            sides = None if low is None else ceil(low), None if high is None else floor(high)
            _whole_rows(parts, sides, draft, constraint.name)
        else:
            _real_row(constraint, quantities, (low, high), draft)


def _whole_rows(
    parts: Sequence[_Part], sides: tuple[int | None, int | None], draft: Draft, kind: str
) -> None:
    lower, upper = sides
    if all(abs(part.factor) <= _BASE for part in parts):
        low = -INFINITY if lower is None else lower
        _row(parts, (low, INFINITY if upper is None else upper), draft, kind)
        return
    if upper is not None:
        _at_most(parts, upper, draft, kind)
    if lower is not None:
        turned = [part._replace(factor=-part.factor) for part in parts]
        _at_most(turned, -lower, draft, kind)


def _real_row(
    constraint: Constraint,
    quantities: Quantities,
    sides: tuple[Fraction | None, Fraction | None],
    draft: Draft,
) -> None:
    """A row with columns of real numbers, brought to factors of at most 1."""
    largest = max(abs(factor) for _, factor in constraint.terms)
    low, high = (None if side is None else float(side / largest) for side in sides)
    terms = (
        (0, quantities.columns(term)[0], float(factor / largest))
        for term, factor in constraint.terms
    )
    bounds = -INFINITY if low is None else low, INFINITY if high is None else high
    draft.sums(*terms, lower=bounds[0], upper=bounds[1], kind=constraint.name)


def _row(parts: Sequence[_Part], bounds: tuple[float, float], draft: Draft, kind: str) -> None:
    terms = ((0, part.columns, part.factor) for part in parts)
    draft.sums(*terms, lower=bounds[0], upper=bounds[1], kind=kind)


def _at_most(parts: Sequence[_Part], bound: int, draft: Draft, kind: str) -> None:
    """`sum of the parts <= bound`, with no factor above the base.

    With every factor and the bound split as B q + r, the sum keeps the bound exactly if there is a
    whole carry c with `sum of r x <= r of the bound + B c` and `sum of q x + c <= q of the bound`:
    B times the second and the first add up to it, and the largest c of the second fits the first.
    """
    if all(abs(part.factor) <= _BASE for part in parts):
        _row(parts, (-INFINITY, bound), draft, kind)
        return
    high, low = divmod(bound, _BASE)
    rests = [part._replace(factor=part.factor % _BASE) for part in parts]
    # carried must be what the rests come to at most
    most = max(0, -((low - sum(part.factor * part.most for part in rests)) // _BASE))
    carry = draft.columns(1, upper=float(most), integer=True)
    _row([*rests, _Part(carry, -_BASE, most)], (-INFINITY, low), draft, kind)
    quotients = [part._replace(factor=part.factor // _BASE) for part in parts]
    _at_most([*quotients, _Part(carry, 1, most)], high, draft, kind)
