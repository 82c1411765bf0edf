"""Truth and robustness of formulas on traces, vectorised over steps and batches.

Robustness of counts is called availability: of `f >= m` it is f - m, of `f <= m` it is m - f, in
whole numbers, so that the negation of a formula with availability r has -r - 1. On signals the
negation has -r. `and` and `G` take the minimum, `or` and `F` the maximum.

Source: A. Donzé and O. Maler, "Robust satisfaction of temporal logic over real-valued signals",
FORMATS 2010, read in discrete time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce, singledispatch
from types import MappingProxyType

import numpy as np

from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Limit, Linear, Percent, Relation, Task
from tsplan.logic.catl import translate
from tsplan.logic.nodes import Formula
from tsplan.logic.time_horizon import horizon
from tsplan.logic.traces import CountTrace, SignalTrace, Trace, Values
from tsplan.logic.traversal import fold, fold_all
from tsplan.logic.windows import Choose, switched, windowed

__all__ = ["CountTrace", "SignalTrace", "Trace", "holds", "margins", "robustness"]

Compare = Callable[[Values, float], Values]


@dataclass(frozen=True, eq=False)
class Reading:
    """What the values of a formula are: its constants, atoms and negation.

    Minimum and maximum serve all readings, since on Boolean values they are "and" and "or".
    """

    trace: Trace
    true: Values
    false: Values
    compare: Mapping[Relation, Compare]
    negate: Callable[[Values], Values]


def robustness(formula: Formula, trace: Trace) -> Values:
    """By how much the formula holds (>= 0) or fails (< 0), at every step that can be judged.

    An array (..., steps - horizon) of floats; whole numbers, or infinite for constants, on counts.
    Tasks are read with their closed interval; translate first for the half-open one.

    Raises ValueError for a trace that is too short, lacks a name or does not fit the formula.

    >>> from tsplan.logic import parse
    >>> trace = SignalTrace({"x": np.array([1.0, 4.0, 2.0, 0.0])})
    >>> robustness(parse("F[0,1] x >= 3", language="stl"), trace)
    array([ 1.,  1., -1.])
    """
    return _judged(formula, _margin_reading(trace))


def margins(formula: Formula, trace: Trace) -> Mapping[Formula, Values]:
    """The robustness of a formula and of each of its sub-formulas, at every step it can be judged.

    The formula must hold no tasks and limits; translate it first. Each array is `robustness` of
    its sub-formula, whose last steps are those of the trace less its own horizon.

    Raises ValueError as `robustness` does.

    >>> from tsplan.logic import parse
    >>> trace = SignalTrace({"x": np.array([1.0, 4.0, 2.0, 0.0])})
    >>> margins(parse("F[0,1] x >= 3", language="stl"), trace)[parse("x >= 3", language="stl")]
    array([-2.,  1., -1., -3.])
    """
    _refuse_short(formula, trace)
    return values_of(formula, _margin_reading(trace))


def values_of(formula: Formula, reading: Reading) -> Mapping[Formula, Values]:
    """The values of a formula and of each of its sub-formulas, in one reading."""
    return MappingProxyType(fold_all(formula, lambda node, below: value(node, below, reading)))


def _margin_reading(trace: Trace) -> Reading:
    counted = isinstance(trace, CountTrace)
    return Reading(
        trace,
        np.full(trace.steps, np.inf),
        np.full(trace.steps, -np.inf),
        _COUNT_MARGINS if counted else _SIGNAL_MARGINS,
        _negated_count if counted else np.negative,
    )


def holds(formula: Formula, trace: Trace) -> Values:
    """Whether the formula holds, at every step that can be judged: Booleans (..., steps - horizon).

    On counts this is `robustness(...) >= 0`. On signals it differs only on the border, where a
    strict relation fails at robustness 0.

    >>> from tsplan.logic import parse
    >>> trace = SignalTrace({"x": np.array([1.0, 4.0, 2.0, 0.0])})
    >>> holds(parse("F[0,1] x >= 3", language="stl"), trace).tolist()
    [True, True, False]
    """
    steps = trace.steps
    true, false = np.ones(steps, dtype=np.bool_), np.zeros(steps, dtype=np.bool_)
    return _judged(formula, Reading(trace, true, false, TRUTH, np.logical_not))


def _judged(formula: Formula, reading: Reading) -> Values:
    plain = translate(formula)
    length = _refuse_short(plain, reading.trace)
    values = fold(plain, lambda node, below: value(node, below, reading))
    return np.broadcast_to(values[..., :length], (*reading.trace.batch, length)).copy()


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


_CHOICES: Mapping[type[Formula], tuple[Choose, ...]] = MappingProxyType(
    {
        nodes.And: (np.minimum,),
        nodes.Or: (np.maximum,),
        nodes.Eventually: (np.maximum,),
        nodes.Always: (np.minimum,),
        nodes.Until: (np.maximum, np.minimum),
        nodes.Release: (np.minimum, np.maximum),
    }
)
"""What an operator takes of the values of its operands; until and release at the best change-over
the worst on the way to it, and the other way round."""


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
def _(node: nodes.And | nodes.Or, below: tuple[Values, ...], _reading: Reading) -> Values:
    return reduce(_CHOICES[type(node)][0], _aligned(*below))


@value.register
def _(_node: nodes.Implies, below: tuple[Values, ...], reading: Reading) -> Values:
    left, right = _aligned(*below)
    return np.maximum(reading.negate(left), right)


@value.register
def _(_node: nodes.Iff, below: tuple[Values, ...], reading: Reading) -> Values:
    left, right = _aligned(*below)
    neither = np.minimum(reading.negate(left), reading.negate(right))
    return np.maximum(np.minimum(left, right), neither)


@value.register
def _(
    node: nodes.Eventually | nodes.Always, below: tuple[Values, ...], _reading: Reading
) -> Values:
    return windowed(below[0], node.low, node.high, *_CHOICES[type(node)])


@value.register
def _(node: nodes.Until | nodes.Release, below: tuple[Values, ...], _reading: Reading) -> Values:
    return switched(below, (node.low, node.high), *_CHOICES[type(node)])


@value.register
def _(node: Count, _below: tuple[Values, ...], reading: Reading) -> Values:
    if not isinstance(reading.trace, CountTrace):
        raise ValueError(f"'{node}' counts agents, but the trace holds signals")  # noqa: TRY004  (the trace is the value)
    if isinstance(node.bound, Percent):
        raise ValueError(f"'{node}' is a percentage; resolve_percent() makes it a number")  # noqa: TRY004  (as above)
    counts = reading.trace.at(node.label, node.capability)
    measured: Values = getattr(counts, node.function)(axis=-2)
    return reading.compare[node.relation](measured, float(node.bound))


@value.register
def _(node: Linear, _below: tuple[Values, ...], reading: Reading) -> Values:
    if not isinstance(reading.trace, SignalTrace):
        raise ValueError(f"'{node}' compares signals, but the trace holds counts")  # noqa: TRY004  (the trace is the value)
    total: Values = np.zeros(reading.trace.steps)
    for name, factor in node.terms:
        total = total + factor * reading.trace.signal(name)
    return reading.compare[node.relation](total, node.bound)


@value.register
def _(node: Task | Limit, _below: tuple[Values, ...], _reading: Reading) -> Values:
    raise ValueError(f"'{node}' is judged through its translation")


def _aligned(*arrays: Values) -> tuple[Values, ...]:
    """The arrays over the steps that all of them have."""
    length = min(array.shape[-1] for array in arrays)
    return tuple(array[..., :length] for array in arrays)
