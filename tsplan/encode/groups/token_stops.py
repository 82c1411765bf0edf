"""What a formula asks of somebody in any case, as far as its choices have been made.

The witness encoding of a formula is a model of its own here: the columns of its choices and the
rows between them, without any agents. Between some bounds of these columns a set of them is
*certain* where one of them is 1 in every point. What all columns of a certain set ask for at one
place, each at steps of its own, is a *stop*: agents must be there at the steps of one of them.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.atom_encoders import Site
from tsplan.encode.encoded import Setting
from tsplan.encode.flow_network import Network, laid_out
from tsplan.encode.groups.group_demands import only_of, some_wanted
from tsplan.encode.joint_demands import JointDemands
from tsplan.encode.memory import Watch
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.witness import Demand, WitnessEncoder
from tsplan.milp.model import Bools, Draft, Floats, Ints, Model

_TINY = 1e-6
_ROUNDS = 100  # of propagation; more would say nothing wrong, only less

Place: TypeAlias = tuple[Site, str | None]
Steps: TypeAlias = tuple[int, int]


class Stop(NamedTuple):
    """`amount` agents with a capability are at some states at all steps of one of the `runs`."""

    place: Place
    amount: int
    runs: tuple[Steps, ...]

    @property
    def lasting(self) -> bool:
        """Whether some run is longer than a step, so that who is there may change."""
        return any(first < last for first, last in self.runs)

    @property
    def sure(self) -> tuple[Steps, ...]:
        """Of every run, the steps at which whoever begins to make the stop alone is there."""
        if len(self.place[0]) == 1:
            return self.runs
        return tuple((first, first) for first, _ in self.runs)

    @property
    def once(self) -> Stop:
        """The stop with every run once."""
        return self._replace(runs=tuple(dict.fromkeys(self.runs)))

    def implies(self, other: Stop) -> bool:
        """Whether whoever makes this stop makes the other one."""
        return (
            self.place == other.place
            and self.amount >= other.amount
            and all(
                any(first <= begin and end <= last for begin, end in other.runs)
                for first, last in self.runs
            )
        )


class Limit(NamedTuple):
    """At most `amount` agents with a capability at some states from a first to a last step."""

    place: Place
    amount: int
    steps: Steps


@dataclass(frozen=True, eq=False)
class Bounds:
    """Between which bounds the columns of the choices are."""

    lower: Floats
    upper: Floats

    @property
    def open(self) -> Bools:
        """Columns that may be either."""
        return np.asarray((self.lower < _TINY) & (self.upper > 1 - _TINY))

    def without(self, columns: Sequence[int]) -> Bounds:
        """With some columns at 0."""
        upper = self.upper.copy()
        upper[list(columns)] = 0.0
        return Bounds(self.lower, upper)


class Choices:
    """The choices of a formula, and what they ask of swarms where no robots can do it."""

    def __init__(self, setting: Setting, tokens: int) -> None:
        """The choices of a setting's goal where swarms are in at most so many parts."""
        network = _unrolled(setting, swarms=True)
        robots = _unrolled(setting, swarms=False)
        draft = Draft(Watch(setting.clock))
        encoder = WitnessEncoder(draft, OptimisticBound(setting.goal, setting.atoms(network)))
        witnesses = only_of(encoder.encode(setting.goal), robots)
        self._demands: dict[int, list[Demand]] = defaultdict(list)
        self._always: list[Demand] = []
        for need in witnesses.demands:
            if not need.selection:
                self._always.append(need)
            for column in need.selection:
                self._demands[column].append(need)
        some = some_wanted(witnesses)
        for capability in {need.bound.capability for need in some}:
            mine = [need for need in some if need.bound.capability == capability]
            JointDemands(mine, witnesses.choices).rule_out(tokens)
        self._steps = dict(zip(witnesses.choices.columns, witnesses.choices.steps, strict=True))
        self._model = draft.build()
        self._sums = list(_sums(self._model, frozenset(self._steps)))
        self.refuted = witnesses.choices.refuted

    # --- bounds ----------------------------------------------------------------------------------

    @property
    def bounds(self) -> Bounds | None:
        """The bounds before anything is chosen; None if nothing can be chosen."""
        model = self._model
        most = float(max(model.size.columns, 1))
        return (
            None
            if self.refuted
            else self.settled(Bounds(model.lower, np.minimum(model.upper, most)))
        )

    def settled(self, bounds: Bounds) -> Bounds | None:
        """What follows from bounds, row by row; None if no point is left."""
        model = self._model
        entries = model.matrix.tocoo()
        row, column, factor = entries.row, entries.col, entries.data
        rises = factor > 0
        lower, upper = bounds.lower.copy(), bounds.upper.copy()
        whole = model.integer[column]
        for _ in range(_ROUNDS):
            least = factor * np.where(rises, lower[column], upper[column])
            most = factor * np.where(rises, upper[column], lower[column])
            floor = np.bincount(row, least, len(model.row_lower))
            ceiling = np.bincount(row, most, len(model.row_lower))
            if (floor > model.row_upper + _TINY).any() or (ceiling < model.row_lower - _TINY).any():
                return None
            above = (model.row_upper[row] - (floor[row] - least)) / factor
            below = (model.row_lower[row] - (ceiling[row] - most)) / factor
            high, low = np.where(rises, above, below), np.where(rises, below, above)
            high = np.where(whole, np.floor(high + _TINY), high)
            low = np.where(whole, np.ceil(low - _TINY), low)
            before = lower.copy(), upper.copy()
            np.minimum.at(upper, column, high)
            np.maximum.at(lower, column, low)
            if (lower > upper + _TINY).any():
                return None
            if (np.abs(before[0] - lower) < _TINY).all() and (
                np.abs(before[1] - upper) < _TINY
            ).all():
                break
        return Bounds(lower, upper)

    def step(self, column: int) -> int:
        """When what a column stands for begins."""
        return self._steps[column]

    # --- what is certain -------------------------------------------------------------------------

    def certain(self, bounds: Bounds) -> list[tuple[int, ...]]:
        """Sets of columns of which one is 1 in every point, those at 0 left out."""
        open_ = bounds.upper > 1 - _TINY
        fixed = bounds.lower > 1 - _TINY
        found: dict[frozenset[int], None] = {
            frozenset([column]): None for column in self._steps if fixed[column]
        }
        for least, members, parents in self._sums:
            own = frozenset(members[open_[members]].tolist())
            above = frozenset(parents[open_[parents]].tolist())
            if not own:
                continue
            known = any(other <= above for other in found) if above else False
            if (least >= 1 and not above) or (least >= 0 and known):
                found[own] = None
        return [tuple(sorted(each)) for each in found]

    def stops(self, sets: Sequence[tuple[int, ...]]) -> list[Stop]:
        """What is asked for in any case, but for what follows from another stop."""
        found = [_stop(need) for need in self._always if _wanted(need)]
        for columns in sets:
            found += [stop.once for stop in self._aligned(columns)]
        kept: list[Stop] = []
        for stop in dict.fromkeys(found):
            if not any(other.implies(stop) for other in kept):
                kept = [other for other in kept if not stop.implies(other)]
                kept.append(stop)
        return kept

    def apart(self, sets: Sequence[tuple[int, ...]]) -> set[tuple[Stop, Stop]]:
        """Pairs of stops that no token makes both on its own: they share a step in every witness.

        At several states agents may come and go, so there only the first step is sure.
        """
        found: set[tuple[Stop, Stop]] = set()
        for columns in sets:
            aligned = list(self._aligned(columns))
            for one, other in combinations(aligned, 2):
                if set(one.place[0]).isdisjoint(other.place[0]) and all(
                    a <= end and begin <= b
                    for (a, b), (begin, end) in zip(one.sure, other.sure, strict=True)
                ):
                    found.add((one.once, other.once))
        return found

    def _aligned(self, columns: Sequence[int]) -> Iterator[Stop]:
        """What all columns ask for, with a run of every column."""
        asked: list[dict[Place, list[Demand]]] = []
        for column in columns:
            places: dict[Place, list[Demand]] = defaultdict(list)
            for need in sorted(self._demands[column], key=_steps):
                if _wanted(need):
                    places[need.bound.states, need.bound.capability].append(need)
            asked.append(places)
        for place in asked[0]:
            if all(place in places for places in asked):
                for needs in zip(*(places[place] for places in asked), strict=False):
                    least = min(need.bound.amount for need in needs)
                    yield Stop(place, least, tuple(map(_steps, needs)))

    def limits(self, bounds: Bounds) -> Iterator[Limit]:
        """What may not be exceeded in any case."""
        chosen = [column for column in self._demands if bounds.lower[column] > 1 - _TINY]
        needs = [*self._always, *(need for column in chosen for need in self._demands[column])]
        for need in needs:
            if need.bound.upper:
                place = need.bound.states, need.bound.capability
                yield Limit(place, need.bound.amount, _steps(need))

    def asked(self, column: int) -> list[Stop]:
        """What one column asks for itself."""
        return [_stop(need) for need in self._demands[column] if _wanted(need)]

    def every(self) -> list[Stop]:
        """All that is asked for, whatever is chosen."""
        needs = [*self._always, *(need for each in self._demands.values() for need in each)]
        return list(dict.fromkeys(_stop(need) for need in needs if _wanted(need)))


