"""Missions from Python values: they are written down as a mission file and read like one.

So the checks, their words and the defaults are those of files, and nothing is said twice.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from numbers import Integral, Real
from pathlib import Path
from typing import Any, TypeVar

from tsplan.document import Document, parse_document
from tsplan.errors import Finding, InputError, MissionError
from tsplan.logic.weight_values import Weight
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.configurations import Configuration, Reconfiguration
from tsplan.mission.mission_draft import Beside, parts_from_document
from tsplan.mission.mission_parts import MissionParts, Preference
from tsplan.mission.mission_writer import (
    group_entry,
    preference_entry,
    read_formula,
    resource_entry,
    solver_entry,
    written_formula,
)
from tsplan.mission.module_entries import configuration_entry, reconfiguration_entry
from tsplan.mission.resources import Resource
from tsplan.mission.team import Group
from tsplan.mission.vocabulary import FORMAT
from tsplan.mission.weight_entries import entries_of
from tsplan.ts import TransitionSystem
from tsplan.ts.builders import map_of_graph
from tsplan.ts.io.tsplan_yaml import map_to_yaml

T = TypeVar("T")
_SOURCE = "mission"


def parts_from_values(values: Mapping[str, Any]) -> MissionParts:
    """The parts of a mission from the keys of a mission file, whose parts may be Python objects.

    Raises MissionError; its findings name no lines, since there is no file.
    """
    given = values["map"]
    if hasattr(given, "is_directed") and hasattr(given, "nodes"):  # a graph of networkx
        given = map_of_graph(given)
    if not isinstance(given, TransitionSystem | str | Path | Mapping):
        what = f"the map is a value of type '{type(given).__name__}'"
        remedy = "give a TransitionSystem, a networkx graph or the path of a map file"
        raise MissionError([Finding(what, remedy)])
    system = given if isinstance(given, TransitionSystem) else None
    weights = values["spec"].get("weights") or {}
    others, functions = entries_of(weights)
    written = {
        "format": FORMAT,
        **{key: value for key, value in values.items() if value is not None},
        "spec": {**values["spec"], **({"weights": others} if others else {})},
        "map": map_to_yaml(system) if system is not None else _named(given),
    }
    made = from_values(
        written,
        _entry(values["spec"]["language"], weights),
        lambda document: parts_from_document(document, Path(), Beside(system, functions)),
    )
    return replace(made, origin=None)  # nobody has seen that document


def _named(given: Any) -> Any:
    """The name of a map file, or a mapping as a mission file has it."""
    return given if isinstance(given, Mapping) else str(given)


def from_values(
    written: Mapping[str, Any],
    entry: Callable[[Any], Any],
    read: Callable[[Document], T],
) -> T:
    """What is read from the document that values write; `entry` is that of a Python object.

    Raises MissionError; its findings name no lines, since there is no file.
    """
    try:
        return read(parse_document(_text(written, entry), _SOURCE))
    except InputError as error:
        raise MissionError(_without_lines(finding) for finding in error.findings) from None


def _text(written: Mapping[str, Any], entry: Callable[[Any], Any]) -> str:
    """The document that values write."""
    try:
        return json.dumps(written, default=entry)
    except InputError:
        raise
    except ValueError:  # as Python writes no number that is so long
        raise MissionError([Finding("a number has thousands of digits", "drop digits")]) from None


def _entry(language: Any, weights: Mapping[str, Weight]) -> Any:
    """What a file has in place of Python objects: numpy's numbers, sets, groups, formulas, ..."""

    def entry(value: Any) -> Any:
        if isinstance(value, Group):
            return group_entry(value)
        if isinstance(value, Resource):
            return resource_entry(value)
        if isinstance(value, Configuration):
            return configuration_entry(value)
        if isinstance(value, Reconfiguration):
            return reconfiguration_entry(value)
        if isinstance(value, Preference):
            read = partial(read_formula, language=language, weights=weights)
            text = written_formula(value.formula, value.text, read)
            return preference_entry(value, text)
        return common_entry(value)

    return entry


def common_entry(value: Any) -> Any:
    """What a file of any mission has in place of numbers, sets, formulas and choices of Python."""
    if isinstance(value, SolverChoice):
        return solver_entry(value)
    if isinstance(value, Integral | Real):
        return int(value) if isinstance(value, Integral) else float(value)
    return sorted(value) if isinstance(value, set | frozenset) else str(value)


def _without_lines(finding: Finding) -> Finding:
    if finding.source != _SOURCE:
        return finding
    return replace(finding, line=None, column=None)
