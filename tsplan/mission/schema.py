"""The shape of a mission file, `tsplan-mission/1`: keys and types, and nothing that needs a map."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, StringConstraints

FORMAT = "tsplan-mission/1"


def _name(value: Any) -> Any:
    """A name may look like a whole number in YAML."""
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else value


def _starts(value: Any) -> Any:
    """A single start state stands for a mapping to the group's count, which the reader fills in."""
    one = isinstance(value, str | int) and not isinstance(value, bool)
    return {str(value): 1} if one else value


Name = Annotated[str, BeforeValidator(_name), StringConstraints(min_length=1)]
Count = Annotated[int, Field(strict=True, ge=1)]
Whole = Annotated[int, Field(strict=True, ge=0)]


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True, arbitrary_types_allowed=True)


class Member(_Part):
    """One entry of the team: robots of one class."""

    class_name: Name = Field(alias="class")
    count: Count | None = None
    at: Annotated[dict[Name, Count], BeforeValidator(_starts)]
    capabilities: list[Name] = []


class Spec(_Part):
    """The formula and its language. The formula itself is read elsewhere, with its places."""

    language: Literal["catl", "mtl", "stl"]
    formula: Any


class Solver(_Part):
    """What the mission asks of the solver."""

    name: Name | None = None
    time_limit: Annotated[float, Field(gt=0, allow_inf_nan=False)] | None = None
    gap: Annotated[float, Field(ge=0, allow_inf_nan=False)] | None = None
    threads: Count | None = None
    seed: Whole | None = None


class MissionFile(_Part):
    """A whole mission file."""

    format: Literal["tsplan-mission/1"]
    name: Annotated[str, BeforeValidator(_name)] = ""
    map: Any
    team: Annotated[list[Member], Field(min_length=1)]
    spec: Spec
    objective: list[Name] = ["travel"]
    task_interval: Literal["closed", "half-open"] = "closed"
    horizon: Whole | None = None
    solver: Solver | None = None