def _wanted(need: Demand) -> bool:
    return not need.bound.upper and need.bound.amount > 0


def _stop(need: Demand) -> Stop:
    place = need.bound.states, need.bound.capability
    return Stop(place, need.bound.amount, (_steps(need),))


def _steps(need: Demand) -> Steps:
    return need.first, need.last


def _sums(model: Model, chosen: frozenset[int]) -> Iterator[tuple[float, Ints, Ints]]:
    """Rows that say how many of some columns of choices are 1 at least, less some others."""
    matrix = model.matrix
    for row, least in enumerate(model.row_lower.tolist()):
        span = slice(matrix.indptr[row], matrix.indptr[row + 1])
        columns, factors = matrix.indices[span].astype(np.int64), matrix.data[span]
        if least >= 0 and (np.abs(factors) == 1).all() and chosen.issuperset(columns.tolist()):
            yield least, columns[factors > 0], columns[factors < 0]


def _unrolled(setting: Setting, *, swarms: bool) -> Network:
    """Where all classes, or those that move one by one, can be when; no columns of any model."""
    scratch = Draft(Watch(setting.clock))
    graphs = [
        short.graph
        for item, short in zip(setting.classes, setting.reduced, strict=True)
        if swarms or item.bounds is None
    ]
    laid = [
        laid_out(graph, setting.horizon, scratch, upper=float(graph.agents)) for graph in graphs
    ]
    return Network(tuple(laid), setting.horizon)
