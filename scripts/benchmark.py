"""Measure the planner on families of missions; write a CSV, a Markdown table and plots.

    python scripts/benchmark.py grid --sizes 5,6 --seeds 0-49
    python scripts/benchmark.py grid --sizes 5 --seeds 0-9 --compare reference --time-limit 60
    python scripts/benchmark.py scaling --axis agents --seeds 0-2 --plot out.png
    python scripts/benchmark.py swarm --sizes 30,100 --agents 120 --objective splits
    python scripts/benchmark.py missions FOLDER
    python scripts/benchmark.py build

Times are wall-clock seconds of this process, from the mission in memory to the verified plan.
"""

from __future__ import annotations

import argparse
import csv
import platform
import sys
import time
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from importlib.metadata import version
from pathlib import Path
from statistics import median

import families
import numpy as np

import tsplan
from tsplan.encode.assemble import tight
from tsplan.encode.preparation import prepare
from tsplan.encode.switches import Switch
from tsplan.plans.plan import Plan
from tsplan.run.events import Bound, Event, Incumbent


@dataclass(frozen=True)
class Row:
    """One run."""

    family: str
    axis: str
    value: float
    seed: int
    encoding: str
    status: str
    seconds: float
    first_plan: float | None
    objective: str
    root_bound: float | None
    final_bound: float | None
    final_value: float | None
    columns: int
    integers: int
    rows: int
    extract: float

    @property
    def optimal(self) -> bool:
        """Whether the run ended with a proof: an optimum or infeasibility."""
        return self.status in ("optimal", "infeasible")


class Watch:
    """Notes when the first plan came and the first bound of the last objective."""

    def __init__(self) -> None:
        self.first: float | None = None
        self.root: float | None = None

    def __call__(self, event: Event) -> None:
        """Hear of one event."""
        if isinstance(event, Incumbent) and self.first is None:
            self.first = event.elapsed
        if isinstance(event, Bound | Incumbent) and event.bound is not None and self.root is None:
            self.root = event.bound


def run(case: families.Case, options: argparse.Namespace, encoding: str) -> Row:
    """Plan one mission and note what happened."""
    watch = Watch()
    began = time.perf_counter()
    plan: Plan = tsplan.plan(
        case.mission,
        time_limit=options.time_limit,
        threads=options.threads,
        seed=0,
        encoding=encoding,
        without=tuple(options.without),
        on_event=watch,
    )
    seconds = time.perf_counter() - began
    last = plan.objective[-1] if plan.objective else None
    return Row(
        family=case.family,
        axis=case.axis,
        value=case.value,
        seed=case.seed,
        encoding=encoding,
        status=str(plan.status),
        seconds=seconds,
        first_plan=watch.first,
        objective=" ".join(f"{item.name}={item.value}" for item in plan.objective),
        root_bound=watch.root,
        final_bound=None if last is None else last.bound,
        final_value=None if last is None else last.value,
        columns=plan.size.columns,
        integers=plan.size.integers,
        rows=plan.size.rows,
        extract=plan.timings.extract + plan.timings.verify,
    )


def cases(options: argparse.Namespace) -> Iterable[families.Case]:
    """The missions that the command line asks for."""
    objective = tuple(name for name in options.objective.split(",") if name)
    seeds = numbers(options.seeds)
    if options.family == "scaling":
        yield from families.axis_cases(options.axis, seeds, objective)
    elif options.family == "missions":
        yield from from_folder(Path(options.folder))
    else:
        makers = {
            "grid": _grids,
            "decomposition": _decompositions,
            "swarm": _swarms,
            "partial": _partials,
        }
        yield from makers[options.family](options, seeds, objective)


Made = Iterable[families.Case]
Names = tuple[str, ...]


def _grids(options: argparse.Namespace, seeds: Sequence[int], objective: Names) -> Made:
    for size in numbers(options.sizes):
        for seed in seeds:
            made = families.grid(size, seed, options.agents, objective)
            yield families.Case("grid", "map", size, seed, made)


