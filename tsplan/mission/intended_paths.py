"""Paths that robots of a mission were to take before it was planned again."""

from __future__ import annotations

from typing import NamedTuple

from tsplan.name_runs import Run


class Intended(NamedTuple):
    """The path that robots in a row, by their ids, were to take: as those of plans are.

    `stays` are `(from, to, state)`, and `heading` is the state that they are going to at the end.
    """

    names: Run
    stays: tuple[tuple[int, int, str], ...]
    heading: str | None = None
