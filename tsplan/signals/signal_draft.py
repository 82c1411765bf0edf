"""From a document to the parts of a mission over signals, with every finding at its place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, get_args

from tsplan.document import Document
from tsplan.document.kinds import SIGNALS
from tsplan.document.validation import salvaged, validated
from tsplan.errors import MissionError
from tsplan.logic import TRUE, And, Formula, parse_with_places, variables
from tsplan.logic.text_spans import Span, Written
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.filing import Filing
from tsplan.mission.findings import Fault, moved
from tsplan.mission.formula_checks import formula_horizon
from tsplan.mission.formulas import spelled_out
from tsplan.mission.weight_entries import weights_in
from tsplan.signals.aim_entries import DEFAULT, aims_of
from tsplan.signals.aims import Aim
from tsplan.signals.signal_checks import choice_faults, formula_checks
from tsplan.signals.signal_parts import SignalLanguage, SignalParts
from tsplan.signals.signal_schema import STAND_INS, SignalFile
from tsplan.signals.system_entries import SystemDraft

LANGUAGES: tuple[SignalLanguage, ...] = get_args(SignalLanguage)
_NAMING = frozenset({"signals", "controls", "outputs", "copies"})  # what has names for formulas


@dataclass(frozen=True)
class Beside:
    """What no file has: formulas by texts that need not be read, and weights that are functions."""

    formulas: Mapping[str, Formula]
    weights: Mapping[str, Any]


NOTHING = Beside({}, {})


def parts_of_document(document: Document, beside: Beside = NOTHING) -> SignalParts:
    """The parts of a mission over signals from its document.

    Raises MissionError with everything that is wrong.
    """
    strange = document.misfit((), SIGNALS)
    if strange is not None:
        raise MissionError([strange])
    document = spelled_out(document, LANGUAGES[0])
    file, findings = validated(document, SignalFile)
    sound, faulty = (file, frozenset[str]()) if file else salvaged(document, SignalFile, STAND_INS)
    draft = _Draft.of(document, findings, languages=LANGUAGES, default=LANGUAGES[0])
    system = None if sound is None else SystemDraft(document, sound)
    known = None if sound is None or "spec" in faulty else sound.spec.weights
    weights = {**weights_in(document, known), **beside.weights}
    draft.formulas.reading = _Reader(beside, weights, system)
    draft.formulas.read()
    if sound is None or system is None:
        raise MissionError(draft.in_order())
    parts = draft.judged(sound, system, faulty)
    draft.judge_weights(weights)
    if draft.serious:
        raise MissionError(draft.in_order())
    return replace(parts, warnings=tuple(draft.warnings))


@dataclass
class _Reader:
    """Reads the texts of formulas with the weights, regions and outputs of a file."""

    beside: Beside
    weights: Mapping[str, Any]
    system: SystemDraft | None

    def __call__(self, text: str, language: Any) -> tuple[Formula, Written]:
        outputs = {} if self.system is None else self.system.system.outputs
        formula = self.beside.formulas.get(text)
        if formula is not None and outputs.keys().isdisjoint(variables(formula)):
            return formula, Written(formula, Span(0, len(text)))
        regions = {} if self.system is None else self.system.regions
        return parse_with_places(
            text, language, weights=self.weights, regions=regions, definitions=outputs
        )


@dataclass
class _Draft(Filing):
    """A mission over signals while it is read."""

    def judged(self, file: SignalFile, system: SystemDraft, faulty: frozenset[str]) -> SignalParts:
        """The parts as far as they are known; what does not fit together is filed."""
        named = not faulty & _NAMING
        faults = [*system.unread, *(system.faults if named else ())]
        aims = aims_of(DEFAULT if file.objective is None else file.objective)
        faults += aims.faults
        own = [formula_horizon(formula, "closed") or 0 for _, formula in self.formulas.all()]
        formula = self.formulas.formula
        parts = SignalParts(
            system=system.system,
            formula=TRUE if formula is None else formula,
            horizon=max(own, default=0) if file.horizon is None else file.horizon,
            objective=tuple(_for_all(aim, system) for aim in aims.aims),
            weighting=file.spec.weighting,
            weights=file.spec.weights,
            satisfaction=aims.order,
            prefer=self.preferences(file.spec.prefer),
            regions=system.regions,
            parts=tuple(self._joined()),
            copies=tuple(file.copies),
            language=file.spec.language,
            text=self.formulas.text,
            name=file.name,
            solver=SolverChoice(**(file.solver.model_dump() if file.solver else {})),
            digest=self.document.digest,
            parse_seconds=self.formulas.seconds,
            origin=self.document,
        )
        if not aims.faults:
            faults += choice_faults(parts, named=named)
        if named:
            for where, wanted in self.formulas.all():
                optional = parts.satisfaction is not None or where != self.formulas.where
                found = formula_checks(wanted, parts, optional=optional, sound=not faults)
                faults += moved(found, where)
        for fault in faults:
            self.file(self._shifted(fault))
        return parts

    def _shifted(self, fault: Fault) -> Fault:
        """A fault of an objective at its name, which a single sum has in no list."""
        if fault.path[:1] != ("objective",) or "objective" not in self.document.data:
            return fault
        single = isinstance(self.document.data["objective"], dict)
        path = ("objective", *fault.path[2:]) if single else fault.path
        return replace(fault, at=(self.document.source, *self.document.key_place(path)))

    def _joined(self) -> Iterator[tuple[str, Formula]]:
        """The texts of what the formula joins at its top, with their formulas."""
        texts = [text for text in self.formulas.texts if text.of == self.formulas.where]
        for text, written in ((one.text, one.written) for one in texts):
            if len(texts) == 1 and isinstance(written.formula, And) and written.children:
                for part in written.children:
                    yield text[part.span.begin : part.span.end], part.formula
            else:
                yield text.strip(), written.formula


def _for_all(aim: Aim, system: SystemDraft) -> Aim:
    """An objective whose efforts of one robot's signals are those of every robot."""
    efforts = {
        term: {own: factor for name, factor in factors.items() for own in system.every(name)}
        for term, factors in aim.efforts.items()
    }
    return Aim(aim.weights, efforts)
