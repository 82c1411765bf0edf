"""Which tokens best make which stops.

Every stop is made by one token or by several together. What a token costs depends on the set of all
calls that it makes, so the stops are divided between tokens one after the other: the least sum over
all ways to divide a set in two.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, product
from typing import NamedTuple

import numpy as np

from tsplan.encode.groups.token_stops import Stop
from tsplan.encode.groups.token_weights import Wanted, Weighting
from tsplan.milp.model import Bools, Floats, Ints

_TINY = 1e-6
_MOST = 400  # ways to make stops together that are looked at


class Task(NamedTuple):
    """A stop as calls: what one token makes that makes it alone, and what each of several does.

    In a stop that `changes` tokens may follow each other, so any two of them may make it.
    """

    stop: Stop
    alone: int
    together: int
    wanted: Wanted
    changes: bool


class Service(NamedTuple):
    """The least price, and the calls that each token makes for it."""

    price: float
    calls: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class Servants:
    """Tokens with so many agents: the swarm of each, and its price for every set of calls."""

    weighting: Weighting
    swarms: Sequence[int]
    prices: Sequence[Floats]

    def cheapest(self, tasks: Sequence[Task], below: float) -> Service | None:
        """The cheapest way to make all stops, if it costs less than a price."""
        weights = self.weighting.weights
        able = [np.array([s in task.wanted.able for s in self.swarms]) for task in tasks]
        single = [
            each & (weights >= task.wanted.amount - _TINY)
            for task, each in zip(tasks, able, strict=True)
        ]
        options = [
            [*([()] if alone.any() else []), *_together(task, weights, each)]
            for task, each, alone in zip(tasks, able, single, strict=True)
        ]
        if not all(options):
            return None
        if np.prod([float(len(each)) for each in options]) > _MOST:
            options, single = _loosened(options, single)
        best = None
        for chosen in product(*options):
            found = self._with(tasks, chosen, single, below)
            if found is not None:
                best, below = found, found.price
        return best

    def _with(
        self,
        tasks: Sequence[Task],
        chosen: Sequence[tuple[int, ...]],
        single: Sequence[Bools],
        below: float,
    ) -> Service | None:
        """The cheapest where it is chosen which stops are made together and by whom."""
        base = [0] * len(self.prices)
        for task, some in zip(tasks, chosen, strict=True):
            for token in some:
                base[token] |= task.together
        if sum(price[made] for price, made in zip(self.prices, base, strict=True)) >= below:
            return None
        alone = [number for number, some in enumerate(chosen) if not some]
        calls = np.zeros(1, dtype=np.int64)  # of every set of these
        for number in alone:
            calls = np.concatenate([calls, calls | tasks[number].alone])
        own = []
        for token, price in enumerate(self.prices):
            barred = sum(1 << place for place, n in enumerate(alone) if not single[n][token])
            forbidden = np.arange(len(calls)) & barred > 0
            own.append(np.where(forbidden, np.inf, price[calls | base[token]]))
        total, parts = _divided(own)
        if total >= below:
            return None
        made = zip(parts, base, strict=True)
        return Service(total, tuple(int(calls[part]) | also for part, also in made))


def _together(task: Task, weights: Floats, able: Bools) -> Iterator[tuple[int, ...]]:
    """Sets of tokens that make a stop together and of which none can be spared."""
    mine = np.flatnonzero(able).tolist()
    if task.changes:  # of those who come and go at least two come
        yield from combinations(mine, 2)
        return
    for size in range(2, len(mine) + 1):
        for some in combinations(mine, size):
            agents = weights[list(some)]
            spared = agents.sum() - agents.min()
            if spared < task.wanted.amount - _TINY <= agents.sum():
                yield some


def _loosened(
    options: Sequence[list[tuple[int, ...]]], single: Sequence[Bools]
) -> tuple[list[list[tuple[int, ...]]], list[Bools]]:
    """Let any one of those who make a stop together do it alone, which is never dearer."""
    loose = [each.copy() for each in single]
    for sets, alone in zip(options, loose, strict=True):
        for some in sets:
            alone[list(some)] = True
    return [[()] for _ in options], loose


def _divided(own: Sequence[Floats]) -> tuple[float, list[int]]:
    """Divide the set of all between tokens: the least sum of their prices, and their parts."""
    left = len(own[0]) - 1
    totals = [own[0]]
    for prices in own[1:-1]:
        part, rest, first = _subsets(left.bit_length())
        totals.append(np.minimum.reduceat(prices[part] + totals[-1][rest], first))
    price, made = float(own[0][left]), []
    for token in range(len(own) - 1, 0, -1):
        parts = _parts(left)
        sums = own[token][parts] + totals[token - 1][left & ~parts]
        place = int(sums.argmin())
        if token == len(own) - 1:
            price = float(sums[place])
        made.append(int(parts[place]))
        left &= ~int(parts[place])
    return price, [left, *reversed(made)]


def _parts(whole: int) -> Ints:
    """All subsets of a set."""
    found = np.zeros(1, dtype=np.int64)
    for bit in range(whole.bit_length()):
        if whole >> bit & 1:
            found = np.concatenate([found, found | 1 << bit])
    return found


@lru_cache(maxsize=4)
def _subsets(count: int) -> tuple[Ints, Ints, Ints]:
    """Subsets of every set of so many things, what is left of it, and where each set's begin."""
    part, rest = np.zeros(1, dtype=np.int64), np.zeros(1, dtype=np.int64)
    for bit in range(count):
        one = 1 << bit
        part = np.concatenate([part, part | one, part])
        rest = np.concatenate([rest, rest, rest | one])
    order = np.argsort(part | rest, kind="stable")
    part, rest = part[order], rest[order]
    return part, rest, np.flatnonzero(np.diff(part | rest, prepend=-1))
