"""Checking a part of a document against a pydantic model, with findings a person can act on."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeVar, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from tsplan.document.document import Document, Path
from tsplan.document.fields import shown
from tsplan.errors import Finding, nearest

SchemaT = TypeVar("SchemaT", bound=BaseModel)

_LIST = ("a list", "write it as [a, b]")
_MAPPING = ("a mapping", "write it as {key: value}")
_KINDS: dict[str, tuple[str, str]] = {
    "int": ("a whole number", "write it without quotes, as in 3"),
    "int_from_float": ("a whole number", "round it"),
    "float": ("a number", "write it without quotes, as in 1.5"),
    "finite_number": ("a finite number", "write its value"),
    "string": ("text", "put it in quotes"),
    "bool": ("true or false", "write true or false"),
    **dict.fromkeys(("list", "tuple", "set", "frozen_set"), _LIST),
    **dict.fromkeys(("dict", "model", "model_attributes"), _MAPPING),
}
"""What a value should be, and how to write one, by pydantic's words without `_type`, `_parsing`."""

_LIMITS = {
    "ge": ("greater than or equal to", "at least"),
    "gt": ("greater than", "more than"),
    "le": ("less than or equal to", "at most"),
    "lt": ("less than", "less than"),
}
"""Limits of numbers by pydantic's names: what a value should be, and what to use."""


def validated(
    document: Document, schema: type[SchemaT], path: Path = ()
) -> tuple[SchemaT | None, list[Finding]]:
    """The part of a document at `path` as a pydantic model, or else everything wrong with it.

    Findings stand at the value they are about, those on unknown keys at the key. A validator may
    raise `fields.complaint(message, remedy)` to say its own message and remedy.
    """
    try:
        return schema.model_validate(document.at(path)), []
    except ValidationError as error:
        findings = [_finding(document, schema, path, details) for details in error.errors()]
        return None, list(dict.fromkeys(findings))


def salvaged(
    document: Document, schema: type[SchemaT], stand_ins: Mapping[str, Any]
) -> tuple[SchemaT | None, frozenset[str]]:
    """A whole document without its faulty keys, and which these are; None if that is no use.

    `stand_ins` has a value for each key that the schema wants, for where it is faulty.
    """
    data = document.data
    if not isinstance(data, dict):
        return None, frozenset()
    try:
        return schema.model_validate(data), frozenset()
    except ValidationError as error:
        faulty = frozenset(str(details["loc"][0]) for details in error.errors() if details["loc"])
    kept = {key: value for key, value in data.items() if key not in faulty}
    try:
        return schema.model_validate({**stand_ins, **kept}), faulty
    except ValidationError:
        return None, faulty


def _finding(
    document: Document, schema: type[BaseModel], path: Path, error: ErrorDetails
) -> Finding:
    here, kind, context = (*path, *error["loc"]), error["type"], error.get("ctx", {})
    if kind == "missing":
        return _missing(document, here, _only_value(schema, error["loc"]))
    if kind == "extra_forbidden":
        remedy = nearest(str(here[-1]), known_keys(schema, error["loc"][:-1]))
        return document.key_finding(here, f"unknown key '{here[-1]}'", remedy)
    words = [step for step in here if isinstance(step, str)]  # the last one names what is wrong
    subject = context.get("about") or "".join(words[-1:])
    message, remedy = _told(error)
    return document.finding(here, f"{subject}: {message}" if subject else message, remedy)


def _missing(document: Document, path: Path, value: str | None) -> Finding:
    """A key that is not there, or an entry that a list is too short for."""
    if isinstance(path[-1], int):
        return document.finding(path[:-1], f"entry {path[-1] + 1} is missing", "add it")
    remedy = f"add '{path[-1]}: {value or '...'}'"
    return document.finding(path[:-1], f"'{path[-1]}' is missing", remedy)


def _only_value(schema: type[BaseModel], location: tuple[int | str, ...]) -> str | None:
    """The value of a key that can have one value only, such as the name of the format."""
    for model in _models_at(schema, location[:-1]):
        field = model.model_fields.get(str(location[-1]))
        if field is not None and get_origin(field.annotation) is Literal:
            values = get_args(field.annotation)
            return str(values[0]) if len(values) == 1 else None
    return None


def _told(error: ErrorDetails) -> tuple[str, str]:
    """What is wrong and what to do, in words of this project wherever its own files err."""
    kind, context, value = error["type"], error.get("ctx", {}), shown(error["input"])
    wanted = _KINDS.get(kind.removesuffix("_type").removesuffix("_parsing"))
    if wanted is not None:
        empty = error["input"] is None and wanted != _KINDS["string"]
        how = "give it a value or leave the key out" if empty else wanted[1]
        return f"{value} is not {wanted[0]}", how
    if kind == "too_short":
        least = f"write at least {context['min_length']}"
        return f"{context['actual_length']} entries are too few", least
    for key, (should_be, use) in _LIMITS.items():
        if key in context:
            limit = context[key]
            return f"{value} should be {should_be} {limit}", f"use a number that is {use} {limit}"
    if kind == "literal_error":
        return f"{value} should be {context['expected']}", f"use one of {context['expected']}"
    text = str(context.get("message") or context.get("error") or error["msg"])
    text = text[:1].lower() + text[1:] if text[1:2].islower() else text
    return text, str(context.get("remedy", ""))


def _models(annotation: Any) -> list[type[BaseModel]]:
    """Every pydantic model named in a type, through unions, lists and mappings."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for part in get_args(annotation) for model in _models(part)]


def known_keys(schema: type[BaseModel], location: tuple[int | str, ...]) -> list[str]:
    """The keys that a schema knows at a location; none where it leaves open what is there."""
    models = _models_at(schema, location)
    return [field.alias or name for model in models for name, field in model.model_fields.items()]


def _models_at(schema: type[BaseModel], location: tuple[int | str, ...]) -> list[type[BaseModel]]:
    """The models of which one describes a location below a schema."""
    models = [schema]
    for step in location:
        named = [
            field
            for model in models
            for name, field in model.model_fields.items()
            if step in (name, field.alias)
        ]
        # a list position or a free key stays within the same models
        if named:
            models = [below for field in named for below in _models(field.annotation)]
    return models
