"""Who of a plan is where at a step: how many, and the first few by their ids."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from tsplan.explanation.why.stock_lines import StockLine, stock_lines
from tsplan.plans.agent_plans import state_in
from tsplan.plans.summary import names

if TYPE_CHECKING:
    from tsplan.logic.atoms import Count
    from tsplan.logic.traces import CountTrace
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

MOST_IDS = 4
"""Agents that are named at one state; more are only counted."""


@dataclass(frozen=True, slots=True)
class Presence:
    """Agents at one state: how many (or are expected), and the first few of them.

    Structures are named with their modules.
    """

    state: str
    count: float
    ids: tuple[str, ...]


@dataclass(frozen=True)
class Staff:
    """Who is where in a plan."""

    plan: Plan
    mission: Mission
    trace: CountTrace

    @cached_property
    def stocks(self) -> tuple[StockLine, ...]:
        """What lies where, what is taken and who brought it."""
        return stock_lines(self.plan, self.mission)

    def present(self, atom: Count, step: int | None) -> tuple[Presence, ...]:
        """Who is at the states with an atom's label at a step; nobody if there is none."""
        if step is None:
            return ()
        states = self.mission.system.labels[atom.label]
        there = self.trace.at(atom.label, atom.capability, upper=atom.upper)
        counts = there[:, step].tolist()
        ids: dict[str | None, list[str]] = {state: [] for state in states}
        for body in self.plan.structures:
            if atom.capability is None or atom.capability in body.capabilities:
                known = ids.get(body.state_at(step), [])
                known += [f"{body.id} ({names(body.modules)})"][: MOST_IDS - len(known)]
        for bundle in self.plan.robots:
            if atom.capability is None or atom.capability in bundle.capabilities:
                known = ids.get(state_in(bundle.stays, step), [])
                known += bundle.agents[: MOST_IDS - len(known)]
        return tuple(
            Presence(state, count, tuple(ids[state]))
            for state, count in zip(states, counts, strict=True)
        )
