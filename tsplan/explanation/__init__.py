"""Why a mission cannot be met, what would help, and what is tight about one that can be.

- `explaining`: the whole way from a mission to its `Explanation`.
- `facts`, `scarcity`, `meetings`: what forbids every plan and is seen without a solver.
- `oracle`, `relaxing`, `conflicts`: irreducible conflicts, decided by the ordinary planner.
- `candidates`, `dimensions`, `surroundings`, `changes`: the smallest changes that help.
- `several`: changes that only help together.
- `waiting`: where nobody can wait, as an element, as facts and as changes.
- `bounds`, `swarms`: the bounds of swarms as elements, as facts and as changes.
- `tightness`, `critical`: what holds availability down, and how early deadlines could be.
- `rewriting`: a changed mission as a file.
- `writing`, `report`: explanations as JSON, and for people.

Conflicts of a formula speak about its parts by where they occur (`occurrences`, `places`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.explanation.explanation import (
    Change,
    Conflict,
    Element,
    Explanation,
    Fact,
    Part,
    Place,
    Status,
)

if TYPE_CHECKING:
    from tsplan.explanation.whynot.explaining import explain

__all__ = [
    "Change",
    "Conflict",
    "Element",
    "Explanation",
    "Fact",
    "Part",
    "Place",
    "Status",
    "explain",
]


def __getattr__(name: str) -> object:
    """Load `explain` when it is first used: it loads a solver."""
    if name != "explain":
        raise AttributeError(f"module 'tsplan.explanation' has no attribute '{name}'")
    from tsplan.explanation.whynot.explaining import explain  # noqa: PLC0415  (that is the purpose)

    return explain
