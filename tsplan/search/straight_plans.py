"""Plans of large missions with resources, by straight ways (`encode.straight_ways`).

The linear program of such a mission takes minutes where that of the restriction takes a second.
Ways that begin seldom are tried first, and more of them where that leaves no plan. Then better
plans are looked for, by the same restriction. It proves nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np

from tsplan.clock import Clock, Halted
from tsplan.encode.assemble import tight
from tsplan.encode.encoded import Encoded, Point
from tsplan.encode.priced_objectives import Travel
from tsplan.encode.straight_ways import flows_in, straightened
from tsplan.encode.switches import Switch
from tsplan.errors import SolverError
from tsplan.milp.model import Floats
from tsplan.search.effort import Effort
from tsplan.search.kernel import Kernel
from tsplan.search.question import Question, start_in
from tsplan.search.search import Search

_CUTS = frozenset({Switch.VISITS, Switch.LAZY, Switch.VISITORS, Switch.TOGETHER})
_TURNS = (8, 16)  # how often ways may begin within the horizon
_FIRST, _BETTER = 15.0, 20.0  # seconds for a plan, and for better ones
_SHARE = 1 / 3  # of the time that is left may be spent on better ones


class StraightPlans:
    """Looks for answers by straight ways, one question after the other.

    What one of them found is where the next one begins.
    """

    def __init__(self, effort: Effort) -> None:
        self._effort = effort
        self._point: Point | None = None

    def flows(self, question: Question, encoded: Encoded, clock: Clock) -> Iterator[Floats]:
        """Flows of the `encoded` model: those of a plan, and of better ones if asked for."""
        values = self._again(question, encoded)
        if values is None:
            with suppress(Halted):  # the search of the whole problem hears of that by itself
                values = self._any(question, encoded, clock.within(_FIRST))
        if values is None:
            return
        yield from self._told(encoded)
        if not question.first:
            for _ in self._better(question, values, clock):
                yield from self._told(encoded)

    def _told(self, encoded: Encoded) -> Iterator[Floats]:
        flows = None if self._point is None else flows_in(encoded, self._point)
        if flows is not None:
            yield flows

    def _again(self, question: Question, encoded: Encoded) -> Floats | None:
        """The point that is known, where it answers this question too."""
        known = self._point
        if known is None or known.encoded.level != encoded.level:
            return None
        return start_in(_narrowed(question, known.encoded), known)

    def _any(self, question: Question, encoded: Encoded, clock: Clock) -> Floats | None:
        """Any point that there is, of ways that begin as seldom as that allows."""
        setting = replace(encoded.setting, clock=clock)
        setting = replace(setting, switches=setting.switches - _CUTS)
        for turns in _TURNS:
            with clock.timed("build"):
                straight = straightened(setting, max(setting.horizon // turns, 1))
                if straight is None:
                    return None
                restricted = tight(straight, encoded.level)
            narrow = _narrowed(question, restricted)
            # few moves leave little to be made whole
            target = Travel().target(straight, narrow)
            search = Search(narrow, target, self._effort, clock, lambda *_: None)
            try:
                values = search.minimise(first=True).values
            except SolverError:  # the whole problem is asked anyway
                continue
            if values is not None:
                self._keep(restricted, values)
                return values
        return None

    def _better(self, question: Question, values: Floats, clock: Clock) -> Iterator[None]:
        """Keep better and better points."""
        assert self._point is not None
        restricted, left = self._point.encoded, clock.left
        narrow = _narrowed(question, restricted)
        target = question.objective.target(restricted.setting, narrow)
        within = clock.within(_BETTER if left is None else min(_BETTER, _SHARE * left))
        for better in Kernel(narrow, target, self._effort, within).better(values):
            self._keep(restricted, better)
            yield

    def _keep(self, restricted: Encoded, values: Floats) -> None:
        count = restricted.model.size.columns
        values = np.where(restricted.model.integer, np.round(values[:count]), values[:count])
        self._point = Point(restricted, values, tight=True)


def _narrowed(question: Question, restricted: Encoded) -> Encoded:
    """The restricted model of what loses nothing that is to be kept."""
    narrow = question.kept.narrowed(restricted.setting, restricted)
    return question.objective.extended(narrow)
