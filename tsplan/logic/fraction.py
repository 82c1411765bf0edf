"""How much of a formula holds on a trace: its fraction, as an exact number from 0 to 1.

The fraction of an atom is 1 where it holds and 0 where it does not; of `and` the mean of its
parts, of `G` the mean over its window; of `or` and `F` the greatest; of `p U[a,b] q` the greatest,
over the steps s at which the change-over may be, of the mean of q at s and p at each step before;
of `all` 1 where all of it holds and else 0. A formula holds exactly where its fraction is 1. The
formula is taken as it is written, in positive normal form: `a && b && c` has three parts,
`a && (b && c)` two. A task is the tree it translates to, an atom stays one atom whatever its
relation, and release is read through until (`tree_of`).

With weights it is a preference: means are those with the weights, and of alternatives each is
multiplied by its weight over the greatest of the node, which for until are those of the
change-overs. Weights are the decimal numbers that they are written as.

Sources: G. A. Cardona and C.-I. Vasile, "Partial Satisfaction of Signal Temporal Logic
Specifications for Coordination of Multi-Robot Systems", WAFR 2022, with the mean in until; weights
as the authors' tool PyTeLo has them (github.com/erl-lehigh/PyTeLo), and likewise those of until.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import singledispatch
from itertools import accumulate
from math import inf, lcm
from typing import NamedTuple, TypeAlias

from tsplan.exact import exact
from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Execution, Known, Limit, Linear, Task
from tsplan.logic.catl import TaskInterval, translate
from tsplan.logic.evaluation import holds, robustness
from tsplan.logic.nodes import Formula, disjunction
from tsplan.logic.normal_form import positive_atoms
from tsplan.logic.traces import Trace
from tsplan.logic.traversal import fold, fold_all, walk


class Share(NamedTuple):
    """How much of a formula holds at a step, and what the atoms that hold for it have to spare.

    Of two shares the greater fraction is better, and of equal ones the greater spare. `spare` is
    the least robustness of what is satisfied, infinite where nothing is or nothing can fail.
    """

    fraction: Fraction
    spare: float

    def scaled(self, by: Fraction) -> Share:
        """The share of an alternative that counts so much."""
        return Share(self.fraction * by, self.spare)


Joining: TypeAlias = nodes.Several | nodes.Window | nodes.Until
Shares: TypeAlias = "tuple[Share, ...]"  # one for each step that can be judged, from 0 on

NOTHING = Share(Fraction(0), inf)
WHOLE = Share(Fraction(1), inf)


def tree_of(formula: Formula, interval: TaskInterval = "closed") -> Formula:
    """The tree whose fraction is meant: positive, without tasks, limits and release.

    `p R[a,b] q` becomes: q throughout, or p before a, or from a on q until both. Weights of its
    steps say how much q counts at each, so they go to "throughout". What counts as a whole does so
    still; weights below it, which would not matter, are left out.

    >>> from tsplan.logic import parse
    >>> print(tree_of(parse("!(a && sum(b) = 2)")))
    sum(a) < 1 || sum(b) != 2
    >>> print(tree_of(parse("a R[0,3] b")))
    G[0,3] b || (b U[0,2] (a && b))
    """
    tree = fold(positive_atoms(translate(formula, interval)), without_release)
    if not any(isinstance(node, nodes.Whole) for node in walk(tree)):
        return tree
    plain = fold_all(tree, _plain)
    return fold(tree, lambda node, below: _over_plain(node, below, plain))


def _over_plain(
    node: Formula, below: tuple[Formula, ...], plain: Mapping[Formula, Formula]
) -> Formula:
    return nodes.Whole(plain[node]) if isinstance(node, nodes.Whole) else node.over(below)


def _plain(node: Formula, below: tuple[Formula, ...]) -> Formula:
    """A node without what matters only to formulas that may hold in part: weights and Whole."""
    if isinstance(node, nodes.Whole):
        return below[0]
    if getattr(node, "weights", None) is None:
        return node.over(below)
    return node.assembled(node.parameters[:-1], below)


def without_release(node: Formula, below: tuple[Formula, ...]) -> Formula:
    """A node over children without release, which is said by what holds instead."""
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


def fraction(
    formula: Formula, trace: Trace, interval: TaskInterval = "closed", *, weighted: bool = False
) -> Fraction:
    """How much of a formula holds at step 0; if `weighted`, by how much its weights prefer that.

    Raises ValueError for a trace that is too short or a batch, or that lacks a name.

    >>> from tsplan.logic import parse
    >>> from tsplan.logic.traces import SignalTrace
    >>> trace = SignalTrace({"x": [1.0, 4.0, 2.0, 0.0]})
    >>> formula = parse("G[0,3]^[1, 1, 1, 2] x >= 2", language="wstl")
    >>> fraction(formula, trace), fraction(formula, trace, weighted=True)
    (Fraction(1, 2), Fraction(2, 5))
    """
    tree = tree_of(formula, interval)
    judged = shares(tree, trace, weighted=weighted)[tree]
    if not judged:
        raise ValueError("the trace is too short for the formula")
    return judged[0].fraction


def shares(tree: Formula, trace: Trace, *, weighted: bool = False) -> dict[Formula, Shares]:
    """The shares of every sub-formula of a tree, at every step of a trace that can be judged."""
    if trace.batch:
        raise ValueError("fractions are computed for one trace, not for a batch")
    return shares_of(tree, lambda atom: _atom(atom, trace), weighted=weighted)


def shares_of(
    tree: Formula, atom: Callable[[Formula], Shares], *, weighted: bool = False
) -> dict[Formula, Shares]:
    """The shares of every sub-formula of a tree, given those of its atoms and constants."""
    return fold_all(tree, lambda node, below: share(node, below, weighted) if below else atom(node))


def portions(node: Joining, *, weighted: bool = True) -> tuple[Fraction, ...]:
    """What each part, step or change-over counts in a node: of all together, or of the greatest.

    Without weights, all count the same.

    >>> from tsplan.logic import parse
    >>> portions(parse("a &&^[1, 3] b", "wmtl")), portions(parse("a ||^[1, 2] b", "wmtl"))
    ((Fraction(1, 4), Fraction(3, 4)), (Fraction(1, 2), Fraction(1, 1)))
    """
    together = isinstance(node, nodes.And | nodes.Always)
    if node.weights is None or not weighted or is_even(node):
        count = len(node.children) if isinstance(node, nodes.Several) else node.high - node.low + 1
        return (Fraction(1, count if together else 1),) * count
    each = tuple(map(exact, node.weights))
    whole = sum(each) if together else max(each)
    return tuple(weight / whole for weight in each)


def preference(tree: Formula, trace: Trace) -> Fraction | None:
    """How much its weights prefer what holds of a tree at step 0; None for a tree without any."""
    if all(getattr(node, "weights", None) is None for node in walk(tree)):
        return None
    return shares(tree, trace, weighted=True)[tree][0].fraction


def is_even(node: Formula) -> bool:
    """Whether all weights of a node are the same, or it has none."""
    return len(set(getattr(node, "weights", None) or ())) <= 1


def _atom(node: Formula, trace: Trace) -> Shares:
    if isinstance(node, nodes.Constant):
        return (WHOLE if node.value else NOTHING,) * trace.steps
    if not isinstance(node, Count | Linear | Known | Execution):
        return share(node, (), False)
    held, spare = holds(node, trace).tolist(), robustness(node, trace).tolist()
    return tuple(
        Share(Fraction(1), by) if so else NOTHING for so, by in zip(held, spare, strict=True)
    )


@singledispatch
def share(node: Formula, _below: tuple[Shares, ...], _weighted: bool) -> Shares:
    """A node's shares from those of its children. Every class of nodes registers its own."""
    raise TypeError(f"no fraction is registered for {type(node).__name__}")


