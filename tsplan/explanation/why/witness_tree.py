"""Why a plan satisfies its formula: the formula as a tree, with what settles each of its nodes.

The tree is that of the formula as it was written; a task or limit has the counts it stands for
below it. All values come from the evaluator and the counts of the plan.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.checking.fitting import refuse_misfit
from tsplan.explanation.why.requirements import measured, runs, trace_of
from tsplan.explanation.why.staffing import Presence, Staff
from tsplan.explanation.why.stock_lines import Supply, supplies
from tsplan.explanation.why.supply_words import supply_lines
from tsplan.logic.atoms import Count, Execution, Limit, Linear, Task
from tsplan.logic.catl import resolve_percent
from tsplan.logic.causes import NO_STEPS, NONE, Steps, Values, cause_of
from tsplan.logic.evaluation import margins
from tsplan.logic.nodes import Always, And, Eventually, Formula, Implies, Or, Release, Until
from tsplan.logic.obligations import Obligation, obligations
from tsplan.logic.text import operator_text
from tsplan.logic.traces import SignalTrace
from tsplan.logic.traversal import walk
from tsplan.plans.summary import names
from tsplan.words import number, run_words

if TYPE_CHECKING:
    from tsplan.logic.traces import Trace
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

MOST_LINES = 2000
"""Nodes that are printed; a formula that repeats itself can have many more."""

_LONGEST = 60  # characters of a formula in one line
_RUNS = 4
_CLOSE = 1e-9  # values that sums of floats in different orders may give for one
_STATES = 4


@dataclass(frozen=True, eq=False)
class WitnessNode:
    """One node of the formula, where it stands, and what settles it there.

    `steps` are those at which it is judged because the nodes above it rest on it there, and
    `availability` its robustness at each of them. `witness_steps` has, for each of these, the step
    that a temporal operator rests on: where an eventuality is met first and best, where an `always`
    is tightest, where an until changes over or a release sets free; None where there is none. A
    node that is not `needed` is a branch that nothing rests on, judged where its parent is (or
    nowhere, then `steps` is empty). For atoms, `counts` is what they compare with their bounds at
    each of the steps: agents, or the value `of_signals`; for counts, `present` says who was there
    at the tightest step. For a task that is executed then, `supplies` say how what it needs came
    to lie there.
    """

    formula: Formula
    meaning: Formula
    steps: tuple[int, ...]
    availability: tuple[float, ...]
    witness_steps: tuple[int | None, ...] = ()
    needed: bool = True
    counts: tuple[float, ...] = ()
    present: tuple[Presence, ...] = ()
    children: tuple[WitnessNode, ...] = field(default=(), repr=False)
    of_signals: bool = False
    supplies: tuple[Supply, ...] = ()

    @cached_property
    def tightest(self) -> int | None:
        """The earliest judged step with the least availability."""
        return _tightest(self.steps, self.availability)

    @property
    def worst(self) -> float | None:
        """The least availability over the judged steps; None if there are none."""
        return min(self.availability, default=None)

    @property
    def holds(self) -> bool | None:
        """Whether it holds at all judged steps; None if there are none."""
        return None if self.worst is None else self.worst >= 0

    @cached_property
    def critical(self) -> Mapping[Formula, tuple[int, ...]]:
        """The atoms that it rests on which are worth no more than the whole, with their steps."""
        found: dict[Formula, set[int]] = {}
        for node in self._rests_on():
            if isinstance(node.meaning, Count | Linear):
                judged = zip(node.steps, node.availability, strict=True)
                at = {step for step, value in judged if self._is_worst(value)}
                if at:
                    found.setdefault(node.meaning, set()).update(at)
        return MappingProxyType({atom: tuple(sorted(steps)) for atom, steps in found.items()})

    def _is_worst(self, value: float) -> bool:
        return self.worst is not None and math.isclose(
            value, self.worst, rel_tol=_CLOSE, abs_tol=_CLOSE
        )

    def _rests_on(self) -> Iterator[WitnessNode]:
        """It and the needed nodes below, each once."""
        waiting, seen = [self], {id(self)}
        while waiting:
            node = waiting.pop()
            yield node
            below = [child for child in reversed(node.children) if id(child) not in seen]
            seen.update(map(id, below))
            waiting += (child for child in below if child.needed)

    def walk(self) -> Iterator[tuple[int, WitnessNode]]:
        """Every node with its depth, from the top, in the order of the text."""
        waiting = [(0, self)]
        while waiting:
            depth, node = waiting.pop()
            yield depth, node
            waiting += ((depth + 1, child) for child in reversed(node.children))

    def __str__(self) -> str:
        """The tree, one node a line."""
        return tree_text(self)


def _tightest(steps: tuple[int, ...], availability: Sequence[float] | Values) -> int | None:
    """The earliest of some steps with the least availability; None if there are none."""
    return steps[int(np.argmin(availability))] if steps else None


def explain(plan: Plan, mission: Mission) -> WitnessNode:
    """Why the plan satisfies the formula, or why it does not.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    return _by_counts(plan, mission, mission.formula)


