"""Who is to keep which appointment from when on, and what changes of that can be tried."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.routing.appointments import Agenda, Need
from tsplan.routing.duties import Duties

Serving: TypeAlias = "tuple[tuple[int, ...], ...]"
"""The agents of every need of an appointment."""


class Member(NamedTuple):
    """An agent and the number of its class."""

    agent: int
    kind: int


@dataclass(frozen=True, eq=False)
class Engagements:
    """The beginning of every appointment and the agents of its needs, on a map of some states."""

    agenda: Agenda
    states: int
    times: tuple[int, ...]
    serving: tuple[Serving, ...]

    def of(self, agent: int) -> Iterator[tuple[int, Need]]:
        """The appointments of an agent by their numbers, and for which needs."""
        for number, groups in enumerate(self.serving):
            for need, agents in zip(self.agenda.appointments[number].needs, groups, strict=True):
                if agent in agents:
                    yield number, need

    def duties(self, agent: int) -> Duties:
        """Where an agent has to be, and when."""
        found: Duties = {}
        for number, need in self.of(agent):
            mask = np.zeros(self.states, dtype=np.bool_)
            mask[list(need.states)] = True
            for after in need.after:
                step = self.times[number] + after
                found[step] = mask & found[step] if step in found else mask
        return found

    def agents(self, number: int) -> list[int]:
        """The agents of an appointment."""
        return sorted({agent for agents in self.serving[number] for agent in agents})

    def shifted(self, numbers: Sequence[int], later: int) -> Engagements | None:
        """With some appointments that begin so many steps later; None where one must not."""
        times = list(self.times)
        for number in numbers:
            times[number] += later
            item = self.agenda.appointments[number]
            if not item.first <= times[number] <= item.last:
                return None
        return replace(self, times=tuple(times))

    def swapped(self, one: Member, other: Member, since: int, until: int) -> Engagements | None:
        """With two agents in each other's place at all appointments that begin in some steps.

        None where one of them cannot take a place of the other.
        """
        turned = {one.agent: other, other.agent: one}
        serving = list(self.serving)
        for number, time in enumerate(self.times):
            if not since <= time <= until:
                continue
            needs = self.agenda.appointments[number].needs
            for need, agents in zip(needs, self.serving[number], strict=True):
                if any(a in turned and turned[a].kind not in need.able for a in agents):
                    return None
            serving[number] = tuple(
                tuple(turned[agent].agent if agent in turned else agent for agent in agents)
                for agents in self.serving[number]
            )
        return replace(self, serving=tuple(serving))
