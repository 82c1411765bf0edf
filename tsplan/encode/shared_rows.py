"""One row for several demands on the same sum, of which options that exclude each other ask one.

Where a selection w is 1, `f >= b`. With `base` below which f cannot be, options that exclude each
other have one row, `f >= base + sum of (b_i - base) * w_i`, which is exact, as at most one w_i is
1, and stronger than a row for each. What is asked for in any case is a row of its own and the base
of the others.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from typing import Any, TypeVar

from tsplan.encode.encoder_rules import Witnesses
from tsplan.milp.model import INFINITY

ANYWAY = -1
"""In the place of a column: what is asked for whatever is selected."""

KeyT = TypeVar("KeyT", bound=Hashable)


def amounts(
    witnesses: Witnesses, of: Callable[[Any], tuple[KeyT, float]]
) -> dict[KeyT, dict[int, dict[int, float]]]:
    """For every key and step the most that each column asks for.

    `of` tells the key and the amount of a demand's bound.
    """
    found: dict[KeyT, dict[int, dict[int, float]]] = defaultdict(lambda: defaultdict(dict))
    for need in witnesses.stepwise:
        key, amount = of(need.bound)
        asked = found[key][need.step]
        for column in need.selection or (ANYWAY,):
            asked[column] = max(asked.get(column, -INFINITY), amount)
    return found


def shared_rows(
    asked: Mapping[int, float],
    low: float,
    families: Callable[[Sequence[int]], Iterable[Iterable[int]]],
) -> Iterator[tuple[float, dict[int, float]]]:
    """The rows of one sum that cannot be below `low`: their base, and what each column adds.

    `families` parts columns into those that exclude each other.
    """
    hard = asked.get(ANYWAY, -INFINITY)
    base = max(hard, low)
    if hard > low:
        yield hard, {}
    for family in families([column for column in asked if column != ANYWAY]):
        beyond = {column: asked[column] - base for column in family if asked[column] > base}
        if beyond:
            yield base, beyond
