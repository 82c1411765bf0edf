"""The shape of a file `tsplan-signals/1`: keys and types, and nothing that needs the system."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, ConfigDict, Field

from tsplan.document.fields import complaint, shown
from tsplan.document.written import Written
from tsplan.limits import MOST_COST, MOST_STEPS, MOST_WEIGHT, is_number
from tsplan.mission.entry_fields import Name
from tsplan.mission.mission_schema import (
    ONE_FORMULA,
    FormulaEntry,
    Part,
    SoftFormula,
    Solver,
    Title,
    WeightEntry,
)
from tsplan.signals.integrators import Model
from tsplan.signals.signal_parts import SignalLanguage, Weighting

FORMAT = "tsplan-signals/1"
LARGEST_VALUE = MOST_COST
"""Values of signals and factors are below this: solvers take it for infinity."""

_INFINITE = {"Infinity": math.inf, "-Infinity": -math.inf}  # as JSON is written by Python


def _value(value: Any) -> Any:
    """A finite number that solvers tell from infinity."""
    if not is_number(value):
        raise complaint(f"{shown(value)} is not a finite number", "write one, as in 1.5")
    if abs(value) >= LARGEST_VALUE:
        raise complaint(f"{shown(value)} is as good as infinite", "use smaller units")
    return float(value)


def _end(value: Any) -> Any:
    """An end of a range: a number, or an infinite one for none."""
    value = _INFINITE.get(value, value) if isinstance(value, str) else value
    infinite = isinstance(value, float) and math.isinf(value)
    return value if infinite else _value(value)


def _bounds(value: Any) -> Any:
    """`[0, 10]` is short for `{min: 0, max: 10}`, and nothing for no bounds."""
    if isinstance(value, list):
        _two(value)
        return {"min": value[0], "max": value[1]}
    return _nothing(value)


def _nothing(value: Any) -> Any:
    """A key without a value stands for a mapping without entries."""
    return {} if value is None else value


def _range(value: Any) -> Any:
    """A number, or the two ends of a range."""
    if isinstance(value, list):
        _two(value)
        return value
    return [value, value]


def _two(value: list[Any]) -> None:
    if len(value) != 2:  # noqa: PLR2004  (the two ends)
        raise complaint(f"a range has 2 numbers, not {len(value)}", "write it as [0, 10]")


Value = Annotated[float, BeforeValidator(_value)]
End = Annotated[float, BeforeValidator(_end), Written(float | Literal["Infinity", "-Infinity"])]
_Ends = tuple[End, End]
Start = Annotated[list[End], BeforeValidator(_range), Written(End | _Ends)]
Side = Annotated[list[Value], BeforeValidator(_range), Written(Value | tuple[Value, Value])]


class Bounds(Part):
    """The values that something may have; without an end, any."""

    min: End = -math.inf
    max: End = math.inf


class SignalEntry(Bounds):
    """A signal: its bounds, and where it begins if that is not free."""

    initial: Start | None = None


class DynamicsEntry(Part):
    """How signals go on: matrices, or a model by its name."""

    A: list[list[Value]] | None = None
    B: list[list[Value]] | None = None
    D: list[Value] | None = None
    model: Model | None = None
    axes: Annotated[list[Name], Field(min_length=1)] | None = None
    step: Annotated[Value, Field(gt=0)] | None = None


class CopyEntry(Part):
    """One of several robots: where its signals begin."""

    initial: dict[Name, Start] = Field(default_factory=dict)


class SignalSpec(Part):
    """The formula, its language and weights. The formula itself is read elsewhere."""

    model_config = ConfigDict(json_schema_extra=ONE_FORMULA)

    language: SignalLanguage = "stl"
    formula: FormulaEntry = None
    must: FormulaEntry = None
    prefer: list[SoftFormula] = Field(default_factory=list)
    weights: dict[Name, WeightEntry] = Field(default_factory=dict)
    weighting: Weighting = "product"


Whole = Annotated[int, Field(strict=True, ge=0, le=MOST_STEPS)]
Factor = Annotated[float, Field(ge=0, le=MOST_WEIGHT, allow_inf_nan=False)]


_Signal = Annotated[SignalEntry, BeforeValidator(_bounds), Written(SignalEntry | _Ends | None)]
_Control = Annotated[Bounds, BeforeValidator(_bounds), Written(Bounds | _Ends | None)]
_Copy = Annotated[CopyEntry, BeforeValidator(_nothing), Written(CopyEntry | None)]


class SignalFile(Part):
    """A whole file."""

    format: Literal["tsplan-signals/1"]
    name: Title = ""
    signals: Annotated[dict[Name, _Signal], Field(min_length=1)]
    controls: dict[Name, _Control] = Field(default_factory=dict)
    dynamics: DynamicsEntry | None = None
    outputs: dict[Name, str] = Field(default_factory=dict)
    limits: list[str] = Field(default_factory=list)
    regions: dict[Name, dict[Name, Side]] = Field(default_factory=dict)
    copies: dict[Name, _Copy] = Field(default_factory=dict)
    spec: Annotated[SignalSpec, Written(SignalSpec | FormulaEntry)]
    objective: Any = None
    horizon: Whole | None = None
    solver: Solver | None = None


# what stands for a part of a file that is wrong, so that the others can be judged
STAND_INS = {"format": FORMAT, "signals": {"?": None}, "spec": {"formula": "true"}}
