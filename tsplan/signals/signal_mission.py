"""The mission over signals: a system, a formula, and what to optimise."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from tsplan.logic import Formula
from tsplan.milp.solver_choice import SolverChoice
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import System
from tsplan.signals.region import Region

Weighting: TypeAlias = Literal["product", "normalised"]


@dataclass(frozen=True)
class SoftFormula:
    """A formula that is met as far as possible, with its weight among others of its level."""

    formula: Formula
    text: str
    weight: float = 1.0
    level: int = 0
    partial: bool = False


@dataclass(frozen=True)
class SignalMission:
    """A system, a formula over its signals, and what to optimise.

    `formula` speaks of signals and controls alone: outputs and regions are replaced in it, weights
    are on its nodes. `horizon` is the last step, at least the formula's own. `objective` is one aim
    after the other; without any, every satisfying trajectory is as good as another. `satisfaction`
    is the order in which a formula may hold in part (None: it must hold), `prefer` has formulas
    that are met as far as possible besides. `regions` are kept for pictures, `parts` the texts of
    what the formula joins at its top, with their formulas. `digest` is the SHA-256 of the text.
    """

    system: System
    formula: Formula
    horizon: int
    objective: tuple[Aim, ...] = ()
    weighting: Weighting = "product"
    satisfaction: str | None = None
    prefer: tuple[SoftFormula, ...] = ()
    regions: Mapping[str, Region] = field(default_factory=dict, hash=False)
    parts: tuple[tuple[str, Formula], ...] = ()
    language: str = "stl"
    text: str = ""
    name: str = ""
    solver: SolverChoice = field(default_factory=SolverChoice)
    digest: str = ""
