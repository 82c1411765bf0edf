"""Whether signals and controls are those that a system allows, step by step."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from tsplan.errors import Finding, PlanError
from tsplan.milp.model import Bools, Floats
from tsplan.signals.equalities import TOLERANCE
from tsplan.signals.linear_system import Limit, Range, System, Terms
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.words import many


class Motion:
    """A trajectory that has exactly the signals and controls of its system.

    `values` has each of them as an array, (T+1,) and (T,). `scales` is the range of each: between
    its bounds, and where these are infinite or one, the size of its values, at least 1. What is
    `past` was measured: the signals up to that step and the controls before it are as they are.
    """

    def __init__(self, system: System, trajectory: Trajectory, past: int | None = None) -> None:
        self.system, self.horizon, self.past = system, trajectory.horizon, past
        self.values: Mapping[str, Floats] = {name: trajectory[name] for name in system.names}
        ranges = {**system.signals, **system.controls}
        self.scales = {name: _scale(ranges[name], row) for name, row in self.values.items()}

    def width(self, terms: Terms) -> float:
        """The range of a sum."""
        return sum((abs(factor) * self.scales[name] for name, factor in terms), 0.0)

    @property
    def now(self) -> int:
        """The first step whose controls are judged."""
        return 0 if self.past is None else self.past

    @property
    def ahead(self) -> int:
        """The first step whose signals are judged."""
        return 0 if self.past is None else self.past + 1

    @property
    def simulated(self) -> Mapping[str, Floats]:
        """The signals that the controls lead to; those that move freely as they are."""
        signals = self.system.signals
        rows = np.array([self.values[name] for name in signals])
        if self.system.dynamics is not None:
            steered = [self.values[name] for name in self.system.controls]
            controls = np.array(steered).reshape(len(steered), rows.shape[1] - 1)
            with np.errstate(over="ignore", invalid="ignore"):  # whoever asks looks at that
                later = self.system.simulated(rows[:, self.now].tolist(), controls[:, self.now :])
            rows = np.hstack([rows[:, : self.now], later])
        return dict(zip(signals, rows, strict=True))


def strangers(system: System, trajectory: Trajectory, horizon: int) -> Iterator[str]:
    """Whether a trajectory is of another horizon, or has other signals or controls."""
    if trajectory.horizon != horizon:
        yield f"the trajectory ends at step {trajectory.horizon} and the mission at step {horizon}"
    kinds = (
        ("signal", trajectory.signals, system.signals),
        ("control", trajectory.controls, system.controls),
    )
    for kind, given, wanted in kinds:
        yield from (f"{kind} {name} has no values" for name in wanted if name not in given)
        yield from (f"the system has no {kind} {name}" for name in given if name not in wanted)


def refuse_misfit(trajectory: Trajectory, mission: SignalMission | None, source: str = "") -> None:
    """Raise PlanError for a trajectory without signals, or with those of another mission.

    This is far less than `check` asks: a trajectory that breaks the formula still fits.
    """
    findings = []
    source = source or "trajectory"
    if not trajectory.has_signals:
        what = f"a trajectory of status {trajectory.status} has no signals"
        findings = [Finding(what, "plan the mission again with more time", source)]
    elif mission is not None:
        remedy = "name the mission that was planned"
        words = strangers(mission.system, trajectory, mission.horizon)
        findings = [Finding(what, remedy, source) for what in words]
    if findings:
        raise PlanError(findings)


def settled(system: System, trajectory: Trajectory, past: int | None = None) -> Trajectory:
    """The trajectory as it will be: its start and controls in their bounds, its signals simulated.

    Signals without dynamics are brought into their bounds. What is `past` stays as it was measured.
    """
    motion = Motion(system, trajectory, past)
    rows = dict(motion.values)
    for kind, first in ((system.signals, motion.ahead), (system.controls, motion.now)):
        for name, ends in kind.items():
            rows[name][first:] = np.clip(rows[name][first:], *ends)
    if past is None:
        for name in system.signals:
            rows[name][0] = np.clip(rows[name][0], *system.begins(name))
    signals, controls = (_plain(rows, names) for names in (system.signals, system.controls))
    moved = replace(trajectory, signals=signals, controls=controls)
    return led(Motion(system, moved, past), moved)


def led(motion: Motion, trajectory: Trajectory) -> Trajectory:
    """The trajectory with the signals that its start and controls lead to."""
    return replace(trajectory, signals=_plain(motion.simulated, motion.system.signals))


def _plain(rows: Mapping[str, Floats], names: Iterable[str]) -> dict[str, tuple[float, ...]]:
    return {name: tuple((rows[name] + 0.0).tolist()) for name in names}


def deviations(motion: Motion, other: Mapping[str, Floats], what: str) -> Iterator[str]:
    """Signals that are not what others say, in words: where each first is not."""
    for name, row in other.items():
        far = np.abs(row - motion.values[name]) > TOLERANCE * motion.scales[name]
        for step, words in _first(far):
            own, led = motion.values[name][step], row[step]
            yield f"at step {step} signal {name} is {_exact(own)}, {what} {_exact(led)}{words}"


def broken(motion: Motion) -> Iterator[str]:
    """Ranges, bounds and limits that are not kept from now on, in words."""
    system = motion.system
    for kind, bounds, since in (
        ("signal", system.signals, motion.ahead),
        ("control", system.controls, motion.now),
    ):
        for name, ends in bounds.items():
            row, slack = motion.values[name], TOLERANCE * motion.scales[name]
            for place, side, sign in ((0, "below", 1), (1, "above", -1)):
                bound = np.full(len(row), float(ends[place]))
                if kind == "signal":
                    bound[0] = system.begins(name)[place]
                for step, words in _first(sign * (bound - row) > slack, since):
                    end = "start" if step == 0 and name in system.initial else "bound"
                    what = f"{kind} {name} is {_exact(row[step])}"
                    yield f"at step {step} {what}, {side} its {end} {_exact(bound[step])}{words}"
    for limit in system.limits:
        value, width = left_side(motion, limit)
        steered = any(name in system.controls for name in limit.names)
        since = motion.now if steered else motion.ahead
        for step, words in _first(value - limit.bound > TOLERANCE * width, since):
            what = f"at step {step} the left side of {limit} is"
            yield f"{what} {_exact(value[step])}{words}"


def left_side(motion: Motion, limit: Limit) -> tuple[Floats, float]:
    """What a limit bounds, at each step that it holds for, and the range of that."""
    parts = [(1.0, limit.terms, False), *((factor, t, True) for factor, t in limit.absolute)]
    steps = min((len(motion.values[name]) for name in limit.names), default=1)
    total, width = np.zeros(steps), 0.0
    for factor, terms, absolute in parts:
        inner = sum(own * motion.values[name][:steps] for name, own in terms)
        total += factor * (np.abs(inner) if absolute else inner)
        width += factor * motion.width(terms)
    return total, width


def _first(far: Bools, since: int = 0) -> Iterator[tuple[int, str]]:
    """The first step from `since` on at which something is amiss, and how many more there are."""
    steps = since + np.flatnonzero(far[since:])
    if steps.size:
        more = int(steps.size) - 1
        yield int(steps[0]), f" (and at {many(more, 'more step')})" if more else ""


def _scale(bounds: Range, row: Floats) -> float:
    width = float(bounds[1]) - float(bounds[0])
    if np.isfinite(width) and width > 0:
        return width
    return max(1.0, float(np.abs(row).max(initial=0.0)))


def _exact(value: float) -> str:
    """A number, in as many digits as tell it from a bound it is near."""
    return f"{value:.10g}"
