"""JSON files in parts, so that the plan of very many agents never is one text in the memory."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from tsplan.plans.records import as_json


def array(items: Iterable[str]) -> Iterator[str]:
    r"""An array of items, which are JSON themselves, one a line.

    >>> "".join(array(["1", "2"]))
    '[\n  1,\n  2]'
    """
    before = "[\n  "
    for item in items:
        yield before + item
        before = ",\n  "
    yield "]" if before.startswith(",") else "[]"


def document(
    entries: Mapping[str, Any], arrays: Mapping[str, Iterable[str]] | None = None
) -> Iterator[str]:
    r"""An object of small entries and long arrays, one key or item a line.

    >>> "".join(document({"horizon": 4}, {"agents": ['"a-1"']}))
    '{"horizon": 4,\n "agents": [\n  "a-1"]}\n'
    """
    before = "{"
    for key, value in entries.items():
        yield f"{before}{as_json(key)}: {as_json(value)}"
        before = ",\n "
    for key, items in (arrays or {}).items():
        yield f"{before}{as_json(key)}: "
        yield from array(items)
        before = ",\n "
    yield "}\n"
