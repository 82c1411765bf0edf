"""Missions over signals as files: what is written is read as the same mission."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from tsplan.document.files import write_whole
from tsplan.document.flow_style import flow, word
from tsplan.errors import MissionError
from tsplan.logic import Formula
from tsplan.mission.mission_writer import solver_entry, spec_lines
from tsplan.mission.weight_entries import entries_of
from tsplan.signals.aim_entries import aim_entry
from tsplan.signals.copies import Single, renamed_limit, renamed_terms
from tsplan.signals.signal_parts import SignalParts
from tsplan.signals.signal_schema import FORMAT
from tsplan.signals.system_entries import region_entry, starts_entry, system_entry


def signals_to_yaml(mission: SignalParts) -> str:
    """The text of a file."""
    return "".join(f"{line}\n" for line in _lines(mission))


def save_signals(mission: SignalParts, path: Path) -> None:
    """Write a mission to a file, at once or not at all."""
    write_whole(path, signals_to_yaml(mission).encode(), MissionError)


def _lines(mission: SignalParts) -> Iterator[str]:
    yield f"format: {FORMAT}"
    if mission.name:
        yield f"name: {word(mission.name)}"
    for key, entry in _parts(mission).items():
        if isinstance(entry, dict):
            yield f"{key}:"
            yield from (f"  {word(name)}: {flow(part)}" for name, part in entry.items())
        else:
            yield f"{key}: {flow(entry)}"

    def read(text: str) -> Formula:
        return mission.parsed(text)[0]

    yield from spec_lines(mission.language, (mission.formula, mission.text), mission.prefer, read)
    if mission.weights:
        yield f"  weights: {flow(entries_of(mission.weights)[0])}"
    if mission.weighting != "product":
        yield f"  weighting: {mission.weighting}"
    yield f"objective: {flow([aim_entry(aim, mission.satisfaction) for aim in mission.objective])}"
    yield f"horizon: {mission.horizon}"
    if solver := solver_entry(mission.solver):
        yield f"solver: {flow(solver)}"


def _parts(mission: SignalParts) -> dict[str, Any]:
    """The entries of the system and its regions; what several robots share is said once."""
    system = mission.system
    copies = {}
    if mission.copies:
        single = Single.of(system, mission.copies)
        copies = {
            copy: {"initial": starts_entry(single.starts(copy, system))} for copy in mission.copies
        }
        outputs = single.said_once(
            system.outputs.items(), lambda sum_, call: (renamed_terms(sum_[0], call), sum_[1])
        )
        limits = single.said_once((("", limit) for limit in system.limits), renamed_limit)
        system = replace(
            single.system, outputs=dict(outputs), limits=tuple(limit for _, limit in limits)
        )
    made = system_entry(system)
    if mission.regions:
        made["regions"] = {name: region_entry(one) for name, one in mission.regions.items()}
    if copies:
        made["copies"] = copies
    return made
