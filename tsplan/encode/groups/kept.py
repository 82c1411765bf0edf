"""What earlier objectives of swarms reached, and the models that do not lose it."""

from __future__ import annotations

from dataclasses import dataclass, replace

from tsplan.encode.assemble import Encoded
from tsplan.encode.groups.group_objectives import OF_GROUPS, late, target
from tsplan.encode.groups.group_sizes import sizes, with_smallest
from tsplan.encode.groups.swarm_model import SwarmModel
from tsplan.milp.model import Model


@dataclass(frozen=True)
class Kept:
    """What earlier stages reached and later ones must not lose, as it is minimised."""

    rows: tuple[tuple[str, float], ...] = ()
    makespan: int | None = None

    @property
    def of_groups(self) -> bool:
        """Whether it says nothing about sizes."""
        return all(name in OF_GROUPS for name, _ in self.rows)

    def narrow(self, model: SwarmModel, encoded: Encoded) -> Encoded:
        """The occupied or counted model of those plans that lose nothing of it."""
        inner = encoded.model
        if self.makespan is not None:
            upper = inner.upper.copy()
            for swarm in model.swarms:
                upper[late(swarm, self.makespan)] = 0.0
            inner = inner.with_bounds(inner.lower, upper)
        for name, value in self.rows:
            if name == "balance":
                inner = _at_least(model, inner, -value)
            else:
                inner = target(model, name, inner.size.columns).kept(inner, value, f"kept {name}")
        return replace(encoded, model=inner)


def _at_least(model: SwarmModel, inner: Model, size: float) -> Model:
    """The model in which every sub-swarm has at least `size` agents, by a fixed column."""
    wide = with_smallest(inner, sizes(model), size)
    lower = wide.lower.copy()
    lower[-1] = size
    return wide.with_bounds(lower, wide.upper)
