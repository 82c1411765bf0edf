"""Where the parts of a mission's formula stand: in the mission file, or in the formula's text.

Others ask for the `text`, the `place` or the `span` of an occurrence, and for nothing else.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from tsplan.explanation.explanation import Place
from tsplan.explanation.whynot.occurrences import Occurrence, counts_of, node_at
from tsplan.logic import parse_with_places
from tsplan.logic.text_spans import Span
from tsplan.mission import Mission

if TYPE_CHECKING:
    from tsplan.document import Path
    from tsplan.logic import Formula
    from tsplan.logic.text_spans import Way, Written
    from tsplan.signals.result_check import AnyMission


class _Text(NamedTuple):
    """One text of a formula: its way below the root, its path in the file, and its parts."""

    below: Way
    path: Path | None
    text: str
    written: Written


class Sources:
    """The texts of a mission's formula, with the places of all its parts."""

    def __init__(self, mission: AnyMission) -> None:
        self._document = mission.origin
        self._formula = mission.formula
        self._texts = tuple(_texts(mission))

    def text(self, part: Occurrence) -> str | None:
        """What is written of a part of the formula; None where that cannot be told."""
        found = self._found(self._way_of(part))
        return None if found is None else found[0].text[slice(*found[1])]

    def place(self, part: Occurrence) -> Place:
        """Where a part stands; the whole formula where that cannot be told."""
        way = self._way_of(part)
        # what is said of a region is one text, whatever it consists of
        ways = (way[:length] for length in range(len(way), 0, -1))
        found = next((found for above in ways if (found := self._found(above))), self._found(()))
        if found is not None:
            source, (begin, end) = found
            line, column = self._in_file(source, max(end - 1, begin))
            return Place(*self._in_file(source, begin), line, column + 1)
        if self._document is None:
            return Place(1, 1)
        return self.at(formula_path(self._document.data))

    def span(self, way: Way) -> Span | None:
        """The characters of the file that say what a way leads to (see `text_spans.Written`)."""
        found = self._found(way)
        if found is None or self._document is None:
            return None
        source, (begin, end) = found
        lines = self._document.content.split("\n")

        def offset(at: int) -> int:
            line, column = self._in_file(source, at)
            return sum(len(text) + 1 for text in lines[: line - 1]) + column - 1

        return Span(offset(begin), offset(end - 1) + 1)

    def at(self, path: Path) -> Place:
        """The place of another entry of the mission file; no place without a file."""
        return Place() if self._document is None else Place(*self._document.place(path))

    def _way_of(self, part: Occurrence) -> Way:
        if part.need is None:
            return part.way
        counted = len(counts_of(node_at(self._formula, part.way)))
        if part.need < counted:
            return (*part.way, "needs", part.need)
        return (*part.way, "resources", part.need - counted)

    def _found(self, way: Way) -> tuple[_Text, Span] | None:
        """The text that a way leads into, and the characters there; None for the joint root."""
        for source in self._texts:
            length = len(source.below)
            if way[:length] == source.below:
                span = source.written.get(way[length:])
                return None if span is None else (source, span)
        return None

    def _in_file(self, source: _Text, offset: int) -> tuple[int, int]:
        """Line and column in the mission file of a character of one of the texts, from 1."""
        if self._document is None or source.path is None:
            before = source.text[:offset]
            return before.count("\n") + 1, offset - before.rfind("\n")
        return self._document.character(source.path, offset)


def formula_path(data: object) -> Path:
    """Where a mission file keeps what must hold."""
    spec = data.get("spec") if isinstance(data, dict) else None
    word = "must" if isinstance(spec, dict) and "formula" not in spec else "formula"
    return ("spec", word)


def _parsed(mission: AnyMission, text: str) -> tuple[Formula, Written]:
    """A text of the mission as it is read, with what it may name."""
    if isinstance(mission, Mission):
        return parse_with_places(text, mission.language, weights=mission.weights)
    return mission.parsed(text)


def _texts(mission: AnyMission) -> Iterator[_Text]:
    """The texts as the file has them; nothing where they do not say the mission's formula."""
    entries: list[tuple[Path | None, object]] = [(None, mission.text)]
    if mission.origin is not None:
        path = formula_path(mission.origin.data)
        given = mission.origin.at(path)
        entries = [(path, given)]
        if isinstance(given, list):
            entries = [((*path, number), entry) for number, entry in enumerate(given)]
    alone = len(entries) == 1
    expected = (mission.formula,) if alone else mission.formula.children
    found = []
    for number, (place, entry) in enumerate(entries):
        text = str(entry).lower() if isinstance(entry, bool) else str(entry)
        formula, written = _parsed(mission, text)
        if len(entries) != len(expected) or formula is not expected[number]:
            return  # the mission was changed after it was read
        found.append(_Text(() if alone else (number,), place, text, written))
    yield from found
