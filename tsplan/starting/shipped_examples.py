"""The examples that come with the package: which there are, and a copy of one to work on."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from os.path import commonpath
from pathlib import Path
from typing import Any

from tsplan.document import read_document
from tsplan.document.document import LARGEST_FILE
from tsplan.document.files import read_text
from tsplan.errors import Finding, InputError, nearest

_FORMAT = re.compile(r"^format: tsplan-(\w+)/", re.MULTILINE)
_SENTENCE = re.compile(r"(.+?[^.])\.(?=\s+[A-Z0-9]|$)")
_PACKAGE = Path(__file__).parents[1]
_PLACES = (_PACKAGE / "environments", _PACKAGE.parent / "environments")
"""Where examples are: in the installed package, or beside it in a checkout."""


@dataclass(frozen=True, order=True)
class Example:
    """A shipped file: its `kind` (mission, signals, sweep or map), and what it says of itself."""

    kind: str
    name: str
    path: Path
    words: str


def examples() -> tuple[Example, ...]:
    """All shipped examples, maps last; none where the package came without them."""
    order = ("mission", "signals", "sweep", "map")
    return tuple(sorted(_found(), key=lambda item: (order.index(item.kind), item.name)))


def example(name: str) -> Example:
    """The example of a name; InputError with the nearest where there is none."""
    known = {item.name: item for item in examples()}
    if name not in known:
        remedy = nearest(name, known) or "'tsplan examples' lists them"
        raise InputError([Finding(f"there is no example '{name}'", remedy)])
    return known[name]


def files_of_example(item: Example) -> dict[Path, bytes]:
    """What a copy of an example has: its file and those that it names, each by its place there."""
    paths = sorted({item.path, *_named(item.path)})
    folder = Path(commonpath([path.parent for path in paths]))
    return {path.relative_to(folder): path.read_bytes() for path in paths}


def place_of(item: Example) -> Path:
    """Where the file of an example is in its copy."""
    paths = [item.path, *_named(item.path)]
    return item.path.relative_to(commonpath([path.parent for path in paths]))


@cache
def _found() -> tuple[Example, ...]:
    folder = next((place for place in _PLACES if place.is_dir()), None)
    paths = sorted(folder.rglob("*.yaml")) if folder else []
    return tuple(_read(path) for path in paths)


def _read(path: Path) -> Example:
    text = read_text(path, most=LARGEST_FILE)
    kind = _FORMAT.search(text)
    return Example(kind[1] if kind else "map", path.stem, path, _first_sentence(text))


def _first_sentence(text: str) -> str:
    """What the comment at the top begins with."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# ").rstrip())
    comment = " ".join(lines)
    sentence = _SENTENCE.match(comment)
    return sentence[1] if sentence else comment


def _named(path: Path) -> Iterator[Path]:
    """The files that a file names, and those that they name."""
    data: Any = read_document(path).data
    for key in ("map", "mission"):
        given = data.get(key)
        given = given.get("file") if isinstance(given, dict) else given
        if isinstance(given, str):
            other = (path.parent / given).resolve()
            yield other
            yield from _named(other)
