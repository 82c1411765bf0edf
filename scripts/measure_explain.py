"""Measure explaining of missions from which agents or time were taken, against planning them.

    python scripts/measure_explain.py --seeds 0-8 --families grid,decomposition,modules

`late` has the deadlines of the published grid cut two steps at a time, `grid`, `decomposition` and
`modules` lose a fifth of their agents again and again, drawn by chance, each until there is no
plan. `sibling` is the last mission that has one. All times are seconds of CPU, of all threads.
"""

from __future__ import annotations

import argparse
import re
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from math import nan
from random import Random
from statistics import median, quantiles

import families

import tsplan
from tsplan import Mission
from tsplan.explanation import Change, Conflict, Fact, Found

_LIMIT = 60.0  # seconds to find out whether there is a plan


@dataclass(frozen=True)
class Row:
    """One mission without a plan: seconds for its sibling's plan, and until something is known."""

    name: str
    plan: float
    proof: float
    fact: float
    conflict: float
    change: float
    whole: float
    found: tsplan.explanation.Explanation


def late(seed: int) -> Iterator[Mission]:
    """The grid mission with ever earlier deadlines."""
    mission = families.grid(6, seed)
    for cut in range(0, 21, 2):
        text = re.sub(
            r"F\[(\d+),(\d+)\]",
            lambda found, cut=cut: f"F[{found[1]},{max(int(found[2]) - cut, int(found[1]))}]",
            mission.text,
        )
        yield families.mission(mission.name, mission.system, mission.team, text, [])


def fewer(mission: Mission) -> Iterator[Mission]:
    """The mission with ever fewer agents; an entry of the team keeps one at least."""
    random = Random(mission.name)
    while True:
        yield mission
        team = []
        agents = [n for n, group in enumerate(mission.team) for _ in range(group.count)]
        gone = random.sample(agents, max(1, len(agents) // 5))
        for number, group in enumerate(mission.team):
            starts = [state for state, count in group.starts for _ in range(count)]
            random.shuffle(starts)
            kept = starts[min(gone.count(number), len(starts) - 1) :]
            counts = {state: kept.count(state) for state in dict.fromkeys(kept)}
            team.append(replace(group, starts=tuple(counts.items())))
        if sum(group.count for group in team) == mission.size:
            return
        mission = replace(mission, team=tuple(team), warnings=())


FAMILIES: dict[str, Callable[[int], Iterator[Mission]]] = {
    "late": late,
    "grid": lambda seed: fewer(families.grid(6, seed)),
    "decomposition": lambda seed: fewer(families.decomposition(20, seed)),
    "modules": lambda seed: fewer(families.modules(12, 1, seed)),
}


def infeasible(series: Iterator[Mission]) -> tuple[Mission, float, float] | None:
    """The first mission without a plan, and seconds for the one before and for its proof."""
    before = nan
    for mission in series:
        began = time.process_time()
        plan = tsplan.plan(replace(mission, objective=()), time_limit=_LIMIT)
        spent = time.process_time() - began
        if plan.status == "infeasible":
            return None if before != before else (mission, before, spent)  # noqa: PLR0124  (nan)
        if not plan.has_paths:
            return None
        before = spent
    return None


def row(name: str, mission: Mission, plan: float, proof: float) -> Row:
    """Explain a mission, and note when what was told."""
    began = time.process_time()
    first: dict[type, float] = {}

    def heard(item: Found) -> None:
        first.setdefault(type(item), time.process_time() - began)

    found = tsplan.explain(mission, on_found=heard)
    times = [first.get(kind, nan) for kind in (Fact, Conflict, Change)]
    return Row(name, plan, proof, *times, time.process_time() - began, found)


def shown(item: Row) -> str:
    """A row in words."""
    made = item.found
    (conflict, *_) = made.conflicts
    return (
        f"{item.name}: sibling {item.plan:.2f} s, proof {item.proof:.2f} s; fact {item.fact:.2f}, "
        f"conflict {item.conflict:.2f}, change {item.change:.2f}, all {item.whole:.2f} s: "
        f"{len(conflict.parts)} parts, {'' if conflict.minimal else 'not '}minimal, "
        f"{len(made.changes)} changes ({sum(change.proven for change in made.changes)} proven)"
    )


def summary(rows: list[Row]) -> Iterator[str]:
    """Medians and spread of every time that is known."""
    for name, values in (
        ("sibling", [item.plan for item in rows]),
        ("first fact", [item.fact for item in rows]),
        ("conflict", [item.conflict for item in rows]),
        ("conflict / sibling", [item.conflict / item.plan for item in rows]),
        ("first change", [item.change for item in rows]),
        ("all", [item.whole for item in rows]),
    ):
        known = [value for value in values if value == value]  # noqa: PLR0124  (not nan)
        if len(known) > 1:
            low, _, high = quantiles(known, n=4)
            spread = f"quartiles {low:.2f} .. {high:.2f}, largest {max(known):.2f}"
            yield f"  {name} ({len(known)}): median {median(known):.2f}, {spread}"


def main() -> None:
    """Print a line for each mission, and medians and spread for each family."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--seeds", default="0-8", help="first-last")
    parser.add_argument("--families", default=",".join(FAMILIES), help="a,b,...")
    asked = parser.parse_args()
    first, last = (int(number) for number in asked.seeds.split("-"))
    tsplan.explain(families.grid(3, 0))  # what is loaded at first is not measured
    for family in asked.families.split(","):
        rows = []
        for seed in range(first, last + 1):
            known = infeasible(FAMILIES[family](seed))
            if known is not None:
                rows.append(row(f"{family} {seed}", *known))
                print(shown(rows[-1]), flush=True)
        print(f"{family}:", *summary(rows), sep="\n", flush=True)


if __name__ == "__main__":
    main()
