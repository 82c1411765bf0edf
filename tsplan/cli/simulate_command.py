"""`tsplan simulate`: how often a plan succeeds when every agent goes by chance."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_and_plan
from tsplan.cli.output import say
from tsplan.errors import PlanError
from tsplan.protocol.margin_size import margin_for
from tsplan.protocol.simulation import Frequency, simulate
from tsplan.words import number

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

    from tsplan.errors import Finding
    from tsplan.mission import Mission
    from tsplan.protocol.simulation import Simulation


def run(options: argparse.Namespace) -> Exit:
    """Print how often formula and bounds held, how far numbers strayed, and what would help."""
    mission, plan = mission_and_plan(options.mission, options.plan)
    try:
        found = simulate(mission, plan, runs=options.runs, seed=options.seed)
    except PlanError as error:
        raise PlanError(_named(error, str(options.plan))) from None
    for line in _words(mission, found, options.probability):
        say(line)
    return Exit.DONE


def _words(mission: Mission, found: Simulation, probability: float) -> Iterator[str]:
    yield f"{found.runs:,} runs (seed {found.seed}): every agent by chance, by the plan's shares"
    yield f"the formula held in {_frequency(found.formula)}"
    yield f"the bounds on sub-swarms held in {_frequency(found.bounds)}"
    yield (
        f"numbers at a state strayed from the plan by {found.stray_mean:.2f} agents on average, "
        f"at most by {found.stray_max:,}"
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
