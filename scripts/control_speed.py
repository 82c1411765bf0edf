"""How long a controller takes for a step, and how often what it leads satisfies its formula."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np
import signal_scenes

import tsplan
from tsplan.protocol.disturbances import simulate_disturbed
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory

SCENES = ("reach-avoid:T=15", "either-or:T=20", "narrow:T=25", "narrow:T=50,u=0.2", "many-target")
"""Scenes that are steered by default."""

AMPLITUDE = 0.05
"""Up to which every signal is shaken at every step: scenes are 10 wide, speeds at most 1."""


@dataclass(frozen=True)
class Steered:
    """What a controller did over some runs of a scene."""

    scene: str
    runs: int
    seconds: Sequence[float]
    late: int
    fresh: float
    held: float
    open_loop: float


def steered(text: str, runs: int, deadline: float, threads: int) -> Steered:
    """Steer a scene so many times, shaken, and follow its plan blindly a thousand times."""
    mission = signal_scenes.scene(text)
    plan = tsplan.synthesise(mission, time_limit=60, threads=threads)
    seconds: list[float] = []
    fresh = held = 0
    for seed in range(runs):
        *steps, last = _run(mission, plan, seed, deadline, threads)
        held += last[0].holds
        fresh += sum(step.fresh for step, _ in steps)
        seconds += [took for _, took in steps]
    late = sum(took > deadline for took in seconds)
    blind = simulate_disturbed(mission, plan, amplitude=AMPLITUDE).formula.rate
    share = fresh / len(seconds)
    return Steered(text, runs, seconds, late, share, held / runs, blind)


def _run(
    mission: SignalMission, plan: Trajectory, seed: int, deadline: float, threads: int
) -> Iterator[tuple[tsplan.signals.controller.Step, float]]:
    """The steps of one run and the seconds that they took."""
    random, system = np.random.default_rng(seed), mission.system
    controller = tsplan.Controller(mission, plan=plan, threads=threads, seed=0)
    state = {name: float(plan[name][0]) for name in system.signals}
    while not controller.done:
        began = time.perf_counter()
        step = controller.step(state, deadline)
        yield step, time.perf_counter() - began
        if not controller.done:
            led = system.led(state, step.control)
            state = {name: by + random.uniform(-AMPLITUDE, AMPLITUDE) for name, by in led.items()}


def table(scenes: Sequence[str], runs: int, deadline: float, threads: int) -> str:
    """A Markdown table: one line per scene."""
    lines = [
        "| scene | runs | steps | seconds median / worst | late | fresh | holds | open loop |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for text in scenes:
        row = steered(text, runs, deadline, threads)
        lines.append(
            f"| {row.scene} | {row.runs} | {len(row.seconds)} | {median(row.seconds):.3f} / "
            f"{max(row.seconds):.3f} | {row.late} | {row.fresh:.0%} | {row.held:.0%} | "
            f"{row.open_loop:.0%} |"
        )
    return "\n".join(lines)
