"""Searches that take turns, so that none waits for another to end."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import TypeVar

Found = TypeVar("Found")


def in_turns(*searches: Iterator[Found]) -> Iterator[Found]:
    """What all find; it is the turn of that which has taken least time, at first of the first."""
    waiting = list(searches)
    spent = [0.0] * len(waiting)
    while waiting:
        place = spent.index(min(spent))
        began = time.perf_counter()
        try:
            found = next(waiting[place])
        except StopIteration:
            del waiting[place], spent[place]
            continue
        spent[place] += time.perf_counter() - began
        yield found
