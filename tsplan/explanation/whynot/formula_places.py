"""Where the parts of a mission's formula stand: in the mission file, or in the formula's text."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from tsplan.explanation.explanation import Place
from tsplan.explanation.whynot.occurrences import Leaf, Way
from tsplan.logic import parse_with_places

if TYPE_CHECKING:
    from tsplan.logic.text_spans import Span, Written
    from tsplan.mission import Mission

Path: TypeAlias = "tuple[str | int, ...]"


class Source(NamedTuple):
    """One text of a formula: its way below the root, its path in the file, and its parts."""

    below: Way
    path: Path | None
    text: str
    written: Written

    def stretch(self, way: Way) -> Span | None:
        """The text of the sub-formula at the end of a way."""
        return self.written.get(way)

    def pair(self, leaf: Leaf) -> Span | None:
        """The text of a leaf: of one need of a task or limit, or of the sub-formula itself."""
        return self.written.get(leaf.way if leaf.pair is None else (*leaf.way, "needs", leaf.pair))

    def interval(self, way: Way) -> Span | None:
        """The text of the interval of the operator at the end of a way, brackets included."""
        return self.written.get((*way, "interval"))


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
        if self._document is None or source.path is None:
            before = source.text[:offset]
            return before.count("\n") + 1, offset - (before.rfind("\n") + 1) + 1
        return self._document.character(source.path, offset)

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
        formula, written = parse_with_places(text, mission.language)
        if formula is not expected[number]:
            return []  # the mission was changed after it was read
        below = () if len(entries) == 1 else (number,)
        found.append(Source(below, place, text, written))
    return found


def _entries(given: object, path: Path) -> list[tuple[Path | None, str]]:
    """Path and text of a formula, or of each of a list."""
    if isinstance(given, list):
        return [((*path, number), _text(entry)) for number, entry in enumerate(given)]
    return [(path, _text(given))]


def _text(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)
