"""Something that does not fit in a mission, before it is known where in which file it stands."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TypeAlias

from tsplan.errors import Finding, Spot
from tsplan.logic import Formula
from tsplan.logic.text_spans import Way
from tsplan.mission.team import Group

Place: TypeAlias = "tuple[str | int, ...]"
Entry: TypeAlias = tuple[Place, Group]
"""A group, and where it stands in the mission."""

FORMULA: Place = ("spec", "formula")


def preferred(number: int, key: str = "formula") -> Place:
    """Where the formula of a preference stands, or something else of it."""
    return ("spec", "prefer", number, key)


@dataclass(frozen=True, slots=True)
class Fault:
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
        """The fault of a mission that was not read from a file."""
        if self.at is not None:
            return Finding(self.message, self.remedy, *self.at)
        where = "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in self.path)
        return Finding(f"{where.lstrip('.')}: {self.message}", self.remedy)


def moved(faults: Iterable[Fault], place: Place) -> list[Fault]:
    """Faults of a formula that stands elsewhere than the mission's own."""
    return [replace(fault, path=place) if fault.path == FORMULA else fault for fault in faults]
