"""What forbids every trajectory and can be seen without a solver.

The intervals that signals can reach step by step (`tsplan.signals.reach`) say that a signal is
forced out of its bounds, or that a comparison cannot hold when it must.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.explanation.explanation import Fact, SoftConstraint
from tsplan.explanation.whynot.occurrences import Occurrence, occurrences
from tsplan.explanation.whynot.signal_constraints import bare, near, signal_bounds
from tsplan.explanation.whynot.signal_numbers import MAX, MIN, alike
from tsplan.explanation.whynot.soft_constraints import of_occurrence
from tsplan.logic import Always, And, Eventually, Formula, Linear, Or, positive
from tsplan.logic.text import number_text, sum_text
from tsplan.milp.model import INFINITY
from tsplan.signals.reach import Reach, reach
from tsplan.signals.synthesis import Synthesis

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tsplan.explanation.part_words import Wording
    from tsplan.explanation.whynot.occurrences import Way
    from tsplan.signals.signal_mission import SignalMission

_CLOSE = 1e-6  # what a solver forgives: intervals that miss by less prove nothing
_DIGITS = 6  # of a number that is measured


class _Where(NamedTuple):
    """A part that would have to hold at one of some steps, and can at none; the nearest of them.

    If `chosen`, others might hold in its place, and cannot either.
    """

    way: Way
    node: Formula
    steps: range
    step: int
    chosen: bool = False


@dataclass(frozen=True)
class Finders:
    """Looks for facts of one mission."""

    wording: Wording

    @property
    def _mission(self) -> SignalMission:
        mission: SignalMission = self.wording.mission
        return mission

    @cached_property
    def _reach(self) -> Reach:
        return reach(self._mission.system, self._mission.horizon)

    def facts(self) -> Iterator[Fact]:
        """Signals that are forced out of their bounds; else comparisons out of reach."""
        forced = next(self._forced(), None)
        if forced is not None:
            yield forced
            return
        yield from self._blocked()

    def _forced(self) -> Iterator[Fact]:
        """The first step at which a signal has no value left in its bounds."""
        low, high = self._reach.low, self._reach.high
        for step in np.flatnonzero((low > high).any(axis=0)).tolist():
            for row in np.flatnonzero(low[:, step] > high[:, step]).tolist():
                name = self._mission.system.names[row]
                ends = self._mission.system.signals[name]
                # whichever end was reached by the dynamics is not the bound itself
                above = low[row, step] > ends[MIN]
                place = MAX if above else MIN
                said = low[row, step] if above else high[row, step]
                text = (
                    f"at step {step} {name} is {'at least' if above else 'at most'} {_told(said)}, "
                    f"whatever is done before, and it may be {'at most' if above else 'at least'} "
                    f"{number_text(ends[place])}"
                )
                key = (alike(self._mission, name)[0], place)
                yield self._fact("bounds", text, [], SoftConstraint("signal", key))

    def _blocked(self) -> Iterator[Fact]:
        """Comparisons that would have to hold where signals cannot be."""
        plain = bare(self._mission, self._mission.formula, self._mission.system)
        setting = Synthesis(plain).setting()
        none = np.empty((0, self._mission.horizon + 1), dtype=np.int64)
        normal = near(plain.formula, plain.system)
        bound = OptimisticBound(normal, setting.atoms(none, 0.0, INFINITY))

        def best(node: Formula, step: int) -> float:
            return bound.best(near(node, plain.system), step)

        told: set[str] = set()
        for found in _blocked_parts(plain.formula, best):
            text = self._words(found)
            if text not in told:
                told.add(text)
                way = self.wording.conjunct(found.way) if found.chosen else found.way
                yield self._fact("reach", text, occurrences(plain.formula, way))

    def _fact(
        self, kind: str, text: str, parts: Iterable[Occurrence], *place: SoftConstraint
    ) -> Fact:
        """A fact about parts of the formula and all that bounds signals; of these one is named."""
        own = list(parts)
        bounds = (item for item in signal_bounds(self._mission) if item.kind != "limit")
        said = self.wording.parts({*map(of_occurrence, own), *bounds})
        where = self.wording.sources.place(own[0]) if own else self.wording.fact(place[0]).place
        return Fact(kind, text, where, said)

    def _words(self, found: _Where) -> str:
        first, last = found.steps[0], found.steps[-1]
        at = f"at step {first}" if first == last else f"at any of the steps {first}..{last}"
        atom = positive(found.node)
        if isinstance(atom, Linear):
            when = " there" if first == last else f", at step {found.step}"
            why = f"{self._reached(atom, found.step)}{when}"
        elif isinstance(atom, And):
            why = "its comparisons exclude each other"
        else:
            why = "signals cannot be where it needs them"
        words = f"{self.wording.text(Occurrence(found.way))} cannot hold {at}: {why}"
        if found.chosen:
            whole = self.wording.whole(found.way)
            return f"nothing that {whole} offers can hold, not even the nearest: {words}"
        return words

    def _reached(self, atom: Linear, step: int) -> str:
        """How far the sum of a comparison can go at a step."""
        low, high = self._reach.sides(atom.terms)
        wants_more = atom.relation in (">=", ">")
        side = high[step] if wants_more else low[step]
        return f"{sum_text(atom.terms)} is {'at most' if wants_more else 'at least'} {_told(side)}"


def _told(value: float) -> str:
    return number_text(round(float(value), _DIGITS))


def _blocked_parts(root: Formula, best: Callable[[Formula, int], float]) -> Iterator[_Where]:
    """The parts that forbid the formula, each as far down as it can be followed.

    `best` says by how much a part can hold at a step at most.
    """

    def below(here: _Where, number: int, steps: range, *, chosen: bool = False) -> _Where:
        child = here.node.children[number]
        nearest = max(steps, key=lambda step: best(child, step))
        steps = range(nearest, nearest + 1) if chosen else steps
        return _Where((*here.way, number), child, steps, nearest, here.chosen or chosen)

    waiting = [_Where((), root, range(1), 0)]
    while waiting:
        here = waiting.pop()
        node, steps = here.node, here.steps
        if best(node, here.step) >= -_CLOSE:
            continue
        if isinstance(node, Eventually):
            steps = range(steps[0] + node.low, steps[-1] + node.high + 1)
            waiting.append(below(here, 0, steps))
        elif isinstance(node, Always):
            asked = range(here.step + node.low, here.step + node.high + 1)
            first = next(step for step in asked if best(node.child, step) < -_CLOSE)
            waiting.append(below(here, 0, range(first, first + 1), chosen=len(steps) > 1))
        elif isinstance(node, Or):
            each = [below(here, number, steps, chosen=True) for number in range(len(node.children))]
            waiting.append(max(each, key=lambda one: best(one.node, one.step)))
        elif isinstance(node, And):
            each = [below(here, number, steps) for number in range(len(node.children))]
            failing = [one for one in each if best(one.node, one.step) < -_CLOSE]
            waiting += reversed(failing)
            if not failing:
                yield here
        else:
            yield here
