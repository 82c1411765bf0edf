"""Measure the planner on families of missions; write a CSV, a Markdown table and plots.

    python scripts/benchmark.py grid --sizes 5,6 --seeds 0-49
    python scripts/benchmark.py grid --sizes 5 --seeds 0-9 --compare reference --time-limit 60
    python scripts/benchmark.py scaling --axis agents --seeds 0-2 --plot out.png
    python scripts/benchmark.py swarm --sizes 30,100 --agents 120 --objective splits
    python scripts/benchmark.py resources --sizes 10 --agents 100 --resources 10 --time-limit 60
    python scripts/benchmark.py modules --agents 12 --docks 2 --time-limit 60
    python scripts/benchmark.py floor --sizes 3,6 --agents 20 --stations 8 --lanes --time-limit 60
    python scripts/benchmark.py mapf --map FILE.map --scenario FILE.scen --agents 50 --time-limit 60
    python scripts/benchmark.py signals --compare stlpy,sos1 --time-limit 60
    python scripts/benchmark.py signals --scenes either-or:T=40 door:T=50,n=3
    python scripts/benchmark.py control --scenes narrow:T=25 --seeds 0-9 --time-limit 0.5
    python scripts/benchmark.py replanning --sizes 5,6 --seeds 0-49 --time-limit 60
    python scripts/benchmark.py missions FOLDER
    python scripts/benchmark.py build

Times are wall-clock seconds of this process, from the mission in memory to the verified plan. The
formulas of signals are read from their texts within that time.
"""

from __future__ import annotations

import argparse
import csv
import platform
import sys
import time
from collections.abc import Iterable, Sequence
from dataclasses import asdict, replace
from importlib.metadata import version
from pathlib import Path

import control_speed
import families
import floors
import replanning_speed
import signal_encodings
import signal_scenes
from benchmark_rows import Row, plot, processor, ratios, table

import tsplan
from tsplan.encode.assemble import tight
from tsplan.encode.preparation import prepare
from tsplan.encode.switches import Switch
from tsplan.milp.solution import Options, Progress
from tsplan.run.events import Bound, Event, Incumbent
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory


class Watch:
    """Notes when the first plan came and the first bound; a solver's times `sign`."""

    def __init__(self) -> None:
        self.sign = 1
        self.first: float | None = None
        self.first_cpu: float | None = None
        self.began = time.process_time()
        self.root: float | None = None

    def __call__(self, event: Event) -> None:
        """Hear of one event."""
        if isinstance(event, Incumbent) and self.first is None:
            self.first = event.elapsed
            self.first_cpu = self.cpu
        if isinstance(event, Bound | Incumbent) and event.bound is not None and self.root is None:
            self.root = event.bound

    @property
    def cpu(self) -> float:
        """Processor seconds of this process since this was made."""
        return time.process_time() - self.began

    def solving(self, progress: Progress) -> bool:
        """Hear of a solver's own progress."""
        if progress.objective is not None and self.first is None:
            self.first = progress.elapsed
            self.first_cpu = self.cpu
        if progress.bound is not None and self.root is None:
            self.root = self.sign * progress.bound
        return False


def run(case: families.Case, options: argparse.Namespace, encoding: str) -> Row:
    """Plan one mission and note what happened."""
    watch = Watch()
    began = time.perf_counter()
    if encoding in signal_encodings.ENCODINGS:
        asked = Options(time_limit=options.time_limit, threads=options.threads, seed=0)
        watch.sign = -1 if any(aim.rises for aim in case.mission.objective[:1]) else 1
        plan = signal_encodings.trajectory(case.mission, encoding, asked, watch.solving)
    elif isinstance(case.mission, SignalMission):
        plan = synthesised(case.mission, options, watch)
    else:
        plan = tsplan.plan(
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
        objective={item.name: item.value for item in plan.objective},
        root_bound=watch.root,
        final_bound=None if last is None else last.bound,
        final_value=None if last is None else last.value,
        columns=plan.size.columns,
        integers=plan.size.integers,
        rows=plan.size.rows,
        extract=plan.timings.extract + plan.timings.verify,
        cpu=watch.cpu,
        first_cpu=watch.first_cpu,
    )


