"""How soon there is a plan again after an agent is lost, against how soon there was the first."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass
from random import Random
from statistics import median

import families

import tsplan
from tsplan.run.events import Incumbent


@dataclass(frozen=True)
class Lost:
    """Seconds to the first and to the best plan, before and after an agent was lost."""

    first: float
    best: float
    again: float | None
    settled: float
    status: str


def lost(size: int, seed: int, agents: int, time_limit: float) -> Lost | None:
    """Plan a mission of the grid family, lose an agent at a third of its horizon, plan again."""
    mission = families.grid(size, seed, agents, ["travel"])
    watch = _First()
    plan = tsplan.plan(mission, time_limit=time_limit, on_event=watch)
    best = time.perf_counter() - watch.began
    if not plan.has_paths or watch.seconds is None:
        return None
    step = mission.horizon // 3
    name = Random(seed).choice([agent.id for agent in plan.agents])
    again = _First()
    options = {"time_limit": time_limit, "on_event": again}
    made = tsplan.replan(mission, plan, step, lost=[name], options=options)
    settled = time.perf_counter() - again.began
    return Lost(watch.seconds, best, again.seconds, settled, made.status.value)


class _First:
    """Notes when the first plan came."""

    def __init__(self) -> None:
        self.began = time.perf_counter()
        self.seconds: float | None = None

    def __call__(self, event: tsplan.Event) -> None:
        if isinstance(event, Incumbent) and self.seconds is None:
            self.seconds = time.perf_counter() - self.began


def table(sizes: Iterable[int], seeds: Iterable[int], agents: int, time_limit: float) -> str:
    """A Markdown table of the medians and the worst."""
    lines = [
        "| grid | missions | first plan, s | settled, s | again: first, s | settled, s | no plan |",
        "|---|---|---|---|---|---|---|",
    ]
    for size in sizes:
        rows = [row for seed in seeds if (row := lost(size, seed, agents, time_limit)) is not None]
        found = [row for row in rows if row.again is not None]
        columns = [
            _both([row.first for row in rows]),
            _both([row.best for row in rows]),
            _both([row.again for row in found if row.again is not None]),
            _both([row.settled for row in rows]),
        ]
        none = sum(row.status == "infeasible" for row in rows)
        lines.append(f"| {size}x{size} | {len(rows)} | {' | '.join(columns)} | {none} |")
    return "\n".join(lines)


def _both(seconds: list[float]) -> str:
    """The median and the worst of some times."""
    return f"{median(seconds):.2f} / {max(seconds):.2f}" if seconds else "-"