def explain_preferred(plan: Plan, mission: Mission) -> dict[str, WitnessNode]:
    """The same for each formula that the mission prefers, by its name.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    return {soft.name: _by_counts(plan, mission, soft.formula) for soft in mission.prefer}


def explain_on(formula: Formula, trace: Trace) -> WitnessNode:
    """Why a formula holds on a trace at step 0, or why it does not.

    A formula of counts is without tasks, limits and percentages. Robustness is without weights.

    >>> from tsplan.logic import parse
    >>> trace = SignalTrace({"x": np.array([1.0, 4.0, 2.0])})
    >>> print(explain_on(parse("F[0,2] x >= 3", language="stl"), trace))
    F[0,2]    holds at 0, robustness 1, met at 1, critical: x >= 3 at 1
      x >= 3  holds at 1, robustness 1, value 4
    """
    return _Builder(formula, {node: node for node in walk(formula)}, trace).tree()


def _by_counts(plan: Plan, mission: Mission, formula: Formula) -> WitnessNode:
    meaning = meanings(mission, formula)
    trace = trace_of(plan, mission, meaning[formula])
    return _Builder(formula, meaning, trace, Staff(plan, mission, trace)).tree()


class _Place(NamedTuple):
    """A formula with the steps it is asked for; equal places have equal witness nodes."""

    formula: Formula
    steps: tuple[int, ...]
    needed: bool


class _Builder:
    """Makes the tree of one formula; without recursion, since formulas may be deep."""

    def __init__(
        self,
        formula: Formula,
        meaning: Mapping[Formula, Formula],
        trace: Trace,
        staff: Staff | None = None,
    ) -> None:
        self._meaning = meaning
        self._top = _Place(formula, (0,), needed=True)
        self._trace = trace
        self._margins = margins(meaning[formula], trace)
        self._staff = staff

    def tree(self) -> WitnessNode:
        """The node of every place, children before their parents."""
        done: dict[_Place, WitnessNode] = {}
        below: dict[_Place, tuple[_Place, ...]] = {}
        waiting = [self._top]
        while waiting:
            place = waiting[-1]
            if place not in below:
                below[place] = self._below(place)
                waiting += (child for child in below[place] if child not in done)
                continue
            waiting.pop()
            if place not in done:
                done[place] = self._node(place, tuple(done[child] for child in below[place]))
        return done[self._top]

    def _below(self, place: _Place) -> tuple[_Place, ...]:
        """The places below a place."""
        node, steps = place.formula, np.array(place.steps, dtype=np.int64)
        if isinstance(node, Task | Limit):
            owed = obligations(self._meaning[node], Obligation(None, steps), self._margins)
            counts = (
                (part, one.steps)
                for (part, _), one in owed.items()
                if isinstance(part, Count | Execution)
            )
            return tuple(_Place(atom, tuple(at.tolist()), place.needed) for atom, at in counts)
        # where nobody asks for a node, nothing below it settles anything
        wanted = [NO_STEPS] * len(node.children)
        if node.children and steps.size:
            wanted = [*cause_of(self._meaning[node], steps, self._margins).below]
        made = []
        for child, own in zip(node.children, wanted, strict=True):
            # a branch that was not taken is judged where it was offered
            offered = not own.size and isinstance(node, And | Or | Implies)
            judged = place.steps if offered else tuple(own.tolist())
            made.append(_Place(child, judged, place.needed and bool(own.size)))
        return tuple(made)

    def _node(self, place: _Place, children: tuple[WitnessNode, ...]) -> WitnessNode:
        meaning = self._meaning.get(place.formula, place.formula)
        steps = np.array(place.steps, dtype=np.int64)
        values = self._margins[meaning][steps]
        rests: Steps | None = None
        if place.formula.children and steps.size:
            rests = cause_of(meaning, steps, self._margins).witness_steps
        chosen = () if rests is None else rests.tolist()
        atom = meaning if isinstance(meaning, Count | Linear) else None
        present: tuple[Presence, ...] = ()
        if isinstance(atom, Count) and self._staff is not None:
            present = self._staff.present(atom, _tightest(place.steps, values.tolist()))
        return WitnessNode(
            formula=place.formula,
            meaning=meaning,
            steps=place.steps,
            availability=tuple(values.tolist()),
            witness_steps=tuple(None if step == NONE else step for step in chosen),
            needed=place.needed,
            counts=() if atom is None else tuple(measured(atom, self._trace)[steps].tolist()),
            present=present,
            children=children,
            of_signals=isinstance(self._trace, SignalTrace),
            supplies=self._supplies(place),
        )

    def _supplies(self, place: _Place) -> tuple[Supply, ...]:
        """What came to the executions of a task at the steps at which it is asked for."""
        if self._staff is None or not isinstance(place.formula, Execution):
            return ()
        return supplies(self._staff.stocks, place.formula.task, place.steps)


def meanings(mission: Mission, formula: Formula) -> Mapping[Formula, Formula]:
    """What each sub-formula of a mission's formula as written says in counts and numbers alone."""
    found: dict[Formula, Formula] = {}
    for node in walk(formula):
        if node.children:
            found[node] = node.over(found[child] for child in node.children)
            continue
        plain = mission.translated(node)
        found[node] = resolve_percent(plain, mission.having)
    return found


