"""How much of a formula holds on a trace: its fraction, as an exact number from 0 to 1.

The fraction of an atom is 1 where it holds and 0 where it does not; of `and` the mean of its
parts, of `G` the mean over its window; of `or` and `F` the greatest; of `p U[a,b] q` the greatest,
over the steps s at which the change-over may be, of the mean of q at s and p at each step before.
A formula holds exactly where its fraction is 1. The formula is taken as it is written, in positive
normal form: `a && b && c` has three parts, `a && (b && c)` two. A task is the tree it translates
to, an atom stays one atom whatever its relation, and release is read through until
(`tree_of`).

Source: G. A. Cardona and C.-I. Vasile, "Partial Satisfaction of Signal Temporal Logic
Specifications for Coordination of Multi-Robot Systems", WAFR 2022, with the mean in until.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import singledispatch
from itertools import accumulate
from math import inf, lcm
from typing import NamedTuple, TypeAlias

from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Limit, Linear, Task
from tsplan.logic.catl import TaskInterval, translate
from tsplan.logic.evaluation import holds, robustness
from tsplan.logic.nodes import Formula, disjunction
from tsplan.logic.normal_form import positive_atoms
from tsplan.logic.traces import Trace
from tsplan.logic.traversal import fold, fold_all


class Share(NamedTuple):
    """How much of a formula holds at a step, and what the atoms that hold for it have to spare.

    Of two shares the greater fraction is better, and of equal ones the greater spare. `spare` is
    the least robustness of what is satisfied, infinite where nothing is or nothing can fail.
    """

    fraction: Fraction
    spare: float


Shares: TypeAlias = "tuple[Share, ...]"  # one for each step that can be judged, from 0 on

NOTHING = Share(Fraction(0), inf)
WHOLE = Share(Fraction(1), inf)


def tree_of(formula: Formula, interval: TaskInterval = "closed") -> Formula:
    """The tree whose fraction is meant: positive, without tasks, limits and release.

    `p R[a,b] q` becomes: q throughout, or p before a, or from a on q until both. Weights of its
    steps say how much q counts at each, so they go to "throughout".

    >>> from tsplan.logic import parse
    >>> print(tree_of(parse("!(a && sum(b) = 2)")))
    sum(a) < 1 || sum(b) != 2
    >>> print(tree_of(parse("a R[0,3] b")))
    G[0,3] b || (b U[0,2] (a && b))
    """
    return fold(positive_atoms(translate(formula, interval)), _without_release)


def _without_release(node: Formula, below: tuple[Formula, ...]) -> Formula:
    if not isinstance(node, nodes.Release):
        return node.over(below)
    left, right = below
    low, high = node.low, node.high
    options: list[Formula] = [nodes.Always(low, high, right, node.weights)]
    if low:
        options.append(nodes.Eventually(0, low - 1, left))
    if high > low:
        until = nodes.Until(0, high - 1 - low, right, nodes.And((left, right)))
        options.append(nodes.Eventually(low, low, until) if low else until)
    return disjunction(options)


def fraction(formula: Formula, trace: Trace, interval: TaskInterval = "closed") -> Fraction:
    """How much of a formula holds at step 0.

    Raises ValueError for a trace that is too short or a batch, or that lacks a name.

    >>> from tsplan.logic import parse
    >>> from tsplan.logic.traces import SignalTrace
    >>> trace = SignalTrace({"x": [1.0, 4.0, 2.0, 0.0]})
    >>> fraction(parse("G[0,3] x >= 2", language="stl"), trace)
    Fraction(1, 2)
    """
    tree = tree_of(formula, interval)
    judged = shares(tree, trace)[tree]
    if not judged:
        raise ValueError("the trace is too short for the formula")
    return judged[0].fraction


def shares(tree: Formula, trace: Trace) -> dict[Formula, Shares]:
    """The shares of every sub-formula of a tree, at every step of a trace that can be judged."""
    if trace.batch:
        raise ValueError("fractions are computed for one trace, not for a batch")
    return shares_of(tree, lambda atom: _atom(atom, trace))


def shares_of(tree: Formula, atom: Callable[[Formula], Shares]) -> dict[Formula, Shares]:
    """The shares of every sub-formula of a tree, given those of its atoms and constants."""
    return fold_all(tree, lambda node, below: share(node, below) if below else atom(node))


def _atom(node: Formula, trace: Trace) -> Shares:
    if isinstance(node, nodes.Constant):
        return (WHOLE if node.value else NOTHING,) * trace.steps
    if not isinstance(node, Count | Linear):
        return share(node, ())
    held, spare = holds(node, trace).tolist(), robustness(node, trace).tolist()
    return tuple(
        Share(Fraction(1), by) if so else NOTHING for so, by in zip(held, spare, strict=True)
    )


@singledispatch
def share(node: Formula, _below: tuple[Shares, ...]) -> Shares:
    """A node's shares from those of its children. Every class of nodes registers its own."""
    raise TypeError(f"no fraction is registered for {type(node).__name__}")


