"""Truth and robustness of formulas on traces, vectorised over steps and batches.

Robustness of counts is called availability: of `f >= m` it is f - m, of `f <= m` it is m - f, in
whole numbers, so that the negation of a formula with availability r has -r - 1. On signals the
negation has -r. `and` and `G` take the minimum, `or` and `F` the maximum.

Signals may be read in another kind besides, whose rules are in `tsplan.logic.connectives`.

Source: A. Donzé and O. Maler, "Robust satisfaction of temporal logic over real-valued signals",
FORMATS 2010, read in discrete time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial, singledispatch
from types import MappingProxyType
from typing import Literal, TypeAlias, get_args

import numpy as np

from tsplan.errors import nearest
from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Execution, Known, Limit, Linear, Percent, Relation, Task
from tsplan.logic.catl import translate
from tsplan.logic.connectives import EXTREMES, Connectives, Means, Scaled
from tsplan.logic.nodes import Formula
from tsplan.logic.normal_form import positive
from tsplan.logic.predicate_ranges import Bounds, predicate_ranges
from tsplan.logic.time_horizon import horizon
from tsplan.logic.traces import CountTrace, SignalTrace, Trace, Values
from tsplan.logic.traversal import fold, fold_all, walk, walk_all

__all__ = ["KINDS", "CountTrace", "Kind", "SignalTrace", "Trace", "holds", "margins", "robustness"]

Kind: TypeAlias = Literal["traditional", "agm", "product", "normalised"]

KINDS: tuple[Kind, ...] = get_args(Kind)
"""The kinds of robustness; each is positive where the formula holds and negative where not."""

Compare = Callable[[Values, float], Values]


@dataclass(frozen=True, eq=False)
class Reading:
    """What the values of a formula are: its constants and atoms, and how operators join them.

    `scale` turns the margins of predicates over signals into their values. `measures` says that
    values are margins, so that what is known by one has that and not only its truth.
    """

    trace: Trace
    true: Values
    false: Values
    compare: Mapping[Relation, Compare]
    negate: Callable[[Values], Values]
    connectives: Connectives = EXTREMES
    scale: Callable[[Linear, Values], Values] = lambda _, margins: margins
    measures: bool = True


def robustness(
    formula: Formula,
    trace: Trace | Mapping[str, Values],
    kind: Kind = "traditional",
    bounds: Bounds | None = None,
) -> Values:
    """By how much the formula holds (>= 0) or fails (< 0), at every step that can be judged.

    An array (..., steps - horizon) of floats; whole numbers, or infinite for constants, on counts.
    Tasks are read with their closed interval; translate first for the half-open one. A mapping of
    names to arrays (..., steps) is a trace of signals.

    `traditional` takes the least and the greatest and leaves weights aside. `product` and
    `normalised` do so after multiplying parts by what their weights make of it; see
    `tsplan.logic.weights`. `agm` takes means (with the weights there are) and is for signals alone:
    the margin of a predicate is divided by its range, which follows from `bounds`, the least and
    the greatest value of each signal that the formula names; values lie in [-1, 1]. The other kinds
    do without bounds. A formula of counts is weighted in its positive normal form.

    Raises ValueError for a trace that is too short, lacks a name or does not fit the formula, for
    an unknown kind, and for bounds that are missing or of no use.

    >>> from tsplan.logic import parse
    >>> formula, x = parse("F[0,1] x >= 3", language="stl"), np.array([1.0, 4.0, 2.0, 0.0])
    >>> robustness(formula, {"x": x})
    array([ 1.,  1., -1.])
    >>> robustness(formula, {"x": x}, kind="agm", bounds={"x": (0, 10)}).round(3)
    array([ 0.05 ,  0.05 , -0.196])
    """
    given = SignalTrace(trace) if isinstance(trace, Mapping) else trace
    reading = _margin_reading(formula, given, kind, bounds)
    if reading.negate is _refused:
        return _judged(positive(translate(formula)), reading)
    return _judged(formula, reading)


def margins(
    formula: Formula, trace: Trace, kind: Kind = "traditional", bounds: Bounds | None = None
) -> Mapping[Formula, Values]:
    """The robustness of a formula and of each of its sub-formulas, at every step it can be judged.

    The formula must hold no tasks and limits; translate it first, and one of counts with weights
    into its positive normal form. Each array is `robustness` of
    its sub-formula, whose last steps are those of the trace less its own horizon.

    Raises ValueError as `robustness` does.

    >>> from tsplan.logic import parse
    >>> trace = SignalTrace({"x": np.array([1.0, 4.0, 2.0, 0.0])})
    >>> margins(parse("F[0,1] x >= 3", language="stl"), trace)[parse("x >= 3", language="stl")]
    array([-2.,  1., -1., -3.])
    """
    _refuse_short(formula, trace)
    return values_of(formula, _margin_reading(formula, trace, kind, bounds))


def values_of(formula: Formula, reading: Reading) -> Mapping[Formula, Values]:
    """The values of a formula and of each of its sub-formulas, in one reading."""
    negated = (nodes.Not, nodes.Implies, nodes.Iff)
    if _two_counts(reading.trace) and any(isinstance(node, negated) for node in walk(formula)):
        alone = {node: positive(node) for node in walk(formula)}
        values: dict[Formula, Values] = {}
        for node in walk_all(alone.values()):
            values[node] = value(node, tuple(values[child] for child in node.children), reading)
        return MappingProxyType({node: values[plain] for node, plain in alone.items()})
    return MappingProxyType(fold_all(formula, lambda node, below: value(node, below, reading)))


def _margin_reading(formula: Formula, trace: Trace, kind: Kind, bounds: Bounds | None) -> Reading:
    if kind not in KINDS:
        raise ValueError(f"there is no robustness of the kind '{kind}'; {nearest(kind, KINDS)}")
    true, counted = np.full(trace.steps, np.inf), isinstance(trace, CountTrace)
    compare = _COUNT_MARGINS if counted else _SIGNAL_MARGINS
    if kind == "agm":
        if counted:
            raise ValueError("robustness of the kind 'agm' is of signals, the trace holds counts")
        scale = partial(_in_range, predicate_ranges(formula, bounds or {}))
        whole = np.ones(trace.steps)
        return Reading(trace, whole, -whole, compare, np.negative, Means(), scale)
    if kind == "traditional":
        return margin_reading(trace)
    return Reading(trace, true, -true, compare, _refused if counted else np.negative, Scaled(kind))


def margin_reading(trace: Trace) -> Reading:
    """Values are margins: traditional robustness."""
    true = np.full(trace.steps, np.inf)
    if isinstance(trace, CountTrace):
        return Reading(trace, true, -true, _COUNT_MARGINS, _negated_count)
    return Reading(trace, true, -true, _SIGNAL_MARGINS, np.negative)


def truth_reading(trace: Trace) -> Reading:
    """Values are truths: Booleans."""
    true, false = np.ones(trace.steps, dtype=np.bool_), np.zeros(trace.steps, dtype=np.bool_)
    return Reading(trace, true, false, TRUTH, np.logical_not, measures=False)


def _refused(_values: Values) -> Values:
    """What -r - 1 of a weighted r would be is no weighted value of anything."""
    raise ValueError("a formula of counts is weighted in its positive normal form alone")


def _in_range(ranges: Mapping[Linear, float], atom: Linear, margins: Values) -> Values:
    """Margins as shares of the range of a predicate, from -1 to 1; of a constant their signs."""
    if not ranges[atom]:
        return np.sign(margins)
    return np.clip(margins / ranges[atom], -1.0, 1.0)


def holds(formula: Formula, trace: Trace) -> Values:
    """Whether the formula holds, at every step that can be judged: Booleans (..., steps - horizon).

    On counts this is `robustness(...) >= 0`. On signals it differs only on the border, where a
    strict relation fails at robustness 0.

    >>> from tsplan.logic import parse
    >>> trace = SignalTrace({"x": np.array([1.0, 4.0, 2.0, 0.0])})
    >>> holds(parse("F[0,1] x >= 3", language="stl"), trace).tolist()
    [True, True, False]
    """
    return _judged(formula, truth_reading(trace))


def _judged(formula: Formula, reading: Reading) -> Values:
    plain = translate(formula)
    if _two_counts(reading.trace):
        plain = positive(plain)  # which counts an atom is about is told by its own relation
    length = _refuse_short(plain, reading.trace)
    values = fold(plain, lambda node, below: value(node, below, reading))
    return np.broadcast_to(values[..., :length], (*reading.trace.batch, length)).copy()


def _two_counts(trace: Trace) -> bool:
    """Whether bounds from above are held against counts of their own."""
    return isinstance(trace, CountTrace) and bool(trace.most)


def _refuse_short(plain: Formula, trace: Trace) -> int:
    """How many steps can be judged; ValueError if none can."""
    length = trace.steps - horizon(plain)
    if length < 1:
        raise ValueError(
            f"the formula looks {horizon(plain)} steps ahead, "
            f"the trace has only {trace.steps}; {1 - length} more are needed"
        )
    return length


def _negated_count(values: Values) -> Values:
    return -values - 1.0


def _margins(strict: float) -> Mapping[Relation, Compare]:
    """Margins of comparisons; a strict one of whole numbers asks for 1 more than another."""
    return MappingProxyType(
        {
            ">=": lambda values, bound: values - bound,
            "<=": lambda values, bound: bound - values,
            ">": lambda values, bound: values - bound - strict,
            "<": lambda values, bound: bound - values - strict,
            "=": lambda values, bound: -np.abs(values - bound),
            "!=": lambda values, bound: np.abs(values - bound) - strict,
        }
    )


_COUNT_MARGINS, _SIGNAL_MARGINS = _margins(1.0), _margins(0.0)

TRUTH: Mapping[Relation, Compare] = MappingProxyType(
    {
        ">=": np.greater_equal,
        "<=": np.less_equal,
        ">": np.greater,
        "<": np.less,
        "=": np.equal,
        "!=": np.not_equal,
    }
)


@singledispatch
def value(node: Formula, _below: tuple[Values, ...], _reading: Reading) -> Values:
    """A node's values from those of its children. Every class of nodes registers its own."""
    raise TypeError(f"no evaluation is registered for {type(node).__name__}")


