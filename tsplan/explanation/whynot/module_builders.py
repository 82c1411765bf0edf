"""Modules as the finders of facts see them: which structures they can be, how many, where when."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from tsplan.ts.reachability import Lengths, usable

if TYPE_CHECKING:
    from tsplan.mission import Configuration, Group, Mission
    from tsplan.mission.configurations import Pool


@dataclass(frozen=True, eq=False)
class Builder:
    """The modules of a pool with the shapes in which they have a capability.

    `steps` has the first step at which each shape can be at each state.
    """

    mission: Mission
    pool: Pool
    steps: Mapping[str, Mapping[str, int]]
    shapes: tuple[Configuration, ...]

    @classmethod
    def of(
        cls,
        mission: Mission,
        pool: Pool,
        steps: Mapping[str, Mapping[str, int]],
        capability: str | None,
    ) -> Builder:
        """The modules of a pool, to be structures with a capability; there may be no shape."""
        group = mission.team[pool.groups[0]]
        return cls(mission, pool, steps, mission.modular.able(group, pool, capability))

    @property
    def group(self) -> Group:
        """Whose class and capabilities the modules have."""
        return self.mission.team[self.pool.groups[0]]

    @property
    def least(self) -> int:
        """Of how many modules such a structure is made at least."""
        return min(shape.modules for shape in self.shapes)

    @property
    def most(self) -> int:
        """How many such structures there can be at once, at most."""
        return self.pool.count // self.least

    @property
    def words(self) -> str:
        """How many modules there are, and of how many a structure is made."""
        known = f"{self.pool.count} {self.group.class_name}"
        more = " or more" if any(shape.modules > self.least for shape in self.shapes) else ""
        return known if self.least == 1 else f"{known} in structures of {self.least}{more}"

    def first(self, states: Iterable[str]) -> float:
        """The first step at which such a structure can be at one of some states; inf if never."""
        known = [
            self.steps[shape.name].get(state, inf) for shape in self.shapes for state in states
        ]
        return min(known, default=inf)

    def fewest(self, sources: Iterable[str], targets: Iterable[str]) -> float:
        """Fewest steps of a module from one of some states to one of others, in whatever shapes."""
        system = self.mission.system
        number = {name: place for place, name in enumerate(system.states)}
        name = self.group.class_name
        entries = [
            (number[edge.source], number[edge.target], shape.steps(edge, name) or 1)
            for shape in self.pool.shapes
            for edge, _ in usable(system, name, self.group.capabilities | shape.capabilities)
        ]
        tail, head, length = np.array(entries, dtype=np.int64).reshape(-1, 3).T
        far = Lengths(len(number), tail, head, length).nearest([number[each] for each in sources])
        return min((float(far[number[each]]) for each in targets), default=inf)
