"""Outcomes: what plans and trajectories say of how they came about, and what cannot be together.

An outcome is two facts: what is known (`Status`) and what stopped the search (`StoppedBy`). Pairs
that contradict each other cannot be constructed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from enum import StrEnum
from typing import Any, Protocol, Self

from tsplan.errors import Finding
from tsplan.plans.records import OPTIONAL, Finite, Record, Whole, Word
from tsplan.stopping import LIMITS, StoppedBy


class Status(StrEnum):
    """What is known when planning ends."""

    OPTIMAL = "optimal"
    FEASIBLE = "feasible"
    INFEASIBLE = "infeasible"
    NO_PLAN_FOUND = "no_plan_found"
    ERROR = "error"


_POSSIBLE: Mapping[Status, frozenset[StoppedBy | None]] = {
    Status.OPTIMAL: frozenset({None}),
    Status.FEASIBLE: frozenset(StoppedBy),
    Status.INFEASIBLE: frozenset({None}),
    Status.NO_PLAN_FOUND: LIMITS,
    Status.ERROR: frozenset({None, *LIMITS}),
}
FOUND = frozenset({Status.OPTIMAL, Status.FEASIBLE})
"""What is known where there is a plan."""


CERTIFIED = "certified"
"""What is said of a bound or a refutation that was worked out exactly, whatever a solver says."""


@dataclass(frozen=True, slots=True)
class ObjectiveValue(Record):
    """Value of one objective in the plan, and the proven bound on what any plan can reach.

    Both are in the objective's own sense and unit: a bound of one that is maximised lies above.
    `proof` says who vouches for the bound: it is `certified`, or only some solver says so. What is
    certified `rests` on the encoding, and on the parts of it that are named, whose truth its tests
    show. Objectives are compared by what is proven, not by who says so.
    """

    name: Word
    value: Finite | None
    bound: Finite | None = None
    proof: Word | None = field(default=None, compare=False, metadata=OPTIONAL)
    rests: tuple[Word, ...] = field(default=(), compare=False, metadata=OPTIONAL)

    @property
    def proven(self) -> bool:
        """Whether no plan does better."""
        return self.value is not None and self.value == self.bound

    def vouched(self, used: SolverUse, bound: float | None) -> Self:
        """With such a bound and who vouches for it; its value is what the check measures."""
        proof = None if bound is None else self.proof or used.word
        return replace(self, value=None, bound=bound, proof=proof)


@dataclass(frozen=True, slots=True)
class MissionRef(Record):
    """Which mission a plan belongs to: its name and the SHA-256 of its text."""

    name: str
    sha256: str


@dataclass(frozen=True, slots=True)
class SolverUse(Record):
    """The solver that found the plan, its version and the options it ran with."""

    name: str = ""
    version: str = ""
    options: Mapping[str, Any] = field(default_factory=dict)

    @property
    def word(self) -> str:
        """What is said of what only the solver calls proven."""
        return f"by {self.name} {self.version}".strip()


@dataclass(frozen=True, slots=True)
class Programs(Record):
    """Linear programs whose ends were worked out exactly: at once, or solved again for it.

    What is `unproven` even then counts for nothing.
    """

    verified: Whole = 0
    again: Whole = 0
    unproven: Whole = 0


@dataclass(frozen=True, slots=True)
class ModelSize(Record):
    """Size of the model that was solved, and of the map it was built on."""

    columns: Whole = 0
    integers: Whole = 0
    rows: Whole = 0
    nonzeros: Whole = 0
    states: Whole = 0
    edges: Whole = 0


@dataclass(frozen=True, slots=True)
class Timings(Record):
    """Seconds spent in each stage, to the microsecond."""

    load: Finite = 0.0
    parse: Finite = 0.0
    reduce: Finite = 0.0
    build: Finite = 0.0
    solve: Finite = 0.0
    extract: Finite = 0.0
    verify: Finite = 0.0
    total: Finite = 0.0

    def __post_init__(self) -> None:
        for item in fields(self):
            object.__setattr__(self, item.name, round(getattr(self, item.name), 6))


class Outcome(Protocol):
    """What a plan and a trajectory say of how they came about."""

    @property
    def status(self) -> Status:
        """What is known."""

    @property
    def stopped_by(self) -> StoppedBy | None:
        """What ended the search before that was all."""

    @property
    def verified(self) -> bool:
        """Whether the independent check accepted it."""

    @property
    def horizon(self) -> int:
        """The last step."""

    @property
    def solver(self) -> SolverUse:
        """What it was found with."""

    @property
    def size(self) -> ModelSize:
        """Of the model in which it was found."""

    @property
    def timings(self) -> Timings:
        """Seconds of each stage."""


def contradictions(result: Outcome, noun: str, content: str, *, there: bool) -> list[Finding]:
    """What cannot be together in a result: status, what stopped it, and whether anything is there.

    Words that were given for the first two become what they mean; ValueError for other words.
    """
    object.__setattr__(result, "status", status := Status(result.status))
    if result.stopped_by is not None:
        object.__setattr__(result, "stopped_by", StoppedBy(result.stopped_by))
    findings = []
    if result.stopped_by not in (possible := _POSSIBLE[status]):
        words = ", ".join(sorted(str(item) if item else "null" for item in possible))
        what = f"status {status} contradicts stopped_by {result.stopped_by or 'null'}"
        findings.append(Finding(what, f"possible: {words}"))
    found = status in FOUND
    if there != found:
        shape = "needs" if found else "cannot hold"
        findings.append(Finding(f"a {noun} of status {status} {shape} {content}"))
    if result.verified and not found:
        findings.append(Finding(f"a {noun} of status {status} cannot be verified"))
    return findings
