"""What remains of a formula after the first steps of a trace.

The remainder is judged at the first step that is still open. It is closed form rather than step by
step: what lies wholly in the past is read off the values of the evaluator, a window that reaches
into the future is one window from now on, and only the few steps in between, whose parts look past
the present, are gone through one by one. Of parts that can be told to be at least as robust as
others, only those that decide are kept (`tsplan.logic.dominance`).

Source of the idea, for truth and one step at a time: F. Bacchus and F. Kabanza, "Using temporal
logics to express search control knowledge for planning", Artificial Intelligence 116, 2000.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import replace
from functools import singledispatch
from typing import Any, TypeAlias

import numpy as np

from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Execution, Known, Limit, Linear, Task
from tsplan.logic.catl import translate
from tsplan.logic.dominance import Dominance
from tsplan.logic.evaluation import Reading, margin_reading, truth_reading, value
from tsplan.logic.nodes import FALSE, TRUE, Formula
from tsplan.logic.normal_form import positive
from tsplan.logic.settled import known_count, known_signal, settled
from tsplan.logic.simplification import joined, simpler, simplify
from tsplan.logic.time_horizon import lookahead
from tsplan.logic.traces import CountTrace, SignalTrace, Trace, Values
from tsplan.logic.traversal import fold_all, walk


def progress(
    formula: Formula, trace: Trace | Mapping[str, Values], consumed: Collection[str] = ()
) -> Formula:
    """What remains of a formula after a trace of the first k steps, to be judged at step k.

    Of every whole trace that begins with this one, the remainder has on the steps from k on exactly
    the robustness, and the truth, that the formula has on the whole trace. What is past and still
    matters is known by its margin: of counts as `Known`, of signals as a `Linear` without terms.

    Tasks are read with their closed interval; translate first for the half-open one. Of a task that
    has begun at one of the first steps and is still executed, an `Execution` of the steps that are
    left remains (see `still_executed`), without the resources that are `consumed`, by name. A
    mapping of names to arrays is a trace of signals.

    Raises ValueError for several traces at once, for expected numbers of agents, for weights, whose
    kinds of robustness do not add up step by step, and for what cannot be judged on the trace.

    >>> from tsplan.logic import parse
    >>> trace = CountTrace({None: np.array([[0, 3, 1]])}, {"a": np.array([0])})
    >>> print(progress(parse("F[0,9] sum(a) >= 5 && G[2,4] a"), trace))
    (known(-2) || F[0,6] (sum(a) >= 5)) && known(0) && G[0,1] a
    """
    given = SignalTrace(trace) if isinstance(trace, Mapping) else trace
    if given.batch:
        raise ValueError("a formula is progressed by one trace, not by a batch of several")
    plain = translate(formula)
    weighted = (node for node in walk(plain) if getattr(node, "weights", None) is not None)
    for node in weighted:
        raise ValueError(f"'{node}' has weights, with which nothing can be progressed")
    if isinstance(given, CountTrace) and given.most:
        plain = positive(plain)  # which counts an atom is about is told by its own relation
    if not given.steps:
        return simplify(plain)
    return simplify(Past(plain, given, frozenset(consumed)).remainder())


def still_executed(node: Execution, done: int, consumed: Collection[str] = ()) -> Execution:
    """The rest of an execution that was begun so many steps ago.

    It needs its agents and what is not `consumed` for the steps that are left; a trace tells that
    it goes on by a `task` of its own.

    >>> node = Execution("T(3,a,{(c,1)},{(oil,2)})", "a", (("c", 1),), (("oil", 2.0),), 3)
    >>> print(still_executed(node, 2, {"oil"}))
    executed begun(T(3,a,{(c,1)},{(oil,2)}),2)
    """
    kept = tuple((name, amount) for name, amount in node.resources if name not in consumed)
    return replace(node, resources=kept, last=node.last - done, begun=node.begun + done)


_TWO = 2

Kind: TypeAlias = type[nodes.And] | type[nodes.Or]


class Past:
    """The first steps of a trace, and what remains at each of them of the parts of a formula."""

    def __init__(self, formula: Formula, trace: Trace, consumed: frozenset[str]) -> None:
        self.steps = trace.steps
        self.trace = trace
        self.consumed = consumed
        self._whole = formula
        self._dominance = Dominance()
        self._margins = self._values(margin_reading(trace))
        counted = isinstance(trace, CountTrace)
        self._truths = None if counted else self._values(truth_reading(trace))
        self._remains: dict[tuple[Formula, int], Formula] = {}

    def _values(self, reading: Reading) -> Mapping[Formula, Values]:
        """The values of all parts of the formula at every step at which all of it is past."""

        def past(node: Formula, below: tuple[Values, ...]) -> Values:
            values = value(node, below, reading)
            last = node.last if isinstance(node, Execution) else 0
            return values[..., : max(values.shape[-1] - last, 0)]

        return fold_all(self._whole, past)

    def remainder(self) -> Formula:
        """What remains of the whole formula, at step 0."""
        order = tuple(walk(self._whole))
        wanted: dict[Formula, set[int]] = defaultdict(set, {self._whole: {0}})
        for node in reversed(order):
            wanted[node] = {step for step in wanted[node] if step >= self.ended(node)}
            for child, (low, high) in zip(node.children, lookahead(node), strict=True):
                for step in wanted[node]:
                    wanted[child].update(range(step + low, min(step + high + 1, self.steps)))
        for node in order:
            for step in sorted(wanted[node]):
                self._remains[node, step] = remains(node, step, self)
        return self.at(self._whole, 0)

    def ended(self, node: Formula) -> int:
        """The number of first steps at which all that a formula looks at is past."""
        return int(self._margins[node].shape[-1])

    def at(self, node: Formula, step: int) -> Formula:
        """What remains of a formula judged at one of the first steps."""
        if step >= self.ended(node):
            return self._remains[node, step]
        return self._known(lambda values: values[node][step])

    def over(self, node: Formula, steps: range, kind: Kind) -> list[Formula]:
        """What remains of a formula judged at some of the first steps, all or some of which count.

        Of the steps at which everything is past, it is one formula.
        """
        end = max(min(self.ended(node), steps.stop), steps.start)
        open_ = [self.at(node, step) for step in range(end, steps.stop)]
        if end == steps.start:
            return open_
        choose = np.min if kind is nodes.And else np.max
        return [self._known(lambda values: choose(values[node][steps.start : end])), *open_]

    def changed(self, node: nodes.Switch, step: int, end: int) -> tuple[Formula, Formula]:
        """What the steps from `step` to before `end` say of a change-over, all of which are past.

        The best one of these (for a release the worst), and the left side at all of them.
        """
        best, worst = (
            (np.max, np.minimum) if isinstance(node, nodes.Until) else (np.min, np.maximum)
        )
        low = step + node.low

        def change(values: Mapping[Formula, Values]) -> Any:
            left, right = values[node.left], values[node.right]
            before = worst.accumulate(left[step : end - 1])
            there = right[max(low, step + 1) : end]
            found = worst(there, before[before.size - there.size :])
            return best(np.concatenate([right[step : step + (low == step)], found]))

        through = self._known(lambda values: worst.reduce(values[node.left][step:end]))
        never = FALSE if isinstance(node, nodes.Until) else TRUE
        return self._known(change) if low < end else never, through

    def joined(self, kind: Kind, parts: Iterable[Formula]) -> Formula:
        """All or some of several parts, without those that never decide."""
        made = joined(kind, parts)
        if isinstance(made, kind):
            decide = self._dominance.least if kind is nodes.And else self._dominance.greatest
            made = joined(kind, decide(made.children))
        return _floored(made)

    def _known(self, found: Callable[[Mapping[Formula, Values]], Any]) -> Formula:
        """What is known of the past, as a formula."""
        margin = float(found(self._margins))
        if self._truths is None:
            return known_count(margin)
        return known_signal(margin, bool(found(self._truths)))


def _floored(formula: Formula) -> Formula:
    """`m && (n || p)` as `n || (m && p)`, where m > n: known margins of one kind meet then."""
    if not isinstance(formula, nodes.And) or len(formula.children) != _TWO:
        return formula
    for cap, other in (formula.children, formula.children[::-1]):
        most = settled(cap)
        if most is None or not isinstance(other, nodes.Or):
            continue
        floors = [part for part in other.children if settled(part) is not None]
        rest = [part for part in other.children if settled(part) is None]
        if len(floors) == 1 and rest:
            return joined(nodes.Or, (*floors, joined(nodes.And, (cap, joined(nodes.Or, rest)))))
    return formula


@singledispatch
def remains(node: Formula, _step: int, _past: Past) -> Formula:
    """What remains of a node judged at one of the first steps, if it looks past the last of them.

    Every class of nodes registers its own.
    """
    raise TypeError(f"no progression is registered for {type(node).__name__}")


@remains.register
def _(
    node: nodes.Constant | Count | Linear | Known | Task | Limit, _step: int, _past: Past
) -> Formula:
    raise ValueError(f"'{node}' looks at no step after its own; of tasks, translate the formula")


@remains.register
def _(node: Execution, step: int, past: Past) -> Formula:
    assert isinstance(past.trace, CountTrace)
    if not past.trace.executed(node.task, node.label)[step]:
        return FALSE
    return still_executed(node, past.steps - step, past.consumed)


@remains.register
def _(node: nodes.Not | nodes.Whole | nodes.Pair, step: int, past: Past) -> Formula:
    return simpler(node, tuple(past.at(child, step) for child in node.children))


@remains.register
def _(node: nodes.And | nodes.Or, step: int, past: Past) -> Formula:
    return past.joined(type(node), (past.at(child, step) for child in node.children))


@remains.register
def _(node: nodes.Eventually | nodes.Always, step: int, past: Past) -> Formula:
    kind: Kind = nodes.Or if isinstance(node, nodes.Eventually) else nodes.And
    first, end = step + node.low, step + node.high + 1
    parts = past.over(node.child, range(first, min(end, past.steps)), kind)
    if end > past.steps:
        window = max(first, past.steps) - past.steps, end - 1 - past.steps
        parts.append(type(node)(*window, node.child))
    return past.joined(kind, parts)


@remains.register
def _(node: nodes.Until | nodes.Release, step: int, past: Past) -> Formula:
    """Right at a step, or left there and the rest; the rest of the last one is a new window."""
    some: Kind = nodes.Or if isinstance(node, nodes.Until) else nodes.And
    every: Kind = nodes.And if isinstance(node, nodes.Until) else nodes.Or
    last, low = step + node.high, step + node.low
    if last < past.steps:
        made, end = past.at(node.right, last), last
    else:
        window = max(low, past.steps) - past.steps, last - past.steps
        made, end = type(node)(*window, node.left, node.right), past.steps
    ended = min(past.ended(node.left), past.ended(node.right), end)
    for earlier in range(end - 1, max(ended, step) - 1, -1):
        made = past.joined(every, (past.at(node.left, earlier), made))
        if earlier >= low:
            made = past.joined(some, (past.at(node.right, earlier), made))
    if ended > step:
        change, through = past.changed(node, step, ended)
        made = past.joined(some, (change, past.joined(every, (through, made))))
    return made
