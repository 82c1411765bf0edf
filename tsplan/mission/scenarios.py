"""Scenarios of the MovingAI benchmarks: where robots on a grid map start and where they go.

The columns are those of https://movingai.com/benchmarks/formats.html: bucket, map, width, height of
the map, column and row of the start, column and row of the goal, and the length of a shortest way
of which diagonal moves are a part. The first line names the version.
"""

from __future__ import annotations

import math
import pathlib
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tsplan.document.document import LARGEST_FILE
from tsplan.document.files import read_text
from tsplan.document.flow_style import flow, word
from tsplan.errors import Finding, InputError, MissionError
from tsplan.mission.vocabulary import FORMAT
from tsplan.ts import TransitionSystem
from tsplan.ts.builders import cell_name
from tsplan.ts.io.tsplan_yaml import map_to_yaml
from tsplan.ts.reachability import shortest_durations

_COLUMNS = 9
_VERSION = "version"


class Way(NamedTuple):
    """Where a robot starts, and where it has to go."""

    start: str
    goal: str


def read_scenario(path: pathlib.Path, system: TransitionSystem, robots: int) -> tuple[Way, ...]:
    """The first ways of a scenario, on a grid map that was read before.

    Raises
    ------
    MissionError
        The file cannot be read, or everything that is wrong with those lines.

    """
    try:
        lines = read_text(path, most=LARGEST_FILE).splitlines()
    except InputError as error:
        raise MissionError(error.findings) from None
    findings: list[Finding] = []
    ways: list[Way] = []
    first = next(iter(lines), "")
    if not first.startswith(_VERSION) or first.split()[1:] not in (["1"], ["1.0"]):
        what = "this is no scenario of version 1"
        findings.append(Finding(what, "its first line is 'version 1'", str(path), 1, 1))
    rows = [(number, line) for number, line in enumerate(lines[1:], start=2) if line.strip()]
    if len(rows) < robots and not findings:
        what = f"the scenario has {len(rows)} robots, and {robots} are asked for"
        findings.append(Finding(what, f"ask for at most {len(rows)}", str(path)))
    for number, line in rows[:robots]:
        way, complaints = _way(line, system)
        findings += (Finding(*words, str(path), number, 1) for words in complaints)
        ways += [way] if way is not None else []
    starts: dict[str, int] = {}
    for (number, _), way in zip(rows, ways, strict=False):
        if starts.setdefault(way.start, number) != number:
            what = f"two robots start at {way.start}, the first in line {starts[way.start]}"
            findings.append(Finding(what, "ask for fewer robots", str(path), number, 1))
    if findings:
        raise MissionError(findings)
    return tuple(ways)


def _way(line: str, system: TransitionSystem) -> tuple[Way | None, list[tuple[str, str]]]:
    """The way of a line, and what is wrong with it."""
    parts = line.split("\t") if "\t" in line else line.split()
    if len(parts) != _COLUMNS:
        return None, [(f"this line has {len(parts)} columns", f"a robot has {_COLUMNS}")]
    numbers = parts[4:8]
    if not all(part.isascii() and part.isdigit() for part in numbers):
        return None, [("a place is no pair of whole numbers", "write column and row, from 0 on")]
    ends = [
        cell_name(int(numbers[place + 1]), int(numbers[place])) for place in (0, 2)
    ]  # the file has the column first
    lost = [(f"there is no free cell {name}", "name the map of the scenario") for name in ends]
    faults = [words for name, words in zip(ends, lost, strict=True) if name not in system.states]
    return (None if faults else Way(ends[0], ends[1])), faults


def scenario_mission(system: TransitionSystem, ways: Sequence[Way], *, name: str = "") -> str:
    """The text of a mission in which every robot goes to a goal of its own, and all travel least.

    A robot is a class of its own, so that a formula can name it. The horizon is the longest of
    their shortest ways, and as many steps more as there are robots to make room for. Raises
    MissionError where there is no way.
    """
    number = {name: place for place, name in enumerate(system.states)}
    far = shortest_durations(system, [way.start for way in ways])
    steps = [far[place, number[way.goal]] for place, way in enumerate(ways)]
    lost = [way for way, step in zip(ways, steps, strict=True) if step == math.inf]
    if lost:
        findings = (Finding(f"no way leads from {way.start} to {way.goal}") for way in lost)
        raise MissionError(findings)
    longest = int(max(steps, default=0))
    return "\n".join([*_lines(system, ways, longest + len(ways), name), ""])


def _lines(system: TransitionSystem, ways: Sequence[Way], horizon: int, name: str) -> Iterator[str]:
    yield f"format: {FORMAT}"
    yield f"name: {word(name)}"
    yield "map:"
    yield from (f"  {line}" for line in map_to_yaml(system).splitlines())
    yield "team:"
    for number, way in enumerate(ways, start=1):
        yield f"  - {flow({'class': f'robot{number}', 'count': 1, 'at': way.start})}"
    yield "spec:"
    yield "  language: mtl"
    yield "  formula:"
    for number, way in enumerate(ways, start=1):
        yield f"  - 'F[0,{horizon}] sum({way.goal}, robot{number}) >= 1'"
    yield "objective: [travel]"
