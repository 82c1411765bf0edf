"""Field types for file schemas: values that must be written as what they are.

Pydantic would turn `"3"`, `true` or `3.7` into numbers; here a whole number is written as one
(2.0 counts), and text that YAML reads as something else is refused with a remedy.
"""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field
from pydantic_core import PydanticCustomError

from tsplan.limits import LARGEST, is_number


def _must_be(kind: type, what: str, remedy: str) -> BeforeValidator:
    """A validator that takes values of one type only."""

    def checked(value: Any) -> Any:
        if not isinstance(value, kind):
            raise complaint(f"{shown(value)} is {what}", remedy)
        return value

    return BeforeValidator(checked)


def _whole(value: Any) -> Any:
    if isinstance(value, float) and value.is_integer():
        return int(value)
    if isinstance(value, bool) or not isinstance(value, int):
        raise complaint(f"{shown(value)} is not a whole number", "write one, as in 3")
    return value


def _number(value: Any) -> Any:
    if not is_number(value):
        raise complaint(f"{shown(value)} is not a finite number", "write one, as in 1.5")
    return value


def _filled(value: str) -> str:
    if not value:
        raise complaint("the text is empty", "write at least one character")
    return value


def complaint(message: str, remedy: str, about: str = "") -> PydanticCustomError:
    """An error for validators, with the message and remedy that the finding will have.

    `about` names what is wrong, where the key it stands under does not.
    """
    context = {"message": message, "remedy": remedy, "about": about}
    return PydanticCustomError("tsplan", "{message}", context)


def shown(value: Any) -> str:
    """A value in a message, short and as it is written in YAML.

    >>> shown(True), shown([1]), shown("x")
    ("'true'", 'a list', "'x'")
    """
    if value is None:
        return "nothing"
    if isinstance(value, dict | list):
        return "a mapping" if isinstance(value, dict) else "a list"
    text = str(value).lower() if isinstance(value, bool) else str(value)
    longest = 40
    return f"'{text}'" if len(text) <= longest else f"'{text[: longest - 3]}...'"


_LIST = _must_be(list, "not a list", "write it as [a, b]")
Whole = Annotated[int, BeforeValidator(_whole)]
Natural = Annotated[int, Field(ge=0, le=LARGEST), BeforeValidator(_whole)]
Positive = Annotated[int, Field(ge=1, le=LARGEST), BeforeValidator(_whole)]
Number = Annotated[float, BeforeValidator(_number)]
Truth = Annotated[bool, _must_be(bool, "neither true nor false", "write true or false")]
Word = Annotated[str, AfterValidator(_filled), _must_be(str, "not text", "put it in quotes")]
Words = Annotated[list[Word], _LIST]
Point = Annotated[tuple[Number, Number], _LIST]
