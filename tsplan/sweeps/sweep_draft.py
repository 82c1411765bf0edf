"""From a sweep file to its runs, with everything that is wrong with it at its place."""

from __future__ import annotations

import math
import pathlib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Any

from tsplan.document import Document, Path, validated
from tsplan.document.files import beside
from tsplan.document.kinds import MISSION, SIGNALS, SWEEP, kind_of_data
from tsplan.document.validation import salvaged
from tsplan.errors import Finding, InputError, in_order
from tsplan.exact_json import canonical
from tsplan.sweeps.axis_entries import AxisReader
from tsplan.sweeps.mission_variant import FileText, Variant
from tsplan.sweeps.sweep_runs import Setting, SweepRun
from tsplan.sweeps.sweep_schema import STAND_INS, SweepFile
from tsplan.ts.io.map_settings import is_reference

MOST_RUNS = 100_000
"""Runs of a sweep; a misprint must not fill the memory."""


def load_sweep(path: str | pathlib.Path) -> tuple[SweepRun, ...]:
    """The runs of a sweep file, in the order of its axes: the first one changes last.

    Raises InputError with everything that is wrong with it, and with the files that it names. What
    is wrong with the mission of one run is found out when that is run.
    """
    file = FileText.read(pathlib.Path(path))
    document = file.document
    strange = document.misfit((), SWEEP)
    if strange is not None:
        raise InputError([strange])
    read, findings = validated(document, SweepFile)
    sound, faulty = (read, frozenset[str]()) if read else salvaged(document, SweepFile, STAND_INS)
    if sound is None:
        raise InputError(in_order(findings))
    draft = _Draft(document, file, sound, faulty, findings)
    runs = draft.runs()
    if draft.findings:
        raise InputError(in_order(draft.findings))
    return runs


@dataclass
class _Draft:
    """A sweep while it is read: what is wrong so far, and the map files that were read."""

    document: Document
    file: FileText
    read: SweepFile
    faulty: frozenset[str]  # keys of which the schema has said what is wrong
    findings: list[Finding] = field(default_factory=list)
    maps: dict[str, FileText | None] = field(default_factory=dict)

    def runs(self) -> tuple[SweepRun, ...]:
        """All runs; none where something is wrong."""
        variant = self._variant()
        if variant is not None:
            variant = self._with_map(variant)
        base = None if variant is None else variant.patchwork.document
        reader = AxisReader(self.document, base, self.findings)
        parts = self._parts(reader)
        count = math.prod(map(len, parts))
        if count > MOST_RUNS and not self.findings:
            self._refuse((), f"{count:,} runs are more than {MOST_RUNS:,}", "drop some values")
        if variant is None or self.findings:
            return ()
        combined = (sum(choice, ()) for choice in product(*parts))
        return tuple(self._run(settings, variant) for settings in combined)

    def _run(self, settings: Sequence[Setting], variant: Variant) -> SweepRun:
        """A run, whose map is the one that its edits name."""
        for setting in settings:
            if setting.edit is not None and setting.edit.path == ("map",):
                found = self._map(variant, self.document.at(setting.edit.value))
                variant = replace(variant, map_file=found)
        return SweepRun.of(settings, replace(variant, sweep=self.file))

    def _parts(self, reader: AxisReader) -> list[list[tuple[Setting, ...]]]:
        """What is combined each with each: the values of axes or the listed runs, and repeats."""
        parts: list[list[tuple[Setting, ...]]] = []
        axes, listed = self.read.axes, self.read.runs
        if axes is not None and listed is not None:
            what = "the runs are there twice, as 'axes' and as 'runs'"
            self.findings.append(self.document.key_finding(("runs",), what, "keep one of them"))
        elif listed is not None:
            entries = [reader.listed(run, ("runs", n)) for n, run in enumerate(listed)]
            self._refuse_alike(("runs",), entries)
            parts.append(entries)
        elif axes is not None:
            for path, settings in reader.axes(axes):
                values: list[tuple[Setting, ...]] = [(setting,) for setting in settings]
                self._refuse_alike(path, values)
                parts.append(values)
        times = self.read.repeat
        if times > MOST_RUNS:
            self._refuse(("repeat",), f"{times:,} runs are more than {MOST_RUNS:,}", "use fewer")
        elif times > 1:
            parts.append([(Setting("repeat", number),) for number in range(1, times + 1)])
        if not parts and not self.findings:
            remedy = "add one, as in 'axes: {seeds: [1, 2, 3]}', or 'repeat: 3'"
            self._refuse(("axes",), "no axis is named, so there is nothing to vary", remedy)
        return parts

    def _variant(self) -> Variant | None:
        """The mission without any edit, and without its map."""
        given = self.read.mission
        if "mission" in self.faulty:
            return None
        if isinstance(given, dict):
            return Variant(self.file, ("mission",))
        if not isinstance(given, str):
            what = "the mission is neither a file name nor a mission"
            self._refuse(("mission",), what, "write the name of a mission file")
            return None
        try:
            return Variant(FileText.read(beside(self._folder, given)))
        except InputError as error:
            why = error.findings[0]
            self._refuse(("mission",), f"mission '{given}': {why.message}", why.remedy)
            return None

    @property
    def _folder(self) -> pathlib.Path:
        return pathlib.Path(self.file.source).parent

    def _with_map(self, variant: Variant) -> Variant | None:
        """The mission with its map; None where it is no mission or its map is none."""
        try:
            made = variant.patchwork
        except InputError as error:
            self.findings += error.findings
            return None
        kind = kind_of_data(made.document.data)
        if kind not in (MISSION, SIGNALS):
            fallback = made.document.finding((), "this is no mission", "name a mission file")
            self.findings.append(made.document.misfit((), MISSION) or fallback)
            return None
        named = made.document.data.get("map")
        if isinstance(named, str) and self._map(variant, named) is None:
            what = f"the map '{named}' cannot be read"
            self.findings.append(made.document.finding(("map",), what, "correct it first"))
            return None
        return replace(variant, map_file=self._map(variant, named))

    def _map(self, variant: Variant, name: Any) -> FileText | None:
        """The map of a name, read once."""
        name = name["file"] if is_reference(name) else name
        if isinstance(name, str) and name not in self.maps:
            self.maps[name] = variant.named_map(name)
        return self.maps.get(name) if isinstance(name, str) else None

    def _refuse_alike(self, path: Path, entries: Iterable[Sequence[Setting]]) -> None:
        """Report what would be run, or called, as something before it."""
        first: dict[str, int | None] = {}
        for number, settings in enumerate(entries):
            alike = canonical({setting.column: setting.shown for setting in settings})
            below = self.document.at(path)
            place = (*path, number if isinstance(below, list) else list(below)[number])
            if alike in first:
                what = f"this makes the same runs as line {first[alike]} does"
                self._refuse(place, what, "leave one out, or use 'repeat' for several of a kind")
            first.setdefault(alike, self.document.place(place)[0])

    def _refuse(self, path: Path, what: str, remedy: str) -> None:
        self.findings.append(self.document.finding(path, what, remedy))
