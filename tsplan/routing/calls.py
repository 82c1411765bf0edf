"""The steps of appointments at which routes of single agents are asked to be somewhere.

A need of an appointment asks for agents at each of its steps. Of a stay two of them tell most: who
is there when it begins and who is there when it ends. Mostly that is the same agent, and then it
was there as long as the stay lasts; but agents may relieve each other in between.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from tsplan.milp.model import Floats, Ints
from tsplan.routing.appointments import Agenda, Need
from tsplan.routing.distances import Distances

MOST = 62
"""Calls up to which routes are looked for: sets of them are whole numbers of 64 bits."""


@dataclass(frozen=True)
class Call:
    """A need of the appointment with a number, and one of its steps after the beginning."""

    appointment: int
    need: Need
    after: int


def calls_of(agenda: Agenda, *, ends: bool = True) -> tuple[Call, ...]:
    """The beginning of every stay and, with `ends`, its end, unless that would be too many."""
    needs = [(n, need) for n, item in enumerate(agenda.appointments) for need in item.needs]
    both = tuple(
        Call(number, need, after)
        for number, need in needs
        for after in dict.fromkeys((need.after[0], need.after[-1]))
    )
    if ends and len(both) <= MOST:
        return both
    return tuple(Call(number, need, need.after[0]) for number, need in needs)


def apart(calls: Sequence[Call]) -> Floats:
    """How many steps are between two calls of one agent, at least; infinite if never.

    All calls of an appointment are counted from the same step.
    """
    of, after = (np.array([getattr(call, name) for call in calls]) for name in _TOLD)
    later = (after - after[:, None]).astype(np.float64)
    later[later < 0] = np.inf
    return np.where(of[:, None] == of, later, 0.0)


def joined(calls: Sequence[Call], kind: int, distances: Distances) -> Ints:
    """The same number for both ends of a stay between which an agent answers no other call.

    It is so where there is no time to go anywhere else and back, for agents of a class.
    """
    able = [number for number, call in enumerate(calls) if kind in call.need.able]
    found = np.arange(len(calls))
    for first, last in pairwise(able):
        one, other = calls[first], calls[last]
        if one.need is not other.need:
            continue
        here = distances.places(one.need.states)
        rest = {s for n in able if n not in (first, last) for s in calls[n].need.states}
        there = distances.places(sorted(rest))
        away = distances.steps[kind][np.ix_(here, there)].min(axis=0, initial=np.inf)
        back = distances.steps[kind][np.ix_(there, here)].min(axis=1, initial=np.inf)
        if (away + back > other.after - one.after).all():
            found[last] = first
    return found


_TOLD = "appointment", "after"
