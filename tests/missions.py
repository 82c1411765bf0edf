"""Small missions as files, and what is found wrong with them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tsplan.errors import InputError
from tsplan.mission import Mission, load_mission

MAP = "waiting: true\nstates: {p: {labels: [A]}, q: {labels: [B]}}\nedges: [[p, q, 1], [q, p, 1]]\n"
MISSION = """\
format: tsplan-mission/1
name: there and back
map: map.yaml
team: [{class: a, count: 2, at: p, capabilities: [see]}]
spec: {language: mtl, formula: "F[0,3] sum(B, see) >= 2 && F[4,6] sum(A) >= 2"}
objective: [travel]
"""
FILES = {"map.yaml": MAP, "mission.yaml": MISSION}


def read(folder: Path, text: str) -> Mission:
    """The mission of a text that is written to a file of a folder."""
    (folder / "mission.yaml").write_text(text)
    return load_mission(folder / "mission.yaml")


def wrong_in(folder: Path, text: str) -> list[str]:
    """Everything wrong with the mission of a text in a folder, as `line:column: words`."""
    own = str(folder / "mission.yaml")
    return [line.replace(own + ":", "") for line in findings(read, folder, text)]


def findings(reader: Callable[..., object], *given: object) -> list[str]:
    """Everything that an input is refused for, one line each."""
    with pytest.raises(InputError) as caught:
        reader(*given)
    return [str(item) for item in caught.value.findings]