# --- in words ----------------------------------------------------------------------------------


def tree_text(top: WitnessNode) -> str:
    """The tree, one node a line: what it is, when it holds, its availability and its choice.

    Nodes are indented by two columns for each level.
    """
    rows: list[tuple[str, str]] = []
    rest = 0
    for depth, node in top.walk():
        if len(rows) >= MOST_LINES:
            rest += 1
            if rest > MOST_LINES:
                break
            continue
        rows.append(("  " * depth + title(node), verdict(node) + _critical(node, depth)))
        rows += [("", f"  {line}") for line in supply_lines(node.supplies)]
    width = min(max(len(left) for left, _ in rows), _LONGEST)
    lines = [f"{left:<{width}}  {right}".rstrip() for left, right in rows]
    if rest:
        more = f"more than {MOST_LINES}" if rest > MOST_LINES else str(rest)
        lines.append(f"... and {more} further nodes")
    return "\n".join(lines)


def title(node: WitnessNode) -> str:
    """A node without what is below it, and what an atom means where its text alone does not say."""
    if isinstance(node.formula, Execution):
        return "executed"
    text = operator_text(node.formula)
    if not node.formula.children and node.meaning is not node.formula and not node.children:
        return f"{text} (that is {node.meaning})"
    return text


def verdict(node: WitnessNode) -> str:
    """What is said about a node: whether it holds, where, how well, and what it rests on."""
    if not node.steps:
        return "not needed"
    if isinstance(node.formula, Execution):
        text = _held(node).removeprefix("holds ")
        return text if node.needed else f"(not needed: {text})"
    worst = node.worst or 0.0
    level = ("unbounded" if worst > 0 else "impossible") if math.isinf(worst) else number(worst)
    words = [_held(node), f"{'robustness' if node.of_signals else 'availability'} {level}"]
    if node.witness_steps:
        words.append(_choice(node))
    if node.counts:
        least, most = (number(end) for end in (min(node.counts), max(node.counts)))
        what = "value" if node.of_signals else "count"
        words += [f"{what} {least}" if least == most else f"{what} {least}..{most}", *_who(node)]
    text = ", ".join(words)
    return text if node.needed else f"(not needed: {text})"


def _critical(node: WitnessNode, depth: int) -> str:
    """What a formula over signals, and each of its outermost parts, hangs on."""
    if depth > 1 or not (node.of_signals and node.needed and node.children):
        return ""
    shown = [f"{atom} at {_at(steps)}" for atom, steps in node.critical.items()]
    more = [f"{len(shown) - _STATES} more"] if len(shown) > _STATES else []
    return f", critical: {'; '.join([*shown[:_STATES], *more])}" if shown else ""


def _at(steps: Iterable[int]) -> str:
    """Steps in words; only the first few runs of them."""
    return run_words(runs(np.array(sorted(set(steps)), dtype=np.int64)), _RUNS)


def _held(node: WitnessNode) -> str:
    where = f"at {_at(node.steps)}"
    if node.holds:
        return f"holds {where}"
    failing = [s for s, value in zip(node.steps, node.availability, strict=True) if value < 0]
    if len(failing) == len(node.steps):
        return f"fails {where}"
    return f"holds {where} but for {_at(failing)}"


def _choice(node: WitnessNode) -> str:
    """The steps that a temporal operator rests on."""
    steps = [step for step in node.witness_steps if step is not None]
    if not steps:
        return "held all through" if isinstance(node.formula, Release) else "never given up"
    words = _RESTS.get(type(node.formula), ("step", "step"))
    return f"{words[0 if node.holds else 1]} {_at(steps)}"


_RESTS: Mapping[type[Formula], tuple[str, str]] = MappingProxyType(
    {
        Eventually: ("met at", "closest at"),
        Always: ("tightest at", "tightest at"),
        Until: ("right side at", "left side ends at"),
        Release: ("released at", "right side fails at"),
    }
)
"""What the witness steps are, where an operator holds and where it fails."""


def _who(node: WitnessNode) -> list[str]:
    """Who stands there at the tightest step; empty states count where every state does."""
    everywhere = isinstance(node.meaning, Count) and node.meaning.function == "min"
    there = [presence for presence in node.present if presence.count or everywhere]
    if not there:
        return []
    shown = "; ".join(_presence(presence) for presence in there[:_STATES])
    more = f"; {len(there) - _STATES} more states" if len(there) > _STATES else ""
    return [f"at step {node.tightest}: {shown}{more}"]


def _presence(presence: Presence) -> str:
    if not presence.ids:
        who = f"{number(round(presence.count, 2))} agents" if presence.count else "nobody"
        return f"{who} at {presence.state}"
    more = presence.count - len(presence.ids)
    rest = f" and {number(more)} more" if more else ""
    return f"{names(presence.ids)}{rest} at {presence.state}"
