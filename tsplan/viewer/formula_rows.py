"""The formula as rows that tick off while a plan is played, with the counts behind each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import TypeAlias, cast

import numpy as np

from tsplan.checking.fitting import refuse_misfit
from tsplan.explanation.why.requirements import measured, runs, trace_of
from tsplan.explanation.why.witness_tree import meanings
from tsplan.logic import nodes
from tsplan.logic.atoms import OPPOSITE, Count, Execution, Linear
from tsplan.logic.decision_time import decided_at, earliness
from tsplan.logic.nodes import Formula
from tsplan.logic.obligations import START, Obligation, below, obligations
from tsplan.logic.text import text_of
from tsplan.logic.time_horizon import Span
from tsplan.logic.traces import Floats, SignalTrace, Trace
from tsplan.logic.traversal import walk
from tsplan.mission import Mission
from tsplan.plans.plan import Plan

Atom: TypeAlias = Count | Linear | Execution

MOST_PARTS = 300
"""Rows of a formula; what lies below them is summed up in the last ones."""

MOST_CHARTS = 6
"""Counts that one row shows."""

_LONGEST = 400  # characters of a row


@dataclass(frozen=True, slots=True)
class Chart:
    """One count of agents, or value of signals, against what is needed of it.

    `counts` are `(step, count)` from each change on, of values at every step: these go on `smooth`
    between steps. The need is due at the `needed` steps, which were chosen among the `possible`
    ones; spans of steps include both ends.
    """

    text: str
    bound: float
    counts: tuple[tuple[int, float], ...]
    needed: tuple[Span, ...]
    possible: tuple[Span, ...]
    smooth: bool = False


@dataclass(frozen=True, slots=True)
class Part:
    """One row: a part of the formula, what it has to fulfil, and when that is done.

    `heading` says what joins the rows below, where there are some; else it is the `text`.
    A duty is one count, or one execution of a task, at one step. `settled` has pairs of a step and
    the duties fulfilled at it.
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
        """How many counts and executions at how many steps the part has to fulfil."""
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
    """A formula on a trace: what each part means, how early it is certain, where atoms look."""

    trace: Trace
    meaning: Mapping[Formula, Formula]
    early: Mapping[Formula, Floats]
    places: Callable[[Iterable[Atom]], tuple[str, ...]]
    texts: Mapping[Formula, str] = field(default_factory=dict)


