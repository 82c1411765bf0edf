"""The system of a file: signals, dynamics, outputs, limits and regions, of one robot or several."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from math import inf
from typing import Any, TypeVar

from tsplan.document import Document
from tsplan.document.flow_style import short
from tsplan.errors import FormulaError, nearest
from tsplan.mission.findings import Fault, Place
from tsplan.mission.formulas import located
from tsplan.signals.copies import (
    Renaming,
    copied,
    prefixed,
    renamed_limit,
    renamed_terms,
)
from tsplan.signals.integrators import matrices, model_rows
from tsplan.signals.linear_system import Dynamics, Limit, Range, System
from tsplan.signals.region import Region
from tsplan.signals.signal_expressions import Sum, expression, expression_text, limits
from tsplan.signals.signal_schema import DynamicsEntry, SignalFile
from tsplan.signals.system_checks import start_faults, system_faults

T = TypeVar("T")


@dataclass
class SystemDraft:
    """The system of a file while it is read, what is wrong with it, and texts that are."""

    document: Document
    file: SignalFile
    faults: list[Fault] = field(default_factory=list)
    unread: list[Fault] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.base = self._base()
        self.renaming = Renaming(frozenset(self.base.names), tuple(self.file.copies))
        found = system_faults(self.base)
        self.faults += [
            fault
            for fault in found
            if fault.path != ("controls",) or self.document.data.get("dynamics") is None
        ]
        if any(fault.path[0] == "dynamics" for fault in found):
            self.base = replace(self.base, dynamics=None)
        self.system = self._of_all()
        self.regions = self._regions()

    def every(self, name: str) -> tuple[str, ...]:
        """What all robots call what one robot calls by a name; another name as it is."""
        return tuple(prefixed(copy, name) for copy in self.renaming.of([name]))

    def _report(self, path: Place, message: str, remedy: str) -> None:
        self.faults.append(Fault(path, message, remedy))

    def _base(self) -> System:
        """The system of one robot, without outputs and limits."""
        file = self.file
        signals = {name: (one.min, one.max) for name, one in file.signals.items()}
        controls = {name: (one.min, one.max) for name, one in file.controls.items()}
        initial = {name: _range(one.initial) for name, one in file.signals.items() if one.initial}
        base = System(signals, controls, None, initial)
        entry = file.dynamics
        if entry is None:
            return base
        if entry.model is not None:
            return replace(base, dynamics=self._modelled(entry, base))
        if entry.A is None:
            what = "neither matrices nor a model are given"
            self._report(("dynamics",), what, "write 'A', 'B' and 'D', or 'model' and 'axes'")
            return base
        for key in ("axes", "step"):
            if getattr(entry, key) is not None:
                what = f"'{key}' belongs to a model, and matrices are given"
                self._report(("dynamics", key), what, "remove it, or write 'model'")
        rows = entry.B if entry.B is not None else [[] for _ in entry.A]
        d = entry.D if entry.D is not None else [0.0] * len(entry.A)
        if entry.B is None and controls:
            self._report(("dynamics",), "'B' is missing and there are controls", "add 'B: ...'")
            return base
        made = Dynamics(tuple(map(tuple, entry.A)), tuple(map(tuple, rows)), tuple(d))
        return replace(base, dynamics=made)

    def _modelled(self, entry: DynamicsEntry, base: System) -> Dynamics | None:
        """The dynamics of a model, whose signals and controls have to be those of the file."""
        model = entry.model
        assert model is not None
        if entry.A is not None or entry.B is not None:
            what = "both matrices and a model are given"
            self._report(("dynamics",), what, "keep one of them")
            return None
        if entry.axes is None:
            what = f"'axes' is missing, along which the {model} moves"
            self._report(("dynamics",), what, "add 'axes: [x, y]'")
            return None
        rows = model_rows(model, entry.axes, 1.0 if entry.step is None else entry.step)
        wanted = {
            "signals": tuple(rows[0]),
            "controls": tuple(f"u{axis}" for axis in entry.axes),
        }
        complete = len(set(entry.axes)) == len(entry.axes)
        if not complete:
            self._report(("dynamics", "axes"), "an axis is named twice", "name each once")
        for key, names in wanted.items():
            there = getattr(base, key)
            about = f"the {model} of {', '.join(entry.axes)} has the {key} {', '.join(names)}"
            for name in names:
                if name not in there:
                    complete = False
                    self._report((key,), f"{about}, and '{name}' is missing", f"add '{name}'")
            for name in there:
                if name not in names:
                    complete = False
                    self._report((key, name), f"{about}, not '{name}'", "remove it")
        d = entry.D or ()
        return matrices(rows, (*base.signals,), (*base.controls,), d) if complete else None

    def _of_all(self) -> System:
        """The system of every robot, with outputs and limits."""
        system, file = self.base, self.file
        if file.copies:
            starts = {
                copy: {name: _range(given) for name, given in one.initial.items()}
                for copy, one in file.copies.items()
            }
            for copy, begins in starts.items():
                for fault in start_faults(replace(self.base, initial=begins)):
                    at = ("copies", copy, "initial", fault.path[1])
                    self.faults.append(replace(fault, path=at))
            system = copied(self.base, starts)
        self.names = system.names
        outputs: dict[str, Sum] = {}
        for name, text in file.outputs.items():
            path: Place = ("outputs", name)
            terms, constant = self._read(path, text, expression) or ((), 0.0)
            copies = self._copies(path, text, (signal for signal, _ in terms))
            if not copies:  # whoever names it needs no finding
                copies, terms = ("", *file.copies), ()
            for copy in copies:
                own = renamed_terms(terms, partial(prefixed, copy))
                outputs[prefixed(copy, name)] = own, constant
        found: list[Limit] = []
        for number, text in enumerate(file.limits):
            path = ("limits", number)
            made = self._read(path, text, limits) or ()
            used = [name for limit in made for name in limit.names]
            for copy in self._copies(path, text, used):
                found += [renamed_limit(limit, partial(prefixed, copy)) for limit in made]
        whole = replace(system, outputs=outputs, limits=tuple(found))
        self.faults += [fault for fault in system_faults(whole) if fault.path[0] == "outputs"]
        return whole

    def _read(self, path: Place, text: str, reader: Callable[[str], T]) -> T | None:
        """What a text of the file means; None if it is wrong."""
        try:
            return reader(text)
        except FormulaError as error:
            self.unread += [
                Fault(path, item.message, item.remedy, at=(item.source, item.line, item.column))
                for item in located(error.findings, self.document, path)
            ]
            return None

    def _copies(self, path: Place, text: str, used: Iterable[str]) -> tuple[str, ...]:
        """The robots for which something is there that uses some names; none if they are wrong."""
        names = tuple(dict.fromkeys(used))
        wrong = () if self.renaming.shared(names) else [n for n in names if n not in self.names]
        for name in wrong:
            what = f"there is no signal or control '{name}'"
            at = self.document.character(path, max(text.find(name), 0)) if text else None
            spot = None if at is None else (self.document.source, *at)
            known = {*self.names, *self.base.names}
            self.faults.append(Fault(path, what, nearest(name, known), at=spot))
        return () if wrong else self.renaming.of(names)

    def _regions(self) -> dict[str, Region]:
        """The regions, along signals of every robot or of several together.

        Some region stands for one that is wrong, so that whoever names it needs no finding.
        """
        given = self.document.data.get("regions")
        regions = dict.fromkeys(
            given if isinstance(given, dict) else (),
            Region(**{next(iter(self.base.names)): (0, 0)}),
        )
        for name, sides in self.file.regions.items():
            axes = {axis: _range(ends) for axis, ends in sides.items()}
            try:
                region = Region(**axes)
            except ValueError as error:
                remedy = "write a region as {x: [0, 1], y: [2, 3]}"
                self.unread.append(Fault(("regions", name), f"{name}: {error}", remedy))
                continue
            if self._copies(("regions", name), "", axes):
                regions[name] = region
        return regions


def _range(ends: list[float]) -> Range:
    low, high = ends
    return low, high


def system_entry(system: System) -> dict[str, Any]:
    """The entries of a system in a file: those keys of it that say something."""
    start = starts_entry(system.initial)
    signals: dict[str, Any] = {name: _bounds(ends) for name, ends in system.signals.items()}
    for name, begins in start.items():
        low, high = system.signals[name]
        signals[name] = {**_ends(low, high), "initial": begins}
    entry: dict[str, Any] = {"signals": signals}
    if system.controls:
        entry["controls"] = {name: _bounds(ends) for name, ends in system.controls.items()}
    if system.dynamics is not None:
        entry["dynamics"] = dynamics_entry(system.dynamics)
    if system.outputs:
        entry["outputs"] = {name: expression_text(*sum_) for name, sum_ in system.outputs.items()}
    if system.limits:
        entry["limits"] = [str(limit) for limit in system.limits]
    return entry


def starts_entry(starts: Mapping[str, Range]) -> dict[str, Any]:
    """The entries of where signals begin: numbers, or ranges."""
    return {name: _short_range(ends) for name, ends in starts.items()}


def dynamics_entry(dynamics: Dynamics) -> dict[str, Any]:
    """The entry of matrices, without those that are empty or 0."""
    entry: dict[str, Any] = {"A": short(dynamics.a)}
    if any(dynamics.b):
        entry["B"] = short(dynamics.b)
    if any(dynamics.d):
        entry["D"] = short(dynamics.d)
    return entry


def region_entry(region: Region) -> dict[str, Any]:
    """The entry of a region."""
    return {axis: short(ends) for axis, ends in region.axes.items()}


def _bounds(ends: Range) -> Any:
    """The ends of a range, or those of them that there are."""
    there = _ends(*ends)
    return list(there.values()) if len(there) == len(ends) else there


def _ends(low: float, high: float) -> dict[str, Any]:
    both = {"min": low, "max": high}
    return {key: short(float(end)) for key, end in both.items() if end not in (-inf, inf)}


def _short_range(ends: Range) -> Any:
    """A range, or the number that it consists of."""
    low, high = short((float(ends[0]), float(ends[1])))
    return low if low == high else [low, high]
