"""The shape of a plan file, `tsplan-plan/1`."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, Literal, Self, TypeAlias

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, model_validator

from tsplan.limits import LARGEST, MOST_STEPS
from tsplan.plans.plan import Status

Whole = Annotated[int, Field(strict=True, ge=0, le=LARGEST)]
Positive = Annotated[int, Field(strict=True, ge=1, le=LARGEST)]
Word = Annotated[str, Field(min_length=1)]
Finite = Annotated[float, Field(allow_inf_nan=False)]
_ROUNDING = 1e-9
Outcome = Annotated[Status, Field()]


def _forwards(stays: list[tuple[int, int, str]]) -> list[tuple[int, int, str]]:
    before = -1
    for first, last, _ in stays:
        if not before < first <= last:
            raise ValueError(f"the stay from {first} to {last} is out of order")
        before = last
    return stays


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid")


class Mission(_Part):
    """Which mission the plan belongs to."""

    name: str
    sha256: str


class Objective(_Part):
    """Value and bound of one objective."""

    name: Word
    value: Finite | None
    bound: Finite | None = None


class Agent(_Part):
    """One agent's path."""

    id: Word
    class_name: Word = Field(alias="class")
    capabilities: list[Word] = []
    stays: Annotated[
        list[tuple[Whole, Whole, Word]], Field(min_length=1), AfterValidator(_forwards)
    ]
    heading: Word | None = None


def _distinct(moves: list[Move]) -> list[Move]:
    seen = set()
    for step, source, target, _ in moves:
        if (step, source, target) in seen:
            raise ValueError(f"the move from {source} to {target} at step {step} is there twice")
        seen.add((step, source, target))
    return moves


Move: TypeAlias = tuple[Whole, Word, Word, Positive]
Moves: TypeAlias = Annotated[list[Move], AfterValidator(_distinct)]


class SubSwarm(_Part):
    """A sub-swarm: where it is in which steps, and what it comes from and becomes."""

    id: Word
    swarm: Word
    first: Whole = Field(alias="from")
    last: Whole = Field(alias="to")
    size: Positive
    state: Word | None = None
    edge: tuple[Word, Word] | None = None
    parents: list[Word] = []
    children: list[Word] = []

    @model_validator(mode="after")
    def _somewhere(self) -> Self:
        """One place, and steps that are in order."""
        if (self.state is None) == (self.edge is None):
            raise ValueError("a sub-swarm is at a state or on an edge, one of both")
        if self.last < self.first:
            raise ValueError(f"the steps {self.first} to {self.last} are out of order")
        return self


def _related(groups: list[SubSwarm]) -> list[SubSwarm]:
    known = {group.id: group for group in groups}
    if len(known) < len(groups):
        raise ValueError("two sub-swarms have the same id")
    for group in groups:
        for other in (*group.parents, *group.children):
            if other not in known:
                raise ValueError(f"sub-swarm {group.id} names {other}, which is not there")
    return groups


class Solver(_Part):
    """The solver and its options."""

    name: str = ""
    version: str = ""
    options: dict[str, Any] = {}


class Size(_Part):
    """Size of the model and the map."""

    columns: Whole = 0
    integers: Whole = 0
    rows: Whole = 0
    nonzeros: Whole = 0
    states: Whole = 0
    edges: Whole = 0


class Timings(_Part):
    """Seconds of each stage."""

    load: Finite = 0.0
    parse: Finite = 0.0
    reduce: Finite = 0.0
    build: Finite = 0.0
    solve: Finite = 0.0
    extract: Finite = 0.0
    verify: Finite = 0.0
    total: Finite = 0.0


class _Portion(_Part):
    """A fraction, as a number to read and as the exact one."""

    fraction: Finite
    exact: Annotated[str, Field(pattern=r"^[0-9]{1,4000}(/[0-9]{0,3999}[1-9][0-9]{0,3999})?$")]

    @model_validator(mode="after")
    def _same(self) -> Self:
        value = Fraction(self.exact)
        if not 0 <= value <= 1:
            raise ValueError(f"the fraction {self.exact} is not between 0 and 1")
        if abs(float(value) - self.fraction) > _ROUNDING:
            raise ValueError(f"the fraction {self.fraction} is not {self.exact}")
        return self


class Node(_Portion):
    """How much of one part of a formula holds."""

    text: str
    depth: Whole
    steps: tuple[Whole, Whole]
    met: bool
    counted: bool = True


class Depth(_Part):
    """How much holds of one depth."""

    depth: Whole
    value: Whole
    bound: Whole | None = None


class Satisfaction(_Portion):
    """How much of the mission's formula holds."""

    order: Literal["weighted", "hierarchical", "depth"]
    availability: Finite | None = None
    depths: list[Depth] = []
    nodes: list[Node] = []


class Fulfilment(_Portion):
    """What became of one preferred formula."""

    name: str
    weight: Annotated[Finite, Field(gt=0)]
    level: Whole
    partial: bool
    met: bool
    nodes: list[Node] = []


class PlanFile(_Part):
    """A whole plan file."""

    format: Literal["tsplan-plan/1"]
    status: Outcome
    stopped_by: Literal["time_limit", "gap", "interrupt", "memory", "precision"] | None = None
    mission: Mission
    horizon: Annotated[int, Field(strict=True, ge=0, le=MOST_STEPS)]
    objective: list[Objective] = []
    availability: Finite | None = None
    satisfaction: Satisfaction | None = None
    preferences: list[Fulfilment] = []
    verified: Annotated[bool, Field(strict=True)] = False
    agents: list[Agent] | None = None
    moves: dict[Word, Moves] = {}
    groups: Annotated[list[SubSwarm], AfterValidator(_related)] = []
    solver: Solver = Solver()
    size: Size = Size()
    timings: Timings = Timings()
    notes: list[str] = []

    @model_validator(mode="after")
    def _within(self) -> Self:
        """Nothing happens after the horizon."""
        late = [move[0] for moves in self.moves.values() for move in moves]
        if late and max(late) >= self.horizon:
            raise ValueError(f"a move at step {max(late)} of a plan that ends at {self.horizon}")
        if any(group.last > self.horizon for group in self.groups):
            raise ValueError(f"a sub-swarm exists after step {self.horizon}, where the plan ends")
        return self