def synthesised(mission: SignalMission, options: argparse.Namespace, watch: Watch) -> Trajectory:
    """A trajectory from the formula's text on."""
    read = replace(mission, formula=tsplan.parse(str(mission.formula), mission.language))
    return tsplan.synthesise(
        read,
        time_limit=options.time_limit,
        threads=options.threads,
        seed=0,
        on_event=watch,
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
            "resources": _resources,
            "modules": _modules,
            "floor": _floors,
            "mapf": _scenario,
            "signals": _scenes,
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


def _resources(options: argparse.Namespace, seeds: Sequence[int], objective: Names) -> Made:
    for size in numbers(options.sizes):
        works = families.Works(
            size, options.agents, options.resources, options.tasks, options.horizon
        )
        for seed in seeds:
            made = families.resources(works, seed, objective)
            yield families.Case("resources", f"{works.agents} agents, map", size, seed, made)


def _modules(options: argparse.Namespace, seeds: Sequence[int], objective: Names) -> Made:
    for seed in seeds:
        made = families.modules(options.agents, options.docks, seed, objective)
        yield families.Case(
            "modules", f"{options.docks} docks, modules", options.agents, seed, made
        )


def _floors(options: argparse.Namespace, seeds: Sequence[int], objective: Names) -> Made:
    for rooms in numbers(options.sizes):
        sizes = floors.Floor(rooms, options.agents, options.stations, options.lanes)
        for seed in seeds:
            made = floors.floor(sizes, seed, objective)
            cells = len(made.system.states)
            yield families.Case("floor", f"{sizes.robots} robots, cells", cells, seed, made)


def _scenario(options: argparse.Namespace, _: Sequence[int], objective: Names) -> Made:
    made = floors.scenario(Path(options.map), Path(options.scenario), options.agents, objective)
    yield families.Case("mapf", made.system.name, options.agents, 0, made)


def _scenes(options: argparse.Namespace, _: Sequence[int], __: Names) -> Made:
    chosen = options.scenes or (signal_scenes.QUICK if options.quick else signal_scenes.GOALS)
    for text in chosen:
        family, _, numbers = text.partition(":")
        rest = ",".join(item for item in numbers.split(",") if not item.startswith("T="))
        made = signal_scenes.scene(text)
        axis = f"{rest} T" if rest else "T"
        yield families.Case(family, axis, made.horizon, 0, replace(made, name=text))


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


def parser() -> argparse.ArgumentParser:
    """The command line."""
    made = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    choices = ["grid", "decomposition", "scaling", "swarm", "partial", "resources"]
    choices += ["modules", "floor", "mapf", "signals", "missions", "control", "build", "replanning"]
    made.add_argument("family", choices=choices)
    made.add_argument("folder", nargs="?", default="environments", help="for `missions`")
    made.add_argument(
        "--sizes", default="5,6", help="grid: rows and columns, such as 5,6 or 3-6; swarm: states"
    )
    made.add_argument("--seeds", default="0-9")
    made.add_argument("--agents", type=int, default=20)
    made.add_argument("--resources", type=int, default=10, help="resources: how many")
    made.add_argument("--tasks", type=int, default=8, help="resources: how many tasks")
    made.add_argument("--horizon", type=int, default=60, help="resources: the last step")
    made.add_argument(
        "--docks", type=int, default=2, help="modules: where structures are rebuilt, 0 for anywhere"
    )
    made.add_argument("--stations", type=int, default=4, help="floor: where robots are wanted")
    made.add_argument(
        "--lanes", action="store_true", help="floor: two robots do not pass between two cells"
    )
    made.add_argument("--map", help="mapf: a map of the MovingAI benchmarks")
    made.add_argument("--scenario", help="mapf: a list of starts and goals for it")
    made.add_argument("--axis", choices=list(families.AXES), default="agents")
    made.add_argument(
        "--objective", default="travel", help="such as availability,travel; '' for none"
    )
    encodings = ["tight", "reference", *signal_encodings.ENCODINGS]
    made.add_argument("--encoding", default="tight", choices=encodings)
    made.add_argument("--without", nargs="*", default=[], help="switches to turn off")
    made.add_argument(
        "--compare", default="", help="other encodings too: reference; signals: stlpy,sos1"
    )
    made.add_argument("--scenes", nargs="*", help="signals: such as narrow or door:T=50,n=4")
    made.add_argument("--quick", action="store_true", help="signals: small scenes alone")
    made.add_argument("--time-limit", type=float, default=600.0)
    made.add_argument("--threads", type=int, default=2)
    made.add_argument("--whole-map", action="store_true", help="build: without map reduction")
    made.add_argument("--csv", type=Path)
    made.add_argument("--plot", metavar="PNG")
    return made


def measure_apart(options: argparse.Namespace) -> None:
    """Families that are no plans of missions one by one."""
    if options.family == "build":
        build_speed(options)
        return
    if options.family == "replanning":
        sizes, seeds = numbers(options.sizes), numbers(options.seeds)
        print(replanning_speed.table(sizes, seeds, options.agents, options.time_limit))
        return
    scenes = options.scenes or control_speed.SCENES
    runs = len(numbers(options.seeds))
    print(control_speed.table(scenes, runs, options.time_limit, options.threads))


def main() -> None:
    """Run what the command line asks for."""
    made = parser()
    options = made.parse_args()
    if options.family in ("build", "replanning", "control"):
        measure_apart(options)
        return
    encodings = [options.encoding, *(name for name in options.compare.split(",") if name)]
    known = {"reference"} if options.family != "signals" else set(signal_encodings.ENCODINGS)
    if unknown := set(encodings[1:]) - known:
        made.error(f"cannot compare with {', '.join(sorted(unknown))}, only {', '.join(known)}")
    rows = []
    if options.family == "signals":  # what is loaded once is no part of the first scene's time
        tsplan.synthesise("x >= 0", tsplan.signals.free_signals(x=(0, 1)), horizon=1)
    for case in cases(options):
        for encoding in encodings:
            if encoding in signal_encodings.ENCODINGS and case.mission.language == "wstl":
                continue  # they know no weights
            row = run(case, options, encoding)
            rows.append(row)
            first = "none" if row.first_plan is None else f"{row.first_plan:.3f}"
            print(
                f"{case.mission.name} {encoding}: {row.status} {row.values} "
                f"(bound {row.final_bound}) {row.seconds:.2f} s, first plan {first} s, "
                f"{row.cpu:.1f} s of the processor",
                file=sys.stderr,
            )
    if options.csv:
        with options.csv.open("w", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=list(asdict(rows[0])))
            writer.writeheader()
            writer.writerows({**asdict(row), "objective": row.values} for row in rows)
    packages = ", ".join(f"{name} {version(name)}" for name in ("highspy", "numpy", "scipy"))
    print(f"Python {platform.python_version()}, {packages}, {options.threads} threads\n")
    print(table(rows))
    print(processor(rows))
    print(ratios(rows, options.encoding))
    if options.plot:
        plot(rows, options.plot)


if __name__ == "__main__":
    main()
