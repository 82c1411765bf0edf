"""What a mission consists of, before it is known whether that fits together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from tsplan.document import Document
from tsplan.errors import Finding
from tsplan.logic import Formula
from tsplan.logic.weight_values import Weight
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.configurations import ModuleRules
from tsplan.mission.intended_paths import Intended
from tsplan.mission.objectives import default_objective
from tsplan.mission.resources import Resource
from tsplan.mission.team import Expectation, Group, SwarmBounds, SwarmRules
from tsplan.mission.vocabulary import Booking, Language, Order, TaskInterval
from tsplan.ts import TransitionSystem
from tsplan.words import nfc


@dataclass(frozen=True, slots=True)
class Preference:
    """A formula that is met if possible, and how much that is worth.

    Levels are settled one after the other, the highest first; within a level the summed weights
    of what is met are maximised. A `partial` preference counts by its fraction, any other one as
    a whole or not at all. Without a `name`, it is called by its text.
    """

    formula: Formula
    text: str = ""
    weight: Fraction = Fraction(1)
    name: str = ""
    level: int = 0
    partial: bool = False

    def __post_init__(self) -> None:
        """Complete what is written of the formula."""
        object.__setattr__(self, "text", nfc(self.text or str(self.formula)))
        object.__setattr__(self, "name", nfc(self.name or self.text.strip()))


@dataclass(frozen=True)
class MissionParts:
    """The fields of a `Mission`, which says what they mean."""

    name: str
    system: TransitionSystem
    team: tuple[Group, ...]
    language: Language
    text: str
    formula: Formula
    horizon: int
    objective: tuple[str, ...] = default_objective(swarms=False)
    task_interval: TaskInterval = "closed"
    solver: SolverChoice = field(default_factory=SolverChoice)
    swarm: SwarmRules | None = None
    resources: tuple[Resource, ...] = ()
    modular: ModuleRules = field(default_factory=ModuleRules)
    expected: Expectation | None = None
    delay: int = 0
    booking: Booking = "shared"
    satisfaction: Order = "weighted"
    prefer: tuple[Preference, ...] = ()
    intended: tuple[Intended, ...] = ()
    weights: Mapping[str, Weight] = field(default_factory=dict, compare=False, repr=False)
    digest: str = field(default="", compare=False)
    warnings: tuple[Finding, ...] = field(default=(), compare=False)
    parse_seconds: float = field(default=0.0, compare=False, repr=False)
    origin: Document | None = field(default=None, compare=False, repr=False)

    @property
    def headroom(self) -> SwarmRules | Expectation | None:
        """What says how far counts are kept away from what the formula needs, if anything does."""
        rules = self.swarm or self.expected
        return rules if rules is not None and rules.margin else None

    @property
    def books(self) -> bool:
        """Whether every task is executed, with agents that are booked for it."""
        return self.booking != "shared"

    def group_bounds(self, class_name: str) -> SwarmBounds | None:
        """How a class may divide into sub-swarms; None for ordinary robots."""
        return None if self.swarm is None else self.swarm.each.get(class_name)
