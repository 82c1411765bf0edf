"""`tsplan lint`: what looks odd in a map or a mission."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.output import say
from tsplan.document.kinds import MISSION, SIGNALS, kind_of_data
from tsplan.mission import Mission
from tsplan.signals.signal_files import load_any_mission
from tsplan.ts.io.map_files import load_map, map_document
from tsplan.ts.map_lint import lint
from tsplan.words import many

if TYPE_CHECKING:
    import argparse
    from collections.abc import Sequence
    from pathlib import Path

    from tsplan.errors import Finding


def run(options: argparse.Namespace) -> Exit:
    """Print one line for everything that looks odd."""
    findings, size = _judged(options.file)
    for finding in findings:
        placed = finding if finding.source else replace(finding, source=str(options.file))
        say(str(placed))
    if findings:
        return Exit.REFUSED
    say(f"{size}, nothing looks odd")
    return Exit.DONE


def _judged(path: Path) -> tuple[Sequence[Finding], str]:
    """What looks odd in a file, and how large what it holds is."""
    if kind_of_data(map_document(path).data) not in (MISSION, SIGNALS):
        system = load_map(path)
        notes = [note for note in system.notes if note.remedy]
        return [*lint(system), *notes], f"{len(system.states)} states, {len(system.edges)} edges"
    mission = load_any_mission(path)
    if isinstance(mission, Mission):
        own = many(mission.size, "agent")
    else:
        parts = mission.system.signals, mission.system.controls
        own = f"{many(len(parts[0]), 'signal')}, {many(len(parts[1]), 'control')}"
    return mission.warnings, f"{own}, horizon {mission.horizon}"