@share.register
def _(
    node: nodes.Constant | Count | Linear | Known | Execution,
    _below: tuple[Shares, ...],
    _weighted: bool,
) -> Shares:
    raise ValueError(f"'{node}' is judged on a trace")


@share.register
def _(
    node: nodes.Not | nodes.Implies | nodes.Iff | nodes.Release | Task | Limit,
    _below: tuple[Shares, ...],
    _weighted: bool,
) -> Shares:
    raise ValueError(f"'{node}' has no fraction of its own; take tree_of() first")


@share.register
def _(_node: nodes.Whole, below: tuple[Shares, ...], _weighted: bool) -> Shares:
    return tuple(part if part.fraction == 1 else NOTHING for part in below[0])


@share.register
def _(node: nodes.And, below: tuple[Shares, ...], weighted: bool) -> Shares:
    each = portions(node, weighted=weighted)
    return tuple(_mean(parts, each) for parts in zip(*below, strict=False))


@share.register
def _(node: nodes.Or, below: tuple[Shares, ...], weighted: bool) -> Shares:
    each = portions(node, weighted=weighted)
    return tuple(max(map(Share.scaled, parts, each)) for parts in zip(*below, strict=False))


@share.register
def _(node: nodes.Always, below: tuple[Shares, ...], weighted: bool) -> Shares:
    windows = _windows(node, below[0])
    each = portions(node, weighted=weighted)
    if weighted and not is_even(node):
        return tuple(_mean(window, each) for window in windows)
    total = list(accumulate((part.fraction for part in below[0]), initial=Fraction(0)))
    return tuple(
        Share(
            (total[step + node.high + 1] - total[step + node.low]) * each[0],
            min(part.spare for part in window),
        )
        for step, window in enumerate(windows)
    )