@value.register
def _(node: nodes.Constant, _below: tuple[Values, ...], reading: Reading) -> Values:
    return reading.true if node.value else reading.false


@value.register
def _(_node: nodes.Not, below: tuple[Values, ...], reading: Reading) -> Values:
    return reading.negate(below[0])


@value.register
def _(_node: nodes.Whole, below: tuple[Values, ...], _reading: Reading) -> Values:
    return below[0]


@value.register
def _(node: nodes.And | nodes.Or, below: tuple[Values, ...], reading: Reading) -> Values:
    return reading.connectives.joined(type(node), below, node.weights)


@value.register
def _(_node: nodes.Implies, below: tuple[Values, ...], reading: Reading) -> Values:
    left, right = below
    return reading.connectives.joined(nodes.Or, (reading.negate(left), right))


@value.register
def _(_node: nodes.Iff, below: tuple[Values, ...], reading: Reading) -> Values:
    joined = reading.connectives.joined
    neither = joined(nodes.And, tuple(map(reading.negate, below)))
    return joined(nodes.Or, (joined(nodes.And, below), neither))


@value.register
def _(node: nodes.Eventually | nodes.Always, below: tuple[Values, ...], reading: Reading) -> Values:
    return reading.connectives.over_window(node, *below)


@value.register
def _(node: nodes.Until | nodes.Release, below: tuple[Values, ...], reading: Reading) -> Values:
    return reading.connectives.over_switch(node, *below)


