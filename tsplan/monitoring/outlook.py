"""Formulas on what has happened so far, and on what is to be expected from here on."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import inf

import numpy as np

from tsplan.logic import Count, Formula, Not, walk, walk_all
from tsplan.logic.settled import settled
from tsplan.logic.traces import Floats
from tsplan.mission import Mission
from tsplan.monitoring.decisions import FAILS, HOLDS, OPEN, Decisions
from tsplan.monitoring.expected_counts import ExpectedCounts, execution_margins
from tsplan.monitoring.fleet import Shift
from tsplan.monitoring.lateness_runs import LatenessRuns
from tsplan.monitoring.margin_network import AVAILABILITY, LATENESS, ROWS, MarginNetwork, Span
from tsplan.monitoring.verdict import Slack
from tsplan.plans.plan import Plan


@dataclass(eq=False)
class _Atom:
    """An atom, or a negated one, and its two values at the steps up to the last it matters at."""

    node: Formula
    values: Floats  # (rows, steps)
    runs: LatenessRuns
    first: int  # the first step it matters at

    def holds(self, step: int) -> bool:
        """Whether it holds at a step."""
        return bool(self.values[AVAILABILITY, step] >= 0)

    @property
    def last(self) -> int:
        """The last step it matters at."""
        return int(self.values.shape[1]) - 1


class Outlook:
    """What some formulas, in positive normal form, are worth along a plan as it is carried out."""

    def __init__(self, mission: Mission, plan: Plan, goals: Iterable[Formula]) -> None:
        self._goals = tuple(dict.fromkeys(goals))
        leaves = [n for n in walk_all(self._goals) if not n.children or isinstance(n, Not)]
        self._decisions = Decisions(self._goals)
        self._network = MarginNetwork(self._goals)
        self._counts = ExpectedCounts(mission, plan, leaves)
        executed = execution_margins(mission, plan, leaves)
        self._atoms: dict[Formula, _Atom] = {}
        # atoms with runs that begin at a step to come
        self._starting: dict[int, set[_Atom]] = defaultdict(set)
        for leaf in leaves:
            span = self._decisions.span(leaf)
            if span[0] <= span[1]:
                self._enter(leaf, Span(*span), executed)
        self._open = {goal: frozenset(walk(goal)) for goal in self._goals}
        self._begins: dict[int, list[_Atom]] = defaultdict(list)
        for atom in self._atoms.values():
            self._begins[atom.first].append(atom)
        self._now: dict[Formula, _Atom] = {}  # atoms that the present step may matter to
        self._bound(-1)
        self._settle()

    def truth(self, goal: Formula) -> int:
        """What is decided of a formula."""
        return self._decisions.truth(goal)

    def slack(self, goal: Formula) -> Slack:
        """What a formula has to spare if all goes on as expected."""
        return Slack(*self._network.value(goal))

    def refuse(self, counts: Mapping[str, Mapping[str, int]], states: Sequence[str]) -> None:
        """Raise InputError for numbers of agents of swarms that cannot be."""
        self._counts.refuse(counts, states)

    def advance(
        self, now: int, shifts: Sequence[Shift], counts: Mapping[str, Mapping[str, int]]
    ) -> None:
        """Go on to the next step, at which agents are elsewhere than was expected."""
        lost = self._counts.shift(shifts)
        self._counts.report(counts, now)
        for count, span in self._counts.changes().items():
            self._measure(count, span, now)
        for atom in self._begins.pop(now, ()):
            self._now[atom.node] = atom
        for atom in list(self._now.values()):
            self._decisions.note(atom.node, now, now, HOLDS if atom.holds(now) else FAILS)
            if now >= atom.last:
                del self._now[atom.node]
        for atom in self._starting.pop(now, ()):
            begun = atom.runs.begun(now)
            if begun is not None:
                self._late(atom, *begun)
        if lost:
            self._bound(now)
        self._settle()

    def _enter(self, leaf: Formula, span: Span, executed: Mapping[Formula, Floats]) -> None:
        """Take up an atom with its values along the plan."""
        steps = Span(0, span.last)
        known = settled(leaf)
        if known is not None:
            margins = np.full(span.last + 1, float(known.margin))
        elif isinstance(leaf, Count):
            margins = self._counts.atoms[leaf].margins(steps)
        else:
            margins = executed[leaf][: span.last + 1]
        values = np.full((ROWS, margins.size), -inf)
        values[AVAILABILITY] = margins
        atom = _Atom(leaf, values, LatenessRuns(margins >= 0), span.first)
        self._refresh(atom, 0, margins, 0)
        if known is None:
            self._atoms[leaf] = atom

    def _measure(self, count: Count, span: Span, now: int) -> None:
        """Read an atom anew where its counts have changed."""
        atom = self._atoms.get(count)
        if atom is None:
            return
        span = span.within(Span(0, atom.last))
        if span.empty:
            return
        margins = self._counts.atoms[count].margins(span)
        atom.values[AVAILABILITY, span.first : span.last + 1] = margins
        self._network.tell(count, span.first, atom.values[:, span.first : span.last + 1])
        self._refresh(atom, span.first, margins, now)

    def _refresh(self, atom: _Atom, first: int, margins: Floats, now: int) -> None:
        """Find the runs of an atom anew whose margins have changed from a step on."""
        self._late(atom, *atom.runs.refresh(first, margins >= 0, now))
        for step in atom.runs.starts(first, first + margins.size + 1).tolist():
            if step > now:
                self._starting[step].add(atom)

    def _late(self, atom: _Atom, first: int, late: Floats) -> None:
        end = first + late.size
        atom.values[LATENESS, first:end] = late
        self._network.tell(atom.node, first, atom.values[:, first:end])

    def _bound(self, now: int) -> None:
        """Decide what is certain of all steps to come by how many agents there are."""
        for count, measured in self._counts.atoms.items():
            certain = measured.decided(self._counts.agents[count.capability])
            if certain is not None and count in self._atoms:
                truth = HOLDS if certain else FAILS
                self._decisions.note(count, now + 1, self._atoms[count].last, truth)

    def _settle(self) -> None:
        """Draw the conclusions, and forget atoms that matter to nothing that is open any more."""
        self._network.settle()
        self._decisions.settle()
        decided = [goal for goal in self._open if self._decisions.truth(goal) != OPEN]
        if not decided:
            return
        for goal in decided:
            del self._open[goal]
        needed = frozenset[Formula]().union(*self._open.values())
        self._now = {node: atom for node, atom in self._now.items() if node in needed}
        for step, atoms in self._begins.items():
            self._begins[step] = [atom for atom in atoms if atom.node in needed]
