"""Where the parts of a mission's formula stand: in the mission file, or in the formula's text."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from tsplan.explanation.explanation import Place
from tsplan.explanation.whynot.occurrences import Leaf, Way
from tsplan.logic import parse_with_places

if TYPE_CHECKING:
    from tsplan.logic import Formula
    from tsplan.mission import Mission

Path: TypeAlias = "tuple[str | int, ...]"
Ranges: TypeAlias = "tuple[tuple[int, int, int, int], ...]"

_PAIR = re.compile(r'\(\s*(?:"(?:\\.|[^"\\])*"|[^\W\d]\w*)\s*,\s*[^(),\s]+\s*\)')
_INTERVAL = re.compile(r"\[[^\[\]]*\]")


class Stretch(NamedTuple):
    """Characters `begin` up to before `end` of a text."""

    begin: int
    end: int


@dataclass(frozen=True)
class Source:
    """One text of a formula: its way below the root, its path in the file, and its parts."""

    below: Way
    path: Path | None
    text: str
    formula: Formula
    places: Mapping[Formula, Ranges]

    @cached_property
    def _lines(self) -> list[int]:
        starts = [0]
        for line in self.text.split("\n"):
            starts.append(starts[-1] + len(line) + 1)
        return starts

    def stretch(self, way: Way) -> Stretch | None:
        """The text of the sub-formula at the end of a way; None where it cannot be told."""
        node, here = self.formula, Stretch(0, len(self.text))
        for step in way:
            found = self._child(node, here, step)
            if found is None:
                return None
            node, here = node.children[step], found
        return here if way else self._own(node, here)

    def _own(self, node: Formula, here: Stretch) -> Stretch:
        """The whole text without what surrounds its formula."""
        return next(iter(self._inside(node, here)), here)

    def _child(self, node: Formula, here: Stretch, number: int) -> Stretch | None:
        """The text of one child: children follow each other in the order of the text."""
        for child in node.children[: number + 1]:
            found = next(iter(self._inside(child, here)), None)
            if found is None:
                return None
            here = Stretch(found.end, here.end)
        return found

    def _inside(self, node: Formula, here: Stretch) -> list[Stretch]:
        starts = self._lines
        found = [
            Stretch(starts[line - 1] + column - 1, starts[last - 1] + end - 1)
            for line, column, last, end in self.places.get(node, ())
        ]
        return [item for item in found if here.begin <= item.begin and item.end <= here.end]

    def pair(self, leaf: Leaf) -> Stretch | None:
        """The text of a leaf: of one need of a task or limit, or of the sub-formula itself."""
        whole = self.stretch(leaf.way)
        if whole is None or leaf.pair is None:
            return whole
        begin = self.text.find("{", whole.begin, whole.end)
        pairs = list(_PAIR.finditer(self.text, begin, whole.end))
        if begin < 0 or leaf.pair >= len(pairs):
            return whole
        return Stretch(*pairs[leaf.pair].span())

    def interval(self, way: Way) -> Stretch | None:
        """The text of the interval of the operator at the end of a way, brackets included."""
        whole = self.stretch(way)
        if whole is None:
            return None
        begin, node = whole.begin, self.formula
        for step in way:
            node = node.children[step]
        if len(node.children) > 1:  # the interval stands between the two sides
            left = self.stretch((*way, 0))
            begin = whole.begin if left is None else left.end
        found = _INTERVAL.search(self.text, begin, whole.end)
        return None if found is None else Stretch(*found.span())

    def line_and_column(self, offset: int) -> tuple[int, int]:
        """Line and column of a character of the text, both from 1."""
        before = self.text[:offset]
        return before.count("\n") + 1, offset - (before.rfind("\n") + 1) + 1


class Sources:
    """The texts of a mission's formula, with the places of all its parts."""

    def __init__(self, mission: Mission) -> None:
        self._document = mission.origin
        self.texts = tuple(_sources(mission))

    def of(self, way: Way) -> tuple[Source, Way] | None:
        """The text that a way leads into, and the rest of the way; None for the joint root."""
        for source in self.texts:
            if way[: len(source.below)] == source.below:
                return source, way[len(source.below) :]
        return None

    def place(self, leaf: Leaf) -> Place:
        """Where a leaf stands."""
        found = self.of(leaf.way)
        if found is None:
            return self._begin()
        source, way = found
        stretch = source.pair(Leaf(way, leaf.pair))
        if stretch is None:
            return self._begin()
        first = self.in_file(source, stretch.begin)
        line, column = self.in_file(source, max(stretch.end - 1, stretch.begin))
        return Place(*first, line, column + 1)

    def in_file(self, source: Source, offset: int) -> tuple[int, int]:
        """Line and column in the mission file of a character of one of the texts."""
        place = source.line_and_column(offset)
        if self._document is None or source.path is None:
            return place
        return self._document.inside(source.path, *place)

    def _begin(self) -> Place:
        """The whole formula."""
        if self._document is None:
            return Place(1, 1)
        return Place(*self._document.place(formula_path(self._document.data)))

    def at(self, path: Path) -> Place:
        """The place of another entry of the mission file; no place without a file."""
        return Place() if self._document is None else Place(*self._document.place(path))


def formula_path(data: object) -> Path:
    """Where a mission file keeps what must hold."""
    spec = data.get("spec") if isinstance(data, dict) else None
    word = "must" if isinstance(spec, dict) and "formula" not in spec else "formula"
    return ("spec", word)


def _sources(mission: Mission) -> list[Source]:
    """The texts as the file has them; nothing where they do not say the mission's formula."""
    entries: list[tuple[Path | None, str]] = [(None, mission.text)]
    if mission.origin is not None:
        path = formula_path(mission.origin.data)
        entries = _entries(mission.origin.at(path), path)
    if len(entries) == 1:
        expected = [mission.formula]
    elif len(entries) == len(mission.formula.children):
        expected = list(mission.formula.children)
    else:
        return []
    found = []
    for number, (place, text) in enumerate(entries):
        formula, places = parse_with_places(text, mission.language)
        if formula is not expected[number]:
            return []  # the mission was changed after it was read
        below = () if len(entries) == 1 else (number,)
        found.append(Source(below, place, text, formula, places))
    return found


def _entries(given: object, path: Path) -> list[tuple[Path | None, str]]:
    """Path and text of a formula, or of each of a list."""
    if isinstance(given, list):
        return [((*path, number), _text(entry)) for number, entry in enumerate(given)]
    return [(path, _text(given))]


def _text(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)
