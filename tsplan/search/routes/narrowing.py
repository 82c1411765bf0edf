"""Steps for all errands, found by routes: windows are narrowed until all are run at one step.

A route program knows windows, but not that all who run an errand must be there together. So of the
windows in which the program's routes are not there together, those of the largest errands are
halved, where most of their routes can begin, and the others are left open; then the program is
solved again. In the end a step is chosen for each of the others. A settled plan becomes better by
setting some errands free again (large neighbourhood search: Shaw, 1998): one that has become dearer
by what was settled, the likelier the more it has, and those that are run at about the same time.
Nothing here proves anything.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeAlias

import numpy as np

from tsplan.milp.model import Bools, Floats
from tsplan.search.routes.errands import Errand, narrowed
from tsplan.search.routes.route_program import Routed, RouteProgram

_SHARE = 0.25  # of the windows that are too wide are halved at once
_ENOUGH = 0.99  # of the agents that an errand needs: the rest is tolerance
_NEAR = 1.0  # between a program's value and bound: plans differ by whole numbers
_MEMORIES = 3  # times that more is remembered after windows have become narrower
_FREED = (8, 12, 16, 24)  # errands that are set free together
_APART = 10.0  # steps that chance puts between errands run at the same time
_POOL = 4_000  # routes that are kept for the next programs
_LITTLE = 1e-7

Windows: TypeAlias = tuple[tuple[int, int], ...]
"""The first and last step at which each errand's stay may begin."""


@dataclass(frozen=True, eq=False)
class Settled:
    """Windows, and what the program comes to with them."""

    windows: Windows
    routed: Routed


@dataclass(eq=False)
class Narrowing:
    """Narrows the windows of one program, whose routes run errands whole; `most` values of it."""

    program: RouteProgram
    errands: tuple[Errand, ...]
    most: int
    _random: np.random.Generator = field(default_factory=lambda: np.random.default_rng(0))

    @property
    def widest(self) -> Windows:
        """The windows that errands have."""
        return tuple(errand.ends for errand in self.errands)

    def solved(self, windows: Windows, rounds: int = _MEMORIES) -> Settled:
        """What the program comes to with these windows."""
        errands = narrowed(self.errands, windows)
        self.program.narrowed(errands, self.program.pool[-_POOL:])
        routed = self.program.solve(_NEAR)
        for _ in range(rounds):
            if self.program.clock.over or not self.program.remember(routed, self.most):
                break
            routed = self.program.solve(_NEAR)
        self._keep(routed)
        return Settled(windows, routed)

    def _keep(self, routed: Routed) -> None:
        """Those routes come last, and so are kept longest, that are used."""
        used = routed.used > _LITTLE
        order = np.argsort(used, kind="stable")
        self.program.pool = tuple(
            routed.routes[place] for place in order.tolist() if not routed.routes[place].repeats
        )

    def settled(self, found: Settled, most: float = np.inf) -> Settled | None:
        """With a step for every errand; None where it is not below `most`, or time is up."""
        while any(low < high for low, high in found.windows):
            if self.program.clock.over or found.routed.value > most - 1 + _LITTLE:
                return None
            found = self.solved(self._narrower(found))
        return found if found.routed.value <= most - 1 + _LITTLE else None

    def better(self, found: Settled, loose: Settled) -> Iterator[Settled | None]:
        """Tries to better a settled plan, one after the other; None for those that did not.

        `loose` is what it was settled from: its prices tell what has become dear since.
        """
        turn = 0
        while not self.program.clock.over:
            size = _FREED[turn % len(_FREED)]
            turn += 1
            free = self._related(found, loose, size)
            windows = tuple(
                errand.ends if number in free else window
                for number, (errand, window) in enumerate(
                    zip(self.errands, found.windows, strict=True)
                )
            )
            tried = self.settled(self.solved(windows), found.routed.value)
            found = found if tried is None else tried
            yield tried

    def _related(self, found: Settled, loose: Settled, size: int) -> frozenset[int]:
        """Some errand that has become dear, and those that are run at about the same time."""
        steps = np.array([low for low, _ in found.windows], dtype=np.float64)
        amounts = np.array([errand.amount for errand in self.errands])
        dearer = amounts * np.maximum(found.routed.prices - loose.routed.prices, 0.0) + _LITTLE
        chosen = int(self._random.choice(len(steps), p=dearer / dearer.sum()))
        apart = np.abs(steps - steps[chosen]) + self._random.exponential(_APART, len(steps))
        apart[chosen] = 0.0
        return frozenset(np.argsort(apart, kind="stable")[:size].tolist())

    # --- one round -------------------------------------------------------------------------------

    def _narrower(self, found: Settled) -> Windows:
        """Some windows halved or, where all can be run together, every one settled."""
        windows = list(found.windows)
        served = self._served(found)
        wide = [number for number, (low, high) in enumerate(windows) if low < high]
        apart = [n for n in wide if served[n].most < _ENOUGH * self.errands[n].amount]
        if not apart:
            for number in wide:
                windows[number] = (served[number].best,) * 2
            return tuple(windows)
        apart.sort(key=lambda number: -self.errands[number].amount)
        for number in apart[: max(int(_SHARE * len(apart)), 1)]:
            (low, high), (early, late) = windows[number], served[number].halves
            middle = (low + high) // 2
            windows[number] = (low, middle) if early >= late else (middle + 1, high)
        return tuple(windows)

    def _served(self, found: Settled) -> list[_Served]:
        """When the routes that are used run each errand."""
        served = [_Served(window) for window in found.windows]
        routed = found.routed
        for place in np.flatnonzero(routed.used > _LITTLE).tolist():
            route, used = routed.routes[place], float(routed.used[place])
            for number in {number for _, number in route.credits}:
                served[number].add(self.errands[number], route.stays, used)
        return served


class _Served:
    """How many agents could run an errand from each step of a window on."""

    def __init__(self, window: tuple[int, int]) -> None:
        self._low, self._high = window
        self._able: list[Bools] = []
        self._used: list[float] = []

    def add(self, errand: Errand, stays: Sequence[tuple[int, int, int]], used: float) -> None:
        """So much of a route that stands somewhere from one step to another."""
        able = np.zeros(self._high - self._low + 1, dtype=np.bool_)
        for node, since, until in stays:
            if node in errand.states:
                first, last = max(since, self._low), until - errand.stay + 1
                able[first - self._low : max(last - self._low + 1, 0)] = True
        self._able.append(able)
        self._used.append(used)

    @cached_property
    def _at(self) -> Floats:
        none = np.zeros(self._high - self._low + 1)
        return np.asarray(np.array(self._used) @ np.array(self._able)) if self._used else none

    @property
    def most(self) -> float:
        """The most agents that can run it together."""
        return float(self._at.max())

    @property
    def best(self) -> int:
        """A step at which so many can, in the middle of all such steps."""
        return self._low + _middle(self._at)

    @property
    def halves(self) -> tuple[float, float]:
        """How many can begin in the early half, and how many in the late one.

        Where as many can in both, it is how many can at once.
        """
        middle = (self._high - self._low) // 2 + 1
        if self._used:
            able = np.array(self._able)
            early, late = (
                float(np.array(self._used) @ half.any(axis=1))
                for half in (able[:, :middle], able[:, middle:])
            )
            if abs(early - late) > _LITTLE:
                return early, late
        return float(self._at[:middle].max()), float(self._at[middle:].max())


def _middle(values: Floats) -> int:
    """The place of the largest value, the middle one of several."""
    places = np.flatnonzero(values >= values.max() - _LITTLE)
    return int(places[len(places) // 2])
