"""The shape of a mission file, `tsplan-mission/1`: keys and types, and nothing that needs a map."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, StringConstraints

from tsplan.document.fields import complaint, shown
from tsplan.errors import nearest
from tsplan.mission.data import ORDERS

FORMAT = "tsplan-mission/1"


def _name(value: Any) -> Any:
    """A name may look like a whole number in YAML."""
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else value


def _starts(value: Any) -> Any:
    """A single start state stands for a mapping to the group's count, which the reader fills in."""
    one = isinstance(value, str | int) and not isinstance(value, bool)
    return {str(value): 1} if one else value


def _aim(value: Any) -> Any:
    """An objective with an order, `{satisfaction: weighted}`, is read as one text."""
    if not isinstance(value, dict):
        return value
    order = value.get("satisfaction")
    if set(value) != {"satisfaction"}:
        remedy = "write its name, or {satisfaction: weighted}"
        raise complaint("a mapping is no objective", remedy)
    if order not in ORDERS:
        remedy = nearest(str(order), ORDERS)
        raise complaint(f"{shown(order)} is no order of satisfaction", remedy)
    return f"satisfaction: {order}"


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


class Wish(_Part):
    """A preferred formula; the formula itself is read elsewhere."""

    formula: Any
    weight: Annotated[float, Field(gt=0, allow_inf_nan=False)] = 1
    name: Name | None = None
    level: Whole = 0
    partial: bool = False


class Spec(_Part):
    """The formula and its language. The formula itself is read elsewhere, with its places."""

    language: Literal["catl", "mtl", "stl"]
    formula: Any = None
    must: Any = None
    prefer: list[Wish] = []


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
    objective: list[Annotated[Name, BeforeValidator(_aim)]] = ["travel"]
    task_interval: Literal["closed", "half-open"] = "closed"
    horizon: Whole | None = None
    solver: Solver | None = None
