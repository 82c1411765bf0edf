"""The shape of a file `tsplan-sweep/1`: keys and types, and nothing that needs the mission."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field

from tsplan.document.written import Written
from tsplan.limits import MOST_SEED
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.entry_fields import Count, Name
from tsplan.mission.mission_schema import Part, Solver, Title

FORMAT = "tsplan-sweep/1"

Seed = Annotated[int, Field(strict=True, ge=0, le=MOST_SEED)]
Values = Annotated[list[Any], Field(min_length=1)]


class SolverEntry(Solver):
    """What a run asks of the solver and of the encoding, and what that is called in the results."""

    label: Name | None = None
    encoding: Literal["tight", "reference"] = "tight"
    without: list[Name] = Field(default_factory=list)

    @property
    def choice(self) -> SolverChoice:
        """What is asked of the solver alone."""
        return SolverChoice(self.name, self.time_limit, self.gap, self.threads, self.seed)

    @property
    def title(self) -> str:
        """The label, or else what is asked in words."""
        if self.label is not None:
            return self.label
        numbers = [f"{name} {value:g}" for name, value in self.choice.numbers.items()]
        encoding = [] if self.encoding == "tight" else [self.encoding]
        without = [f"without {name}" for name in self.without]
        return ", ".join([self.name or "default", *numbers, *encoding, *without])


class AxesEntry(Part):
    """What is varied, each with each."""

    seeds: Annotated[list[Seed], Field(min_length=1)] | None = None
    parameters: Annotated[dict[Name, Values], Field(min_length=1)] | None = None
    formulas: Annotated[dict[Name, Any], Field(min_length=1)] | None = None
    solvers: Annotated[list[SolverEntry], Field(min_length=1)] | None = None


class RunEntry(Part):
    """One run of a list."""

    seed: Seed | None = None
    parameters: dict[Name, Any] = Field(default_factory=dict)
    formula: Any = None
    solver: SolverEntry | None = None


class SweepFile(Part):
    """A whole file."""

    format: Literal["tsplan-sweep/1"]
    name: Title = ""
    mission: Annotated[Any, Written(str | dict[str, Any])]
    axes: AxesEntry | None = None
    runs: Annotated[list[RunEntry], Field(min_length=1)] | None = None
    repeat: Count = 1


# what stands for a part of a file that is wrong, so that the others can be judged
STAND_INS = {"format": FORMAT, "mission": {}}
