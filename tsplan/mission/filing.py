"""What is wrong with a file while it is read: every finding at its place, warnings apart."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Self

from tsplan.document import Document
from tsplan.errors import Finding
from tsplan.mission.findings import Fault, Place, preferred
from tsplan.mission.formulas import Formulas
from tsplan.mission.mission_parts import Preference
from tsplan.mission.mission_schema import SoftFormula
from tsplan.mission.start_entries import start_path
from tsplan.mission.vocabulary import WHO


@dataclass
class Filing:
    """A document, its formulas as far as they can be read, and what is wrong so far."""

    document: Document
    findings: list[Finding]
    formulas: Formulas
    warnings: list[Finding] = field(default_factory=list)
    known: set[Finding] = field(default_factory=set)  # those that were faults

    @classmethod
    def of(cls, document: Document, findings: Iterable[Finding], **how: Any) -> Self:
        """Begin with what the schema finds; `how` the formulas are read."""
        noted = list(findings)
        return cls(document, noted, Formulas(document, noted, **how))

    def word(self, value: str, path: Place) -> str:
        """A name as it is written: `01` is no number here."""
        return self.document.text(path) or value

    def preferences(self, entries: Iterable[SoftFormula]) -> tuple[Preference, ...]:
        """The preferences whose formulas could be read."""
        made = []
        for number, entry in enumerate(entries):
            read = self.formulas.soft.get(number)
            if read is not None:
                name = self.word(entry.name, preferred(number, "name")) if entry.name else ""
                weight = Fraction(str(entry.weight))
                made.append(Preference(*read, weight, name, entry.level, entry.partial))
        return tuple(made)

    def judge_weights(self, given: Iterable[str]) -> None:
        """Weights that no formula names (a warning)."""
        unused = set(given) - self.formulas.weight_names if self.formulas.complete else ()
        for name in sorted(unused):
            what = f"no operator of the formula has the weights '{name}'"
            remedy = f"write ^{name} after an operator, or remove them"
            self.file(Fault(("spec", "weights", name), what, remedy, serious=False))

    def report(self, path: Place, message: str, remedy: str) -> None:
        """File what is wrong at a path."""
        self.file(Fault(path, message, remedy))

    def file(self, fault: Fault) -> None:
        """Turn a fault into a finding at its place."""
        at = fault.at or (self.document.source, *self.formulas.place(self._found(fault)))
        finding = Finding(fault.message, fault.remedy, *at)
        if finding not in self.known:
            self.known.add(finding)
            self.findings.append(finding)
            if not fault.serious:
                self.warnings.append(finding)

    def _found(self, fault: Fault) -> Fault:
        """A fault of a start that is one of a list, at its place in that."""
        if "at" not in fault.path[:-1] or fault.path[0] not in WHO:
            return fault
        place = fault.path.index("at") + 1
        try:
            given = self.document.at(fault.path[:place])
        except KeyError:
            return fault
        return replace(fault, path=(*fault.path[:place], *start_path(given, fault.path[place])))

    @property
    def serious(self) -> bool:
        """Whether anything was found that forbids planning."""
        return len(self.findings) > len(self.warnings)

    def in_order(self) -> list[Finding]:
        """All findings, those of other files first, then by their place."""
        own = self.document.source
        return sorted(self.findings, key=lambda f: (f.source == own, f.line or 0, f.column or 0))
