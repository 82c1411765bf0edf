"""`tsplan map`: convert a map of another program, and say what that leaves out."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import refuse_place
from tsplan.cli.output import attempted, say, say_json
from tsplan.document.files import write_whole
from tsplan.errors import Finding, InputError, MapError, told
from tsplan.mission.scenarios import read_scenario, scenario_mission
from tsplan.ts.edges import DEFAULT
from tsplan.ts.io.map_files import format_of, map_document, map_from_document
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.io.tsplan_yaml import map_to_yaml
from tsplan.ts.map_lint import lint
from tsplan.words import many

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterable

    from tsplan.ts import TransitionSystem

_LISTED = 8  # labels that are named


@dataclass(frozen=True)
class _Report:
    """What became of a file."""

    source: str
    form: str
    system: TransitionSystem
    odd: tuple[Finding, ...]

    @property
    def durations(self) -> tuple[int, int] | None:
        """The fewest and the most steps of a move, None where there is none."""
        steps = [
            each
            for edge in self.system.edges.values()
            if not edge.is_wait
            for each in (
                [edge.duration] if isinstance(edge.duration, int) else edge.duration.values()
            )
        ]
        return (min(steps), max(steps)) if steps else None

    @property
    def levels(self) -> list[str]:
        """The levels of the map, each once."""
        states = self.system.states.values()
        return list(dict.fromkeys(s.level for s in states if s.level is not None))

    def lines(self) -> Iterable[str]:
        """The report for people."""
        system = self.system
        sizes = f"{many(len(system.states), 'state')}, {many(len(system.edges), 'edge')}"
        yield f"{self.source}: read as {self.form}, {sizes}"
        if system.step_seconds is not None:
            yield f"  a step takes {system.step_seconds:g} s"
        if self.durations is not None:
            least, most = self.durations
            both = many(most, "step") if least == most else f"{least} to {most} steps"
            yield f"  moves take {both}"
        if len(self.levels) > 1:
            yield f"  levels: {', '.join(self.levels)}"
        if system.zones:
            rooms = (f"{name} (at most {most})" for name, most in system.zones.items())
            yield f"  zones: {', '.join(rooms)}"
        if system.labels:
            shown = [f"{name} ({len(states)})" for name, states in system.labels.items()]
            more = f" and {len(shown) - _LISTED} more" if len(shown) > _LISTED else ""
            yield f"  labels: {', '.join(shown[:_LISTED])}{more}"
        for words, findings in (("dropped or chosen:", system.notes), ("looks odd:", self.odd)):
            if findings:
                yield words
                yield from (f"  {line}" for line in told(findings))

    def to_json(self) -> str:
        """The report for programs."""
        system = self.system
        report: dict[str, Any] = {
            "format": "tsplan-map-report/1",
            "file": self.source,
            "read_as": self.form,
            "states": len(system.states),
            "edges": len(system.edges),
            "step_seconds": system.step_seconds,
            "durations": self.durations,
            "levels": self.levels,
            "zones": dict(system.zones),
            "labels": {name: len(states) for name, states in system.labels.items()},
            "notes": [_entry(note) for note in system.notes],
            "odd": [_entry(finding) for finding in self.odd],
        }
        return json.dumps(report, ensure_ascii=False) + "\n"


def _entry(finding: Finding) -> dict[str, Any]:
    return {
        "message": finding.message,
        "remedy": finding.remedy,
        "file": finding.source,
        "line": finding.line,
        "column": finding.column,
    }


def run(options: argparse.Namespace) -> Exit:
    """Convert a map, write it or a mission on it, and print what was dropped and what looks odd."""
    inputs = [options.file, options.scenario]
    refuse_place(options.output, "the map", inputs)
    if (options.scenario is None) != (options.robots is None):
        raise InputError([Finding("--scenario and --robots need each other", "give both")])
    document = _document(options)
    settings = _settings(options)
    system = map_from_document(document, (), settings)
    odd = (replace(finding, source=str(options.file)) for finding in lint(system))
    report = _Report(str(options.file), format_of(document).name, system, tuple(odd))
    unwritten = None
    if options.output is not None:
        text = _mission(options, report) if options.scenario else map_to_yaml(system)
        unwritten = attempted(lambda: write_whole(options.output, text.encode(), MapError))
    if options.json:
        say_json(report.to_json())
    else:
        for line in report.lines():
            say(line)
    if unwritten is not None:
        raise unwritten
    return Exit.DONE


def _document(options: argparse.Namespace) -> Any:
    try:
        return map_document(options.file)
    except InputError as error:
        raise MapError(error.findings) from None


def _mission(options: argparse.Namespace, report: _Report) -> str:
    """The mission of a scenario, with the map in it."""
    ways = read_scenario(options.scenario, report.system, options.robots)
    return scenario_mission(report.system, ways, name=options.file.stem)


def _settings(options: argparse.Namespace) -> MapSettings:
    """What the options say of reading the map."""
    speeds = dict(options.speed)
    speed = speeds.pop("", None)
    if speeds and speed is not None:
        speeds[DEFAULT] = speed

    def locate(path: tuple[str | int, ...], message: str, remedy: str) -> Finding:
        return Finding(message, remedy, f"--{path[0]}")

    return MapSettings(
        step=options.step,
        speed=speeds or speed,
        cell=options.cell,
        capacity=options.capacity,
        locate=locate,
    )
