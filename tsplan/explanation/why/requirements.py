"""What the formula asks of the counts, and what the plan gives: one chart's data for each atom.

Everything here is computed by the evaluator from the counts of the plan, never from the solver.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias, cast

import numpy as np
import numpy.typing as npt

from tsplan.checking.fitting import refuse_misfit
from tsplan.checking.traffic import read_traffic
from tsplan.logic.atoms import Count, Linear
from tsplan.logic.catl import resolve_percent
from tsplan.logic.causes import Steps
from tsplan.logic.evaluation import margins
from tsplan.logic.nodes import And
from tsplan.logic.normal_form import positive
from tsplan.logic.obligations import JUDGED, Obligation, obligations
from tsplan.logic.simplification import simplify
from tsplan.logic.symbols import capabilities
from tsplan.logic.time_horizon import Span
from tsplan.logic.traces import SignalTrace
from tsplan.plans.count_traces import count_trace
from tsplan.plans.supplies import execution_tables

if TYPE_CHECKING:
    from tsplan.logic.nodes import Formula
    from tsplan.logic.traces import CountTrace, Trace
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

Ints: TypeAlias = npt.NDArray[np.int64]
Floats: TypeAlias = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Requirement:
    """One atom of the mission's goal, or of what it prefers, and the counts it speaks about.

    `counts` has the measured number at every step 0..horizon: agents at all states with the label
    together (`sum`), at the state with the fewest (`min`) or the most (`max`). `margins` is the
    atom's availability at every step. `windows` are the steps `(first, last)` at which the formula
    can ask for it, one for each place in the formula; `witness_steps` are the runs of steps at
    which the plan satisfies the formula by it, or comes nearest to it where it does not hold; empty
    where the plan takes another branch. `places` is the number of states with the label. `soft` is
    the name of the preferred formula that the atom belongs to, None for what has to hold.
    """

    atom: Count
    places: int
    counts: Ints
    margins: Floats
    windows: tuple[Span, ...]
    witness_steps: tuple[Span, ...]
    soft: str | None = None

    @property
    def label(self) -> str:
        """The label whose states are counted."""
        return self.atom.label

    @property
    def capability(self) -> str | None:
        """The capability that is counted; None for all agents."""
        return self.atom.capability

    @property
    def relation(self) -> str:
        """How the count is compared with the bound, `>=` or `<=`."""
        return self.atom.relation

    @property
    def bound(self) -> int:
        """The number of agents it is compared with."""
        return cast("int", self.atom.bound)  # a goal has no percentages

    @property
    def slack(self) -> float | None:
        """The least availability over the witness steps: agents to spare; None without any."""
        inside = [self.margins[first : last + 1].min() for first, last in self.witness_steps]
        return float(min(inside)) if inside else None

    @property
    def title(self) -> str:
        """The atom in words, as short as it can be said.

        Over one state alone `sum`, `min` and `max` are the same and read the same.
        """
        who = self.atom.capability or "agents"
        every = {"sum": "at", "min": "at every", "max": "at any"}
        where = every[self.atom.function] if self.places > 1 else "at"
        sign = {">=": "\u2265", "<=": "\u2264"}.get(self.atom.relation, self.atom.relation)
        said = f"{who} {where} {self.atom.label} {sign} {self.atom.bound}"
        return f"{self.soft}: {said}" if self.soft else said


def requirements(plan: Plan, mission: Mission) -> tuple[Requirement, ...]:
    """The requirements of the mission in the order of its text, each atom of a formula once.

    First comes the goal; where it may hold in part, each of its outermost parts is looked at by
    itself, so that one that fails does not hide what holds. Preferred formulas follow. Raises
    PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    made = []
    for name, formula in _demands(mission):
        trace = trace_of(plan, mission, formula)
        made += [
            Requirement(
                atom=atom,
                places=len(trace.labels[atom.label]),
                counts=_frozen(measured(atom, trace)),
                margins=_frozen(values),
                windows=tuple(sorted(owed.windows)),
                witness_steps=runs(owed.steps),
                soft=name,
            )
            for atom, values, owed in judged_atoms(formula, trace)
            if isinstance(atom, Count)
        ]
    return tuple(made)


def judged_atoms(
    formula: Formula, trace: Trace
) -> Iterator[tuple[Count | Linear, Floats, Obligation]]:
    """The atoms of a formula in its order: their robustness, and the steps that settle it."""
    values = margins(formula, trace)
    for (atom, _), owed in obligations(formula, JUDGED, values).items():
        if isinstance(atom, Count | Linear):
            yield atom, values[atom], owed


def _demands(mission: Mission) -> Iterator[tuple[str | None, Formula]]:
    """The formulas that are charted: what has to hold, and what is preferred by its name."""
    goal = mission.goal
    apart = mission.partial and isinstance(goal, And)
    yield from ((None, part) for part in (goal.children if apart else (goal,)))
    for soft in mission.prefer:
        plain = mission.translated(soft.formula)
        yield soft.name, simplify(positive(resolve_percent(plain, mission.having)))


def trace_of(plan: Plan, mission: Mission, formula: Formula) -> CountTrace:
    """The counts of a plan at all states of its mission's map, as far as a formula needs them.

    Of agents that may be late, those that are there for certain, and those that may be.
    """
    states = tuple(mission.system.states)
    wanted = (None, *sorted(capabilities(formula)))
    traffic, _ = read_traffic(mission, plan) if plan.delay else (None, [])
    if traffic is not None:
        return traffic.late_trace(sorted(capabilities(formula)), traffic.delay)
    counts = {name: plan.tallied(states, name) for name in wanted}
    executed = execution_tables(plan.executions, states, plan.horizon)
    return count_trace(mission.system, counts, executed)


def measured(atom: Count | Linear, trace: Trace) -> Any:
    """What an atom compares with its bound at every step: numbers of agents, or a value."""
    if isinstance(trace, SignalTrace):
        return trace.total(cast("Linear", atom).terms)
    atom = cast("Count", atom)
    there = trace.at(atom.label, atom.capability, upper=atom.upper)
    return np.asarray(getattr(there, atom.function)(axis=-2))


def runs(steps: Steps) -> tuple[Span, ...]:
    """Sorted steps as runs `(first, last)`.

    >>> runs(np.array([1, 2, 3, 7]))
    ((1, 3), (7, 7))
    """
    if not len(steps):
        return ()
    breaks = np.flatnonzero(np.diff(steps) > 1)
    firsts = steps[np.concatenate([[0], breaks + 1])]
    lasts = steps[np.concatenate([breaks, [len(steps) - 1]])]
    return tuple(zip(firsts.tolist(), lasts.tolist(), strict=True))


def _frozen(array: Any) -> Any:
    array.flags.writeable = False
    return array
