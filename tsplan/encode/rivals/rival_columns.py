"""Which witnesses exclude each other because the same agents would have to serve both.

Everything that a witness needs, its ancestors' needs included, is compared with everything that
another one needs: where agents must be shared and there is no time to go from one place to the
other (`encode.rivals.travel_gaps`), at most one of the two is 1. A witness that excludes itself, or
what is needed in any case, is impossible.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tsplan.encode.atom_encoders import Site
from tsplan.encode.encoder_rules import Demand, Witnesses
from tsplan.encode.flow_network import Network
from tsplan.encode.rivals.module_gaps import ModuleGaps
from tsplan.encode.rivals.travel_gaps import Stay, TravelGaps
from tsplan.encode.structure_flows import Change
from tsplan.milp.model import Bools, Ints

MOST_NEEDS = 1500
"""Needs up to which all are compared with each other."""

_ANYWAY = -1  # in the place of a column: what is needed whatever the witnesses are


@dataclass(frozen=True, eq=False)
class RivalColumns:
    """Columns of witnesses, in order, and which of them exclude each other.

    Sets of columns are the bits of numbers: bit i stands for `columns[i]`. `excluded[i]` are those
    that are 0 where that is 1. Those that are `impossible` are always 0; if `refuted`, what is
    needed in any case cannot be had.
    """

    columns: tuple[int, ...]
    excluded: tuple[int, ...]
    impossible: int = 0
    refuted: bool = False

    def chosen(self, members: int) -> list[int]:
        """The columns of a set."""
        return [self.columns[place] for place in bits(members)]


def bits(members: int) -> list[int]:
    """The bits of a number that are 1, in order.

    >>> bits(0b10110)
    [1, 2, 4]
    """
    found = []
    while members:
        lowest = members & -members
        found.append(lowest.bit_length() - 1)
        members ^= lowest
    return found


def rival_columns(
    witnesses: Witnesses, network: Network, changes: Sequence[Change] = ()
) -> RivalColumns | None:
    """Which columns of `witnesses` exclude each other; None where none do, or they are too many.

    `changes` say how structures of modules become others.
    """
    needed = _Needed(TravelGaps(network))
    for column, demands in _implied(witnesses).items():
        needed.add(column, demands)
    entries = needed.entries(ModuleGaps(network, changes) if changes else None)
    if entries is None or len(entries.column) > MOST_NEEDS:
        return None
    columns, begin = np.unique(entries.column, return_index=True)
    exclusive = np.add.reduceat(_exclusive(entries), begin, axis=0, dtype=np.int64)
    exclusive = np.add.reduceat(exclusive, begin, axis=1) > 0
    if not exclusive.any():
        return None
    impossible = exclusive.diagonal().copy()
    refuted = False
    if columns[0] == _ANYWAY:
        refuted = bool(impossible[0])
        impossible = (impossible | exclusive[0])[1:]
        columns, exclusive = columns[1:], exclusive[1:, 1:]
    masks = tuple(_mask(row) for row in exclusive)
    return RivalColumns(tuple(columns.tolist()), masks, _mask(impossible), refuted)


def _implied(witnesses: Witnesses) -> dict[int, list[Demand]]:
    """What is needed where each decided column is 1, its ancestors' needs included."""
    own: dict[int, list[Demand]] = defaultdict(list)
    for need in witnesses.demands:
        if not need.bound.upper and need.bound.amount > 0 and need.bound.states:
            for column in need.selection or (_ANYWAY,):
                own[column].append(need)
    choices = witnesses.choices
    implied = {_ANYWAY: own[_ANYWAY]}
    for column in choices.columns:
        above = (own.get(ancestor, ()) for ancestor in choices.ancestors(column))
        implied[column] = [*own.get(column, ()), *(need for needs in above for need in needs)]
    return implied


class _Entries(NamedTuple):
    """Needs at one place each, by column: from when to when, and how far apart they must be.

    `gap[i, j]` steps lie between need i and need j if that comes later.
    """

    column: Ints
    first: Ints
    last: Ints
    gap: Ints


class _Needed:
    """Gathers needs; what one column needs at one place at the same steps is one of them."""

    def __init__(self, gaps: TravelGaps) -> None:
        self._gaps = gaps
        self._kinds: dict[Stay, int] = {}
        self._found: list[tuple[int, int, int, int, int]] = []

    def add(self, column: int, demands: Iterable[Demand]) -> None:
        """What a column needs."""
        places: dict[tuple[Site, int, int], dict[str | None, int]] = defaultdict(dict)
        for need in demands:
            amounts = places[need.bound.states, need.first, need.last]
            capability = need.bound.capability
            amounts[capability] = max(amounts.get(capability, 0), need.bound.amount)
        for (states, first, last), amounts in places.items():
            # others may have come by the end of a stay, and relieve those that were first
            begun, ended = (self._kind(states, amounts, step) for step in (first, last))
            self._found.append((column, first, last, begun, ended))

    def _kind(self, states: Site, amounts: Mapping[str | None, int], step: int) -> int:
        return self._kinds.setdefault(self._gaps.stay(states, amounts, step), len(self._kinds))

    def entries(self, built: ModuleGaps | None) -> _Entries | None:
        """Those needs that some other one must be apart from; None if there are none."""
        way = self._gaps.between(list(self._kinds))
        if built is not None:
            way = np.maximum(way, built.between(list(self._kinds)))
        if not way.any():
            return None
        column, first, last, begun, ended = np.array(sorted(self._found), dtype=np.int64).T
        late, early = (np.asarray(way.max(axis=axis)) > 0 for axis in (0, 1))
        far = late[begun] | early[ended]
        gap = way[np.ix_(ended[far], begun[far])]
        return _Entries(column[far], first[far], last[far], gap)


def _exclusive(entries: _Entries) -> Bools:
    """Which needs cannot both be met.

    Agents may relieve each other while a need lasts, so its last step is compared with the first
    of a later one, and where two overlap the later beginning with itself.
    """
    _, first, last, gap = entries
    later = first[None, :] - last[:, None]
    follows = first[None, :] >= first[:, None]
    kept = np.where(follows, gap, gap.T) > 0
    found = kept & (later < gap) & (later.T < gap.T)
    return np.asarray(found | found.T)


def _mask(row: Bools) -> int:
    return int.from_bytes(np.packbits(row, bitorder="little").tobytes(), "little")
