"""What a plan does to fulfil its formula: which part has to hold at which steps.

A disjunction needs one of its parts, an eventuality one of its steps. Here the choice falls on
what the plan fulfils first (see `tsplan.logic.deciding`), so the chosen witnesses are those by
which the formula was certain as early as it was. Below a negation a part has to fail.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import singledispatch
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.logic.atoms import Count
from tsplan.logic.deciding import Decided
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
    Window,
)
from tsplan.logic.traces import Floats

Steps: TypeAlias = npt.NDArray[np.bool_]
Times: TypeAlias = Mapping[Formula, Decided]


class Duty(NamedTuple):
    """A part that has to hold (`holds`) or to fail at the steps `needed`.

    `possible` are the steps that its windows leave to choose from; both are Boolean arrays over
    the steps of the trace.
    """

    formula: Formula
    holds: bool
    needed: Steps
    possible: Steps

    def certain(self, times: Times) -> Floats:
        """When it is certain, judged at each step; infinity where it never is."""
        return _padded(_certain(self.formula, self.holds, times), self.needed.size)

    def to(self, formula: Formula, needed: Steps, possible: Steps, *, same: bool = True) -> Duty:
        """What this duty asks of one of its parts; `same` False where the part is negated."""
        return Duty(formula, self.holds == same, needed, possible)


def root_duty(formula: Formula, steps: int) -> Duty:
    """A formula has to hold at step 0."""
    start = np.zeros(steps, dtype=np.bool_)
    start[:1] = True
    return Duty(formula, True, start, start)


def atoms(duty: Duty, times: Times) -> Iterator[Duty]:
    """The duties of the counts below, in the order of the text."""
    waiting = [duty]
    while waiting:
        one = waiting.pop()
        if isinstance(one.formula, Count):
            yield one
        waiting += reversed(parts(one.formula, one, times))


@singledispatch
def parts(node: Formula, _duty: Duty, _times: Times) -> list[Duty]:
    """What a duty asks of its formula's parts. Every class of nodes registers its own."""
    raise TypeError(f"no duties are registered for {type(node).__name__}")


@parts.register(Constant)
@parts.register(Count)
def _(_node: Formula, _duty: Duty, _times: Times) -> list[Duty]:
    return []


@parts.register
def _(node: Not, duty: Duty, _times: Times) -> list[Duty]:
    return [duty.to(node.child, duty.needed, duty.possible, same=False)]


@parts.register(And)
@parts.register(Or)
def _(node: And | Or, duty: Duty, times: Times) -> list[Duty]:
    signed = [(child, True) for child in node.children]
    return _several(duty, signed, times, everything=isinstance(node, And) == duty.holds)


@parts.register
def _(node: Implies, duty: Duty, times: Times) -> list[Duty]:
    signed = [(node.left, False), (node.right, True)]
    return _several(duty, signed, times, everything=not duty.holds)


@parts.register
def _(node: Iff, duty: Duty, times: Times) -> list[Duty]:
    """Both and neither, or the one and the other, step by step whichever is certain first."""
    left, right = node.left, node.right
    options = []
    for first in (True, False):
        second = first == duty.holds
        signs = ((left, first), (right, second))
        latest = np.maximum(*(_padded(_certain(f, s, times), duty.needed.size) for f, s in signs))
        options.append((signs, latest))
    sooner = options[0][1] <= options[1][1]
    return [
        Duty(formula, sign, duty.needed & chosen, duty.possible)
        for (signs, _), chosen in zip(options, (sooner, ~sooner), strict=True)
        for formula, sign in signs
        if (duty.needed & chosen).any()
    ]


