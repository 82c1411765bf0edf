"""The shape of a mission file, `tsplan-mission/1`: keys and types, and nothing that needs a map."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Annotated, Any, Literal

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    WithJsonSchema,
)

from tsplan.document.fields import Number, complaint, shown
from tsplan.document.written import Written
from tsplan.errors import nearest
from tsplan.limits import (
    LARGEST,
    LEAST_WEIGHT,
    MOST_COST,
    MOST_GAP,
    MOST_ROBOTS,
    MOST_SECONDS,
    MOST_SEED,
    MOST_STEPS,
    MOST_THREADS,
    MOST_WEIGHT,
    Range,
)
from tsplan.mission.entry_fields import CLOSED, Amount, Count, Name, NameText, name_text
from tsplan.mission.start_entries import Starts
from tsplan.mission.vocabulary import (
    BOOKINGS,
    FORMAT,
    ORDERS,
    Booking,
    Dynamics,
    Language,
    Order,
    PolicyKind,
    TaskInterval,
)
from tsplan.mission.weight_entries import weights_of_entry
from tsplan.ts.io.map_settings import MapReference
from tsplan.ts.io.tsplan_yaml import MapFile

_SHARE = re.compile(r"([0-9]{1,15}(?:\.[0-9]{1,15})?)\s*%")


def _margin(value: Any) -> Any:
    """Head-room: `5%` is a fraction of the swarm, a whole number is one of agents."""
    if isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= MOST_ROBOTS:
        return value
    match = _SHARE.fullmatch(value.strip()) if isinstance(value, str) else None
    share = Fraction(match[1]) / 100 if match else None
    if share is None or share > 1:
        raise complaint(
            f"{shown(value)} is no head-room", "write a percentage, as in 5%, or a number of agents"
        )
    return share


def _counted(value: Any) -> Any:
    """A single name stands for a mapping to a count, which the reader fills in."""
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


def _booking(value: Any) -> Any:
    """How agents are booked for tasks."""
    if value not in BOOKINGS:
        raise complaint(f"{shown(value)} is no way to book agents", nearest(str(value), BOOKINGS))
    return value


def _load(value: Any) -> Any:
    """What a robot carries: an amount of each resource, or one number for all together."""
    for amount in value.values() if isinstance(value, dict) else [value]:
        if words := Range(0, LARGEST).complaint(amount):
            raise complaint(words, "write how much it carries, as in {brick: 2}, or 6 for any mix")
    if not isinstance(value, dict):
        return float(value)
    return tuple((str(name), float(amount)) for name, amount in value.items())


Title = Annotated[str, BeforeValidator(name_text), Written(str | int)]
_Weight = Annotated[Number, Field(gt=0)]
WeightEntry = Annotated[
    Any,
    BeforeValidator(weights_of_entry),
    Written(_Weight | list[_Weight] | dict[str, _Weight]),
]
Whole = Annotated[int, Field(strict=True, ge=0, le=LARGEST)]
Counted = Annotated[dict[Name, Count], BeforeValidator(_counted), Written(Name | dict[Name, Count])]
_Text = Annotated[str, Field(min_length=1)] | bool
FormulaEntry = Annotated[Any, Written(_Text | Annotated[list[_Text], Field(min_length=1)])]
"""A formula, or several that all have to hold; it is read elsewhere, with its places."""
_Share = Annotated[str, Field(pattern=rf"^\s*{_SHARE.pattern}\s*$")]
_Margin = Annotated[int, Field(ge=0, le=MOST_ROBOTS)] | _Share


Load = Annotated[Any, BeforeValidator(_load), Written(Amount | dict[Name, Amount])]


class Part(BaseModel):
    """A mapping with known keys and nothing else, whose values are what they are written as."""

    model_config = CLOSED


class ResourceEntry(Part):
    """A resource, and where it lies at first."""

    name: Name
    at: dict[Name, Amount]
    indivisible: bool = False
    consumed: bool = True


class ConfigurationEntry(Part):
    """A shape of structures of modules."""

    modules: Count
    capabilities: list[Name] = []
    cost: Annotated[Number, Field(ge=0, le=LARGEST)] = 1
    duration: Annotated[Number, Field(gt=0, le=MOST_STEPS)] = 1
    carries: Load = ()


class ReconfigurationEntry(Part):
    """How structures become others."""

    parts: Counted = Field(alias="from")
    made: Counted = Field(alias="to")
    duration: Annotated[int, Field(strict=True, ge=1, le=MOST_STEPS)] = 1
    cost: Annotated[Number, Field(ge=0, lt=MOST_COST)] = 0
    at: list[Name] = []


class Member(Part):
    """One entry of the team: robots of one class."""

    class_name: Name = Field(alias="class")
    count: Count | None = None
    at: Starts
    capabilities: list[Name] = []
    carries: Load = ()
    configuration: Name | None = None


class Swarm(Part):
    """A swarm: how many agents, where they start, and how far they may divide."""

    size: Count
    at: Starts
    max_subswarms: Count | None = None
    min_subswarm: Count = 1
    capabilities: list[Name] = []


class NamedSwarm(Swarm):
    """One of several swarms; atoms take its name as a capability."""

    name: Name


class SoftFormula(Part):
    """A preferred formula; the formula itself is read elsewhere."""

    formula: FormulaEntry
    weight: Annotated[float, Field(ge=LEAST_WEIGHT, le=MOST_WEIGHT, allow_inf_nan=False)] = 1
    name: Name | None = None
    level: Whole = 0
    partial: bool = False


ONE_FORMULA: dict[str, Any] = {
    "anyOf": [{"required": [key]} for key in ("formula", "must", "prefer")],
    "not": {"required": ["formula", "must"]},
}
"""Which formulas a mission has."""


class Spec(Part):
    """The formula, its language and weights. The formula is read elsewhere, with its places."""

    model_config = ConfigDict(json_schema_extra=ONE_FORMULA)

    language: Language
    formula: FormulaEntry = None
    must: FormulaEntry = None
    prefer: list[SoftFormula] = []
    weights: dict[Name, WeightEntry] = {}


class Solver(Part):
    """What the mission asks of the solver."""

    name: Name | None = None
    time_limit: Annotated[float, Field(gt=0, le=MOST_SECONDS, allow_inf_nan=False)] | None = None
    gap: Annotated[float, Field(ge=0, le=MOST_GAP, allow_inf_nan=False)] | None = None
    threads: Annotated[int, Field(strict=True, ge=1, le=MOST_THREADS)] | None = None
    seed: Annotated[int, Field(strict=True, ge=0, le=MOST_SEED)] | None = None


class SatisfactionEntry(Part):
    """The objective that the formula holds as far as it can, with what counts how much."""

    satisfaction: Order


Aim = Annotated[NameText, BeforeValidator(_aim), Written(Name | SatisfactionEntry)]
_Foreign = Annotated[
    Any,
    WithJsonSchema(
        {"type": "object", "not": {"anyOf": [{"required": ["states"]}, {"required": ["file"]}]}}
    ),
]
"""A map of another program that is written into a mission; it is read elsewhere."""

MapEntry = Annotated[Any, Written(str | MapFile | MapReference | _Foreign)]
"""The name of a map file, with what is said of reading it, or a map; it is read elsewhere."""

_KINDS: dict[str, Any] = {
    "anyOf": [{"required": [kind]} for kind in ("team", "swarm", "swarms")],
    "not": {"required": ["swarm", "swarms"]},
}
"""Which agents a mission has."""


class MissionFile(Part):
    """A whole mission file."""

    model_config = ConfigDict(json_schema_extra=_KINDS)

    format: Literal["tsplan-mission/1"]
    name: Title = ""
    map: MapEntry
    resources: list[ResourceEntry] = []
    configurations: dict[Name, ConfigurationEntry] = {}
    reconfigure: list[ReconfigurationEntry] = []
    performance: dict[Name, dict[Name, Amount]] = {}
    team: Annotated[list[Member], Field(min_length=1)] = []
    swarm: Swarm | None = None
    swarms: Annotated[list[NamedSwarm], Field(min_length=1)] = []
    max_subswarms: Count | None = None
    # belongs into a swarm, which the reader says
    min_subswarm: Annotated[Any, WithJsonSchema({"not": {}})] = None
    margin: Annotated[Any, BeforeValidator(_margin), Written(_Margin)] = 0
    delay: Whole = 0
    booking: Annotated[Booking, BeforeValidator(_booking)] = "shared"
    spec: Annotated[Spec, Written(Spec | FormulaEntry)]
    objective: list[Aim] | None = None
    task_interval: TaskInterval = "closed"
    horizon: Whole | None = None
    dynamics: Dynamics = "certain"
    policy: PolicyKind | None = None
    solver: Solver | None = None


# what stands for a part of a file that is wrong, so that the others can be judged
STAND_INS = {"format": FORMAT, "map": {}, "spec": {"language": "catl", "formula": "true"}}
