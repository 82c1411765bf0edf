"""The formula as rows that tick off while a plan is played, with the counts behind each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeAlias, cast

import numpy as np

from tsplan.checking.fitting import refuse_misfit
from tsplan.explanation.why.requirements import measured, runs, trace_of
from tsplan.explanation.why.witness_tree import meanings
from tsplan.logic.atoms import OPPOSITE, Count
from tsplan.logic.decision_time import decided_at, earliness
from tsplan.logic.nodes import (
    Always,
    And,
    Eventually,
    Formula,
    Iff,
    Implies,
    Not,
    Or,
    Release,
    Until,
)
from tsplan.logic.obligations import START, Obligation, below, obligations
from tsplan.logic.text import text_of

if TYPE_CHECKING:
    from tsplan.logic.traces import CountTrace, Floats
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

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
    """The mission's formula on the plan's counts: what each part means, how early it is certain."""

    mission: Mission
    trace: CountTrace
    meaning: Mapping[Formula, Formula]
    early: Mapping[Formula, Floats]


def formula_parts(mission: Mission, plan: Plan) -> tuple[Part, ...]:
    """The rows of a mission's formula for a plan, from the outside in; then of what it prefers.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    rows = _rows(_judged(mission, plan, mission.formula), mission.formula)
    for wish in mission.prefer:
        first, *rest = _rows(_judged(mission, plan, wish.formula), wish.formula)
        said = f"preferred: {wish.name}: "
        rows.append(replace(first, text=said + first.text, heading=said + first.heading))
        rows += rest
    return tuple(rows)


def _rows(judged: _Judged, whole: Formula) -> list[Part]:
    """The rows of one formula, from the outside in."""
    rows: list[Part] = []
    waiting = [(whole, START, 0)]
    while waiting:
        formula, owed, depth = waiting.pop()
        opened = len(rows) < MOST_PARTS and _opens(formula)
        rows.append(_row(judged, (formula, owed), depth, opened=opened))
        if opened:
            found = reversed(_below(judged, formula, owed))
            waiting += [(child, more, depth + 1) for child, more in found]
    return rows


def _judged(mission: Mission, plan: Plan, formula: Formula) -> _Judged:
    meaning = meanings(mission, formula)
    goal = meaning[formula]
    trace = trace_of(plan, mission, goal)
    return _Judged(mission, trace, meaning, earliness(goal, trace))


def _opens(formula: Formula) -> bool:
    """Whether a row has rows below: where several atoms are joined somewhere inside."""
    return bool(_joint(formula).children)


def _joint(formula: Formula) -> Formula:
    """The first node below that joins several others, or the atom that there is instead."""
    while len(formula.children) == 1:
        formula = formula.children[0]
    return formula


def _below(judged: _Judged, formula: Formula, owed: Obligation) -> list[tuple[Formula, Obligation]]:
    """The parts that a row joins with what it asks of them, in the order of the text."""
    while len(formula.children) == 1:
        (owed,) = below(judged.meaning[formula], owed, judged.early)
        formula = formula.children[0]
    asked = below(judged.meaning[formula], owed, judged.early)
    return list(zip(formula.children, asked, strict=True))


def _row(judged: _Judged, asked: tuple[Formula, Obligation], depth: int, *, opened: bool) -> Part:
    formula, owed = asked
    meaning = judged.meaning[formula]
    parts = obligations(meaning, owed, judged.early)
    every = {(node, holds): o for (node, holds), o in parts.items() if isinstance(node, Count)}
    counts = {key: one for key, one in every.items() if one.steps.size}
    charts = [_chart(judged, key, one) for key, one in list(counts.items())[:MOST_CHARTS]]
    settled = Counter(step for one in counts.values() for step in one.steps.tolist())
    labels = dict.fromkeys(count.label for count, _ in every)
    text = text_of(formula, _LONGEST)
    return Part(
        text=text,
        heading=heading(formula) if opened else text,
        depth=depth,
        settled=tuple(sorted(settled.items())),
        failed=_failed(judged, meaning, owed),
        needed=runs(np.array(sorted(settled), dtype=np.int64)),
        states=tuple(state for label in labels for state in judged.mission.system.labels[label]),
        charts=tuple(charts),
        hidden=max(0, len(counts) - MOST_CHARTS),
    )


_JOINTS: Mapping[type[Formula], str] = MappingProxyType(
    {
        And: "all of",
        Or: "any of",
        Implies: "the first implies the second",
        Iff: "both or neither of",
        Not: "not",
        Eventually: "at some step of [{0},{1}]",
        Always: "at each step of [{0},{1}]",
        Until: "the first until the second, in [{0},{1}]",
        Release: "the second, in [{0},{1}] or up to the first",
    }
)


def heading(formula: Formula) -> str:
    """What a row with rows below says of them.

    >>> from tsplan.logic import parse
    >>> heading(parse("F[0,3] !(a && b)", language="mtl"))
    'at some step of [0,3] not all of'
    """
    words = [_JOINTS[type(formula)].format(*formula.parameters)]
    while len(formula.children) == 1:
        formula = formula.children[0]
        words.append(_JOINTS[type(formula)].format(*formula.parameters))
    return " ".join(words)


def _chart(judged: _Judged, key: tuple[Count, bool | None], owed: Obligation) -> Chart:
    count, holds = key
    shown = replace(count, relation=OPPOSITE[count.relation]) if holds is False else count
    values = measured(count, judged.trace)
    changes = np.flatnonzero(np.diff(values, prepend=values[0] - 1))
    return Chart(
        text=text_of(shown),
        relation=shown.relation,
        bound=cast("int", count.bound),  # a meaning has no percentages
        counts=tuple((int(step), int(values[step])) for step in changes),
        needed=runs(owed.steps),
        possible=tuple(sorted(owed.windows)),
    )


def _failed(judged: _Judged, meaning: Formula, owed: Obligation) -> int | None:
    """The first step at which it is certain that a part is not what it has to be."""
    if owed.holds is None:
        return None
    early = judged.early[meaning][owed.steps]
    wrong = early[(early >= 0) != owed.holds]
    if not wrong.size:
        return None
    return int(decided_at(wrong, judged.trace.steps - 1).min())
