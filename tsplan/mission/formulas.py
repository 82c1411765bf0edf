"""The formulas of a mission file, read with the place of every part."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, TypeAlias

from tsplan.document import Document
from tsplan.document.yaml_nodes import Node
from tsplan.errors import MOST_TOLD, Finding, InputError
from tsplan.logic import TRUE, Formula, conjunction, parse_with_places, walk
from tsplan.logic.text_spans import Way, Written
from tsplan.mission.findings import FORMULA, Fault, Place, preferred
from tsplan.mission.vocabulary import LANGUAGES


class Text(NamedTuple):
    """A text in the file, and the formula that is written there: one, or one in a list, `of` it."""

    of: Place
    path: Place
    text: str
    written: Written

    def find(self, node: Formula, way: Way) -> int | None:
        """Where a part is written first, and what a way leads to in it: inside of quotes."""
        for here in self.written.occurrences():
            if here.formula is node or (here.stands_for and node in set(walk(here.formula))):
                begin = (here.get(way) or here.span).begin
                return begin + (self.text[begin] == '"')
        return None


Reading: TypeAlias = Callable[[str, Any], tuple[Formula, Written]]
"""How a text is read in a language: the formula, and where its parts stand."""


def spelled_out(document: Document, language: str) -> Document:
    """The document with a formula alone under `spec` as a spec in full.

    A text or a list of texts stands for `{formula: ..., language: ...}`, with the language that
    missions of this kind have by default. The parts keep their places.
    """
    root = document.root
    node = root.children.get("spec") if isinstance(root.children, dict) else None
    if node is None or not isinstance(node.value, str | list | bool) or not node.value:
        return document
    word = Node(language, node.line, node.column, node.start, node.start, text=language)
    parts = {"formula": node, "language": word}
    spec = replace(
        node, value={key: part.value for key, part in parts.items()}, text=None, children=parts
    )
    assert isinstance(root.children, dict)
    made = replace(
        root, value={**root.value, "spec": spec.value}, children={**root.children, "spec": spec}
    )
    return replace(document, data=made.value, root=made)


def located(findings: Iterable[Finding], document: Document, path: Place) -> Iterator[Finding]:
    """Findings of the text at a path, at their places in the file.

    Finding a place takes time with the length of the text, so only so many are found as are
    told; the others stand where the text begins.
    """
    for number, item in enumerate(findings):
        place = document.place(path)
        if number < MOST_TOLD:
            place = document.inside(path, item.line or 1, item.column or 1)
        yield replace(item, source=document.source, line=place[0], column=place[1])


@dataclass
class Formulas:
    """The formula that must hold and those that are preferred, as far as they can be read.

    What is wrong with them goes to `findings`. They are read by `reading` in one of `languages`,
    the `default` one where the file names none.
    """

    document: Document
    findings: list[Finding]
    languages: Sequence[str] = LANGUAGES
    default: str = ""
    reading: Reading = parse_with_places
    formula: Formula | None = None
    text: str = ""
    where: Place = FORMULA
    soft: dict[int, tuple[Formula, str] | None] = field(default_factory=dict)
    texts: list[Text] = field(default_factory=list)
    seconds: float = 0.0

    def read(self) -> None:
        """Read every formula of the file, and say how long that took."""
        began = time.perf_counter()
        self._read()
        self.seconds = time.perf_counter() - began

    def _read(self) -> None:
        spec = self.document.data.get("spec") if isinstance(self.document.data, dict) else None
        if not isinstance(spec, dict):
            return
        prefer = spec.get("prefer")
        entries = prefer if isinstance(prefer, list) else []
        for number, entry in enumerate(entries):
            if isinstance(entry, dict) and "formula" in entry:
                self.soft[number] = self._formula_at(preferred(number))
        if "formula" in spec and "must" in spec:
            what = "the formula is there twice, as 'formula' and as 'must'"
            self._report(("spec", "must"), what, "keep one of them")
        self.where = ("spec", "must") if "must" in spec else FORMULA
        if self.where[-1] in spec:
            read = self._formula_at(self.where)
            self.formula, self.text = (None, "") if read is None else read
        elif entries:
            self.formula, self.text = TRUE, "true"
        else:
            self._report(("spec",), "'formula' is missing", "add 'formula: ...'")

    def all(self) -> Iterator[tuple[Place, Formula]]:
        """Every formula that could be read, with its place in the file."""
        if self.formula is not None:
            yield self.where, self.formula
        for number, read in self.soft.items():
            if read is not None:
                yield preferred(number), read[0]

    @property
    def complete(self) -> bool:
        """Whether every formula of the file could be read."""
        return self.formula is not None and None not in self.soft.values()

    @property
    def weight_names(self) -> frozenset[str]:
        """The names of weights that are written in any of them."""
        return frozenset().union(*(text.written.weight_names for text in self.texts))

    def place(self, fault: Fault) -> tuple[int | None, int | None]:
        """Line and column of what is wrong in the mission, or in a part of a formula."""
        if fault.node is not None and len(self.findings) <= MOST_TOLD:  # nobody is told more
            for text in self.texts:
                begin = text.find(fault.node, fault.way) if text.of == fault.path else None
                if begin is not None:
                    return self.document.character(text.path, begin)
        return self.document.place(fault.path)

    def _report(self, path: Place, message: str, remedy: str) -> None:
        self.findings.append(self.document.finding(path, message, remedy))

    def _formula_at(self, where: Place) -> tuple[Formula, str] | None:
        """A formula and its text; a list of texts means their conjunction."""
        given = self.document.at(where)
        entries = given if isinstance(given, list) else [given]
        paths: list[Place] = [
            (*where, n) if isinstance(given, list) else where for n in range(len(entries))
        ]
        if not entries:
            self._report(where, "the list of formulas is empty", "write true for no demand")
            return None
        texts = [self._text(entry, path) for entry, path in zip(entries, paths, strict=True)]
        parsed = [
            self._parsed(text, path, where)
            for text, path in zip(texts, paths, strict=True)
            if text is not None
        ]
        formulas = [formula for formula in parsed if formula is not None]
        if len(formulas) < len(entries):
            return None
        known = [text for text in texts if text is not None]
        text = known[0] if len(known) == 1 else " && ".join(f"({text})" for text in known)
        return conjunction(formulas), text

    def _text(self, value: Any, path: Place) -> str | None:
        if isinstance(value, bool):
            return "true" if value else "false"
        if isinstance(value, str):
            return value
        self._report(path, "the formula is not a text", "write it in quotes or after a bar |")
        return None

    def _parsed(self, text: str, path: Place, where: Place) -> Formula | None:
        language = str(self.document.data["spec"].get("language", self.default))
        if language not in self.languages:
            return None  # an unknown language is the schema's finding
        try:
            formula, written = self.reading(text, language)
        except InputError as error:
            self.findings += located(error.findings, self.document, path)
            self.findings += self.document.cut(path)
            return None
        if self.document.loses_end(path):
            self.findings += self.document.cut(path)
            return None
        self.texts.append(Text(where, path, text, written))
        return formula
