"""What the moves of swarms cost at least where they split no more than so often.

Swarms that do not split at all go as single agents (`encode.groups.lone_groups`), whose mission is
searched as any other. Where they split, the tours of weighted tokens are (`search.tour_search`).
Either way plans are looked for along the ways that are found, in the whole model.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.groups.group_demands import most_groups
from tsplan.encode.groups.lone_groups import lone, priced_as, tracks
from tsplan.encode.groups.token_flow import Track
from tsplan.encode.groups.token_stops import Choices
from tsplan.encode.groups.travellers import Travellers
from tsplan.encode.priced_objectives import Priced
from tsplan.encode.switches import Switch
from tsplan.milp.confirmation import tried
from tsplan.milp.model import Floats
from tsplan.search.effort import Effort
from tsplan.search.guided_restriction import SLACKS, near
from tsplan.search.search import Search
from tsplan.search.tour_search import TourSearch

_TOURING = 20.0  # seconds for the tours of tokens
_SHARE = 0.5  # of the time that is left, if that is less
_REALISING = 5.0  # seconds for a plan along the ways of tokens


@dataclass(eq=False)
class GroupTravel:
    """Searches for the least price in one whole model, of which `keep` takes better points."""

    encoded: Encoded
    objective: Priced
    effort: Effort
    clock: Clock
    keep: Callable[[Floats], None]

    def __post_init__(self) -> None:
        self._setting = replace(self.encoded.setting, clock=self.clock)
        self._target = self.objective.target(self._setting, self.encoded)
        self._known = np.inf

    def bounds(self, splits: int | None, known: float) -> Iterator[float]:
        """Better and better bounds where there are so many splits, infinite if there is no plan.

        `known` is the price of a plan that is there. Nothing is said without a number of splits,
        unless swarms may not split at all, nor where agents may be late.
        """
        self._known = known
        splits = 0 if self._single else splits
        if splits is None or self._setting.delay or self._setting.mission.expected is not None:
            return
        alone = lone(self._setting) if not splits else None
        if alone is not None and Switch.LONE in self.effort.switches:
            yield self._alone(alone)
        elif Switch.TOURS in self.effort.switches:
            travellers = Travellers(self._setting, self.objective, splits)
            choices = Choices(self._setting, travellers.tokens)
            search = TourSearch(travellers, choices, self._target, self._near)
            yield from search.bounds(known, self._clock)

    @property
    def _clock(self) -> Clock:
        """A part of the time, for the tours."""
        left = self.clock.left
        return self.clock.within(_TOURING if left is None else min(_TOURING, _SHARE * left))

    @property
    def _single(self) -> bool:
        """Whether no swarm may ever be in several parts."""
        together = self._setting.together
        swarms = self.encoded.swarms
        return all(most_groups(swarm.size, swarm.bounds, together) == 1 for swarm in swarms)

    def _alone(self, setting: Setting) -> float:
        """The least price of swarms that go as one agent each."""
        encoded = tight(setting)
        target = priced_as(self.objective.target(setting, encoded), encoded, self._setting)

        def report(values: Floats | None, _value: float | None, _bound: float | None) -> None:
            if values is not None:
                self._along(list(tracks(self._setting, encoded, values)), 0)

        return Search(encoded, target, self.effort, self.clock, report).minimise().bound

    def _near(self, ways: Sequence[Track], least: float) -> float:
        """The price of the best plan near some ways, infinite if none is found.

        None of less than some price is there.
        """
        best = np.inf
        for slack in SLACKS:
            best = min(best, self._along(ways, slack))
            if best <= least or self.clock.over:
                break
        return best

    def _along(self, ways: Sequence[Track], slack: int) -> float:
        """The same, so many steps sooner or later at most."""
        model = near(self.encoded.model, self.encoded.swarms, ways, slack)
        options = self.effort.options(self.clock.within(_REALISING), self._target)
        values = tried(self.effort.solver, model.with_objective(self._target.vector), options)
        if values is None:
            return np.inf
        value = self._target.value(values)
        if self._target.better(value, self._known):
            self._known = value
            self.keep(values)
        return value
