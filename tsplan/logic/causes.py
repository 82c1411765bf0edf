"""Why a formula holds or fails: which steps of its sub-formulas settle it.

What settles an eventuality is one step at which its child holds, what settles an `always` is its
whole window; where they fail it is the other way round. Of several steps that would do, the
earliest with the largest robustness is chosen; of several parts of an `or`, the first one. All of
it is computed from the values of the evaluator, by which the choice settles the whole formula with
the whole formula's own robustness.

Source: I. Beer, S. Ben-David, H. Chockler, A. Orni, R. Trefler, "Explaining counterexamples using
causality", CAV 2009, carried over from failing to holding formulas and to robustness.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import singledispatch
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Execution, Known, Limit, Linear, Task
from tsplan.logic.nodes import Formula
from tsplan.logic.time_horizon import Span

Steps: TypeAlias = npt.NDArray[np.int64]
Values: TypeAlias = npt.NDArray[Any]

NONE = -1
"""Stands for a step where there is none."""

NO_STEPS: Steps = np.empty(0, dtype=np.int64)


class Cause(NamedTuple):
    """What settles a node at some steps.

    `below` has the steps of each child that settle it, sorted; a child without any is not needed.
    `witness_steps` has one step for each step of the node, where the node is settled by a choice of
    steps: the step of an eventuality, the tightest of an `always`, the change-over of an until or
    release; NONE where there is no such step.
    """

    below: tuple[Steps, ...]
    witness_steps: Steps | None = None


class Judged(NamedTuple):
    """A node's robustness and its children's, at every step, and the steps that are asked for."""

    steps: Steps
    own: Values
    below: tuple[Values, ...]


def cause_of(node: Formula, steps: Steps, margins: Mapping[Formula, Values]) -> Cause:
    """What settles a node at the given steps."""
    below = tuple(margins[child] for child in node.children)
    found: Cause = cause(node, Judged(steps, margins[node], below))
    return found


@singledispatch
def cause(node: Formula, _judged: Judged) -> Cause:
    """What settles a node. Every class of nodes registers its own."""
    raise TypeError(f"no cause is registered for {type(node).__name__}")


@cause.register
def _(_node: nodes.Constant | Count | Linear | Known | Execution, _judged: Judged) -> Cause:
    return Cause(())


@cause.register
def _(node: Task | Limit, _judged: Judged) -> Cause:
    raise ValueError(f"'{node}' is settled through its translation")


@cause.register
def _(node: nodes.Not | nodes.Whole | nodes.Iff, judged: Judged) -> Cause:
    return Cause(tuple(judged.steps for _ in node.children))


@cause.register
def _(_node: nodes.And, judged: Judged) -> Cause:
    return Cause(_parts(judged, -np.array([b[judged.steps] for b in judged.below]), every=True))


@cause.register
def _(_node: nodes.Or, judged: Judged) -> Cause:
    return Cause(_parts(judged, np.array([b[judged.steps] for b in judged.below]), every=False))


@cause.register
def _(_node: nodes.Implies, judged: Judged) -> Cause:
    left, right = (b[judged.steps] for b in judged.below)
    own = judged.own[judged.steps]
    # what a left side that fails is worth is not the same for counts and signals, but this is
    score = np.where(right < own, own, -left - 1.0)
    return Cause(_parts(judged, np.array([score, right]), every=False))


@cause.register
def _(node: nodes.Eventually, judged: Judged) -> Cause:
    best = _extreme(judged, (node.low, node.high), judged.below[0])
    return _one_or_all(judged, (node.low, node.high), best, one=judged.own[judged.steps] >= 0)


@cause.register
def _(node: nodes.Always, judged: Judged) -> Cause:
    worst = _extreme(judged, (node.low, node.high), -judged.below[0])
    return _one_or_all(judged, (node.low, node.high), worst, one=judged.own[judged.steps] < 0)


@cause.register
def _(node: nodes.Until, judged: Judged) -> Cause:
    left, right = judged.below
    reached = judged.own[judged.steps] >= 0
    return _switched(judged, (node.low, node.high), (left, right), reached)


@cause.register
def _(node: nodes.Release, judged: Judged) -> Cause:
    left, right = judged.below
    reached = judged.own[judged.steps] < 0
    return _switched(judged, (node.low, node.high), (-left, -right), reached)


def _parts(judged: Judged, scores: Values, *, every: bool) -> tuple[Steps, ...]:
    """The steps of each part: all parts where the node is settled by all, else the best by score.

    An `or` that holds and an `and` that fails are settled by one part.
    """
    holds = judged.own[judged.steps] >= 0
    best = scores.argmax(axis=0)
    alone = ~holds if every else holds
    return tuple(judged.steps[~alone | (best == number)] for number in range(len(judged.below)))


def _extreme(judged: Judged, interval: Span, scores: Values) -> Steps:
    """The earliest step with the largest score in the window of every step."""
    low, high = interval
    found = (t + low + int(np.argmax(scores[t + low : t + high + 1])) for t in judged.steps)
    return np.fromiter(found, dtype=np.int64, count=len(judged.steps))


def _one_or_all(judged: Judged, interval: Span, chosen: Steps, *, one: Values) -> Cause:
    """The chosen step where `one` says so, the whole window elsewhere."""
    low, high = interval
    whole = [np.arange(t + low, t + high + 1, dtype=np.int64) for t in judged.steps[~one]]
    return Cause((_union([chosen[one], *whole]),), chosen)


def _switched(
    judged: Judged, interval: Span, sides: tuple[Values, Values], reached: Values
) -> Cause:
    """The change-over of an until where it is `reached`; else why every change-over fails.

    A release is the same with both sides' signs turned, reached where the release fails.
    """
    lefts, rights, chosen = [NO_STEPS], [NO_STEPS], []
    for t, there in zip(judged.steps.tolist(), reached.tolist(), strict=True):
        step, left, right = (_change if there else _refusal)(t, interval, sides)
        chosen.append(step)
        lefts.append(left)
        rights.append(right)
    return Cause((_union(lefts), _union(rights)), np.array(chosen, dtype=np.int64))


def _change(t: int, interval: Span, sides: tuple[Values, Values]) -> tuple[int, Steps, Steps]:
    """The best change-over from step t: right at it, left before it."""
    left, right = sides
    low, high = interval
    before = np.minimum.accumulate(np.concatenate([[np.inf], left[t : t + high]]))
    step = t + low + int(np.argmax(np.minimum(right[t + low : t + high + 1], before[low:])))
    return step, np.arange(t, step, dtype=np.int64), np.array([step], dtype=np.int64)


def _refusal(t: int, interval: Span, sides: tuple[Values, Values]) -> tuple[int, Steps, Steps]:
    """Why no change-over from step t is any better: left has ended, right never came before."""
    left, right = sides
    low, high = interval
    before = np.minimum.accumulate(np.concatenate([[np.inf], left[t : t + high]]))
    best = np.minimum(right[t + low : t + high + 1], before[low:]).max()
    ended = np.flatnonzero(left[t : t + high] <= best)
    if not ended.size:
        return NONE, NO_STEPS, np.arange(t + low, t + high + 1, dtype=np.int64)
    step = t + int(ended[0])
    return step, np.array([step], dtype=np.int64), np.arange(t + low, step + 1, dtype=np.int64)


def _union(parts: list[Steps]) -> Steps:
    return np.unique(np.concatenate(parts))
