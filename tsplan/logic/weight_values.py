"""Weights as they are given, made into one positive number for each part or step."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import inf, isfinite
from numbers import Real
from typing import TypeAlias, cast

from tsplan.limits import MOST_STEPS

Weights: TypeAlias = "tuple[float, ...] | None"
"""What a node carries: a number for each of its parts, or for each step of its window."""

Weight: TypeAlias = "float | Sequence[float] | Mapping[int, float] | Callable[[int], float]"
"""What may be given: one number for all, numbers in order, numbers or a function by index."""


def weights_for(given: Weight | None, indices: range, what: str) -> Weights:
    """The weights of parts 0, 1, ... or of the steps of a window, which are the `indices`.

    A single number counts for every index; a sequence has exactly as many numbers as there are
    indices; a mapping names each of them; a function is called once for each. `what` is the word
    for an index in messages, `part` or `step`. None stays None.

    Raises ValueError where one is missing, too many or not a finite number above 0, and TypeError
    for what is no number.

    >>> weights_for([0.2, 0.8], range(2), "part")
    (0.2, 0.8)
    >>> weights_for(lambda step: 1 / step, range(1, 4), "step")
    (1.0, 0.5, 0.3333333333333333)
    """
    if given is None:
        return None
    if indices.stop - indices.start > MOST_STEPS + 1:
        raise ValueError(f"there are more than {MOST_STEPS:,} {what}s to be weighed")
    if isinstance(given, Mapping):
        missing = [index for index in indices if index not in given]
        if missing:
            raise ValueError(f"no weight is given for {what} {missing[0]}{_more(missing)}")
        values: Sequence[object] = [given[index] for index in indices]
    elif callable(given):
        values = [given(index) for index in indices]
    elif isinstance(given, Iterable) and not isinstance(given, str):
        values = tuple(given)
        if len(values) != len(indices):
            told = f"{what}s {indices[0]} to {indices[-1]}"
            raise ValueError(f"{len(values)} weights are given for {told}, {len(indices)} needed")
    else:
        values = [given] * len(indices)
    return tuple(_weight(one, f"{what} {at}") for one, at in zip(values, indices, strict=True))


def _more(missing: Sequence[int]) -> str:
    return f" and {len(missing) - 1} more" if len(missing) > 1 else ""


def _weight(value: object, where: str) -> float:
    """A weight as a float: what is weighed 0 or less would not count, or count against itself."""
    if not isinstance(value, Real) or isinstance(value, bool):
        raise TypeError(f"the weight of {where} is no number: {value!r}")
    try:
        number = float(cast("float", value))
    except OverflowError:
        number = inf
    if not (isfinite(number) and number > 0):
        raise ValueError(f"the weight of {where} is {value}, which is no finite number above 0")
    return number
