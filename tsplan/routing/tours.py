"""Who keeps which appointments, where and when, as if nobody were in anybody's way.

Every agent goes from one of its appointments to the next, in one order of all appointments. A few
appointments at a time are taken out of that order and put in again where they cost least, which is
kept unless it is worse.

Source: P. Shaw, "Using constraint programming and local search methods to solve vehicle routing
problems", CP 1998 (large-neighbourhood search); here several agents meet at each stop.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import ceil, isfinite
from typing import TypeAlias

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.model import Floats, Ints
from tsplan.routing.appointments import Agenda, Need
from tsplan.routing.distances import Distances

_MOST = 3  # appointments that are taken out at once
_WORSE = 0.05  # part of the length by which worse tours may be gone on with
_SPARE = 10.0  # steps that are worth a whole way of spare time, however short the way

Posts: TypeAlias = "tuple[tuple[tuple[int, int], ...], ...]"
"""The agents of every need of an appointment, each with its state."""


@dataclass(frozen=True)
class Tours:
    """Appointments in an order, the agents that keep each of them, and how far these go."""

    order: tuple[int, ...] = ()
    serving: Mapping[int, Posts] = field(default_factory=dict)
    length: float = 0.0


@dataclass(frozen=True, eq=False)
class TourPlanner:
    """Plans tours of agents; places hold as many of an appointment as there is `room` for.

    Ways are taken to last longer by a part `spare` of them, and by ten times as many steps.
    """

    agenda: Agenda
    distances: Distances
    room: Mapping[int, int]
    spare: float = 0.0
    seed: int = 0

    def _far(self, agent: int, before: int, after: int) -> float:
        """How much an agent's way from place to place costs."""
        return float(self.distances.prices[self.distances.kind[agent], before, after])

    def _long(self, agent: int, before: int, after: int) -> float:
        """How many steps it is taken to last."""
        steps = float(self.distances.steps[self.distances.kind[agent], before, after])
        return steps + self.spare * (steps + _SPARE) if steps else 0.0

    # --- times -----------------------------------------------------------------------------------

    def times(self, tours: Tours) -> dict[int, int] | None:
        """When each appointment begins at the earliest; None where one would be too late."""
        at = self.distances.begin.tolist()
        free = [0] * len(at)
        times: dict[int, int] = {}
        for number in tours.order:
            item = self.agenda.appointments[number]
            begins = item.first
            stops = list(zip(item.needs, tours.serving[number], strict=True))
            for need, group in stops:
                for agent, state in group:
                    far = self._long(agent, at[agent], self.distances.place[state])
                    if not isfinite(far):
                        return None
                    begins = max(begins, free[agent] + ceil(far) - need.after[0])
            if begins > item.last:
                return None
            times[number] = begins
            for need, group in stops:
                for agent, state in group:
                    free[agent], at[agent] = begins + need.after[-1], self.distances.place[state]
        return times

    # --- tours -----------------------------------------------------------------------------------

    def best(self, clock: Clock, patience: int) -> Tours | None:
        """The shortest tours that are found, until so many attempts in a row did not help."""
        random = np.random.default_rng(self.seed)
        items = self.agenda.appointments
        everything = sorted(range(len(items)), key=lambda number: (items[number].last, number))
        now = best = self._with(Tours(), everything)
        idle = 0
        while idle < patience and not clock.over:
            idle += 1
            if now is None or best is None:
                random.shuffle(everything)
                now = best = self._with(Tours(), everything)
                continue
            size = min(int(random.integers(1, _MOST + 1)), len(items))
            out = random.choice(len(items), size, replace=False).tolist()
            tried = self._with(self._without(now, out), out)
            if tried is None:
                continue
            if tried.length < best.length:
                best, idle = tried, 0
            if tried.length <= now.length + _WORSE * best.length * random.random():
                now = tried
        return best

    def _without(self, tours: Tours, out: Sequence[int]) -> Tours:
        order = tuple(number for number in tours.order if number not in out)
        return self._measured(order, {number: tours.serving[number] for number in order})

    def _measured(self, order: tuple[int, ...], serving: Mapping[int, Posts]) -> Tours:
        at = self.distances.begin.tolist()
        length = 0.0
        for number in order:
            for group in serving[number]:
                for agent, state in group:
                    place = self.distances.place[state]
                    length += self._far(agent, at[agent], place)
                    at[agent] = place
        return Tours(order, serving, length)

    def _with(self, tours: Tours, more: Sequence[int]) -> Tours | None:
        """The tours with more appointments, one after the other where it costs least."""
        for number in more:
            found = [
                tried
                for place in range(len(tours.order) + 1)
                if (tried := self._inserted(tours, number, place)) is not None
            ]
            if not found:
                return None
            tours = min(found, key=lambda each: each.length)
        return tours

    def _inserted(self, tours: Tours, number: int, place: int) -> Tours | None:
        """The tours with one more appointment at a place in the order, if all are in time."""
        before, after = tours.order[:place], tours.order[place:]
        last, then = self.distances.begin.copy(), np.full(len(self.distances.begin), -1)
        for each in before:
            for agent, state in (pair for group in tours.serving[each] for pair in group):
                last[agent] = self.distances.place[state]
        for each in after[::-1]:
            for agent, state in (pair for group in tours.serving[each] for pair in group):
                then[agent] = self.distances.place[state]
        chosen = self._chosen(number, last, then)
        if chosen is None:
            return None
        tried = self._measured((*before, number, *after), {**tours.serving, number: chosen})
        return None if self.times(tried) is None else tried

    def _chosen(self, number: int, last: Ints, then: Ints) -> Posts | None:
        """The agents that can keep an appointment with the least detours, and where.

        A state holds as many of them as its capacity says.
        """
        taken: set[int] = set()
        full: Counter[int] = Counter()
        serving = []
        for need in self.agenda.appointments[number].needs:
            detours = self._detours(need, last, then)
            group: list[tuple[int, int]] = []
            for position in np.argsort(detours, axis=None, kind="stable").tolist():
                if len(group) == need.many:
                    break
                agent, column = divmod(position, len(need.states))
                state = need.states[column]
                if not isfinite(detours[agent, column]):
                    return None
                if agent not in taken and full[state] < self.room.get(state, len(last)):
                    group.append((agent, state))
                    taken.add(agent)
                    full[state] += 1
            if len(group) < need.many:
                return None
            serving.append(tuple(group))
        return tuple(serving)

    def _detours(self, need: Need, last: Ints, then: Ints) -> Floats:
        """By how much each agent's tour gets longer by each state of a need."""
        kind, ways = self.distances.kind, self.distances.prices
        places = self.distances.places(need.states)
        found = ways[kind[:, None], last[:, None], places]
        on = np.flatnonzero(then >= 0)
        back = ways[kind[on, None], places, then[on, None]]
        found[on] += back - ways[kind[on], last[on], then[on]][:, None]
        found[~np.isin(kind, list(need.able))] = np.inf
        return np.asarray(found)
