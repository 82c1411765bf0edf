"""Missions over signals from Python values: written down as a file and read like one.

Formulas and the functions that give weights are handed on beside the file, as they are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from tsplan.errors import Finding, MissionError, nearest
from tsplan.logic import Formula, walk
from tsplan.mission.mission_parts import Preference
from tsplan.mission.mission_writer import preference_entry
from tsplan.mission.values import common_entry, from_values
from tsplan.mission.weight_entries import entries_of, settled
from tsplan.signals.aim_entries import aim_entry
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import Dynamics, System
from tsplan.signals.region import Region
from tsplan.signals.signal_draft import Beside, parts_of_document
from tsplan.signals.signal_parts import SignalParts
from tsplan.signals.signal_schema import FORMAT
from tsplan.signals.system_entries import dynamics_entry, region_entry, system_entry


def parts_of_values(
    values: Mapping[str, Any],
    spec: Mapping[str, Any],
    system: System | None,
    start: Mapping[str, Any],
) -> SignalParts:
    """The parts of a mission from the keys of a file and its spec; None stands for none.

    A `system` says what they do not; signals begin where `start` says. Raises MissionError; its
    findings name no lines, since there is no file.
    """
    given = {key: value for key, value in spec.items() if value is not None}
    weights: dict[str, Any] = given.pop("weights", {})
    plain, functions = entries_of(weights)
    given |= {"weights": plain} if plain else {}
    given.setdefault("language", "wstl" if weights or _weighted(given) else "stl")
    written = {
        "format": FORMAT,
        **({} if system is None else system_entry(system)),
        **{key: value for key, value in values.items() if value is not None},
        "spec": given,
    }
    written["signals"] = _started(written.get("signals", {}), start)
    formulas: dict[str, Formula] = {}

    def entry(value: Any) -> Any:
        if isinstance(value, Formula):
            formulas[str(value)] = value
        return _entry(value)

    beside = Beside(formulas, functions)
    made = from_values(written, entry, lambda document: parts_of_document(document, beside))
    # nobody has seen that document
    return replace(made, origin=None, weights={**made.weights, **settled(functions)})


def _weighted(spec: Mapping[str, Any]) -> bool:
    """Whether some formula that is given as one has weights."""
    listed = [spec.get("formula"), spec.get("must"), *spec.get("prefer", ())]
    formulas = [getattr(one, "formula", one) for one in listed]
    return any(
        getattr(node, "weights", None) is not None
        for formula in formulas
        if isinstance(formula, Formula)
        for node in walk(formula)
    )


def _started(signals: Mapping[str, Any], start: Mapping[str, Any]) -> dict[str, Any]:
    """The entries of signals of which some begin somewhere. Raises MissionError for others."""
    strange = [name for name in start if name not in signals]
    if strange:
        raise MissionError(
            Finding(f"start: there is no signal '{name}'", nearest(name, signals))
            for name in strange
        )
    made = dict(signals)
    for name, begins in start.items():
        ends = made[name]
        entry = dict(ends) if isinstance(ends, Mapping) else {}
        if isinstance(ends, list | tuple):
            entry = dict(zip(("min", "max"), ends, strict=False))
        made[name] = {**entry, "initial": begins}
    return made


_ENTRIES: Mapping[type, Callable[[Any], Any]] = {
    Aim: aim_entry,
    Dynamics: dynamics_entry,
    Region: region_entry,
    Preference: lambda soft: {**preference_entry(soft, ""), "formula": soft.formula},
    Mapping: dict,
    np.ndarray: np.ndarray.tolist,
}


def _entry(value: Any) -> Any:
    """What a file has in place of an object of Python."""
    return next(
        (made(value) for kind, made in _ENTRIES.items() if isinstance(value, kind)),
        common_entry(value),
    )
