"""Modular robots in mission files: their entries, as they are read and as they are written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from tsplan.document import Document
from tsplan.mission.amount_entries import amounts_entry, carries_entry, shortest
from tsplan.mission.configurations import (
    Configuration,
    ModuleRules,
    Reconfiguration,
    counted_parts,
)
from tsplan.mission.findings import Place
from tsplan.mission.mission_schema import MissionFile, ReconfigurationEntry


def module_rules(file: MissionFile, document: Document) -> ModuleRules:
    """What modular robots can become by a mission file, whose document has names as written."""
    shapes = tuple(
        Configuration(
            name,
            entry.modules,
            frozenset(_words(document, entry.capabilities, ("configurations", name))),
            float(entry.cost),
            float(entry.duration),
            entry.carries,
        )
        for name, entry in file.configurations.items()
    )
    rules = tuple(
        _reconfiguration(document, entry, ("reconfigure", number), shapes)
        for number, entry in enumerate(file.reconfigure)
    )
    worth = tuple((label, tuple(each.items())) for label, each in file.performance.items())
    return ModuleRules(shapes, rules, worth)


def _words(document: Document, names: Iterable[str], path: Place) -> Iterator[str]:
    key = "at" if path[0] == "reconfigure" else "capabilities"
    return (document.text((*path, key, n)) or name for n, name in enumerate(names))


def _reconfiguration(
    document: Document, entry: ReconfigurationEntry, path: Place, shapes: Iterable[Configuration]
) -> Reconfiguration:
    def side(key: str, counts: Mapping[str, int]) -> Mapping[str, int] | str:
        if isinstance(document.at((*path, key)), dict):
            return counts
        return document.text((*path, key)) or next(iter(counts))

    modules = {shape.name: shape.modules for shape in shapes}
    parts, made = side("from", entry.parts), side("to", entry.made)
    return Reconfiguration(
        counted_parts(parts, made, modules),
        counted_parts(made, parts, modules),
        entry.duration,
        float(entry.cost),
        tuple(_words(document, entry.at, path)),
    )


def configuration_entry(shape: Configuration) -> dict[str, Any]:
    """The entry of a configuration."""
    entry: dict[str, Any] = {"modules": shape.modules}
    if shape.capabilities:
        entry["capabilities"] = sorted(shape.capabilities)
    factors = {"cost": shape.cost, "duration": shape.duration}
    factors = {key: shortest(factor) for key, factor in factors.items() if factor != 1}
    return {**entry, **factors, **carries_entry(shape.carries)}


def reconfiguration_entry(rule: Reconfiguration) -> dict[str, Any]:
    """The entry of a reconfiguration, with the number of structures of each configuration."""
    entry: dict[str, Any] = {
        "from": dict(rule.parts),
        "to": dict(rule.made),
        "duration": rule.duration,
    }
    if rule.cost:
        entry["cost"] = shortest(rule.cost)
    return {**entry, "at": list(rule.at)} if rule.at else entry


def module_entries(rules: ModuleRules) -> dict[str, Any]:
    """The keys of a mission file about modular robots."""
    entries = {
        "configurations": {s.name: configuration_entry(s) for s in rules.configurations},
        "reconfigure": [reconfiguration_entry(rule) for rule in rules.reconfigurations],
        "performance": {label: amounts_entry(worth) for label, worth in rules.performance},
    }
    return {key: value for key, value in entries.items() if value}