def _decompositions(options: argparse.Namespace, seeds: Sequence[int], objective: Names) -> Made:
    for seed in seeds:
        made = families.decomposition(options.agents, seed, objective)
        yield families.Case("decomposition", "agents", options.agents, seed, made)


def _swarms(options: argparse.Namespace, seeds: Sequence[int], objective: Names) -> Made:
    for states in numbers(options.sizes):
        for seed in seeds:
            horizon = 40 if states <= _SMALL else 60
            made = families.swarm(states, horizon, options.agents, seed, objective)
            yield families.Case("swarm", "states", states, seed, made)


def _partials(_: argparse.Namespace, seeds: Sequence[int], objective: Names) -> Made:
    for place, order in enumerate(("weighted", "depth", "hierarchical")):
        for seed in seeds:
            made = families.partial(order, seed, objective)
            yield families.Case("partial", order, place, seed, made)


def from_folder(folder: Path) -> Made:
    """The missions of a folder; other files in it, and those that do not load, are left out."""
    for number, path in enumerate(sorted(folder.glob("*.yaml"))):
        try:
            mission = tsplan.load_mission(path)
        except tsplan.InputError:
            continue  # a map beside the missions
        yield families.Case("missions", path.stem, 0, number, mission)


_SMALL = 30  # states up to which swarms have a horizon of 40 steps, and of 60 beyond


def numbers(text: str) -> list[int]:
    """`1,4-6` as [1, 4, 5, 6]."""
    found: list[int] = []
    for part in text.split(","):
        low, _, high = part.partition("-")
        found += range(int(low), int(high or low) + 1)
    return found


def build_speed(options: argparse.Namespace) -> None:
    """Columns per second and bytes per column of encoding the scaling family."""
    import tracemalloc  # noqa: PLC0415 - only here

    for horizon in (100, 200, 300):
        mission = families.scaling(families.Scale(horizon=horizon, tasks=40, map=50), 0)
        without = {Switch.REDUCTION} if options.whole_map else set()
        kept = frozenset(Switch) - without
        began = time.perf_counter()
        encoded = tight(prepare(mission, switches=kept))
        seconds = time.perf_counter() - began
        tracemalloc.start()
        tight(prepare(mission, switches=kept))
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        size = encoded.model.size
        print(
            f"horizon {horizon}: {size.columns} columns, {size.nonzeros} nonzeros, "
            f"{seconds:.2f} s, {size.columns / seconds:,.0f} columns/s, "
            f"peak {peak / size.columns:.0f} bytes/column"
        )


