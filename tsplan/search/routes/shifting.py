"""Better steps for errands, by simulated annealing over the steps themselves.

With a step for every errand the least cost is that of a small program. An errand that is begun at
another step drags those along that are linked to it, as far as they are too close to it then and
their windows allow: so most links go on. The program's prices tell which links that cannot be made
would be worth something, and errands are shifted to make one of these. What is better is kept, and
what is worse now and then: the less often, the longer the search takes (Kirkpatrick, Gelatt and
Vecchi, 1983). Nothing here proves anything.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.model import Floats, Ints
from tsplan.milp.what_if import Answer, WhatIf
from tsplan.search.routes.errand_steps import Steps
from tsplan.search.routes.link_program import LinkProgram

_TURNS = 250  # shifts that are tried for each errand while it grows cold
_HOT, _COLD = 0.3, 0.015  # parts of what an errand costs that a change for the worse may cost
_AGAIN = 0.15  # the heat of all rounds but the first, as a part of the first one's
_LINKED = 0.5  # of the shifts are such that a link can be made
_DRAGGED = 0.8  # of the shifts drag others along
_NEAR = 4  # steps of a small shift
_SMALL = 0.6  # of the other shifts are small
_CHAIN = 20  # times that those who are dragged along drag others
_LITTLE = 1e-7


@dataclass(eq=False)
class Shifting:
    """Looks for steps of events at which a program costs little, as long as the clock allows.

    `steps` are the best ones so far, and `value` is what they cost.
    """

    program: LinkProgram
    errands: Steps
    clock: Clock
    steps: Ints
    value: float = field(default=np.inf, init=False)

    def __post_init__(self) -> None:
        links, count = self.program.links, len(self.program.errands)
        source = np.minimum(links.source, count - 1)
        self._begun = links.source >= count
        self._before = self.errands.event[source]
        self._after = self.errands.event[links.target]
        # between events
        gap = links.gap + self.errands.later[source] - self.errands.later[links.target]
        self._gap = np.asarray(gap)
        self._random = np.random.default_rng(0)
        self._asked = WhatIf(self.program.model)
        value = self._asked.ask(self.program.open(self.errands.begins(self.steps)))
        if value is not None:
            self.value = value
            self._answer = self._asked.keep()
            self._used = self._links(self._answer)

    # --- the search ------------------------------------------------------------------------------

    def rounds(self) -> Iterator[bool]:
        """Anneal again and again; whether that gained anything."""
        heat = 1.0
        while np.isfinite(self.value) and not self.clock.over:
            before = self.value
            self._anneal(heat)
            heat = _AGAIN
            yield self.value < before - _LITTLE

    def _anneal(self, heat: float) -> None:
        """Grow cold from some heat on; begins and ends with the best steps."""
        now = self.steps.copy()
        self._settle(now)
        turns = _TURNS * len(self.program.errands)
        value = self._answer.value
        each = value / len(self.program.errands)
        for turn in range(turns):
            if self.clock.over:
                break
            warmth = each * heat * _HOT * (_COLD / _HOT) ** (turn / turns)
            most = value + self._random.exponential(warmth)
            tried = self._shifted(now)
            if self._accepted(tried, most):
                now, value = tried, self._answer.value
                if value < self.value - _LITTLE:
                    self.steps, self.value = now.copy(), value

    def _settle(self, steps: Ints) -> None:
        """Go on from some steps."""
        self._asked.ask(self.program.open(self.errands.begins(steps)))
        self._take()

    def _take(self) -> None:
        self._answer = self._asked.keep()
        self._used = self._links(self._answer)

    def _accepted(self, steps: Ints, most: float) -> bool:
        """Whether events may be at other steps and that costs no more than `most`."""
        if not self.errands.possible(steps):
            return False
        wanted, now = self.program.open(self.errands.begins(steps)), self._asked.open
        answer = self._answer
        lost = answer.values[now & ~wanted].max(initial=0.0) > _LITTLE
        if not lost and answer.reduced[wanted & ~now].min(initial=0.0) > -_LITTLE:
            self._asked.change(wanted)  # the same flows are still the best
            return True
        if self._asked.ask(wanted, most) is None:
            self._asked.drop()
            return False
        self._take()
        return True

    def _links(self, answer: Answer) -> Ints:
        """The links between errands that are used."""
        values = answer.values[: len(self._begun)]
        return np.flatnonzero((values > _LITTLE) & ~self._begun)

    # --- shifts ----------------------------------------------------------------------------------

    def _shifted(self, steps: Ints) -> Ints:
        """Other steps: some errand is shifted, and maybe others with it."""
        random = self._random
        linked = self._linked(steps) if random.random() < _LINKED else None
        if linked is None:
            tried = steps.copy()
            event = int(random.integers(len(steps)))
            first, last = (int(end[event]) for end in self.errands.ends)
            if random.random() < _SMALL:
                first = max(first, int(steps[event]) - _NEAR)
                last = min(last, int(steps[event]) + _NEAR)
            tried[event] = random.integers(first, last + 1)
            linked = tried, {event}
        tried, moved = linked
        return self._dragged(tried, moved) if random.random() < _DRAGGED else tried

    def _linked(self, steps: Ints) -> tuple[Ints, set[int]] | None:
        """Steps at which some link can be made that is worth something, and what was shifted."""
        reduced = self._answer.reduced[: len(self._begun)]
        worth = ~self._asked.open[: len(self._begun)] & (reduced < -_LITTLE) & ~self._begun
        links = np.flatnonzero(worth & (self._before != self._after))
        if not len(links):
            return None
        link = int(links[_drawn(-reduced[links], self._random)])
        before, after = int(self._before[link]), int(self._after[link])
        lacking = int(steps[before] + self._gap[link] - steps[after])
        first, last = self.errands.ends
        sooner = min(lacking, int(steps[before] - first[before]))
        later = min(lacking, int(last[after] - steps[after]))
        if lacking <= 0 or sooner + later < lacking:
            return None
        part = int(self._random.integers(lacking - sooner, later + 1))
        tried = steps.copy()
        tried[after] += part
        tried[before] -= lacking - part
        return tried, {before, after}

    def _dragged(self, steps: Ints, moved: set[int]) -> Ints:
        """Shift what is linked to those that have moved, as far as it has to be and may be."""
        used = self._used
        before, after, gap = self._before[used], self._after[used], self._gap[used]
        for _ in range(_CHAIN):
            late = np.flatnonzero(steps[before] + gap > steps[after])
            ends = (part[late].tolist() for part in (before, after, gap))
            gone = [self._drag(steps, moved, *link) for link in zip(*ends, strict=True)]
            if not any(gone):
                break
        return steps

    def _drag(self, steps: Ints, moved: set[int], before: int, after: int, gap: int) -> bool:
        """Shift one of two events that are too close together; whether that was possible."""
        lacking = int(steps[before]) + gap - int(steps[after])
        if lacking <= 0 or (before in moved and after in moved):
            return False
        sooner = after in moved or (before not in moved and self._random.random() < 1 / 2)
        event = before if sooner else after
        first, last = (int(end[event]) for end in self.errands.ends)
        step = int(steps[event])
        to = max(step - lacking, first) if sooner else min(step + lacking, last)
        steps[event] = to
        moved.add(event)
        return to != step


def _drawn(weights: Floats, random: np.random.Generator) -> int:
    """A place, the likelier the larger its weight is."""
    total = np.cumsum(weights)
    return int(min(np.searchsorted(total, random.random() * total[-1]), len(weights) - 1))