@parts.register(Eventually)
@parts.register(Always)
def _(node: Window, duty: Duty, times: Times) -> list[Duty]:
    possible = _widened(duty.possible, node.low, node.high)
    if isinstance(node, Always) == duty.holds:
        needed = _widened(duty.needed, node.low, node.high)
        return [duty.to(node.child, needed, possible)]
    certain = _padded(_certain(node.child, duty.holds, times), duty.needed.size)
    needed = np.zeros_like(duty.needed)
    for step in np.flatnonzero(duty.needed):
        window = certain[step + node.low : step + node.high + 1]
        if window.size:
            needed[step + node.low + int(np.argmin(window))] = True
    return [duty.to(node.child, needed, possible)]


@parts.register(Until)
@parts.register(Release)
def _(node: Until | Release, duty: Duty, times: Times) -> list[Duty]:
    size = duty.needed.size
    left, right = (_padded(_certain(c, duty.holds, times), size) for c in node.children)
    for_left, for_right = np.zeros_like(duty.needed), np.zeros_like(duty.needed)
    choose = _change_over if isinstance(node, Until) == duty.holds else _release
    for step in np.flatnonzero(duty.needed):
        first, last = step + node.low, min(step + node.high, size - 1)
        if first <= last:
            spans = choose((left, right), int(step), (int(first), int(last)))
            for_left[spans[0]] = True
            for_right[spans[1]] = True
    over_left = _widened(duty.possible, 0, max(0, node.high - 1))
    over_right = _widened(duty.possible, node.low, node.high)
    return [
        duty.to(node.left, for_left, over_left),
        duty.to(node.right, for_right, over_right),
    ]


def _change_over(
    sides: tuple[Floats, Floats], step: int, window: tuple[int, int]
) -> tuple[slice, slice]:
    """The steps of the left side and the step of the right one, by the earliest change-over."""
    left, right = sides
    first, last = window
    before = np.maximum.accumulate(np.concatenate([[0.0], left[step:last]]))[first - step :]
    change = first + int(np.argmin(np.maximum(before, right[first : last + 1])))
    return slice(step, change), slice(change, change + 1)


def _release(
    sides: tuple[Floats, Floats], step: int, window: tuple[int, int]
) -> tuple[slice, slice]:
    """The right side throughout the window, or up to the one step of the left that frees it."""
    left, right = sides
    first, last = window
    throughout = float(right[first : last + 1].max())
    until = np.zeros(last - step)
    if last > first:
        until[first - step :] = np.maximum.accumulate(right[first:last])
    freed = np.maximum(until, left[step:last])
    if not freed.size or throughout <= freed.min():
        return slice(0, 0), slice(first, last + 1)
    free = step + int(np.argmin(freed))
    return slice(free, free + 1), slice(first, max(first, free + 1))


def _several(
    duty: Duty, signed: list[tuple[Formula, bool]], times: Times, *, everything: bool
) -> list[Duty]:
    """All of some parts, or at each step the one that is certain first."""
    if everything:
        return [duty.to(f, duty.needed, duty.possible, same=same) for f, same in signed]
    size = duty.needed.size
    certain = [_padded(_certain(f, duty.holds == same, times), size) for f, same in signed]
    first = np.argmin(certain, axis=0)
    return [
        duty.to(f, duty.needed & (first == place), duty.possible, same=same)
        for place, (f, same) in enumerate(signed)
    ]


def _certain(formula: Formula, holds: bool, times: Times) -> Floats:
    return times[formula].fulfilled if holds else times[formula].failed


def _padded(times: Floats, size: int) -> Floats:
    """Times over all steps of the trace: what cannot be judged is never certain."""
    result = np.full(size, np.inf)
    result[: times.size] = times[:size]
    return result


def _widened(steps: Steps, low: int, high: int) -> Steps:
    """Every step that is low..high after one of `steps`."""
    change = np.zeros(steps.size + 1, dtype=np.int64)
    starts = np.flatnonzero(steps)
    np.add.at(change, np.minimum(starts + low, steps.size), 1)
    np.add.at(change, np.minimum(starts + high + 1, steps.size), -1)
    return np.cumsum(change)[:-1] > 0
