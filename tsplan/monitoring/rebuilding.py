"""Structures that wait for each other to become others, and when they do."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from tsplan.plans.structures import Rebuilt, Structure


@dataclass(eq=False, slots=True)
class Rebuild:
    """Structures, by their rows, that become others; they come out `later` than it begins.

    It `begins` at a step, or, where one of the parts does not come, never. `begun` is the step at
    which it is seen to have begun.
    """

    parts: tuple[int, ...]
    made: tuple[int, ...]
    later: tuple[int, ...]
    planned: int
    begins: int | None
    begun: int | None = None

    def ready(self, arrivals: Sequence[int | None], horizon: int) -> int | None:
        """When it begins if parts arrive at these steps, None for those that do not."""
        if self.begun is not None:
            return self.begun
        there = [step for step in arrivals if step is not None]
        begins = max([self.planned, *there])
        return begins if len(there) == len(arrivals) and begins < horizon else None


class Rebuilding:
    """What is rebuilt of a plan: where structures go in and come out, and of what they are."""

    def __init__(
        self,
        rebuilt: Iterable[Rebuilt],
        structures: Iterable[Structure],
        row: Mapping[str, int],
    ) -> None:
        bodies = sorted(structures, key=lambda each: each.first)
        first = {each.id: each.first for each in bodies}
        self.into: dict[int, Rebuild] = {}
        self.out_of: dict[int, Rebuild] = {}
        for each in rebuilt:
            parts = tuple(row[name] for name in each.parts)
            made = tuple(row[name] for name in each.made)
            later = tuple(first[name] - each.step for name in each.made)
            found = Rebuild(parts, made, later, each.step, each.step)
            self.into.update(dict.fromkeys(parts, found))
            self.out_of.update(dict.fromkeys(made, found))
        self._lives: dict[str, list[int]] = {}
        for body in bodies:
            for module in body.modules:
                self._lives.setdefault(module, []).append(row[body.id])

    def ends(self, row: int, horizon: int) -> int:
        """When a structure stops to be where it goes last; nobody else does before the end."""
        found = self.into.get(row)
        return horizon if found is None or found.begins is None else found.begins

    def lives(self, module: str, now: int) -> Sequence[int]:
        """The structures that a module has been part of by a step, and what it is becoming then."""
        return [row for row in self._lives.get(module, ()) if self._is_begun(row, now)]

    def _is_begun(self, row: int, now: int) -> bool:
        before = self.out_of.get(row)
        return before is None or (before.begins is not None and before.begins < now)