@value.register
def _(node: Count, _below: tuple[Values, ...], reading: Reading) -> Values:
    if not isinstance(reading.trace, CountTrace):
        raise ValueError(f"'{node}' counts agents, but the trace holds signals")  # noqa: TRY004  (the trace is the value)
    if isinstance(node.bound, Percent):
        raise ValueError(f"'{node}' is a percentage; resolve_percent() makes it a number")  # noqa: TRY004  (as above)
    bound = float(node.bound)
    if node.relation not in ("=", "!=") or not _two_counts(reading.trace):
        counts = reading.trace.at(node.label, node.capability, upper=node.upper)
        measured: Values = getattr(counts, node.function)(axis=-2)
        return reading.compare[node.relation](measured, bound)
    least, most = (
        getattr(reading.trace.at(node.label, node.capability, upper=upper), node.function)(axis=-2)
        for upper in (False, True)
    )
    if node.relation == "=":  # both ways
        sides = reading.compare[">="](least, bound), reading.compare["<="](most, bound)
        return np.asarray(np.minimum(*sides))
    sides = reading.compare[">"](least, bound), reading.compare["<"](most, bound)
    return np.asarray(np.maximum(*sides))  # one of them


@value.register
def _(node: Known, _below: tuple[Values, ...], reading: Reading) -> Values:
    if not isinstance(reading.trace, CountTrace):
        raise ValueError(f"'{node}' is about agents, but the trace holds signals")  # noqa: TRY004  (the trace is the value)
    if reading.measures:
        return np.full(reading.trace.steps, float(node.margin))
    return reading.true if node.margin >= 0 else reading.false


@value.register
def _(node: Execution, _below: tuple[Values, ...], reading: Reading) -> Values:
    if not isinstance(reading.trace, CountTrace):
        raise ValueError(f"'{node}' is about agents, but the trace holds signals")  # noqa: TRY004  (the trace is the value)
    return np.where(reading.trace.executed(node.task, node.label), reading.true, reading.false)


@value.register
def _(node: Linear, _below: tuple[Values, ...], reading: Reading) -> Values:
    if not isinstance(reading.trace, SignalTrace):
        raise ValueError(f"'{node}' compares signals, but the trace holds counts")  # noqa: TRY004  (the trace is the value)
    total: Values = np.zeros(reading.trace.steps)
    for name, factor in node.terms:
        total = total + factor * reading.trace.signal(name)
    return reading.scale(node, reading.compare[node.relation](total, node.bound))


@value.register
def _(node: Task | Limit, _below: tuple[Values, ...], _reading: Reading) -> Values:
    raise ValueError(f"'{node}' is judged through its translation")
