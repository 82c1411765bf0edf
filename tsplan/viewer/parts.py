"""The formula as rows that tick off while a plan is played, with the counts behind each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from tsplan import logic
from tsplan.logic.atoms import OPPOSITE, Count, Limit, Task
from tsplan.logic.deciding import decided
from tsplan.logic.evaluate import CountTrace
from tsplan.logic.nodes import (
    Always,
    And,
    Constant,
    Eventually,
    Formula,
    Iff,
    Implies,
    Not,
    Or,
    Release,
    Until,
)
from tsplan.logic.printing import text_of
from tsplan.logic.translation import counted
from tsplan.logic.walking import walk
from tsplan.results.occupancy import state_counts
from tsplan.viewer.duties import Duty, Steps, Times, atoms, parts, root_duty

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.results.plan import Plan

Span: TypeAlias = tuple[int, int]

MOST_PARTS = 300
"""Rows of a formula; what lies below them is summed up in the last ones."""

MOST_CHARTS = 6
"""Counts that one row shows."""

_LONGEST = 400  # characters of a row


@dataclass(frozen=True, slots=True)
class Chart:
    """One count of agents against what is needed of it.

    `counts` are `(step, count)` from each change on. The need is due at the `needed` steps, which
    were chosen among the `possible` ones; spans of steps include both ends.
    """

    text: str
    relation: str
    bound: int
    counts: tuple[tuple[int, int], ...]
    needed: tuple[Span, ...]
    possible: tuple[Span, ...]


@dataclass(frozen=True, slots=True)
class Part:
    """One row: a part of the formula, what it has to fulfil, and when that is done.

    `heading` says what joins the rows below, where there are some; else it is the `text`.
    A duty is one count at one step. `settled` has pairs of a step and the duties fulfilled at it.
    `failed` is the step at which it is certain that the part fails although it is needed.
    """

    text: str
    heading: str
    depth: int
    settled: tuple[tuple[int, int], ...]
    failed: int | None
    needed: tuple[Span, ...]
    states: tuple[str, ...]
    charts: tuple[Chart, ...]
    hidden: int = 0

    @property
    def duties(self) -> int:
        """How many counts at how many steps the part has to fulfil."""
        return sum(number for _, number in self.settled)

    def share(self, time: float) -> float:
        """The share of the duties that are fulfilled at a time; 1 where there are none.

        >>> Part("a", "a", 0, ((2, 1), (3, 1)), None, (), (), ()).share(2.5)
        0.5
        """
        done = sum(number for step, number in self.settled if step <= time)
        return done / self.duties if self.settled else 1.0


@dataclass(frozen=True)
class _Judged:
    """The mission's formula on the plan's counts."""

    mission: Mission
    trace: CountTrace
    plain: Mapping[Formula, Formula]
    times: Times


def formula_parts(mission: Mission, plan: Plan) -> tuple[Part, ...]:
    """The rows of a mission's formula for a plan, from the outside in."""
    judged = _judged(mission, plan)
    root = _without_percent(mission)
    rows: list[Part] = []
    waiting = [(root, root_duty(judged.plain[root], plan.horizon + 1), 0)]
    while waiting:
        formula, duty, depth = waiting.pop()
        open_ = len(rows) < MOST_PARTS and _opens(formula)
        rows.append(_row(judged, formula, duty, depth, opened=open_))
        if open_:
            below = _below(formula, duty, judged.times)
            waiting += [(child, part, depth + 1) for child, part in reversed(below)]
    return tuple(rows)


def _without_percent(mission: Mission) -> Formula:
    """The formula as written, with numbers of agents for percentages."""
    return logic.resolve_percent(mission.formula, mission.having)


def _judged(mission: Mission, plan: Plan) -> _Judged:
    formula = _without_percent(mission)
    plain: dict[Formula, Formula] = {}
    for node in walk(formula):
        below = tuple(plain[child] for child in node.children)
        plain[node] = counted(node, below, mission.task_interval)
    trace = _trace(mission, plan, plain[formula])
    return _Judged(mission, trace, plain, decided(plain[formula], trace))


def _trace(mission: Mission, plan: Plan, formula: Formula) -> CountTrace:
    states = tuple(mission.system.states)
    row = {state: number for number, state in enumerate(states)}
    labels = {
        label: np.array([row[state] for state in members], dtype=np.int64)
        for label, members in mission.system.labels.items()
    }
    counts = {
        name: state_counts(plan.bundles, states, plan.horizon, name)
        for name in (None, *sorted(logic.capabilities(formula)))
    }
    return CountTrace(counts, labels)


