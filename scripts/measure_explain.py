"""Measure explaining on the published grid family, made infeasible, against planning it as it is.

    python scripts/measure_explain.py --size 6 --seeds 0-19

Of every mission there are two that cannot be met: `late` has its deadlines cut two steps at a time,
`small` has its team reduced, each until there is no plan. Times are wall-clock seconds.
"""

from __future__ import annotations

import argparse
import re
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from statistics import median, quantiles

import families

import tsplan
from tsplan import Mission
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.fact_finders import facts_of


@dataclass(frozen=True)
class Row:
    """One infeasible mission: seconds for its sibling's plan, for facts, and for everything."""

    seed: int
    kind: str
    plan: float
    facts: float
    whole: float
    found: tsplan.explanation.Explanation


def late(seed: int, size: int) -> Iterator[Mission]:
    """The mission with ever earlier deadlines."""
    mission = families.grid(size, seed)
    for cut in range(2, 21, 2):
        text = re.sub(
            r"F\[(\d+),(\d+)\]",
            lambda found, cut=cut: f"F[{found[1]},{max(int(found[2]) - cut, int(found[1]))}]",
            mission.text,
        )
        yield families.mission(mission.name, mission.system, mission.team, text, ["travel"])


def small(seed: int, size: int) -> Iterator[Mission]:
    """The mission with ever fewer agents."""
    for agents in range(16, 0, -4):
        yield families.grid(size, seed, agents)


def measured(seed: int, size: int) -> Iterator[Row]:
    """The rows of one seed."""
    began = time.perf_counter()
    tsplan.plan(families.grid(size, seed))
    plan = time.perf_counter() - began
    for kind, series in (("late", late(seed, size)), ("small", small(seed, size))):
        for mission in series:
            if tsplan.plan(replace(mission, objective=())).status == "infeasible":
                yield row(seed, kind, plan, mission)
                break


def row(seed: int, kind: str, plan: float, mission: Mission) -> Row:
    """Facts alone, then the whole explanation."""
    began = time.perf_counter()
    list(facts_of(Context(mission)))
    facts = time.perf_counter() - began
    began = time.perf_counter()
    found = tsplan.explain(mission)
    return Row(seed, kind, plan, facts, time.perf_counter() - began, found)


def main() -> None:
    """Print a line for each mission, then medians and spread."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--size", type=int, default=6)
    parser.add_argument("--seeds", default="0-19", help="first-last")
    asked = parser.parse_args()
    first, last = (int(number) for number in asked.seeds.split("-"))
    rows = []
    tsplan.plan(families.grid(3, 0))  # what is loaded at first is not measured
    for seed in range(first, last + 1):
        for item in measured(seed, asked.size):
            rows.append(item)
            facts, (conflict, *_) = len(item.found.facts), item.found.conflicts
            sure = sum(change.proven for change in item.found.changes)
            print(
                f"seed {item.seed:2} {item.kind:5}: plan {item.plan:.2f} s, facts {item.facts:.3f} "
                f"s ({facts}), explain {item.whole:.2f} s: {len(conflict.parts)} parts, "
                f"{'minimal' if conflict.minimal else 'not minimal'}, "
                f"{len(item.found.changes)} changes ({sure} proven)",
                flush=True,
            )
    for name, values in (
        ("plan", [item.plan for item in rows]),
        ("facts", [item.facts for item in rows]),
        ("explain", [item.whole for item in rows]),
        ("explain / plan", [item.whole / item.plan for item in rows]),
    ):
        low, _, high = quantiles(values, n=4)
        spread = f"quartiles {low:.3f} .. {high:.3f}, largest {max(values):.3f}"
        print(f"{name}: median {median(values):.3f}, {spread}")


if __name__ == "__main__":
    main()
