"""What one search is asked, and what earlier objectives reached that must not be lost."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.groups.group_sizes import smallest
from tsplan.encode.objective_kinds import StageObjective, TargetObjective
from tsplan.milp.model import Floats
from tsplan.milp.proof_tree import ProofTree, StageProof
from tsplan.milp.target import Target

FIRST_PLAN = "first plan"
_FEASIBLE = 1e-6  # by which rows may be violated: the feasibility tolerance of the solvers


@dataclass(frozen=True)
class Kept:
    """Values that earlier stages reached and later ones must not lose, as they are minimised."""

    values: tuple[tuple[StageObjective, float], ...] = ()

    def and_also(self, objective: StageObjective, value: float) -> Kept:
        """With one more value."""
        return Kept((*self.values, (objective, value)))

    def built(self, name: str) -> int:
        """The value of an objective that models are made for, 0 where none is kept."""
        built = (int(v) for kept, v in self.values if kept.built and kept.name == name)
        return max(built, default=0)

    def reached(self, name: str) -> int | None:
        """The value of an objective of whole numbers that is kept, None where none is."""
        found = [round(value) for kept, value in self.values if kept.name == name]
        return found[-1] if found else None

    @property
    def by_places(self) -> bool:
        """Whether it says nothing about how many agents groups have."""
        return all(objective.by_places or objective.built for objective, _ in self.values)

    def narrowed(self, setting: Setting, encoded: Encoded) -> Encoded:
        """The model of those plans that lose nothing of it."""
        for objective, value in self.values:
            if not objective.built or encoded.rho >= 0:
                encoded = objective.kept(setting, encoded, value)
        return encoded


NOTHING_KEPT = Kept()


@dataclass(frozen=True)
class Question:
    """The least value of an objective, or with `first` any plan that it leads to.

    `told` is the objective whose values are told meanwhile, None for none of them; `bound` is what
    is known of it while any plan is looked for. It may be left open after some `seconds`.
    """

    objective: TargetObjective
    kept: Kept
    told: StageObjective | None
    first: bool = False
    bound: float | None = None
    seconds: float | None = None

    @property
    def stage(self) -> str:
        """What the search is called."""
        return FIRST_PLAN if self.told is None else self.told.name

    def note(self, proofs: list[StageProof] | None, tree: ProofTree, *, places: bool) -> None:
        """Put down what a search for the answer proved, if that is wanted."""
        if proofs is not None and (tree.leaves or tree.refuted):
            kept = tuple((each.name, value) for each, value in self.kept.values)
            proofs.append(StageProof(self.stage, self.objective.name, kept, places, tree))

    def shown(self, target: Target, bound: float | None) -> float | None:
        """What can be told of a bound of the target."""
        if self.first:
            return self.bound
        return None if bound is None else target.own(bound)


def start_in(encoded: Encoded, point: Point | None) -> Floats | None:
    """A known point cut or filled up to a model, where it is one of its points."""
    if point is None:
        return None
    values, count = point.values, encoded.model.size.columns
    if len(values) != count and not encoded.swarms:
        return None
    if count > len(values):
        least = smallest(point.encoded.swarms, values)
        values = np.append(values, np.full(count - len(values), least))
    values = np.clip(values[:count], encoded.model.lower, encoded.model.upper)
    return values if encoded.model.violation(values) < _FEASIBLE else None
