"""What agents must come for in any case: errands, the tasks that routes of single agents run.

An errand asks for agents at some states who are there for a number of steps together, somewhere in
a window. It says less than the model: of a demand with several witnesses it knows the window of
all of them, and how many agents the least of them asks for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import sparse
from scipy.sparse.csgraph import dijkstra

from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.encoded import Encoded
from tsplan.encode.visitor_cuts import Visits
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Floats, Ints, Model

_CLEAR = 1e-6  # less than this above a whole number is the solver's tolerance
_NEVER = 2**30  # steps


@dataclass(frozen=True, eq=False)
class Errand:
    """At least `amount` agents of the `classes` are at the `states` at each of `stay` steps.

    These steps follow each other within `first .. last`. One agent that is there at one of them is
    not away and there again at another. If the steps begin at `steps[i]` then `columns[i]` is 1.
    """

    states: Ints
    classes: frozenset[int]
    amount: int
    stay: int
    first: int
    last: int
    steps: Ints
    columns: Ints

    @property
    def ends(self) -> tuple[int, int]:
        """The first and last step at which the stay may begin."""
        return self.first, self.last - self.stay + 1

    def within(self, first: int, last: int) -> Errand:
        """The errand with a stay that begins at `first .. last`."""
        return replace(self, first=first, last=last + self.stay - 1)


def errands_of(encoded: Encoded, *, whole: bool = False) -> tuple[Errand, ...]:
    """The errands of a model; none where robots have to keep more than the formula and the map.

    With `whole` stays are as long as they are asked for, though agents may be away meanwhile.
    """
    if not encoded.setting.formula_alone or encoded.refuted or not encoded.visits:
        return ()
    least = _Least(encoded)
    found = (_errand(encoded, visits, least, whole=whole) for visits in encoded.visits)
    return tuple(errand for errand in found if errand is not None)


def _errand(encoded: Encoded, visits: Visits, least: _Least, *, whole: bool) -> Errand | None:
    """What visits come to in any case, if to anything."""
    network = encoded.network
    amount = least.amount(visits)
    able = network.having(visits.capability)
    if amount <= 0:
        return None
    states = np.array(visits.states)
    stay = visits.stay
    if not whole:
        stay = max(min([stay, *(_away(item, states) for item in able)]), 1)
    part, columns, _ = np.broadcast_arrays(*visits.terms)
    return Errand(
        states=states,
        classes=frozenset(g for g, item in enumerate(network.classes) if item in able),
        amount=amount,
        stay=stay,
        first=int(visits.first.min()),
        last=min(int(visits.last.max()) + stay - 1, network.horizon),
        steps=visits.first[part],
        columns=columns,
    )


class _Least:
    """How little demands can come to, whichever witnesses are chosen."""

    def __init__(self, encoded: Encoded) -> None:
        self._columns = encoded.indicators
        self._lp = WarmLP(_decided(encoded.model, encoded.indicators))

    def amount(self, visits: Visits) -> int:
        """The least that visits ask for together, a bound from below."""
        _, columns, amount = np.broadcast_arrays(*visits.together.terms)
        inside = np.isin(columns, self._columns)
        if not inside.all():
            return 0
        vector = np.zeros(len(self._columns))
        place = np.searchsorted(self._columns, columns)
        np.add.at(vector, place, amount)
        self._lp.costs(np.arange(len(vector)), vector)
        result = self._lp.solve()
        if result.status != "optimal":
            return 0
        return int(np.ceil(result.objective + visits.constant.sum() - _CLEAR))


def _decided(model: Model, indicators: Ints) -> Model:
    """The rows that speak of indicators alone."""
    inside = np.zeros(model.size.columns, dtype=np.bool_)
    inside[indicators] = True
    matrix = sparse.csr_array(model.matrix)
    rows = np.flatnonzero(np.diff(matrix.indptr))
    entries = np.add.reduceat(~inside[matrix.indices], matrix.indptr[rows]) if len(rows) else rows
    rows = rows[entries == 0]
    return replace(
        model,
        objective=np.zeros(len(indicators)),
        matrix=sparse.csr_array(matrix[rows][:, indicators]),
        integer=model.integer[indicators],
        lower=model.lower[indicators],
        upper=model.upper[indicators],
        row_lower=model.row_lower[rows],
        row_upper=model.row_upper[rows],
        tags=(),
        offset=0.0,
    )


def _away(item: ClassColumns, states: Ints) -> int:
    """The least number of steps from being at states to coming there again by a move."""
    graph = item.graph
    moving = ~graph.wait | (graph.duration > 1)
    tail, head, steps = graph.tail[moving], graph.head[moving], graph.duration[moving]
    leaving = np.isin(tail, states)
    if not leaving.any():
        return _NEVER
    back = _to(graph.tail, graph.head, graph.duration, states, len(graph.start))
    return int(min(np.min(steps[leaving] + back[head[leaving]]), _NEVER))


def _to(tail: Ints, head: Ints, steps: Ints, states: Ints, count: int) -> Floats:
    """Steps from every node to the nearest of some."""
    order = np.lexsort((steps, head, tail))
    pairs = np.stack([tail[order], head[order]])
    first = np.append(True, (np.diff(pairs) != 0).any(axis=0)) if len(order) else order
    ways = sparse.csr_array((steps[order][first], tuple(pairs[::-1, first])), shape=(count, count))
    return np.asarray(dijkstra(ways, indices=np.unique(states), min_only=True))


def narrowed(errands: Sequence[Errand], windows: Sequence[tuple[int, int]]) -> tuple[Errand, ...]:
    """Errands whose stays begin in given windows."""
    pairs = zip(errands, windows, strict=True)
    return tuple(errand.within(*window) for errand, window in pairs)
