"""From the text of a file of results to its data, and findings at their places in it."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Hashable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, NoReturn, TypeVar, cast

from pydantic import TypeAdapter, ValidationError

from tsplan.document import Document, parse_document
from tsplan.document.kinds import PLAN, kind_of_data, kind_of_text
from tsplan.document.pause import collector_paused
from tsplan.errors import Finding, InputError, PlanError
from tsplan.limits import DIGITS
from tsplan.words import nfc

T = TypeVar("T")
_LOCATED = 2_000_000  # characters up to which a faulty file is read again for lines and columns


@dataclass(frozen=True, slots=True)
class ResultFormat:
    """A format of files of results: what one of them is called."""

    noun: str

    @property
    def mark(self) -> str:
        """What a file says of itself under the key `format`."""
        return f"tsplan-{self.noun}/1"

    def refusal(self, what: str, source: str) -> PlanError:
        """That something else is in a file, in words."""
        remedy = f'a {self.noun} has "format": "{self.mark}"'
        return _refusal(f"this is no {self.noun}: {what}", remedy, source)


PLANS, TRAJECTORIES = ResultFormat("plan"), ResultFormat("trajectory")


def read_result(kind: type[T], form: ResultFormat, text: str, source: str) -> T:
    """The plan or trajectory in a text; PlanError with every finding for a text that is none.

    Equal paths become one object, which makes grouping cheap.
    """
    with collector_paused():
        return _read(kind, form, text.removeprefix("\ufeff"), source)


def _read(kind: type[T], form: ResultFormat, text: str, source: str) -> T:
    refuse_other(text, form, source)
    data = _parsed(text, form, source)
    if not isinstance(data, dict):
        raise form.refusal("it is no mapping of keys to values", source)
    if data.get("format") != form.mark:
        raise form.refusal(_other_format(data), source)
    del data["format"]
    try:
        result: T = _reader(cast("Hashable", kind)).validate_python(data, context={})
    except ValidationError as error:
        raise PlanError(_located(error, form, text, source)) from None
    return result


@cache
def _reader(kind: Any) -> TypeAdapter[Any]:
    return TypeAdapter(kind)


def spelled(text: str) -> str:
    """The text of a file of results with all names in the form in which names are compared.

    Escapes of characters beyond ASCII are written out: they may be parts of such a name.
    """
    return nfc(_ESCAPE.sub(_character, text) if "\\u" in text else text)


_ESCAPE = re.compile(r"(?<!\\)((?:\\\\)*)\\u([0-9a-fA-F]{4})")


def _character(escape: re.Match[str]) -> str:
    code = int(escape[2], 16)
    ours = code < _BEYOND_ASCII or code in _SURROGATES
    return escape[0] if ours else escape[1] + chr(code)


_BEYOND_ASCII = 0x80
_SURROGATES = range(0xD800, 0xE000)


def refuse_other(text: str, form: ResultFormat, source: str) -> None:
    """Raise PlanError for the beginning of a file that is no JSON, named for what it is."""
    if text.lstrip()[:1] in ("{", "["):
        return
    kind = kind_of_text(text) or _yaml_kind(text)
    if kind is not None:
        raise form.refusal(f"it is {kind}", source)


def _yaml_kind(text: str) -> str | None:
    """What a text in YAML is by the keys at its beginning, if it is ours."""
    pairs = (line.split(":", 1) for line in text[:_GLANCE].split("\n") if line[:1].isalpha())
    return kind_of_data({pair[0]: pair[-1].strip() for pair in pairs})


_GLANCE = 4096  # characters of a text that are looked at


def _other_format(data: dict[str, Any]) -> str:
    """What a file is that is not in the format that is wanted."""
    given, kind = data.get("format"), kind_of_data(data)
    if given is not None:
        return f"its format is {given!r}"
    return "it names no format" if kind in (None, PLAN) else f"it is {kind}"


def _parsed(text: str, form: ResultFormat, source: str) -> Any:
    try:
        return json.loads(
            text, object_pairs_hook=_unrepeated, parse_constant=_not_json, parse_int=_whole
        )
    except json.JSONDecodeError as error:
        place = Finding(f"this is not JSON: {error.msg}", "", source, error.lineno, error.colno)
        raise PlanError([place]) from None
    except RecursionError:
        raise _refusal(f"the JSON is nested too deeply for a {form.noun}", "", source) from None
    except ValueError as error:
        raise _refusal(str(error), "correct the file", source) from None


def _whole(text: str) -> int:
    if len(text) > DIGITS:
        raise ValueError(f"a number of {len(text):,} digits means nothing here")
    return int(text)


def _unrepeated(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    mapping = dict(pairs)
    if len(mapping) < len(pairs):
        times = Counter(name for name, _ in pairs)
        twice = next(name for name in times if times[name] > 1)
        raise ValueError(f"the key '{twice}' is there twice")
    return mapping


def _not_json(word: str) -> NoReturn:
    raise ValueError(f"{word} is not a JSON number")


def _located(error: ValidationError, form: ResultFormat, text: str, source: str) -> list[Finding]:
    """What is wrong with data, with lines and columns unless the file is very large."""
    document = _document(text, source) if len(text) <= _LOCATED else None
    findings = []
    for item in error.errors(include_url=False, include_input=False):
        cause = item.get("ctx", {}).get("error")
        if isinstance(cause, InputError):  # of the whole, which has no place
            findings += [replace(finding, source=source) for finding in cause.findings]
            continue
        path = item["loc"]
        line, column = document.place(path) if document is not None else (None, None)
        where = "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in path)
        message = str(item["msg"]).removeprefix("Value error, ")
        message = message[:1].lower() + message[1:]
        findings.append(
            Finding(f"{where.lstrip('.') or form.noun}: {message}", "", source, line, column)
        )
    return findings


def _document(text: str, source: str) -> Document | None:
    """JSON is YAML too, whose reader knows the place of every value."""
    try:
        return parse_document(text, source)
    except InputError:
        return None


def _refusal(message: str, remedy: str, source: str) -> PlanError:
    return PlanError([Finding(message, remedy, source)])
