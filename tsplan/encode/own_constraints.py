"""Own constraints in a model: which counts they name, and their rows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.expressions import Constraint, CountTerm
from tsplan.encode.flow_network import Network
from tsplan.milp.model import INFINITY, Draft, Ints
from tsplan.ts import TransitionSystem

_BASE = 10**4
"""The largest factor in a row: a solver that lets rows be broken by 1e-6 of their largest factor
still tells whole numbers apart by a wide margin."""


def terms_of(constraints: Iterable[Constraint]) -> set[CountTerm]:
    """All counts that some constraint speaks about."""
    return {term for constraint in constraints for term, _ in constraint.terms}


def states_of(term: CountTerm, system: TransitionSystem, arrays: MapArrays) -> Ints:
    """Numbers of the states meant: a state of this name, else all states with the label."""
    if term.place in arrays.number:
        return np.array([arrays.number[term.place]], dtype=np.int64)
    return arrays.states_with(system, term.place)


class _Part(NamedTuple):
    """A summand of a row: a sum of whole columns between 0 and `most`, times a factor."""

    columns: Ints
    factor: int
    most: int


def constraint_rows(
    constraints: Sequence[Constraint],
    system: TransitionSystem,
    arrays: MapArrays,
    network: Network,
    draft: Draft,
) -> None:
    """Rows for every constraint that bounds anything: one, or a few where numbers are large."""
    for constraint in constraints:
        if constraint.lower is None and constraint.upper is None:
            continue
        parts, constant = [], 0
        for term, factor in constraint.terms:
            columns, fixed = resolve(term, system, arrays, network)
            parts.append(_Part(columns, factor, network.agents(term.capability)))
            constant += factor * fixed
        lower, upper = constraint.lower, constraint.upper
        if all(abs(part.factor) <= _BASE for part in parts):
            low = -INFINITY if lower is None else lower - constant
            high = INFINITY if upper is None else upper - constant
            _row(parts, (low, high), draft, constraint.name)
            continue
        if upper is not None:
            _at_most(parts, upper - constant, draft, constraint.name)
        if lower is not None:
            turned = [part._replace(factor=-part.factor) for part in parts]
            _at_most(turned, constant - lower, draft, constraint.name)


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


def resolve(
    term: CountTerm, system: TransitionSystem, arrays: MapArrays, network: Network
) -> tuple[Ints, int]:
    """Flow columns whose sum, with the returned constant, is a count."""
    states = states_of(term, system, arrays)
    return network.present(states, term.capability, term.step, settled=False)
