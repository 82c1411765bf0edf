"""Trajectories that are shaken: how often the formula still holds.

At every step a random number, even between minus and plus the amplitude and independent of all
others, is added to every signal. The controls are those of the trajectory, where nobody looks at
where the signals are (open loop), or those of a controller that does (closed loop). Signals without
dynamics are shaken where they are.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from tsplan.display import Told
from tsplan.errors import Finding, InputError, PlanError, nearest
from tsplan.frequency import Frequency
from tsplan.logic.evaluation import holds, robustness
from tsplan.logic.traces import SignalTrace
from tsplan.parameters import refuse_options
from tsplan.signals.controller import Controller
from tsplan.signals.equalities import TOLERANCE, approximate
from tsplan.signals.trajectory_check import check
from tsplan.words import number

if TYPE_CHECKING:
    from tsplan.milp.model import Floats
    from tsplan.signals.linear_system import System
    from tsplan.signals.signal_mission import SignalMission
    from tsplan.signals.trajectory import Trajectory

_ENTRIES = 4_000_000  # values of a batch of runs, which are kept at once

Amplitude: TypeAlias = "float | Mapping[str, float]"


@dataclass(frozen=True, slots=True)
class DisturbedRuns(Told):
    """What came of many shaken runs; `str` tells it in words.

    `formula` tells how often the formula held, `bounds` how often every signal stayed in its
    bounds. `least` and `mean` are of the formula's robustness, with its weights.
    """

    runs: int
    seed: int
    formula: Frequency
    bounds: Frequency
    least: float
    mean: float

    def __str__(self) -> str:
        """What `tsplan simulate` prints."""
        runs = f"{self.runs:,} runs (seed {self.seed})"
        return "\n".join(
            (
                f"{runs}: the controls as planned, every step shaken",
                f"the formula held in {self.formula}",
                f"the signals stayed in their bounds in {self.bounds}",
                f"robustness {number(self.mean)} on average, at least {number(self.least)}",
            )
        )


def simulate_disturbed(
    mission: SignalMission,
    trajectory: Trajectory,
    *,
    amplitude: Amplitude,
    runs: int = 1000,
    seed: int = 0,
) -> DisturbedRuns:
    """Follow the trajectory's controls `runs` times while the signals are shaken.

    `amplitude` is one for all signals, or one for each that is shaken, in the unit of the signal.
    The result is the same for equal seeds. Raises PlanError for a trajectory that the independent
    check refuses, InputError for amplitudes below 0 and of unknown signals, and ValueError for
    fewer runs than one and other numbers out of range.
    """
    noises = _noises(mission, trajectory, amplitude, runs, seed)
    traces = (_shaken(mission.system, trajectory, noise) for noise in noises)
    return _judged(mission, traces, runs, seed)


def simulate_controlled(
    mission: SignalMission,
    trajectory: Trajectory,
    *,
    amplitude: Amplitude,
    runs: int = 100,
    seed: int = 0,
    deadline: float | None = None,
) -> DisturbedRuns:
    """Let a `Controller` with the trajectory as its plan lead the signals while they are shaken.

    For equal seeds the signals are shaken as in `simulate_disturbed`, so that the two compare. The
    controller has `deadline` seconds for a step; with one the result depends on the machine.
    Raises what `simulate_disturbed` and `Controller` do.
    """
    noises = _noises(mission, trajectory, amplitude, runs, seed)
    names = mission.system.names

    def led(noise: Floats) -> SignalTrace:
        traces = [_led(mission, trajectory, one, deadline) for one in noise]
        return SignalTrace({n: np.array([trace.signal(n) for trace in traces]) for n in names})

    return _judged(mission, map(led, noises), runs, seed)


def _led(
    mission: SignalMission, plan: Trajectory, noise: Floats, deadline: float | None
) -> SignalTrace:
    """One run of a controller; a row of `noise` (T, n) is added at every step."""
    controller, system = Controller(mission, plan=plan), mission.system
    state = {name: float(plan[name][0]) for name in system.signals}
    for row in noise:
        led = system.led(state, controller.step(state, deadline).control)
        state = {name: led[name] + by for name, by in zip(led, row.tolist(), strict=True)}
    controller.step(state)
    return controller.trajectory.trace()


def _noises(
    mission: SignalMission, trajectory: Trajectory, amplitude: Amplitude, runs: int, seed: int
) -> Iterator[Floats]:
    """What is added to the signals (runs, T, n), in batches whose values fit into memory."""
    if runs < 1:
        raise ValueError(f"at least one run is needed, not {runs}")
    refuse_options(runs=runs, seed=seed)
    sizes = _sizes(mission.system, amplitude)
    report = check(mission, trajectory)
    if not report.ok:
        raise PlanError(report.findings)
    random = np.random.default_rng(seed)
    return (
        random.uniform(-1.0, 1.0, (size, trajectory.horizon, len(sizes))) * sizes
        for size in _batches(trajectory, runs)
    )


def _judged(
    mission: SignalMission, traces: Iterable[SignalTrace], runs: int, seed: int
) -> DisturbedRuns:
    """What came of runs, in batches."""
    judged = approximate(mission.formula, mission.system)
    held = kept = 0
    least, total = np.inf, 0.0
    for trace in traces:
        held += int(holds(judged, trace)[..., 0].sum())
        kept += int(_within(mission.system, trace).sum())
        margins = robustness(mission.formula, trace, kind=mission.weighting)[..., 0]
        least, total = min(least, float(margins.min())), total + float(margins.sum())
    return DisturbedRuns(
        runs, seed, Frequency(held, runs), Frequency(kept, runs), least, total / runs
    )


def _sizes(system: System, amplitude: Amplitude) -> Floats:
    """The amplitude of every signal."""
    if not isinstance(amplitude, Mapping):
        amplitude = dict.fromkeys(system.signals, amplitude)
    findings = [
        Finding(f"there is no signal '{name}'", nearest(name, system.signals))
        for name in amplitude
        if name not in system.signals
    ]
    findings += [
        Finding(f"the amplitude {size} is no number from 0 on", "write one, as in 0.05")
        for size in set(amplitude.values())
        if not (isfinite(size) and size >= 0)
    ]
    if findings:
        raise InputError(findings)
    return np.array([float(amplitude.get(name, 0.0)) for name in system.signals])


def _batches(trajectory: Trajectory, runs: int) -> Iterator[int]:
    """Sizes of batches whose values fit into memory."""
    values = (trajectory.horizon + 1) * (len(trajectory.signals) + len(trajectory.controls))
    size = max(_ENTRIES // values, 1)
    for begin in range(0, runs, size):
        yield min(size, runs - begin)


def _shaken(system: System, trajectory: Trajectory, noise: Floats) -> SignalTrace:
    """The signals (runs, T+1) of a batch, and the controls, which are as planned."""
    runs = len(noise)
    planned = np.array([trajectory[name] for name in system.signals]).T
    rows = np.repeat(planned[np.newaxis], runs, axis=0)
    if system.dynamics is None:
        rows[:, 1:] += noise
    else:  # the signals differ from the planned ones by what the dynamics make of the noise
        a = system.dynamics.arrays[0]
        strayed = np.zeros((runs, noise.shape[-1]))
        for step in range(trajectory.horizon):
            strayed = strayed @ a.T + noise[:, step]
            rows[:, step + 1] += strayed
    calm = trajectory.trace()
    signals = {name: rows[..., place] for place, name in enumerate(system.signals)}
    controls = {
        name: np.broadcast_to(calm.signal(name), (runs, trajectory.horizon + 1))
        for name in system.controls
        if trajectory.horizon
    }
    return SignalTrace({**signals, **controls})


def _within(system: System, trace: SignalTrace) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    """In which runs every signal stays in its bounds, as closely as the check asks."""
    inside = np.ones(trace.batch, dtype=np.bool_)
    for name, (low, high) in system.signals.items():
        row = trace.signal(name)
        slack = TOLERANCE * (high - low) if isfinite(high - low) else 0.0
        inside &= ((row >= low - slack) & (row <= high + slack)).all(axis=-1)
    return inside
