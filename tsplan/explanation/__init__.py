"""Why a mission cannot be met, what would help, and what is tight about one that can be.

- `whynot`: the way from a mission without a plan to an `Explanation` (`diagnosis`): facts that are
  seen without a solver, irreducible conflicts of its soft constraints, decided by the ordinary
  planner, and the smallest edits of its numbers that help.
- `why`: what a plan's formula rests on (the witness tree), and what is tight about it.
- `part_words`, `report`: the parts of a mission in words, and all of it for people.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.explanation.explanation import (
    Change,
    Conflict,
    Explanation,
    Fact,
    Found,
    Likely,
    Part,
    Place,
    SoftConstraint,
    Status,
)
from tsplan.lazy_names import lazily

if TYPE_CHECKING:
    from tsplan.explanation.whynot.diagnosis import explain

__all__ = [
    "Change",
    "Conflict",
    "Explanation",
    "Fact",
    "Found",
    "Likely",
    "Part",
    "Place",
    "SoftConstraint",
    "Status",
    "explain",
]

# it loads a solver
__getattr__, __dir__ = lazily(__name__, {"explanation.whynot.diagnosis": ("explain",)})
