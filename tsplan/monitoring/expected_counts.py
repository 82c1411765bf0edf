"""How many agents are where, so far and from now on if all goes on as it is taken to.

Only states that the atoms of formulas count at are kept.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import inf

import numpy as np

from tsplan.errors import Finding, InputError, nearest
from tsplan.logic import Count, Execution, Formula, Not
from tsplan.logic.traces import Floats
from tsplan.milp.model import Ints
from tsplan.mission import Mission
from tsplan.monitoring.able_counts import AbleCounts
from tsplan.monitoring.fleet import Shift
from tsplan.monitoring.margin_network import Span
from tsplan.parameters import whole
from tsplan.plans.plan import Plan
from tsplan.plans.presence import of_groups, state_counts
from tsplan.plans.supplies import execution_tables


@dataclass(frozen=True, eq=False)
class _Measured:
    """A count, and how many agents with its capability are at each of some places when.

    A place is one state with the label, or where they are added up, all of them.
    """

    atom: Count
    states: int
    table: Ints  # (places, steps)

    def margins(self, span: Span) -> Floats:
        """By how much it holds at some steps."""
        there = self.table[:, span.first : span.last + 1]
        reduced = there.max(axis=0) if self.atom.function == "max" else there.min(axis=0)
        bound = self.atom.bound
        assert isinstance(bound, int)
        return np.asarray(bound - reduced if self.atom.upper else reduced - bound, np.float64)

    def decided(self, agents: int) -> bool | None:
        """What is certain of it whatever so many agents do, if that is anything."""
        most = agents // self.states if self.atom.function == "min" else agents
        bound = self.atom.bound
        assert isinstance(bound, int)
        if self.atom.upper:
            return True if bound >= most else False if bound < 0 else None
        return True if bound <= 0 else False if bound > most else None


class ExpectedCounts:
    """The counts of a plan's agents at the steps up to its horizon, for some atoms."""

    def __init__(self, mission: Mission, plan: Plan, atoms: Iterable[Formula]) -> None:
        counts = [atom for atom in atoms if isinstance(atom, Count)]
        labels = mission.system.labels
        watched = {state for atom in counts for state in labels[atom.label]}
        self._states = tuple(state for state in mission.system.states if state in watched)
        named = {None, *(atom.capability for atom in counts)}
        self._able = AbleCounts(mission, plan)
        self.agents = {name: self._able.of(name) for name in named}
        rows = {state: row for row, state in enumerate(self._states)}
        tables = {name: np.asarray(plan.tallied(self._states, name), np.int64) for name in named}
        self.atoms: dict[Count, _Measured] = {}
        self._watching: dict[str, list[tuple[Count, Ints]]] = defaultdict(list)
        for atom in counts:
            states = labels[atom.label]
            table = tables[atom.capability][[rows[state] for state in states]]  # of its own
            added = atom.function == "sum"
            table = table.sum(axis=0, keepdims=True) if added else table
            self.atoms[atom] = _Measured(atom, len(states), table)
            for number, state in enumerate(states):
                self._watching[state].append((atom, table[0 if added else number]))
        self._changed: dict[Count, Span] = {}
        self._swarms = {
            name: state_counts(
                of_groups(group for group in plan.groups if group.swarm == name),
                self._states,
                plan.horizon,
            )
            for name in dict.fromkeys(group.swarm for group in plan.groups)
        }

    def shift(self, shifts: Iterable[Shift]) -> bool:
        """Change where agents are; whether some of them are lost."""
        lost = False
        for shift in shifts:
            for stays, change in ((shift.former, -1), (shift.latter, 1)):
                for first, last, state in stays:
                    self._add(state, Span(first, last), shift.capabilities, change)
            if shift.lost:
                lost = True
                self._able.lose(shift.lost)
        if lost:
            self.agents = {name: self._able.of(name) for name in self.agents}
        return lost

    def refuse(self, swarms: Mapping[str, Mapping[str, int]], states: Sequence[str]) -> None:
        """Raise InputError with everything that is wrong with numbers of agents of swarms."""
        wrong = [finding for item in swarms.items() for finding in self._faults(*item, states)]
        if wrong:
            raise InputError(wrong)

    def report(self, swarms: Mapping[str, Mapping[str, int]], now: int) -> None:
        """Say how many agents of swarms are at which states at a step; nobody at any other."""
        for name, there in swarms.items():
            for row, state in enumerate(self._states):
                change = int(there.get(state, 0)) - int(self._swarms[name][row, now])
                if change:
                    self._swarms[name][row, now] += change
                    self._add(state, Span(now, now), (name,), change)

    def changes(self) -> dict[Count, Span]:
        """Atoms whose counts have changed since this was asked last, and at which steps."""
        changed, self._changed = self._changed, {}
        return changed

    def _add(self, state: str, span: Span, able: Container[str], change: int) -> None:
        for atom, counts in self._watching.get(state, ()):
            if atom.capability is None or atom.capability in able:
                counts[span.first : span.last + 1] += change
                known = self._changed.get(atom)
                self._changed[atom] = span if known is None else known.hull(span)

    def _faults(
        self, name: str, there: Mapping[str, int], known: Sequence[str]
    ) -> Iterable[Finding]:
        if name not in self._swarms:
            yield Finding(f"the plan has no swarm '{name}'", nearest(name, self._swarms))
            return
        for state, count in there.items():
            if state not in known:
                yield Finding(f"the map has no state '{state}'", nearest(state, known))
            elif (number := whole(count)) is None or number < 0:
                what = f"{count} agents of {name} are at {state}"
                yield Finding(what, "give a whole number from 0")


def execution_margins(
    mission: Mission, plan: Plan, atoms: Iterable[Formula]
) -> dict[Formula, Floats]:
    """Whether tasks are executed, as the plan says, for atoms of that and for negated ones."""
    states = tuple(mission.system.states)
    tables = execution_tables(plan.executions, states, plan.horizon)
    number = {state: row for row, state in enumerate(states)}
    found: dict[Formula, Floats] = {}
    for atom in atoms:
        inner = atom.child if isinstance(atom, Not) else atom
        if not isinstance(inner, Execution):
            continue
        rows = [number[state] for state in mission.system.labels[inner.label]]
        none = np.zeros((len(states), plan.horizon + 1), dtype=np.bool_)
        done = np.asarray(tables.get(inner.task, none))[rows].all(axis=0)
        found[atom] = np.where(done != isinstance(atom, Not), inf, -inf)
    return found
