"""What a mission over signals consists of, before it is known whether that fits together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias

from tsplan.document import Document
from tsplan.errors import Finding
from tsplan.logic import Formula, parse_with_places
from tsplan.logic.text_spans import Written
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.mission_parts import Preference
from tsplan.mission.vocabulary import Order
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import System
from tsplan.signals.region import Region

SignalLanguage: TypeAlias = Literal["stl", "wstl"]
Weighting: TypeAlias = Literal["product", "normalised"]


@dataclass(frozen=True)
class SignalParts:
    """The fields of a `SignalMission`, which says what they mean."""

    system: System
    formula: Formula
    horizon: int
    objective: tuple[Aim, ...] = ()
    weighting: Weighting = "product"
    weights: Mapping[str, Any] = field(default_factory=dict, hash=False)
    satisfaction: Order | None = None
    prefer: tuple[Preference, ...] = ()
    regions: Mapping[str, Region] = field(default_factory=dict, hash=False)
    parts: tuple[tuple[str, Formula], ...] = ()
    copies: tuple[str, ...] = ()
    language: SignalLanguage = "stl"
    text: str = ""
    name: str = ""
    solver: SolverChoice = field(default_factory=SolverChoice)
    digest: str = field(default="", compare=False)
    warnings: tuple[Finding, ...] = field(default=(), compare=False)
    parse_seconds: float = field(default=0.0, compare=False, repr=False)
    origin: Document | None = field(default=None, compare=False, repr=False)

    @property
    def size(self) -> int:
        """How many values a trajectory has at a step."""
        return len(self.system.names)

    @property
    def pieces(self) -> int:
        """What a trajectory is made of one by one at a step: its values."""
        return self.size

    def parsed(self, text: str) -> tuple[Formula, Written]:
        """A formula that may name what the mission does, and where its parts stand in the text."""
        return parse_with_places(
            text,
            self.language,
            weights=self.weights,
            regions=self.regions,
            definitions=self.system.outputs,
        )
