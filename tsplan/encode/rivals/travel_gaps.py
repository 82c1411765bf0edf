"""How many steps lie between two tasks that the same agents have to serve.

Two tasks at different places that need more agents together than there are share some of them, and
whoever is shared must go from the one place to the other in between. By Hall's condition: each
agent counts once for the needs of one place, and for those of both if there is time to go; the
agents of the nearest class are shared first. Where a place needs several capabilities, an agent
meets one need for each of those that it has, so sets of capabilities are compared with agents (the
condition is necessary whatever the sets, and sufficient for one capability at each place).

Source: P. Hall, "On representatives of subsets", Journal of the London Mathematical Society, 1935.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import chain, combinations
from typing import NamedTuple

import numpy as np

from tsplan.encode.atom_encoders import Bound, Site
from tsplan.encode.flow_network import Network
from tsplan.milp.model import Bools, Floats, Ints

_MOST_TOGETHER = 3  # capabilities of one place of which all sets are looked at


class Stay(NamedTuple):
    """Agents that one place needs at a step: so many of each capability, from some classes."""

    states: Site
    amounts: tuple[tuple[str | None, int], ...]
    classes: tuple[int, ...]


class _Sets(NamedTuple):
    """Sets of needs: whose each is, how many agents it wants, what an agent of each class meets."""

    stay: Ints
    wanted: Ints
    meets: Ints


class TravelGaps:
    """How many steps must lie between two stays, on the map of each class of a network."""

    def __init__(self, network: Network) -> None:
        self._network = network
        self._never = network.horizon + 1
        self._agents = np.array([c.graph.agents for c in network.classes], dtype=np.int64)
        self._known: dict[str | None, Bools] = {}

    def stay(self, states: Site, amounts: Mapping[str | None, int], step: int) -> Stay:
        """What a place needs at a step, from the classes of which somebody can have come by then.

        Whoever of them has none of the capabilities is no matter, so he is left out.
        """
        able = np.zeros(len(self._agents), dtype=np.bool_)
        for capability in amounts:
            able |= self._having(capability)
        here = list(states)
        come = [
            bool(has) and int(item.arrival[here].min(initial=self._never)) <= step
            for has, item in zip(able.tolist(), self._network.classes, strict=True)
        ]
        needs = tuple(sorted(amounts.items(), key=lambda need: need[0] or ""))
        return Stay(states, needs, tuple(np.flatnonzero(come).tolist()))

    def between(self, stays: Sequence[Stay]) -> Ints:
        """Steps between the end of a stay (row) and the beginning of a later one (column).

        0 where there are enough agents to serve both apart, or both need agents at a common state;
        more than the horizon where both cannot be served at all.
        """
        found = np.zeros((len(stays), len(stays)), dtype=np.int64)
        sets = self._sets(stays)
        lacking = sets.wanted[:, None] + sets.wanted[None, :]
        for meets, agents in zip(sets.meets.T, self._agents.tolist(), strict=True):
            lacking = lacking - agents * np.maximum(meets[:, None], meets[None, :])
        apart = disjoint([stay.states for stay in stays])
        one, other = np.nonzero((lacking > 0) & apart[np.ix_(sets.stay, sets.stay)])
        if len(one):
            twice = self._agents * np.minimum(sets.meets[one], sets.meets[other])
            away = self._distances(stays)[sets.stay[one], sets.stay[other]]
            ways = _nearest_first(away, twice, lacking[one, other], self._never)
            np.maximum.at(found, (sets.stay[one], sets.stay[other]), ways)
        return found

    def _sets(self, stays: Sequence[Stay]) -> _Sets:
        """The sets of needs of every stay that are looked at."""
        placed = [(place, stay) for place, stay in enumerate(stays) if stay.states]
        entries = [(place, needs) for place, stay in placed for needs in self._subsets(stay)]
        meets = np.zeros((len(entries), len(self._agents)), dtype=np.int64)
        for number, (place, needs) in enumerate(entries):
            classes = list(stays[place].classes)
            for capability, _ in needs:
                meets[number, classes] += self._having(capability)[classes]
        stay = np.array([place for place, _ in entries], dtype=np.int64)
        wanted = [sum(amount for _, amount in needs) for _, needs in entries]
        return _Sets(stay, np.array(wanted, dtype=np.int64), meets)

    def _subsets(self, stay: Stay) -> list[tuple[tuple[str | None, int], ...]]:
        """Sets of the needs of a stay: all of them, or single ones where that would be many.

        Nothing is said of needs that structures of modules may meet, of whom nobody knows how many
        there are.
        """
        amounts = [need for need in stay.amounts if not self._network.reborn(need[0])]
        most = len(amounts) if len(amounts) <= _MOST_TOGETHER else 1
        sizes = range(1, most + 1)
        return list(chain.from_iterable(combinations(amounts, size) for size in sizes))

    def _having(self, capability: str | None) -> Bools:
        """The classes that have a capability."""
        if capability not in self._known:
            able = self._network.counted(capability).any(axis=1)
            self._known[capability] = np.asarray(able, dtype=np.bool_)
        return self._known[capability]

    def _distances(self, stays: Sequence[Stay]) -> Floats:
        """How far it is from stay to stay in each class: an array (from, to, classes)."""
        sites = list(dict.fromkeys(stay.states for stay in stays if stay.states))
        at = np.array([state for site in sites for state in site], dtype=np.int64)
        begin = np.cumsum([0, *(len(site) for site in sites[:-1])])
        each = []
        for item in self._network.classes:
            away = item.graph.lengths.distances(at)[:, at]
            nearest = np.minimum.reduceat(np.minimum.reduceat(away, begin, axis=0), begin, axis=1)
            each.append(nearest)
        number = {site: place for place, site in enumerate(sites)}
        place = [number.get(stay.states, 0) for stay in stays]  # of no states, none is asked for
        return np.stack(each, axis=-1)[np.ix_(place, place)]


def gaps_between(bounds: Sequence[Bound], network: Network) -> Ints:
    """The steps between demands of one capability each, from the earlier (row) to the later one."""
    gaps = TravelGaps(network)
    stays = [gaps.stay(b.states, {b.capability: b.amount}, network.horizon) for b in bounds]
    return gaps.between(stays)


def disjoint(sites: Sequence[Site]) -> Bools:
    """Which places have no state in common."""
    states = sorted({state for site in sites for state in site})
    number = {state: place for place, state in enumerate(states)}
    has = np.zeros((len(sites), len(states)), dtype=np.int64)
    for place, site in enumerate(sites):
        has[place, [number[state] for state in site]] = 1
    return np.asarray(has @ has.T == 0)


def _nearest_first(away: Floats, twice: Ints, lacking: Ints, never: int) -> Ints:
    """How far the nearest agents go that meet, counted twice, what is lacking; one for each row."""
    order = np.argsort(away, axis=1, kind="stable")
    enough = np.cumsum(np.take_along_axis(twice, order, axis=1), axis=1) >= lacking[:, None]
    way = np.take_along_axis(away, order, axis=1)[np.arange(len(away)), enough.argmax(axis=1)]
    return np.where(enough.any(axis=1), np.minimum(way, never), never).astype(np.int64)
