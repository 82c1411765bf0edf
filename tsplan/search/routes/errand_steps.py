"""At which steps errands may begin: those that ask for the same witnesses do so together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tsplan.milp.model import Bools, Ints
from tsplan.search.routes.errands import Errand


@dataclass(frozen=True, eq=False)
class Steps:
    """The steps of events: errands that ask for the same witnesses are one event.

    An errand begins `later` steps after its `event`, which may be at the steps of its row that are
    `allowed`.
    """

    event: Ints
    later: Ints
    allowed: Bools

    @classmethod
    def of(cls, errands: Sequence[Errand]) -> Steps | None:
        """Those of some errands; None where they share witnesses in part.

        An errand without witnesses is an event of its own.
        """
        number_of: dict[int, int] = {}
        kept: list[tuple[Ints, Ints]] = []
        found = []
        for columns, steps in map(_in_order, errands):
            known = {number_of.get(column, len(kept)) for column in columns.tolist()} or {len(kept)}
            if len(known) > 1 or len(np.unique(columns)) < len(columns):
                return None
            number = known.pop()
            if number == len(kept):
                kept.append((columns, steps))
                number_of |= dict.fromkeys(columns.tolist(), number)
            same, base = kept[number]
            if not np.array_equal(columns, same) or len(np.unique(steps - base)) > 1:
                return None
            found.append((number, int(steps[0] - base[0])))
        allowed = np.zeros((len(kept), 1 + max(int(s.max()) for _, s in kept)), dtype=np.bool_)
        for number, (_, steps) in enumerate(kept):
            allowed[number, steps] = True
        event, later = np.array(found, dtype=np.int64).T
        return cls(event, later, allowed)

    def begins(self, steps: Ints) -> Ints:
        """The steps at which errands begin, from those of events."""
        return np.asarray(steps[self.event] + self.later)

    def possible(self, steps: Ints) -> bool:
        """Whether all events may be at these steps."""
        return bool(self.allowed[np.arange(len(steps)), steps].all())

    @cached_property
    def ends(self) -> tuple[Ints, Ints]:
        """The first and the last step of each event."""
        width = self.allowed.shape[1]
        return self.allowed.argmax(axis=1), width - 1 - self.allowed[:, ::-1].argmax(axis=1)

    @property
    def middle(self) -> Ints:
        """For each event the step in the middle of those that it may be at."""
        every = [np.flatnonzero(row) for row in self.allowed]
        return np.array([steps[len(steps) // 2] for steps in every])


def without_joint(errands: Sequence[Errand]) -> tuple[Errand, ...]:
    """The errands without those at several places that others at each of them come to."""
    return tuple(each for each in errands if not _joint(each, errands))


def _joint(errand: Errand, others: Sequence[Errand]) -> bool:
    parts = (
        other.amount
        for other in others
        if len(other.states) == 1
        and np.isin(other.states, errand.states).all()
        and other.classes <= errand.classes
        and other.stay >= errand.stay
        and np.array_equal(other.columns, errand.columns)
        and np.array_equal(other.steps, errand.steps)
    )
    return len(errand.states) > 1 and sum(parts) >= errand.amount


def _in_order(errand: Errand) -> tuple[Ints, Ints]:
    """The columns of an errand in their order, and the steps it may begin at."""
    if not len(errand.columns):
        first, last = errand.ends
        return errand.columns, np.arange(first, last + 1)
    order = np.argsort(errand.columns, kind="stable")
    return errand.columns[order], errand.steps[order]
