"""How many agents are where, so far and from now on if all goes on as it is taken to.

Only states that the atoms of formulas count at are kept.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import inf
from types import MappingProxyType

import numpy as np

from tsplan.errors import Finding, InputError, nearest
from tsplan.logic import Count, Execution, Formula, Not
from tsplan.logic.traces import Floats, Values
from tsplan.mission import Mission
from tsplan.monitoring.fleet import Shift
from tsplan.monitoring.margin_network import Span
from tsplan.parameters import whole
from tsplan.plans.plan import Plan
from tsplan.plans.presence import of_groups, state_counts
from tsplan.plans.supplies import execution_tables

_REDUCED: Mapping[str, np.ufunc] = MappingProxyType(
    {"sum": np.add, "min": np.minimum, "max": np.maximum}
)


@dataclass(frozen=True, eq=False)
class _Measured:
    """A count: the table it is read from, and the rows of its states there."""

    atom: Count
    rows: Values

    def margins(self, table: Values, span: Span) -> Floats:
        """By how much it holds at some steps."""
        there = table[self.rows, span.first : span.last + 1]
        counts = _REDUCED[self.atom.function].reduce(there, axis=0).astype(np.float64)
        bound = float(self.atom.bound)  # type: ignore[arg-type]  # percentages are resolved
        return np.asarray(bound - counts if self.atom.upper else counts - bound)

    def decided(self, agents: int) -> bool | None:
        """What is certain of it whatever so many agents do, if that is anything."""
        states = self.rows.size
        most = {"sum": agents, "max": agents, "min": agents // states}[self.atom.function]
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
        self._row = {state: row for row, state in enumerate(self._states)}
        named = {None, *(atom.capability for atom in counts)}
        self._tables = {name: plan.tallied(self._states, name) for name in named}
        self.agents = {name: mission.having(name) for name in named}
        self.atoms = {
            atom: _Measured(atom, np.array([self._row[state] for state in labels[atom.label]]))
            for atom in counts
        }
        self._watching: dict[tuple[str | None, int], list[Count]] = {}
        for atom, measured in self.atoms.items():
            for row in measured.rows.tolist():
                self._watching.setdefault((atom.capability, row), []).append(atom)
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
            able = [n for n in self._tables if n is None or n in shift.capabilities]
            for stays, change in ((shift.former, -1), (shift.latter, 1)):
                for first, last, state in stays:
                    self._add(state, Span(first, last), able, change)
            if shift.lost:
                lost = True
                for name in able:
                    self.agents[name] -= 1
        return lost

    def refuse(self, swarms: Mapping[str, Mapping[str, int]], states: Sequence[str]) -> None:
        """Raise InputError with everything that is wrong with numbers of agents of swarms."""
        wrong = [finding for item in swarms.items() for finding in self._faults(*item, states)]
        if wrong:
            raise InputError(wrong)

    def report(self, swarms: Mapping[str, Mapping[str, int]], now: int) -> None:
        """Say how many agents of swarms are at which states at a step; nobody at any other."""
        for name, there in swarms.items():
            for state, row in self._row.items():
                change = int(there.get(state, 0)) - int(self._swarms[name][row, now])
                able = [n for n in self._tables if n is None or n == name]
                if change:
                    self._swarms[name][row, now] += change
                    self._add(state, Span(now, now), able, change)

    def changes(self) -> dict[Count, Span]:
        """Atoms whose counts have changed since this was asked last, and at which steps."""
        changed, self._changed = self._changed, {}
        return changed

    def margins(self, atom: Count, span: Span) -> Floats:
        """By how much an atom holds at some steps."""
        return self.atoms[atom].margins(self._tables[atom.capability], span)

    def _add(self, state: str, span: Span, able: Iterable[str | None], change: int) -> None:
        row = self._row.get(state)
        if row is None:
            return
        for name in able:
            self._tables[name][row, span.first : span.last + 1] += change
            for atom in self._watching.get((name, row), ()):
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
    uses = ((use.task, use.state, use.step) for use in plan.executions)
    states = tuple(mission.system.states)
    tables = execution_tables(uses, states, plan.horizon)
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
