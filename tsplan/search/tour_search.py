"""What swarms at least pay for moving that split no more than so often, and plans of that price.

A plan with so many splits is as many weighted tokens as it has groups at step 0 and splits (see
`encode.groups.token_weights`). Each goes over its map on its own, so the cheapest way to share the
stops between them is a bound: what it does not know is that the stops of one witness are made at
one step. Branching on when the witnesses come brings that in, the cheapest node first; where all
stops agree, plans near the ways of the tokens are looked for in the whole problem. That tokens meet
and part again is a split, too, is only seen there.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, count
from typing import NamedTuple

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.groups.token_flow import Track
from tsplan.encode.groups.token_stops import Bounds, Choices, Stop
from tsplan.encode.groups.token_weights import weightings
from tsplan.encode.groups.travellers import Shared, Travellers
from tsplan.milp.target import Target

Realise = Callable[[Sequence[Track], float], float]
"""What the best plan costs that is found near the ways of all swarms; infinite for none.

It is told what plans cost at least.
"""

_SEVERAL = 2
_TRIES = 8  # ways near which plans of a price are looked for


class _Node(NamedTuple):
    """Some choices, ordered by the least price they allow and by how many have been made."""

    price: float
    depth: int
    order: int
    bounds: Bounds
    shared: Shared


class TourSearch:
    """Searches the choices of a formula for the least price of the tokens' ways."""

    def __init__(
        self, travellers: Travellers, choices: Choices, target: Target, realise: Realise
    ) -> None:
        self._travellers = travellers
        self._choices = choices
        self._target = target
        self._realise = realise
        wanted = [travellers.wanted(stop) for stop in choices.every()]
        self._weightings = weightings(travellers.origins, travellers.splits, wanted)
        self._order = count()
        self._known = self._stuck = np.inf
        self._seen: set[tuple[bytes, ...]] = set()

    def bounds(self, known: float, clock: Clock) -> Iterator[float]:
        """Better and better bounds on the price of all plans, infinite if there is no plan.

        A plan of a `known` price is there, or that is infinite. Ends where no plan is better than
        those found, or nothing more can be said; with too many ways to divide agents that is so at
        once.
        """
        if self._weightings is None:
            return
        self._known, self._stuck = known, np.inf
        root = self._choices.bounds
        heap = [] if root is None else list(self._node(root, 0))
        told = -np.inf
        while heap and not clock.over:
            least = min(heap[0].price, self._stuck)
            if least > told:
                told = least
                yield told
            if least < heap[0].price or not self._promising(least):
                break
            for child in self._children(heapq.heappop(heap)):
                heapq.heappush(heap, child)
        yield min([self._known, self._stuck, *(node.price for node in heap)])

    def _promising(self, price: float) -> bool:
        """Whether a plan of this price is better than the known one by a whole step."""
        return price <= self._cutoff

    @property
    def _cutoff(self) -> float:
        return np.inf if np.isinf(self._known) else self._target.cutoff(self._known)

    def _node(self, bounds: Bounds, depth: int) -> Iterator[_Node]:
        """The node of some choices, if it can hold a better plan."""
        choices = self._choices
        sets = choices.certain(bounds)
        asked = choices.stops(sets), choices.apart(sets), list(choices.limits(bounds))
        shared = self._travellers.shared(*asked, self._weightings or (), self._cutoff)
        if shared is not None:
            yield _Node(shared.price, depth, next(self._order), bounds, shared)

    def _children(self, node: _Node) -> Iterator[_Node]:
        """The nodes below one that may still hold better plans than those found."""
        halves = self._disagreeing(node)
        if halves is None:
            self._look_near(node)
            if not self._promising(node.price):
                return
            # other ways of the same price may do, but not often
            halves = self._widest(node.bounds) if len(self._seen) < _TRIES else None
        if halves is None:
            self._stuck = min(self._stuck, node.price)
            return
        for half in halves:
            inner = self._choices.settled(node.bounds.without(half))
            if inner is not None:
                yield from self._node(inner, node.depth - 1)

    def _look_near(self, node: _Node) -> None:
        """Look for plans near the ways of a node, where it has not been done before."""
        tracks = self._travellers.tracks(node.shared)
        key = tuple(part.tobytes() for track in tracks for part in track)
        if key not in self._seen:
            self._seen.add(key)
            self._known = min(self._known, self._realise(tracks, node.price))

    # --- branching -------------------------------------------------------------------------------

    def _disagreeing(self, node: _Node) -> tuple[Sequence[int], Sequence[int]] | None:
        """Halves of a choice of which the tokens make no witness whole; None if there is none.

        Where they come to one of its places earlier than to another, the cut lies in between.
        """
        best, widest = None, -1
        for columns in self._ordered(node.bounds):
            asked = [self._choices.asked(column) for column in columns]
            made = [[self._travellers.makes(node.shared, stop) for stop in each] for each in asked]
            if any(map(all, made)):
                continue
            gap, cut = _between(asked, made)
            if gap > widest:
                best, widest = (columns[cut:], columns[:cut]), gap
        return best

    def _widest(self, bounds: Bounds) -> tuple[Sequence[int], Sequence[int]] | None:
        """Halves of the choice that is most open; None where all is chosen."""
        columns = max(self._ordered(bounds), key=len, default=None)
        if columns is None:
            return None
        cut = len(columns) // 2
        return columns[cut:], columns[:cut]

    def _ordered(self, bounds: Bounds) -> list[list[int]]:
        """The choices that must be made and are open, each in the order of time."""
        sets = self._choices.certain(bounds)
        return [sorted(each, key=self._choices.step) for each in sets if len(each) >= _SEVERAL]


def _between(asked: Sequence[Sequence[Stop]], made: Sequence[Sequence[bool]]) -> tuple[int, int]:
    """How far the options lie apart at which two places are served, and where to cut."""
    served: dict[object, list[int]] = {}
    for option, (stops, each) in enumerate(zip(asked, made, strict=True)):
        for stop, done in zip(stops, each, strict=True):
            served.setdefault(stop.place, []).extend([option] if done else [])
    gap, cut = 0, len(asked) // 2
    for one, other in combinations([each for each in served.values() if each], 2):
        for early, late in ((one, other), (other, one)):
            if late[0] - early[-1] > gap:
                gap, cut = late[0] - early[-1], (late[0] + early[-1] + 1) // 2
    return gap, cut
