"""The shape of a plan file, `tsplan-plan/1`."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, model_validator

from tsplan.mission.data import MOST_STEPS
from tsplan.results.plan import Status

Whole = Annotated[int, Field(strict=True, ge=0)]
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
    stopped_by: Literal["time_limit", "gap", "interrupt", "memory"] | None = None
    mission: Mission
    horizon: Annotated[int, Field(strict=True, ge=0, le=MOST_STEPS)]
    objective: list[Objective] = []
    availability: Finite | None = None
    satisfaction: Satisfaction | None = None
    preferences: list[Fulfilment] = []
    verified: Annotated[bool, Field(strict=True)] = False
    agents: list[Agent] | None = None
    solver: Solver = Solver()
    size: Size = Size()
    timings: Timings = Timings()
    notes: list[str] = []
