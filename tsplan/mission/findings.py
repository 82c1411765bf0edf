"""Something that does not fit in a mission, before it is known where in which file it stands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from tsplan.errors import Finding, Spot

if TYPE_CHECKING:
    from tsplan.logic import Formula
    from tsplan.logic.text_spans import Way
    from tsplan.mission.mission import Group

Place: TypeAlias = "tuple[str | int, ...]"
Entry: TypeAlias = "tuple[Place, Group]"  # a group, and where it stands in the mission
FORMULA: Place = ("spec", "formula")


def preferred(number: int) -> Place:
    """Where the formula of a preference stands."""
    return ("spec", "prefer", number, "formula")


@dataclass(frozen=True, slots=True)
class Problem:
    """Something that does not fit: where it is in the mission, and whether it forbids planning.

    For a part of the formula, `node` is the part and `way` leads to what in it is wrong, a name for
    example (see `tsplan.logic.text_spans`). `at` is the file, line and column of what stands in
    another file than the mission's.
    """

    path: Place
    message: str
    remedy: str = ""
    serious: bool = True
    node: Formula | None = None
    way: Way = ()
    at: Spot | None = None

    def finding(self) -> Finding:
        """The problem of a mission that was not read from a file."""
        if self.at is not None:
            return Finding(self.message, self.remedy, *self.at)
        where = "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in self.path)
        return Finding(f"{where.lstrip('.')}: {self.message}", self.remedy)