def table(rows: Sequence[Row]) -> str:
    """A Markdown table: one line per family, value and encoding."""
    lines = [
        (
            "| family | value | encoding | runs | proven | first plan median / worst | "
            "total median / quartiles / worst | root gap median | columns | rows |"
        ),
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    groups: dict[tuple[str, str, float, str], list[Row]] = {}
    for row in rows:
        groups.setdefault((row.family, row.axis, row.value, row.encoding), []).append(row)
    for (family, axis, value, encoding), members in groups.items():
        seconds = [row.seconds for row in members]
        firsts = [row.first_plan for row in members if row.first_plan is not None] or [float("nan")]
        low, high = np.percentile(seconds, [25, 75])
        lines.append(
            f"| {family} | {axis} {value:g} | {encoding} | {len(members)} "
            f"| {sum(row.optimal for row in members)} "
            f"| {median(firsts):.3f} / {max(firsts):.3f} "
            f"| {median(seconds):.2f} / {low:.2f}-{high:.2f} / {max(seconds):.2f} "
            f"| {_gap(members)} | {median(r.columns for r in members):.0f} "
            f"| {median(r.rows for r in members):.0f} |"
        )
    return "\n".join(lines)


def _gap(rows: Sequence[Row]) -> str:
    gaps = [
        abs(row.final_value - row.root_bound) / max(abs(row.final_value), 1e-9)
        for row in rows
        if row.final_value is not None and row.root_bound is not None
    ]
    return f"{100 * median(gaps):.1f} %" if gaps else "-"


def ratios(rows: Sequence[Row]) -> str:
    """How much longer the other encodings took on the same missions, where both ended proven."""
    by_case: dict[tuple[str, float, int], dict[str, Row]] = {}
    for row in rows:
        by_case.setdefault((row.axis, row.value, row.seed), {})[row.encoding] = row
    found: dict[str, list[float]] = {}
    unequal = []
    for key, runs in by_case.items():
        for encoding, other in runs.items():
            if encoding == "tight" or not other.optimal:
                continue
            found.setdefault(encoding, []).append(other.seconds / runs["tight"].seconds)
            if (other.status, other.objective) != (runs["tight"].status, runs["tight"].objective):
                unequal.append(f"{key}: {runs['tight'].objective} against {other.objective}")
    lines = [
        f"{name}/tight: median {median(values):.1f}, {min(values):.1f} to {max(values):.1f} "
        f"over {len(values)} missions that both proved"
        for name, values in found.items()
    ]
    return "\n".join(lines + [f"DIFFERENT {line}" for line in unequal])


def plot(rows: Sequence[Row], path: str) -> None:
    """Seconds against the axis, total and first plan."""
    from matplotlib import pyplot as plt  # noqa: PLC0415 - an optional dependency

    figure, axes = plt.subplots(figsize=(5, 3.5), layout="constrained")
    for name, pick in (("total", lambda r: r.seconds), ("first plan", lambda r: r.first_plan)):
        values = sorted({row.value for row in rows})
        middle = [
            median(
                [pick(r) for r in rows if r.value == v and pick(r) is not None] or [float("nan")]
            )
            for v in values
        ]
        axes.plot(values, middle, marker="o", label=name)
    axes.set(xscale="log", yscale="log", xlabel=rows[0].axis, ylabel="seconds (median)")
    axes.legend()
    figure.savefig(path)


def parser() -> argparse.ArgumentParser:
    """The command line."""
    made = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    choices = ["grid", "decomposition", "scaling", "swarm", "partial", "missions", "build"]
    made.add_argument("family", choices=choices)
    made.add_argument("folder", nargs="?", default="environments", help="for `missions`")
    made.add_argument(
        "--sizes", default="5,6", help="grid: rows and columns, such as 5,6 or 3-6; swarm: states"
    )
    made.add_argument("--seeds", default="0-9")
    made.add_argument("--agents", type=int, default=20)
    made.add_argument("--axis", choices=list(families.AXES), default="agents")
    made.add_argument(
        "--objective", default="travel", help="such as availability,travel; '' for none"
    )
    made.add_argument("--encoding", default="tight", choices=["tight", "reference"])
    made.add_argument("--without", nargs="*", default=[], help="switches to turn off")
    made.add_argument("--compare", choices=["reference"], help="also run another encoding")
    made.add_argument("--time-limit", type=float, default=600.0)
    made.add_argument("--threads", type=int, default=2)
    made.add_argument("--whole-map", action="store_true", help="build: without map reduction")
    made.add_argument("--csv", type=Path)
    made.add_argument("--plot", metavar="PNG")
    return made


def main() -> None:
    """Run what the command line asks for."""
    options = parser().parse_args()
    if options.family == "build":
        build_speed(options)
        return
    encodings = [options.encoding, *([options.compare] if options.compare else [])]
    rows = []
    for case in cases(options):
        for encoding in encodings:
            row = run(case, options, encoding)
            rows.append(row)
            first = "none" if row.first_plan is None else f"{row.first_plan:.3f}"
            print(
                f"{case.mission.name} {encoding}: {row.status} {row.objective} "
                f"{row.seconds:.2f} s, first plan {first} s",
                file=sys.stderr,
            )
    if options.csv:
        with options.csv.open("w", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=list(asdict(rows[0])))
            writer.writeheader()
            writer.writerows(asdict(row) for row in rows)
    packages = ", ".join(f"{name} {version(name)}" for name in ("highspy", "numpy", "scipy"))
    print(f"Python {platform.python_version()}, {packages}, {options.threads} threads\n")
    print(table(rows))
    print(ratios(rows))
    if options.plot:
        plot(rows, options.plot)


if __name__ == "__main__":
    main()
