"""The trajectory: what every signal is at every step, and what was proven about it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self

import numpy as np
from pydantic import Field

from tsplan import display
from tsplan.errors import Finding, InputError, PlanError, nearest
from tsplan.limits import MOST_STEPS
from tsplan.logic.traces import SignalTrace
from tsplan.milp.model import Floats
from tsplan.plans.known_mission import OfMission
from tsplan.plans.outcomes import (
    MissionRef,
    ModelSize,
    ObjectiveValue,
    SolverUse,
    Status,
    Timings,
    contradictions,
)
from tsplan.plans.plan_text import TRAJECTORIES, read_result
from tsplan.plans.records import (
    OPTIONAL,
    Finite,
    Record,
    Word,
    as_json,
    json_document,
    json_lines,
)
from tsplan.plans.satisfaction import Depth
from tsplan.stopping import StoppedBy

if TYPE_CHECKING:
    from tsplan.signals.signal_mission import SignalMission

Values = tuple[Annotated[float, Field(strict=True, allow_inf_nan=False)], ...]


@dataclass(frozen=True, slots=True)
class PartValue(Record):
    """A part of the formula: by how much it holds, and how much of it does."""

    text: str
    robustness: Finite | None
    fraction: Finite


@dataclass(frozen=True)
class Trajectory(Record, OfMission["SignalMission"], display.Displayed):
    """What synthesis ended with.

    `signals` have one value more than there are `controls`, unless there is no trajectory.
    `robustness` is the formula's, weighted as the mission says, `agm` the arithmetic-geometric
    mean robustness (None where a signal of the formula has no bounds). Where the formula may hold
    in part, `fraction` is how much does, `depths` what holds at each depth of it in the orders by
    depth, and `preference` the same with weights.

    Raises PlanError for a status that contradicts `stopped_by` or the presence of signals, and for
    values that are not finite or not as many as there are steps.
    """

    status: Status
    mission: MissionRef
    horizon: Annotated[int, Field(strict=True, ge=0, le=MOST_STEPS)]
    stopped_by: StoppedBy | None = None
    objective: tuple[ObjectiveValue, ...] = ()
    robustness: Finite | None = None
    agm: Finite | None = None
    fraction: Finite | None = field(default=None, metadata=OPTIONAL)
    preference: Finite | None = field(default=None, metadata=OPTIONAL)
    depths: tuple[Depth, ...] = field(default=(), metadata=OPTIONAL)
    verified: Annotated[bool, Field(strict=True)] = False
    signals: Mapping[Word, Values] = field(default_factory=dict, hash=False)
    controls: Mapping[Word, Values] = field(default_factory=dict, hash=False)
    parts: tuple[PartValue, ...] = field(default=(), metadata=OPTIONAL)
    solver: SolverUse = field(default_factory=SolverUse)
    size: ModelSize = field(default_factory=ModelSize)
    timings: Timings = field(default_factory=Timings)
    notes: tuple[str, ...] = field(default=(), metadata=OPTIONAL)

    def __post_init__(self) -> None:
        for kind in ("signals", "controls"):
            plain = {name: tuple(map(float, row)) for name, row in getattr(self, kind).items()}
            object.__setattr__(self, kind, plain)
        there = self.has_signals
        findings = contradictions(self, "trajectory", "signals", there=there)
        lengths = (
            ("signal", self.signals, self.horizon + 1),
            ("control", self.controls, self.horizon),
        )
        for kind, rows, steps in lengths if there else ():
            for name, row in rows.items():
                if len(row) != steps:
                    what = f"{kind} {name} has {len(row)} values and not {steps}"
                    findings.append(Finding(what, f"the horizon is {self.horizon}"))
                elif not all(map(isfinite, row)):
                    step = next(step for step, value in enumerate(row) if not isfinite(value))
                    findings.append(Finding(f"{kind} {name} is no finite number at step {step}"))
        findings += [
            Finding(f"'{name}' is both a signal and a control")
            for name in self.signals
            if name in self.controls
        ]
        if findings:
            raise PlanError(findings)

    def __getitem__(self, name: str) -> Floats:
        """The values of a signal (T+1,) or a control (T,); InputError for other names."""
        for rows in (self.signals, self.controls):
            if name in rows:
                return np.array(rows[name])
        known = (*self.signals, *self.controls)
        raise InputError([Finding(f"there is no signal '{name}'", nearest(name, known))])

    @property
    def states(self) -> Floats:
        """All signals (n, T+1), in the order of the system."""
        return np.array(list(self.signals.values()))

    @property
    def has_signals(self) -> bool:
        """Whether there is a trajectory."""
        return bool(self.signals)

    def trace(self) -> SignalTrace:
        """What formulas are judged on: every signal and control over the steps 0..T.

        After the last step nothing is steered any more: a control is held there.
        """
        held = {name: (*values, *values[-1:]) for name, values in self.controls.items() if values}
        arrays = {**self.signals, **held}
        return SignalTrace({name: np.array(values) for name, values in arrays.items()})

    # --- with its mission --------------------------------------------------------------------

    def explain(self, mission: SignalMission | None = None) -> display.WitnessNode:
        """Why the trajectory satisfies the formula of its mission, as a tree that prints itself.

        Every node says where it holds and by how much, and what it rests on there; each part names
        the critical predicates, which keep its robustness from being greater. Raises InputError
        where the mission is not known and not given, PlanError for one of another system.
        """
        return display.explain_trajectory(self, self.needed_mission(mission, "explain"))

    def plot(
        self,
        *names: str,
        mission: SignalMission | None = None,
        view: str = "signals",
        ax: Any = None,
    ) -> display.Picture:
        """A picture of the trajectory: its matplotlib figure and axes.

        `view` is `signals` (over time, each in a panel; `names` chooses some), `plane` or `page`,
        which has both. On a given `ax` all signals are drawn together. The mission, which a
        trajectory knows that was not read from a file, gives windows and thresholds.
        Raises PlotUnavailableError without matplotlib, InputError for an unknown view or name, and
        PlanError where there are no signals or they are of another mission.
        """
        return display.draw_trajectory(self, self.known_mission(mission), view, names, ax)

    def plot_plane(
        self, across: str, up: str, mission: SignalMission | None = None, ax: Any = None
    ) -> display.Picture:
        """The plane of two signals, with regions and the path; for copies the path of each.

        Raises as `plot`.
        """
        known = self.known_mission(mission)
        return display.draw_trajectory(self, known, "plane", (across, up), ax)

    def view(self, mission: SignalMission | None = None, path: str | Path | None = None) -> Path:
        """Show the trajectory in the browser: one page that plays it, whose path is returned.

        With a `path` the page is written there and no browser is opened. Raises as `explain`.
        """
        place = None if path is None else Path(path)
        return display.show_page(self.needed_mission(mission, "view"), self, place)

    def animate(
        self, path: str | Path | None = None, mission: SignalMission | None = None, **pace: Any
    ) -> display.Movie:
        """The trajectory as a moving picture; as `Plan.animate`."""
        return display.movie(self.needed_mission(mission, "animate"), self, path, **pace)

    def simulate(
        self,
        mission: SignalMission | None = None,
        *,
        amplitude: float | Mapping[str, float],
        runs: int = 1000,
        seed: int = 0,
    ) -> display.DisturbedRuns:
        """How often the formula still holds where every step shakes the signals.

        See `tsplan.simulate_disturbed`; raises as `explain`.
        """
        known = self.needed_mission(mission, "simulate")
        return display.simulate_disturbed(known, self, amplitude=amplitude, runs=runs, seed=seed)

    def __str__(self) -> str:
        """What `tsplan plan` prints."""
        return display.trajectory_words(self)

    def _repr_html_(self) -> str:
        """The trajectory as notebooks show it: what is known, and the signals over time."""
        return display.trajectory_html(self)

    def _caption(self) -> str:
        signals = ", ".join(self.signals) or "no signals"
        return f"<Trajectory of {self.mission.name!r}: {self.status}, {signals}>"

    def to_json(self) -> str:
        """The trajectory as a `tsplan-trajectory/1` document: one key, and one signal, a line."""
        mark = TRAJECTORIES.mark
        first = {"format": mark, "status": self.status, "stopped_by": self.stopped_by}

        def rows(kind: Mapping[str, Values]) -> str:
            lines = [f"{as_json(name)}: {as_json(row)}" for name, row in kind.items()]
            return json_lines(lines, "{}") if lines else "{}"

        large = {
            "signals": lambda: rows(self.signals),
            "controls": lambda: rows(self.controls),
            "parts": lambda: json_lines(map(as_json, self.parts)),
        }
        return json_document({**first, **self.data()}, large)

    @classmethod
    def from_json(cls, text: str, source: str = "trajectory") -> Self:
        """Read a `tsplan-trajectory/1` document; raises PlanError with everything wrong with it."""
        return read_result(cls, TRAJECTORIES, text, source)
