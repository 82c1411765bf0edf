"""A small mission of modular robots, as a file and with other entries."""

from __future__ import annotations

from tsplan import Mission
from tsplan.mission import mission_from_text

TEXT = """\
format: tsplan-mission/1
name: fence
map:
  waiting: true
  states:
    dock: {labels: [dock]}
    lane: {}
    wall: {labels: [wall]}
    yard: {labels: [yard]}
  edges:
    - {from: dock, to: lane, duration: 2, both_ways: true}
    - {from: lane, to: wall, duration: 1, both_ways: true}
    - {from: lane, to: yard, duration: 1, both_ways: true}
configurations:
  single: {modules: 1, capabilities: [look]}
  line:   {modules: 3, capabilities: [lift], cost: 2.0, duration: 1.5}
  ring:   {modules: 4, capabilities: [lift, drill]}
reconfigure:
  - {from: single, to: line, duration: 2, cost: 3.0, at: [dock]}
  - {from: line, to: single, duration: 1, cost: 1.0}
  - {from: {line: 1, single: 1}, to: {ring: 1}, duration: 3, cost: 4.0}
team:
  - {class: module, count: 5, at: dock, configuration: single}
spec:
  language: catl
  formula: "F[0,12] T(2, wall, {(lift,1)}) && F[0,12] T(1, yard, {(look,1)})"
objective: [energy, travel]
"""
ASKED = '"F[0,12] T(2, wall, {(lift,1)}) && F[0,12] T(1, yard, {(look,1)})"'


def fence_text(**changes: str) -> str:
    """The mission's file with other values of some keys (empty: none), or another `formula`."""
    text = TEXT
    if (formula := changes.pop("formula", None)) is not None:
        text = text.replace(ASKED, f'"{formula}"')
    lines = text.splitlines()
    for key, value in changes.items():
        first = next((n for n, line in enumerate(lines) if line.startswith(f"{key}:")), len(lines))
        last = first + 1
        while last < len(lines) and lines[last].startswith(" "):
            last += 1
        lines[first:last] = [f"{key}: {value}"] if value else []
    return "\n".join([*lines, ""])


def fence(**changes: str) -> Mission:
    """The mission of such a file."""
    return mission_from_text(fence_text(**changes))
