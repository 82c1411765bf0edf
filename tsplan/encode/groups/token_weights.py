"""How many agents the tokens of swarms may have.

A plan with so many splits is a flow of agents over a network without circles, and a flow is a sum
of as many paths as it has groups at step 0 and splits (each path that is taken off ends a group or
a split): the *tokens*, each with agents of one group of step 0. What a plan costs is linear in the
numbers of their agents while every stop is made by the same tokens, so the cheapest numbers are at
a corner of what these stops allow: where sets of tokens have just as many agents as some stop asks
for, or a token has as few as it may.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, islice, product
from typing import NamedTuple

import numpy as np

from tsplan.milp.model import Floats

_TINY = 1e-6
_MOST = 400  # corners that are looked at
_SYSTEMS = 200_000  # systems of equations that are solved to find them
_HALF = 0.5  # determinants of matrices of zeros and ones are whole numbers
_AT_ONCE = 20_000


class Origin(NamedTuple):
    """A group at step 0: its swarm, its state, its agents and the fewest that a token has."""

    swarm: int
    state: int
    agents: int
    least: int


@dataclass(frozen=True, eq=False)
class Weighting:
    """The origin of every token, as a position among all, and its agents."""

    origins: tuple[int, ...]
    weights: Floats


class Wanted(NamedTuple):
    """`amount` agents of the swarms that are `able`."""

    amount: int
    able: frozenset[int]


def weightings(
    origins: Sequence[Origin], splits: int, wanted: Sequence[Wanted]
) -> list[Weighting] | None:
    """All corners, for every way to give the origins so many more tokens; None for too many."""
    found: dict[tuple[tuple[int, float], ...], Weighting] = {}
    # fewer tokens are as good as several that go together
    room = [min(splits, origin.agents // max(origin.least, 1) - 1) for origin in origins]
    for more in product(*(range(each + 1) for each in room)):
        if sum(more) != min(splits, sum(room)):
            continue
        tokens = tuple(n for n, each in enumerate(more) for _ in range(each + 1))
        corners = _corners(origins, tokens, wanted)
        if corners is None:
            return None
        for weights in corners:
            key = tuple(sorted(zip(tokens, (-weights).tolist(), strict=True)))
            found.setdefault(key, Weighting(tokens, -np.array([weight for _, weight in key])))
        if len(found) > _MOST:
            return None
    return list(found.values())


def _corners(
    origins: Sequence[Origin], tokens: tuple[int, ...], wanted: Sequence[Wanted]
) -> list[Floats] | None:
    """Agents of tokens at which as many conditions are met as just there are tokens."""
    of = np.array(tokens)
    sums = np.array([of == n for n in range(len(origins))], dtype=np.float64)
    totals = np.array([origin.agents for origin in origins], dtype=np.float64)
    free = len(tokens) - len(origins)
    if not free:
        return [totals[of]]
    least = np.array([origins[n].least for n in tokens], dtype=np.float64)
    rows, sides = _planes(origins, tokens, wanted)
    choices = combinations(range(len(rows)), free)
    found: list[Floats] = []
    for _ in range(_SYSTEMS // _AT_ONCE):
        block = np.array(list(islice(choices, _AT_ONCE)))
        if not len(block):
            return found
        count = len(block)
        matrix = np.concatenate([np.broadcast_to(sums, (count, *sums.shape)), rows[block]], 1)
        right = np.concatenate([np.broadcast_to(totals, (count, len(totals))), sides[block]], 1)
        regular = np.abs(np.linalg.det(matrix)) > _HALF
        points = np.linalg.solve(matrix[regular], right[regular][:, :, None])[:, :, 0]
        inside = points[(points >= least - _TINY).all(axis=1)]
        found += list(np.unique(np.round(inside, 6), axis=0))
    return None


def _planes(
    origins: Sequence[Origin], tokens: tuple[int, ...], wanted: Sequence[Wanted]
) -> tuple[Floats, Floats]:
    """Conditions that may just be met: sums of tokens' agents, and what these are then."""
    count = len(tokens)
    planes: dict[tuple[tuple[int, ...], float], None] = {
        ((n,), float(origins[origin].least)): None for n, origin in enumerate(tokens)
    }
    for amount, able in dict.fromkeys(wanted):
        mine = [n for n in range(count) if origins[tokens[n]].swarm in able]
        for size in range(1, len(mine) + 1):
            planes |= {(some, float(amount)): None for some in combinations(mine, size)}
    rows = np.zeros((len(planes), count))
    for row, (some, _) in enumerate(planes):
        rows[row, list(some)] = 1.0
    return rows, np.array([side for _, side in planes])
