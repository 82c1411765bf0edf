"""A mission with some of its values changed, as texts that can be read anywhere."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from hashlib import sha256
from pathlib import Path as FilePath
from typing import Any

from tsplan.document import Document, Path, parse_document
from tsplan.document.document import LARGEST_FILE
from tsplan.document.files import beside, read_text
from tsplan.document.kinds import MAP, kind_of_data
from tsplan.document.patchwork import Patchwork
from tsplan.errors import InputError, MissionError
from tsplan.exact_json import canonical
from tsplan.signals.result_check import AnyMission
from tsplan.signals.signal_files import any_mission_from_document
from tsplan.ts.io.map_files import map_document_of
from tsplan.ts.io.map_settings import is_reference


@dataclass(frozen=True, slots=True)
class FileText:
    """A file as it was read."""

    source: str
    text: str

    @classmethod
    def read(cls, path: FilePath) -> FileText:
        """A file. Raises InputError where it cannot be read."""
        return cls(str(path), read_text(path, most=LARGEST_FILE))

    @property
    def digest(self) -> str:
        """The SHA-256 of the text."""
        return _digest(self.text)

    @property
    def document(self) -> Document:
        """The document that it holds; InputError where that is none."""
        return _parsed(self.text, self.source)


@dataclass(frozen=True, slots=True)
class Edit:
    """What takes the place of the value at a path of a mission: what a sweep has at another."""

    path: Path
    value: Path


@dataclass(frozen=True, slots=True)
class Variant:
    """The mission of a file, or the one at the path `inside` it, with the edits of a sweep.

    A map that the mission names is a part of it, so that paths lead into it and a worker on another
    machine need not have it, but for maps of other programs; it is None where its file cannot be
    read.
    """

    base: FileText
    inside: Path = ()
    edits: tuple[Edit, ...] = ()
    sweep: FileText | None = None
    map_file: FileText | None = None

    def named_map(self, name: Any) -> FileText | None:
        """The file of a map, by its name in the mission; None where it is none or broken."""
        name = name["file"] if is_reference(name) else name
        if not isinstance(name, str):
            return None
        try:
            found = FileText.read(beside(FilePath(self.base.source).parent, name))
            _ = map_document_of(found.text, found.source)
        except InputError:
            return None  # whoever reads the mission says what is wrong with it
        return found

    @property
    def as_it_stands(self) -> bool:
        """Whether the mission is a file of its own, and nothing in it is changed."""
        return not self.edits and not self.inside

    @property
    def patchwork(self) -> Patchwork:
        """The document of the mission, put together. Raises InputError for no YAML."""
        made = _with_map(self.base, self.inside, self._part_of_it)
        # by its digest a plan finds the file
        digest = self.base.digest if self.as_it_stands else _digest(self.content)
        for edit in sorted(self.edits, key=lambda edit: len(edit.path)):
            if edit.path != ("map",) or self._part_of_it is None:
                made = self._edited(made, edit)
        return replace(made, document=replace(made.document, digest=digest))

    @property
    def _part_of_it(self) -> FileText | None:
        """The map that becomes a part of the mission: one in steps, that is only named there."""
        if self.map_file is None:
            return None
        given = self.base.document.at(self.inside).get("map")
        for edit in self.edits:
            if edit.path == ("map",) and self.sweep is not None:
                given = self.sweep.document.at(edit.value)
        if not isinstance(given, str):
            return None
        try:
            return self.map_file if kind_of_data(self.map_file.document.data) == MAP else None
        except InputError:  # no YAML: a map of another program
            return None

    def _edited(self, made: Patchwork, edit: Edit) -> Patchwork:
        assert self.sweep is not None, "edits are those of a sweep"
        sweep = self.sweep.document
        try:
            return made.with_part(edit.path, sweep, edit.value)
        except KeyError:
            text = ".".join(map(str, edit.path))
            what = f"'{text}' names nothing in the mission with what else is varied"
            remedy = "list those runs that go together, as 'runs'"
            raise InputError([sweep.finding(edit.value, what, remedy)]) from None

    @property
    def mission(self) -> AnyMission:
        """The mission. Raises MissionError with all findings, each at its place in its own file."""
        try:
            made = self.patchwork
        except InputError as error:
            raise MissionError(error.findings) from None
        try:
            return any_mission_from_document(made.document, FilePath(self.base.source).parent)
        except MissionError as error:
            raise MissionError(made.placed(error.findings)) from None

    @property
    def content(self) -> str:
        """All that the mission is read from, apart from where it stands, in one text."""
        texts = [self.base.digest if not self.inside else _part(self.base, self.inside)]
        texts += [self.map_file.digest] if self.map_file is not None else []
        edits = {
            canonical(edit.path): self.sweep.document.at(edit.value)
            for edit in self.edits
            if self.sweep is not None
        }
        return canonical([texts, edits])


@lru_cache(maxsize=4)
def _with_map(base: FileText, inside: Path, map_file: FileText | None) -> Patchwork:
    """A mission with its map in it; the same for many runs. Nothing changes its nodes."""
    made = Patchwork.of(base.document, inside)
    return made if map_file is None else made.with_part(("map",), map_file.document, ())


@lru_cache(maxsize=8)
def _part(file: FileText, inside: Path) -> str:
    return canonical(file.document.at(inside))


@lru_cache(maxsize=8)
def _parsed(text: str, source: str) -> Document:
    """A document; the same few are read again and again. Nothing changes their nodes."""
    return parse_document(text, source)


@lru_cache(maxsize=8)
def _digest(text: str) -> str:
    return sha256(text.encode("utf-8", "surrogatepass")).hexdigest()
