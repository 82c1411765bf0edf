"""The runs of a sweep: what each one plans and how, and by what it is known again."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from hashlib import sha256
from typing import Any

from tsplan.errors import MissionError
from tsplan.exact_json import canonical
from tsplan.milp.solver_choice import SolverChoice
from tsplan.signals.result_check import AnyMission
from tsplan.sweeps.mission_variant import Edit, Variant

_ID = 12  # hexadecimal digits: 48 bits, so that no two of many thousands are alike

Axes = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Setting:
    """One value of an axis: what its column shows, and what it means for the run."""

    column: str
    shown: Any
    edit: Edit | None = None
    choice: SolverChoice = field(default_factory=SolverChoice)
    encoding: str | None = None
    without: tuple[str, ...] = ()


@dataclass(frozen=True)
class SweepRun:
    """One run: a mission, what is chosen of the solver, and the values of the axes.

    The `id` follows from the values of the axes, wherever they stand; `content` from all that the
    outcome depends on, but for the versions of the programs.
    """

    axes: Axes
    subject: Variant | AnyMission
    choice: SolverChoice = field(default_factory=SolverChoice)
    encoding: str = "tight"
    without: tuple[str, ...] = ()
    id: str = field(init=False)
    content: str = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "id", _digest(self.axes)[:_ID])
        parts = [_content(self.subject), asdict(self.choice), self.encoding, sorted(self.without)]
        object.__setattr__(self, "content", _digest(parts))

    @property
    def mission(self) -> AnyMission:
        """What is planned; raises MissionError with everything that is wrong with it."""
        return self.subject.mission if isinstance(self.subject, Variant) else self.subject

    def chosen(self, choice: SolverChoice) -> SweepRun:
        """The run with what a caller chooses, whatever the sweep says."""
        return self if choice == SolverChoice() else replace(self, choice=choice.over(self.choice))

    @classmethod
    def of(cls, settings: Sequence[Setting], variant: Variant) -> SweepRun:
        """The run of a value of each axis."""
        edits = tuple(setting.edit for setting in settings if setting.edit is not None)
        choice = SolverChoice()
        for setting in settings:  # a seed of its own axis over that of a solver
            seed = setting.column == "seed"
            choice = setting.choice.over(choice) if seed else choice.over(setting.choice)
        encoding = [setting.encoding for setting in settings if setting.encoding is not None]
        return cls(
            {setting.column: setting.shown for setting in settings},
            replace(variant, edits=edits),
            choice,
            encoding[0] if encoding else "tight",
            tuple(name for setting in settings for name in setting.without),
        )


def columns_of(runs: Iterable[SweepRun]) -> list[str]:
    """The names of all axes of some runs, in the order in which they come."""
    return list(dict.fromkeys(column for run in runs for column in run.axes))


def _digest(value: Any) -> str:
    return sha256(canonical(value).encode("utf-8", "surrogatepass")).hexdigest()


def _content(subject: Variant | AnyMission) -> str:
    if isinstance(subject, Variant):
        return subject.content
    try:
        return subject.to_yaml()
    except MissionError:  # weights that are functions, which no text has
        return f"{subject.digest} {subject.text}"
