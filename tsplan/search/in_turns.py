"""Two searches that take turns, so that neither waits for the other to end."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import TypeVar

One = TypeVar("One")
Other = TypeVar("Other")


def in_turns(one: Iterator[One], other: Iterator[Other]) -> Iterator[One | Other]:
    """What both find; it is the turn of that which has taken less time, at first of the one."""
    waiting: list[Iterator[One | Other]] = [one, other]
    spent = [0.0, 0.0]
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