@share.register
def _(node: nodes.Constant | Count | Linear, _below: tuple[Shares, ...]) -> Shares:
    raise ValueError(f"'{node}' is judged on a trace")


@share.register
def _(
    node: nodes.Not | nodes.Implies | nodes.Iff | nodes.Release | Task | Limit,
    _below: tuple[Shares, ...],
) -> Shares:
    raise ValueError(f"'{node}' has no fraction of its own; take tree_of() first")


@share.register
def _(_node: nodes.And, below: tuple[Shares, ...]) -> Shares:
    return tuple(mean(parts) for parts in zip(*below, strict=False))


@share.register
def _(_node: nodes.Or, below: tuple[Shares, ...]) -> Shares:
    return tuple(max(parts) for parts in zip(*below, strict=False))


@share.register
def _(node: nodes.Always, below: tuple[Shares, ...]) -> Shares:
    total = list(accumulate((part.fraction for part in below[0]), initial=Fraction(0)))
    length = node.high - node.low + 1
    return tuple(
        Share(
            (total[step + node.high + 1] - total[step + node.low]) / length,
            min(part.spare for part in below[0][step + node.low : step + node.high + 1]),
        )
        for step in range(len(below[0]) - node.high)
    )


@share.register
def _(node: nodes.Eventually, below: tuple[Shares, ...]) -> Shares:
    return tuple(
        max(below[0][step + node.low : step + node.high + 1])
        for step in range(len(below[0]) - node.high)
    )


@share.register
def _(node: nodes.Until, below: tuple[Shares, ...]) -> Shares:
    left, right = below
    steps = len(right) - node.high
    if node.high:  # or else the left side does not matter
        steps = min(steps, len(left) + 1 - node.high)
    return tuple(max(made for _, made in changes(node, step, left, right)) for step in range(steps))


def changes(node: nodes.Until, step: int, left: Shares, right: Shares) -> list[tuple[int, Share]]:
    """Every step at which an until judged at `step` may change over, and its share if it does."""
    held, spare = Fraction(0), inf
    found = []
    for switch in range(step, step + node.high + 1):
        if switch >= step + node.low:
            part = right[switch]
            total = (held + part.fraction) / (switch - step + 1)
            found.append((switch, Share(total, min(spare, part.spare))))
        if switch < step + node.high:
            held += left[switch].fraction
            spare = min(spare, left[switch].spare)
    return found


def mean(parts: Sequence[Share]) -> Share:
    """The share of parts that count the same."""
    total = sum((part.fraction for part in parts), Fraction(0))
    return Share(total / len(parts), min(part.spare for part in parts))


def denominator(tree: Formula) -> int:
    """A whole number of which every possible fraction of a tree is a multiple of the inverse.

    >>> from tsplan.logic import parse
    >>> denominator(parse("F[0,9] G[0,2] (a && b)"))
    6
    """
    number: int = fold(tree, _denominator)
    return number


def _denominator(node: Formula, below: tuple[int, ...]) -> int:
    common = lcm(*below)
    if isinstance(node, nodes.And):
        return common * len(below)
    if isinstance(node, nodes.Always):
        return common * (node.high - node.low + 1)
    if isinstance(node, nodes.Until):
        return common * lcm(*range(node.low + 1, node.high + 2))
    return common
