"""Frozen records that are written as JSON and read back by their own fields.

A field is described where it is declared: its type says what is read, and how a value is written
follows from the value. So another field of a plan is another line in a record.
"""

from __future__ import annotations

import json
import math
import re
from dataclasses import fields
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self, TypeAlias, TypeVar, cast

from pydantic import ConfigDict, Field, PlainValidator, ValidationInfo, model_validator

from tsplan.document.written import Written
from tsplan.exact import exact
from tsplan.limits import LARGEST

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from _typeshed import DataclassInstance
    from pydantic import ModelWrapValidatorHandler

_NAMES = {
    "class_name": "class",
    "first": "from",
    "last": "to",
    "source": "from",
    "target": "to",
}
_FRACTION = re.compile(r"[0-9]{1,4000}(/[0-9]{0,3999}[1-9][0-9]{0,3999})?")
_RATIONAL = re.compile("-?" + _FRACTION.pattern)
_EXACT = ("exact", "preference")  # written as text
_WHOLE = 1e16  # from here on a float is shorter with its exponent
_ROUNDING = 1e-9  # by which a fraction may differ from its float, of which some digits are written

OPTIONAL: Mapping[str, bool] = {"optional": True}
"""Metadata of a field that is left out of a file while it is empty."""


def json_name(name: str) -> str:
    """The key by which a file has a field."""
    return _NAMES.get(name, name)


def _exact(value: object) -> Fraction:
    if not isinstance(value, str) or not _FRACTION.fullmatch(value):
        raise ValueError("a fraction is written as in '2/3'")
    if not 0 <= Fraction(value) <= 1:
        raise ValueError(f"the fraction {value} is not between 0 and 1")
    return Fraction(value)


def _rational(value: object) -> Fraction:
    if isinstance(value, str) and _RATIONAL.fullmatch(value):
        return Fraction(value)
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise ValueError("a value is a number, or a fraction as in '-2/3'")
    return exact(value)


def rational_json(value: Fraction) -> float | str:
    """A rational number as a number if its decimals end soon, else as a text.

    >>> [rational_json(Fraction(*pair)) for pair in ((4, 2), (-1, 4), (1, 3))]
    [2, -0.25, '1/3']
    """
    if value.denominator == 1:
        return int(value)
    return float(value) if exact(float(value)) == value else str(value)


def _weight(value: object) -> Fraction:
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value < math.inf:
        raise ValueError("a weight is a number above 0")
    return Fraction(str(value))


Whole: TypeAlias = Annotated[int, Field(strict=True, ge=0, le=LARGEST)]
Positive: TypeAlias = Annotated[int, Field(strict=True, ge=1, le=LARGEST)]
Word: TypeAlias = Annotated[str, Field(min_length=1)]
Finite: TypeAlias = Annotated[float, Field(allow_inf_nan=False)]
Exact: TypeAlias = Annotated[
    Fraction,
    PlainValidator(_exact),
    Written(Annotated[str, Field(pattern=f"^{_FRACTION.pattern}$")]),
]
Rational: TypeAlias = Annotated[
    Fraction,
    PlainValidator(_rational),
    Written(float | Annotated[str, Field(pattern=f"^{_RATIONAL.pattern}$")]),
]
Weight: TypeAlias = Annotated[
    Fraction, PlainValidator(_weight), Written(Annotated[float, Field(gt=0)])
]


class Record:
    """A frozen dataclass of a file; other keys than its fields are refused."""

    __slots__ = ()
    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(
        extra="forbid",
        alias_generator=json_name,
        arbitrary_types_allowed=True,  # older releases of pydantic know no fractions
    )

    def data(self) -> dict[str, Any]:
        """What a file has of the record, under the keys there."""
        key: Any = self.__pydantic_config__["alias_generator"]
        return {
            key(item.name): value
            for item in fields(cast("DataclassInstance", self))
            if (value := getattr(self, item.name)) or value == 0 or "optional" not in item.metadata
        }


def _portion_name(name: str) -> str:
    return "exact" if name == "fraction" else json_name(name)


def _with_repeated(schema: dict[str, Any]) -> None:
    """Add what files of a record with a fraction repeat to its JSON Schema."""
    said = {"fraction": {"type": "number"}, "met": {"type": "boolean"}}
    schema["properties"] |= said


class Portion(Record):
    """A record with a fraction, which a file has exactly, as a number and perhaps as a verdict."""

    __slots__ = ()
    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(
        **{**Record.__pydantic_config__, "alias_generator": _portion_name},
        json_schema_extra=_with_repeated,
    )

    def repeated(self) -> dict[str, float | bool]:
        """What a file says once more for those who read it."""
        record: Any = self
        met = {"met": record.met} if hasattr(self, "met") else {}
        return {**met, "fraction": float(record.fraction or 0)}

    def data(self) -> dict[str, Any]:
        """What a file has of the record, and what it repeats."""
        entries: dict[str, Any] = {}
        for key, value in super().data().items():
            if key == "exact":
                entries |= self.repeated()
            entries[key] = str(value or 0) if key in _EXACT else value
        return entries

    @model_validator(mode="wrap")
    @classmethod
    def _agreeing(cls, data: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        """Read the fields alone, and hold what is repeated against them."""
        given = data if isinstance(data, dict) else {}
        rest = {key: value for key, value in given.items() if key not in ("fraction", "met")}
        record = handler(rest if given else data)
        for key, value in record.repeated().items():
            other = given.get(key)
            if not isinstance(other, int | float) or abs(other - value) > _ROUNDING:
                raise ValueError(f"'{key}': {other} is not {rest.get('exact')}")
        return record


def plain(value: Any) -> Any:
    """A value as JSON has it: records as data, whole numbers without a point, infinite ones null.

    >>> plain((2.0, 0.5, float("inf"), frozenset({"b", "a"})))
    [2, 0.5, None, ['a', 'b']]
    """
    if isinstance(value, Record):
        return {key: plain(item) for key, item in value.data().items()}
    if isinstance(value, dict):  # whose numbers are written as they are
        return {k: item if isinstance(item, float) else plain(item) for k, item in value.items()}
    if isinstance(value, frozenset):
        return sorted(value)
    if isinstance(value, tuple | list):
        return [plain(item) for item in value]
    if isinstance(value, Fraction):
        return plain(float(value))
    return _plain_number(value) if isinstance(value, float) else value


def _plain_number(value: float) -> float | None:
    """A number without a point where it is whole; null where it is infinite."""
    if value.is_integer() and abs(value) < _WHOLE:
        return int(value)
    return value if math.isfinite(value) else None


def as_json(value: Any) -> str:
    """A value as JSON text, whatever kind it is of."""
    return json.dumps(plain(value), ensure_ascii=False, allow_nan=False, default=str)


def json_lines(values: Iterable[str], ends: str = "[]") -> str:
    """A list (or with the `ends` of one, an object) in JSON with one of its values a line."""
    return f"{ends[0]}\n  " + ",\n  ".join(values) + ends[1]


def json_document(entries: Mapping[str, Any], large: Mapping[str, Callable[[], str]]) -> str:
    """A file of results: one key a line, but for those of which `large` writes every value."""
    lines = (
        f"{as_json(key)}: {large[key]() if key in large else as_json(value)}"
        for key, value in entries.items()
    )
    return "{" + ",\n ".join(lines) + "}\n"


SharedT = TypeVar("SharedT")


def shared(value: SharedT, info: ValidationInfo) -> SharedT:
    """Of equal values that are read from one file only the first, so that they compare at once."""
    known: dict[SharedT, SharedT] = info.context if isinstance(info.context, dict) else {}
    return known.setdefault(value, value)
