"""One run where it is done: the mission is read, planned in a child process, and told as a row."""

from __future__ import annotations

import json
import platform
import time
import traceback
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from importlib import import_module
from typing import Any

from tsplan.errors import SolverError, TsplanError
from tsplan.mission.mission import digest_of
from tsplan.plans.outcomes import FOUND, MissionRef
from tsplan.plans.plan import Plan
from tsplan.process.interrupt import Requests
from tsplan.run.events import Event
from tsplan.run.isolate import Order, Planning
from tsplan.signals.mission_order import order_for, rest, with_reading
from tsplan.signals.result_check import AnyMission, Result
from tsplan.signals.trajectory import Trajectory
from tsplan.sweeps.mission_variant import Variant
from tsplan.sweeps.sweep_rows import DTYPES, SweepRow
from tsplan.sweeps.sweep_runs import SweepRun
from tsplan.version import VERSION
from tsplan.words import known


@dataclass(frozen=True, slots=True)
class Answer:
    """What became of a run: its row, and the texts of the plan and of its mission if asked for.

    The mission is there where no file says it as it was planned.
    """

    row: SweepRow
    plan: str | None = None
    mission: str | None = None


class _Nobody:
    """Hears of the work and tells nobody."""

    def tell(self, event: Event) -> None:
        """Take an event in."""

    def note(self, text: str) -> None:
        """Take a note in."""


def answer_of(run: SweepRun, keep: bool = False, requests: Requests | None = None) -> Answer:
    """Do a run; whatever goes wrong is a row of it.

    `keep` asks for the plan. `requests` has what signals ask for, where it is done in the process
    that hears them.
    """
    began = time.perf_counter()
    try:
        mission = run.mission
        choice = run.choice.over(mission.solver)
        loaded = time.perf_counter() - began
        left = replace(choice, time_limit=rest(choice.time_limit, loaded))
        order = order_for(mission, left, run.encoding, run.without)
        began += _made_ready(order)
        planned = Planning(_Nobody(), requests or Requests(quiet=True)).plan(order)
        result: Result = with_reading(planned, mission, loaded)
        _refuse_unchecked(result)
        told = {**_told(result), **_sizes(mission, result), **_objectives(result)}
        row = _row(run, began, told)
        return _kept(run, mission, result, row) if keep else Answer(row)
    except Exception as error:  # noqa: BLE001  (no run stops the sweep)
        return failure(run, error, round(time.perf_counter() - began, 6))


def _made_ready(order: Order) -> float:
    """Load the planner once, here, and not in every child that is forked; the seconds of that."""
    began = time.perf_counter()
    import_module(order.planner[0])
    return time.perf_counter() - began


def _refuse_unchecked(result: Result) -> None:
    if result.status in FOUND and not result.verified:
        raise SolverError("the plan that was found has not been checked")


def failure(run: SweepRun, error: BaseException, seconds: float | None = None) -> Answer:
    """The answer of a run that came to nothing."""
    words = str(error) or type(error).__name__
    if not isinstance(error, TsplanError | MemoryError | OSError):
        frames = traceback.extract_tb(error.__traceback__)
        where = f" in {frames[-1].name}, line {frames[-1].lineno}" if frames else ""
        words = f"internal error{where}: {type(error).__name__}: {words}"
    values = {"status": "error", "error_kind": type(error).__name__, "error": words}
    return Answer(_made(run, {**values, "verified": False, "seconds.wall": seconds}))


def _row(run: SweepRun, began: float, values: Mapping[str, Any]) -> SweepRow:
    return _made(run, {**values, "seconds.wall": round(time.perf_counter() - began, 6)})


def _made(run: SweepRun, values: Mapping[str, Any]) -> SweepRow:
    place = {
        "version.tsplan": VERSION,
        "version.python": platform.python_version(),
        "platform": platform.platform(),
        "content": run.content,
    }
    return SweepRow(run.axes, {**dict.fromkeys(DTYPES), "id": run.id, **values, **place})


def _told(result: Result) -> dict[str, Any]:
    """What a plan or a trajectory says of itself."""
    options = result.solver.options
    return {
        "status": result.status.value,
        "stopped_by": None if result.stopped_by is None else result.stopped_by.value,
        "verified": result.verified,
        "availability": known(result.availability) if isinstance(result, Plan) else None,
        "robustness": known(result.robustness) if isinstance(result, Trajectory) else None,
        "steps": result.horizon,
        "used.solver": result.solver.name or None,
        "used.options": json.dumps(dict(options), sort_keys=True) if options else None,
        "version.solver": result.solver.version or None,
        **{f"seconds.{name}": value for name, value in asdict(result.timings).items()},
    }


def _sizes(mission: AnyMission, result: Result) -> dict[str, Any]:
    """How large the mission and its model are."""
    sizes = {f"size.{name}": value for name, value in asdict(result.size).items()}
    return {"agents": mission.size, **sizes}


def _objectives(result: Result) -> dict[str, float | None]:
    """Value and bound of each objective; several of one name are numbered."""
    return dict(_objective_cells(result))


def _objective_cells(result: Result) -> Iterator[tuple[str, float | None]]:
    times: Counter[str] = Counter()
    for item in result.objective:
        times[item.name] += 1
        name = item.name if times[item.name] == 1 else f"{item.name}.{times[item.name]}"
        yield f"value.{name}", known(item.value)
        yield f"bound.{name}", known(item.bound)


def _kept(run: SweepRun, mission: AnyMission, result: Result, row: SweepRow) -> Answer:
    """An answer with the plan, and the mission that goes with it where no file has it."""
    if result.status not in FOUND:
        return Answer(row)
    if isinstance(run.subject, Variant) and run.subject.as_it_stands:
        return Answer(row, result.to_json())
    text = mission.to_yaml()
    named = MissionRef(mission.name, digest_of(text))
    return Answer(row, replace(result, mission=named).to_json(), text)