@share.register
def _(node: nodes.Eventually, below: tuple[Shares, ...], weighted: bool) -> Shares:
    windows = _windows(node, below[0])
    if weighted and not is_even(node):
        each = portions(node)
        return tuple(max(map(Share.scaled, window, each)) for window in windows)
    return tuple(map(max, windows))


@share.register
def _(node: nodes.Until, below: tuple[Shares, ...], weighted: bool) -> Shares:
    left, right = below
    steps = len(right) - node.high
    if node.high:  # or else the left side does not matter
        steps = min(steps, len(left) + 1 - node.high)
    each = portions(node, weighted=weighted)
    found = (changes(node, step, (left, right), each) for step in range(steps))
    return tuple(max(made for _, made in options) for options in found)


def changes(
    node: nodes.Until, step: int, sides: Sequence[Shares], each: Sequence[Fraction]
) -> list[tuple[int, Share]]:
    """Every step at which an until judged at `step` may change over, and its share if it does.

    `each` has the portion of every change-over.
    """
    left, right = sides
    held, spare = Fraction(0), inf
    found = []
    for switch in range(step, step + node.high + 1):
        if switch >= step + node.low:
            part = right[switch]
            total = (held + part.fraction) / (switch - step + 1)
            made = Share(total, min(spare, part.spare))
            found.append((switch, made.scaled(each[switch - step - node.low])))
        if switch < step + node.high:
            held += left[switch].fraction
            spare = min(spare, left[switch].spare)
    return found


def _windows(node: nodes.Window, below: Shares) -> Iterator[Shares]:
    """The shares of the child in the window from every step on."""
    for step in range(len(below) - node.high):
        yield below[step + node.low : step + node.high + 1]


def _mean(parts: Sequence[Share], each: Sequence[Fraction]) -> Share:
    total = sum((part.fraction * by for part, by in zip(parts, each, strict=True)), Fraction(0))
    return Share(total, min(part.spare for part in parts))


def denominator(tree: Formula) -> int:
    """A whole number of which every possible preference of a tree is a multiple of the inverse.

    >>> from tsplan.logic import parse
    >>> denominator(parse("F[0,9] G[0,2] (a && b)"))
    6
    """
    number: int = fold(tree, _denominator)
    return number


def _denominator(node: Formula, below: tuple[int, ...]) -> int:
    if not isinstance(node, Joining):
        return 1
    each = portions(node)
    if isinstance(node, nodes.Until):
        each = tuple(by / (switch + 1) for switch, by in enumerate(each, start=node.low))
    return lcm(*below) * lcm(*(by.denominator for by in each))