def _opens(formula: Formula) -> bool:
    """Whether a row has rows below: where several atoms are joined somewhere inside."""
    while len(formula.children) == 1:
        formula = formula.children[0]
    return bool(formula.children)


def _below(formula: Formula, duty: Duty, times: Times) -> list[tuple[Formula, Duty]]:
    """The parts that a row joins with their duties, in the order of the text."""
    while len(formula.children) == 1:
        formula, duty = formula.children[0], parts(duty.formula, duty, times)[0]
    made = parts(duty.formula, duty, times)
    if isinstance(formula, Iff):
        made = [_side(duty, made, side) for side in duty.formula.children]
    return list(zip(formula.children, made, strict=True))


def _side(duty: Duty, made: Iterable[Duty], side: Formula) -> Duty:
    """One side of `iff`, as it is read at most steps; its other reading has charts of its own."""
    nowhere = duty.to(side, np.zeros_like(duty.needed), duty.possible)
    own = [one for one in made if one.formula is side]
    return max([*own, nowhere], key=lambda one: int(one.needed.sum()))


def _row(judged: _Judged, formula: Formula, duty: Duty, depth: int, *, opened: bool) -> Part:
    counts = [one for one in atoms(duty, judged.times) if one.needed.any()]
    settled = sum((one.needed.astype(np.int64) for one in counts), np.zeros(duty.needed.size, int))
    labels = {one.formula.label for one in counts if isinstance(one.formula, Count)}
    charts = [_chart(judged, one) for one in _merged(counts)[:MOST_CHARTS]]
    text = text_of(formula, _LONGEST)
    return Part(
        text=text,
        heading=heading(formula) if opened else text,
        depth=depth,
        settled=tuple((int(step), int(settled[step])) for step in np.flatnonzero(settled)),
        failed=_failed(duty, judged.times),
        needed=spans(settled > 0),
        states=tuple(
            state for label in sorted(labels) for state in judged.mission.system.labels[label]
        ),
        charts=tuple(charts),
        hidden=max(0, len(_merged(counts)) - MOST_CHARTS),
    )


def heading(formula: Formula) -> str:
    """What a row with rows below says of them."""
    match formula:
        case And():
            return "all of"
        case Or():
            return "any of"
        case Implies():
            return "the first implies the second"
        case Iff():
            return "both or neither of"
        case Not():
            return f"not {heading(formula.child)}"
        case Eventually():
            return f"at some step of [{formula.low},{formula.high}] {heading(formula.child)}"
        case Always():
            return f"at each step of [{formula.low},{formula.high}] {heading(formula.child)}"
        case Until():
            return f"the first until the second, in [{formula.low},{formula.high}]"
        case Release():
            return f"the second, in [{formula.low},{formula.high}] or up to the first"
    return text_of(formula, _LONGEST)


def _merged(counts: Iterable[Duty]) -> list[Duty]:
    """One duty for each count and reading, with the steps of all of them."""
    found: dict[tuple[Formula, bool], Duty] = {}
    for one in counts:
        key = (one.formula, one.holds)
        former = found.get(key, one)
        found[key] = one._replace(
            needed=former.needed | one.needed, possible=former.possible | one.possible
        )
    return list(found.values())


def _chart(judged: _Judged, duty: Duty) -> Chart:
    count = duty.formula
    assert isinstance(count, Count)
    assert isinstance(count.bound, int)
    shown = count if duty.holds else replace(count, relation=OPPOSITE[count.relation])
    at_states = judged.trace.at(count.label, count.capability)
    values = getattr(at_states, count.function)(axis=-2).astype(np.int64)
    changes = np.flatnonzero(np.diff(values, prepend=values[0] - 1))
    return Chart(
        text=text_of(shown),
        relation=shown.relation,
        bound=count.bound,
        counts=tuple((int(step), int(values[step])) for step in changes),
        needed=spans(duty.needed),
        possible=spans(duty.possible),
    )


def _failed(duty: Duty, times: Times) -> int | None:
    """The first step at which it is certain that a duty is not fulfilled."""
    opposite = duty._replace(holds=not duty.holds).certain(times)[duty.needed]
    finite = opposite[np.isfinite(opposite)]
    return int(finite.min()) if finite.size else None


def spans(steps: Steps) -> tuple[Span, ...]:
    """Runs of true steps, with both ends.

    >>> spans(np.array([True, True, False, True]))
    ((0, 1), (3, 3))
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[False], steps, [False]]).astype(np.int8)))
    return tuple((int(a), int(b) - 1) for a, b in zip(edges[::2], edges[1::2], strict=True))
