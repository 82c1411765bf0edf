"""`tsplan simulate`: how often a plan goes well by chance, or a trajectory that is shaken."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, cast

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_and_result
from tsplan.cli.output import say
from tsplan.errors import Finding, InputError, PlanError
from tsplan.protocol.margin_size import margin_for
from tsplan.protocol.simulation import Frequency, simulate
from tsplan.signals.signal_mission import SignalMission
from tsplan.words import number

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator, Sequence

    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan
    from tsplan.protocol.disturbances import DisturbedRuns
    from tsplan.protocol.simulation import Simulation
    from tsplan.signals.trajectory import Trajectory


def run(options: argparse.Namespace) -> Exit:
    """Print how often formula and bounds held, how far numbers strayed, and what would help."""
    mission, result = mission_and_result(options.mission, options.plan)
    signals = isinstance(mission, SignalMission)
    if signals is not bool(options.amplitude):
        what = "a trajectory is shaken by --amplitude, a plan is not"
        remedy = "say how much, as in --amplitude 0.1" if signals else "leave it out"
        raise InputError([Finding(what, remedy)])
    numbers = {"runs": options.runs, "seed": options.seed}
    try:
        if isinstance(mission, SignalMission):
            size = _amplitude(options.amplitude)
            shaken = cast("Trajectory", result).simulate(mission, amplitude=size, **numbers)
            lines = _shaken_words(shaken)
        else:
            found = simulate(mission, cast("Plan", result), **numbers)
            lines = _words(mission, found, options.probability)
    except PlanError as error:
        raise PlanError(_named(error, str(options.plan))) from None
    for line in lines:
        say(line)
    return Exit.DONE


def _amplitude(given: Sequence[tuple[str, float]]) -> float | dict[str, float]:
    """One amplitude for all signals, or one for each that is named."""
    sizes = dict(given)
    if "" in sizes and len(given) > 1:
        what = "one amplitude is of all signals, and others are of one each"
        raise InputError([Finding(what, "name the signal of each, as in --amplitude x=0.1")])
    return sizes.get("", sizes)


def _shaken_words(found: DisturbedRuns) -> Iterator[str]:
    yield f"{found.runs:,} runs (seed {found.seed}): the controls as planned, every step shaken"
    yield f"the formula held in {_frequency(found.formula)}"
    yield f"the signals stayed in their bounds in {_frequency(found.bounds)}"
    yield f"robustness {number(found.mean)} on average, at least {number(found.least)}"


def _words(mission: Mission, found: Simulation, probability: float) -> Iterator[str]:
    by = "shares" if mission.expected is None else "policies"
    yield f"{found.runs:,} runs (seed {found.seed}): every agent by chance, by the plan's {by}"
    yield f"the formula held in {_frequency(found.formula)}"
    if mission.expected is None:
        yield f"the bounds on sub-swarms held in {_frequency(found.bounds)}"
    yield (
        f"numbers at a state strayed from the plan by {found.stray_mean:.2f} agents on average, "
        f"at most by {number(round(found.stray_max, 2))}"
    )
    margin = margin_for(mission, probability)
    yield (
        f"with 'margin: {margin}' (or more) in the mission, any plan's formula holds with "
        f"probability {number(probability)}"
    )


def _frequency(found: Frequency) -> str:
    return (
        f"{found.times:,} of them: {found.rate:.1%} "
        f"(95 % interval {found.low:.1%} to {found.high:.1%})"
    )


def _named(error: PlanError, source: str) -> list[Finding]:
    return [replace(finding, source=source) for finding in error.findings]
