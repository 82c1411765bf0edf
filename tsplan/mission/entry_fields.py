"""Kinds of values that several entries of mission files have: names, counts, amounts."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator, ConfigDict, Field, StringConstraints

from tsplan.document.fields import Number
from tsplan.document.written import Written
from tsplan.limits import LARGEST


def name_text(value: Any) -> Any:
    """A name may look like a whole number in YAML."""
    return str(value) if is_name(value) else value


def is_name(value: Any) -> bool:
    """Whether a value of YAML is a name."""
    return isinstance(value, str | int) and not isinstance(value, bool)


NameText = Annotated[str, BeforeValidator(name_text), StringConstraints(min_length=1)]
Name = Annotated[NameText, Written(Annotated[str, Field(min_length=1)] | int)]
Count = Annotated[int, Field(strict=True, ge=1, le=LARGEST)]
_Amount = Field(ge=0, le=LARGEST)
Amount = Annotated[Number, _Amount, Written(Annotated[float, _Amount])]

CLOSED = ConfigDict(extra="forbid", strict=True, arbitrary_types_allowed=True)
"""Of mappings with known keys and nothing else, whose values are what they are written as."""