def formula_parts(mission: Mission, plan: Plan) -> tuple[Part, ...]:
    """The rows of a mission's formula for a plan, from the outside in; then of what it prefers.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    carriers = mission.system.labels

    def places(atoms: Iterable[Atom]) -> tuple[str, ...]:
        labels = dict.fromkeys(atom.label for atom in atoms if not isinstance(atom, Linear))
        return tuple(state for label in labels for state in carriers[label])

    def rows_of(formula: Formula) -> list[Part]:
        meaning = meanings(mission, formula)
        trace = trace_of(plan, mission, meaning[formula])
        return _rows(formula, _Judged(trace, meaning, earliness(meaning[formula], trace), places))

    return with_wishes(rows_of, mission.formula, ((w.name, w.formula) for w in mission.prefer))


def with_wishes(
    rows_of: Callable[[Formula], list[Part]], goal: Formula, wishes: Iterable[tuple[str, Formula]]
) -> tuple[Part, ...]:
    """The rows of a goal, then of each preferred formula, which says so with its name."""
    rows = rows_of(goal)
    for name, formula in wishes:
        first, *rest = rows_of(formula)
        said = f"preferred: {name}: "
        rows += replace(first, text=said + first.text, heading=said + first.heading), *rest
    return tuple(rows)


def signal_rows(
    formula: Formula,
    trace: SignalTrace,
    places: Callable[[Iterable[Atom]], tuple[str, ...]],
    texts: Mapping[Formula, str],
) -> list[Part]:
    """The rows of a formula over signals.

    `places` are the regions that predicates speak of, `texts` how some parts were written.
    """
    meaning = {node: node for node in walk(formula)}
    return _rows(formula, _Judged(trace, meaning, earliness(formula, trace), places, texts))


def _rows(whole: Formula, judged: _Judged) -> list[Part]:
    """The rows of one formula, from the outside in."""
    rows: list[Part] = []
    waiting = [(whole, START, 0)]
    while waiting:
        formula, duty, depth = waiting.pop()
        parts = _below(judged, formula, duty) if len(rows) < MOST_PARTS else []
        rows.append(_row(judged, (formula, duty), depth, opened=bool(parts)))
        waiting += [(child, more, depth + 1) for child, more in reversed(parts)]
    return rows


def _chain(formula: Formula) -> list[Formula]:
    """The nodes from a formula down to the first that joins several others, or to an atom."""
    chain = [formula]
    while len(chain[-1].children) == 1:
        chain += chain[-1].children
    return chain


def _below(judged: _Judged, formula: Formula, duty: Obligation) -> list[tuple[Formula, Obligation]]:
    """The parts that a row joins with what it asks of them, in the order of the text."""
    duties: tuple[Obligation, ...] = (duty,)
    for node in _chain(formula):
        duties = below(judged.meaning[node], duties[0], judged.early) if node.children else ()
    return list(zip(node.children, duties, strict=True))


def _row(judged: _Judged, asked: tuple[Formula, Obligation], depth: int, *, opened: bool) -> Part:
    formula, duty = asked
    meaning = judged.meaning[formula]
    parts = obligations(meaning, duty, judged.early)
    every = {
        (node, holds): one
        for (node, holds), one in parts.items()
        if isinstance(node, Count | Linear)
    }
    counts = {key: one for key, one in every.items() if one.steps.size}
    charts = [_chart(judged, key, one) for key, one in list(counts.items())[:MOST_CHARTS]]
    executed = [one for (node, _), one in parts.items() if isinstance(node, Execution)]
    settled = Counter(step for one in (*counts.values(), *executed) for step in one.steps.tolist())
    text = judged.texts.get(formula) or text_of(formula, _LONGEST)
    return Part(
        text=text,
        heading=heading(formula) if opened else text,
        depth=depth,
        settled=tuple(sorted(settled.items())),
        failed=_failed(judged, meaning, duty),
        needed=runs(np.array(sorted(settled), dtype=np.int64)),
        states=judged.places(node for node, _ in parts if isinstance(node, Atom)),
        charts=tuple(charts),
        hidden=max(0, len(counts) - MOST_CHARTS),
    )


_JOINTS: Mapping[type[Formula], str] = MappingProxyType(
    {
        nodes.And: "all of",
        nodes.Or: "any of",
        nodes.Implies: "the first implies the second",
        nodes.Iff: "both or neither of",
        nodes.Not: "not",
        nodes.Whole: "as a whole",
        nodes.Eventually: "at some step of [{0},{1}]",
        nodes.Always: "at each step of [{0},{1}]",
        nodes.Until: "the first until the second, in [{0},{1}]",
        nodes.Release: "the second, in [{0},{1}] or up to the first",
    }
)


def heading(formula: Formula) -> str:
    """What a row with rows below says of them.

    >>> from tsplan.logic import parse
    >>> heading(parse("F[0,3] !(a && b)", language="mtl"))
    'at some step of [0,3] not all of'
    """
    return " ".join(_JOINTS[type(node)].format(*node.parameters) for node in _chain(formula))


def _chart(judged: _Judged, key: tuple[Count | Linear, bool | None], duty: Obligation) -> Chart:
    count, holds = key
    shown = replace(count, relation=OPPOSITE[count.relation]) if holds is False else count
    values = measured(count, judged.trace)
    smooth = isinstance(count, Linear)
    changes = np.arange(len(values))
    if not smooth:
        changes = np.flatnonzero(np.diff(values, prepend=values[0] - 1))
    return Chart(
        text=text_of(shown),
        bound=cast("float", count.bound),  # a meaning has no percentages
        counts=tuple((int(step), values[step].item()) for step in changes),
        needed=runs(duty.steps),
        possible=tuple(sorted(duty.windows)),
        smooth=smooth,
    )


def _failed(judged: _Judged, meaning: Formula, duty: Obligation) -> int | None:
    """The first step at which it is certain that a part is not what it has to be."""
    if duty.holds is None:
        return None
    early = judged.early[meaning][duty.steps]
    wrong = early[(early >= 0) != duty.holds]
    return int(decided_at(wrong, judged.trace.steps - 1).min()) if wrong.size else None
