"""`tsplan simulate`: how often a plan goes well by chance, or a trajectory that is shaken."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, cast

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_and_result
from tsplan.cli.output import say
from tsplan.errors import Finding, InputError, PlanError
from tsplan.protocol.margin_size import margin_for
from tsplan.protocol.simulation import simulate
from tsplan.signals.signal_mission import SignalMission
from tsplan.words import number

if TYPE_CHECKING:
    import argparse
    from collections.abc import Sequence

    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan
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
            lines = str(shaken).splitlines()
        else:
            found = simulate(mission, cast("Plan", result), **numbers)
            lines = [*str(found).splitlines(), _advice(mission, options.probability)]
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


def _advice(mission: Mission, probability: float) -> str:
    margin = margin_for(mission, probability)
    return (
        f"with 'margin: {margin}' (or more) in the mission, any plan's formula holds with "
        f"probability {number(probability)}"
    )


def _named(error: PlanError, source: str) -> list[Finding]:
    return [replace(finding, source=source) for finding in error.findings]
