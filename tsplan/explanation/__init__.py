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
from tsplan.lazy_names import lazily

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

# it loads a solver
__getattr__, __dir__ = lazily(__name__, {"whynot.explaining": ("explain",)})
