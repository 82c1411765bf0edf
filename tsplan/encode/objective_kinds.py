"""Kinds of objectives in a model: what each says of itself, and what follows from that.

An objective that lacks something is told when it is made.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import replace
from enum import Enum
from typing import Any, ClassVar

import numpy as np

from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.executions import Executions
from tsplan.encode.flow_network import Network
from tsplan.milp.model import INFINITY, Draft, Floats
from tsplan.milp.target import CLOSED, Target
from tsplan.mission.objectives import OBJECTIVES


class Grouping(Enum):
    """How an objective is searched by the groups of swarms, before the agents in them."""

    SIZES = "not at all: it says how many agents groups have"
    FEW_MOVES = "agents go about as little where groups move little"
    PLACES = "by where groups are alone"
    TOKENS = "by where groups are alone, and by tokens before"


class StageObjective(ABC):
    """One objective, on the model side.

    `opens` says that a plan may be looked for by minimising it; `priced` that agents whose edges
    cost differently are told apart; `built` that models are made for a value of it; `grouping` how
    it is searched by groups.
    """

    name: ClassVar[str]
    built: ClassVar[bool] = False
    grouping: ClassVar[Grouping] = Grouping.SIZES
    opens: ClassVar[bool] = True
    priced: ClassVar[bool] = False

    @property
    def rises(self) -> bool:
        """Whether more is better."""
        return OBJECTIVES[self.name].sense == "maximise"

    @property
    def by_places(self) -> bool:
        """Whether a value depends on where groups are, not on how many agents they have."""
        return self.grouping in (Grouping.PLACES, Grouping.TOKENS)

    def reducible(self, setting: Setting) -> bool:
        """Whether ways between the states that matter that are quick or of less toll are enough."""
        return True

    def toll(self, graph: ClassGraph) -> Floats | None:
        """What every edge costs where a quicker way may be worse; None where none is."""
        return None

    def columns(
        self, setting: Setting, network: Network, executed: Executions, draft: Draft
    ) -> Any:
        """Columns that a model needs only for this objective, in a form of its own."""
        return np.empty(0, dtype=np.int64)

    def extended(self, encoded: Encoded) -> Encoded:
        """The model with what is only needed while this is minimised."""
        return encoded

    @abstractmethod
    def minimised(self, setting: Setting, point: Point) -> float:
        """What a point comes to, as it is minimised and kept."""

    @abstractmethod
    def worth(self, setting: Setting, point: Point) -> float:
        """What the plan of a point is worth, in the objective's own unit."""

    def matched(self, value: float, bound: float) -> float:
        """What is told of a bound, where the last plan is worth so much."""
        return bound

    @abstractmethod
    def kept(self, setting: Setting, encoded: Encoded, value: float) -> Encoded:
        """The model of those plans that are no worse than a value as it is `minimised`."""


class TargetObjective(StageObjective):
    """An objective that a model minimises as it stands."""

    @abstractmethod
    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """What is minimised, in whole units."""

    def minimised(self, setting: Setting, point: Point) -> float:
        """The value of the target."""
        return self.target(setting, point.encoded).value(point.values)

    def worth(self, setting: Setting, point: Point) -> float:
        """The value of the target in the objective's own unit."""
        return self.target(setting, point.encoded).own(self.minimised(setting, point))

    def kept(self, setting: Setting, encoded: Encoded, value: float) -> Encoded:
        """With one more row."""
        target = self.target(setting, encoded)
        return replace(encoded, model=target.kept(encoded.model, value, f"kept {self.name}"))


class RealObjective(TargetObjective):
    """An objective whose values are real numbers, unless its target counts in steps.

    What an earlier one reached is kept but for a share of `lost`, or later ones would spend what
    little solvers do not tell apart. Values are told to `digits` after the point, if to any.
    """

    lost: ClassVar[float] = 1e-8  # solvers forgive more
    digits: ClassVar[int | None] = None

    def matched(self, value: float, bound: float) -> float:
        """The value, if solvers tell it not apart from the bound."""
        if abs(value - bound) > CLOSED * max(1.0, abs(value)):
            return bound
        return value if self.digits is None else round(value, self.digits)

    def kept(self, setting: Setting, encoded: Encoded, value: float) -> Encoded:
        """With a row that allows for no more than rounding."""
        target = self.target(setting, encoded)
        if target.step:
            return super().kept(setting, encoded, value)
        most = value + self.lost * max(1.0, abs(value))
        model = encoded.model.with_row(target.vector, -INFINITY, most, f"kept {self.name}")
        return replace(encoded, model=model)


class ModelObjective(TargetObjective):
    """An objective that is linear in the columns, as most are."""

    @abstractmethod
    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """The coefficients of what is minimised."""

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """What is minimised, in whole units."""
        return Target(self.vector(setting, encoded))


class LevelObjective(StageObjective):
    """An objective whose values are whole numbers, each of which is a model of its own."""

    opens = False

    def by_levels(self, *, tight: bool) -> bool:
        """Whether the encoding at hand has no column for it."""
        return True

    @abstractmethod
    def ideal(self, setting: Setting) -> float:
        """A bound on all values that costs nothing."""

    def minimised(self, setting: Setting, point: Point) -> float:
        """The value itself."""
        return self.worth(setting, point)
