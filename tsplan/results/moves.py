"""Moves of sub-swarms: how many agents enter which edge at which step."""

from __future__ import annotations

from typing import NamedTuple


class Move(NamedTuple):
    """`count` agents of one swarm enter the edge from `source` to `target` at `step`."""

    step: int
    source: str
    target: str
    count: int  # type: ignore[assignment]  # hides tuple.count, which no move is asked
