"""What the agents of one class do in a plan."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tsplan.checking.path_segments import Segment
    from tsplan.plans.bundles import Bundle
    from tsplan.plans.moves import Move
    from tsplan.plans.presence import Presence


@dataclass(frozen=True)
class ClassTraffic:
    """What the agents of one class do.

    `segments` are their times on edges, `present` their stays at states up to the horizon, both
    counted together where they are the same, and `moving` is how many of them ever make a move that
    is no wait: by their paths, or as few as can be where there are only moves. A swarm has `moves`,
    the segments as a plan writes them. `bundles` are the agents with their paths. Structures of
    modules are of a configuration, their
    `shape`: `factor` is by how much more their edges cost, and `moving` counts the modules that
    start in them.
    """

    class_name: str
    segments: tuple[Segment, ...]
    present: tuple[Presence, ...]
    moving: int
    moves: tuple[Move, ...] = ()
    bundles: tuple[Bundle, ...] = ()
    factor: Fraction = Fraction(1)
    shape: str = ""
