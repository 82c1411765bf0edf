"""A corpus: missions whose answers are known, in a folder with one table of them.

The table is a file `expected.yaml` of the format `tsplan-corpus/1`. It names mission files by
their paths from the folder, the status that planning ends with, and the value of each objective:

    format: tsplan-corpus/1
    missions:
      there.yaml: {status: optimal, values: {travel: 2}}
      large.yaml: {status: optimal, values: {splits: 1, travel: 40}, long: true}
      nowhere.yaml: {status: infeasible}

`null` is the value of an availability without an end. An entry that says `long: true` is only
planned where that is asked for. Missions over signals stand beside those of teams.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from tsplan.document import read_document
from tsplan.document.fields import Number, Truth
from tsplan.document.validation import validated
from tsplan.errors import Finding, InputError, nearest
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.run.planner import plan
from tsplan.signals.signal_files import load_any_mission
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.synthesiser import synthesise_mission
from tsplan.signals.trajectory import Trajectory
from tsplan.words import number

TABLE = "expected.yaml"
TOLERANCE = 1e-6
"""How far a value may be from what is expected: exact values by the floats that say them, values of
trajectories by what solvers forgive."""


class _Entry(BaseModel):
    model_config = ConfigDict(extra="forbid")
    status: Literal["optimal", "infeasible"]
    values: Mapping[str, Number | None] = {}
    long: Truth = False


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid")
    format: Literal["tsplan-corpus/1"]
    missions: Annotated[Mapping[str, _Entry], Field(min_length=1)]


@dataclass(frozen=True)
class Expectation:
    """What planning one mission is to answer: its status, and the value of each objective."""

    path: Path
    status: str
    values: Mapping[str, float | None]
    long: bool = False
    """Whether planning it takes so long that it is only done where that is asked for."""

    @property
    def name(self) -> str:
        """The name of the mission's file without its ending."""
        return self.path.stem

    def differences(self, made: Plan | Trajectory) -> tuple[Finding, ...]:
        """Everything in which a plan or trajectory is not what was expected."""
        said = {item.name: item.value for item in made.objective}
        if made.status != self.status:
            wrong = [f"planning ended with '{made.status}' instead of '{self.status}'"]
        elif list(said) != list(self.values):
            wrong = [f"its objectives are {list(said)} instead of {list(self.values)}"]
        else:
            unproven = made.status != "infeasible" and not made.verified
            wrong = ["the plan is not verified"] if unproven else []
            wrong += [
                f"'{name}' is {number(said[name])} instead of {number(value)}"
                for name, value in self.values.items()
                if not _same(said[name], value)
            ]
        return tuple(Finding(words, "", str(self.path)) for words in wrong)


def _same(value: float | None, expected: float | None) -> bool:
    if value is None or expected is None:
        return value is expected
    return abs(value - expected) <= TOLERANCE


def expectations(folder: str | Path) -> tuple[Expectation, ...]:
    """The table of a corpus, in its order. Raises InputError with everything wrong with it."""
    document = read_document(Path(folder) / TABLE)
    table, findings = validated(document, _Table)
    if table is None:
        raise InputError(findings)
    made = [
        Expectation(Path(folder) / path, entry.status, entry.values, entry.long)
        for path, entry in table.missions.items()
    ]
    missing = [
        document.key_finding(("missions", path), f"there is no file '{path}'", "check the path")
        for path, item in zip(table.missions, made, strict=True)
        if not item.path.is_file()
    ]
    if missing:
        raise InputError(missing)
    return tuple(made)


def planned(mission: Mission | SignalMission) -> Plan | Trajectory:
    """The plan of a mission, or the trajectory of one over signals."""
    return synthesise_mission(mission) if isinstance(mission, SignalMission) else plan(mission)


def run_corpus(
    folder: str | Path,
    *,
    names: Iterable[str] | None = None,
    long: bool = False,
    planner: Callable[[Any], Plan | Trajectory] = planned,
) -> tuple[Finding, ...]:
    r"""Plan the missions of a corpus: everything in which their plans are not what is expected.

    `names` chooses some by the names of their files, otherwise `long` says whether those that take
    long are planned as well. A `planner` gives the plan of a mission. Raises InputError for names
    that the table has not, and for whatever cannot be read.

    >>> entry = "mission.yaml: {status: optimal, values: {%s}}"
    >>> table = "format: tsplan-corpus/1\nmissions:\n  " + entry
    >>> _ = Path("expected.yaml").write_text(table % "travel: 2")
    >>> run_corpus(".")
    ()
    >>> _ = Path("expected.yaml").write_text(table % "travel: 1")
    >>> print(*run_corpus("."))
    mission.yaml: 'travel' is 2 instead of 1
    """
    known = {item.name: item for item in expectations(folder)}
    if names is None:
        chosen = [item for item in known.values() if long or not item.long]
    else:
        wanted = list(names)
        unknown = [name for name in wanted if name not in known]
        if unknown:
            source = str(Path(folder) / TABLE)
            raise InputError(
                Finding(f"there is no mission '{name}'", nearest(name, known), source)
                for name in unknown
            )
        chosen = [known[name] for name in wanted]
    return tuple(
        finding
        for item in chosen
        for finding in item.differences(planner(load_any_mission(item.path)))
    )
