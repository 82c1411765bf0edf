"""Many missions at once from Python: planned wherever an executor does, and told as a table."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import Executor
from pathlib import Path

from tsplan.errors import Finding, InputError
from tsplan.limits import LARGEST, Range
from tsplan.milp.solver_choice import SolverChoice
from tsplan.signals.result_check import AnyMission
from tsplan.sweeps.mission_folder import runs_of_folder
from tsplan.sweeps.sweep_draft import load_sweep
from tsplan.sweeps.sweep_rows import SweepResults, SweepRow
from tsplan.sweeps.sweep_runs import SweepRun
from tsplan.sweeps.sweeping import Sweeping

Missions = str | Path | Iterable[AnyMission] | Mapping[str, AnyMission]


def sweep(
    missions: Missions,
    *,
    executor: Executor | None = None,
    jobs: int = 1,
    on_result: Callable[[SweepRow], object] | None = None,
    csv: str | Path | None = None,
    fresh: bool = False,
    retry: bool = False,
    plans: str | Path | None = None,
    solver: str | None = None,
    time_limit: float | None = None,
    gap: float | None = None,
    threads: int | None = None,
    seed: int | None = None,
) -> SweepResults:
    """Plan many missions, and have a row of results for each of them.

    `missions` is a sweep file or a folder of missions by its path, some missions (called by their
    names where these differ, otherwise numbered from 1), or a mapping from what they are called.
    Both kinds of missions may be among them. `solver` and what follows are for every run, whatever
    its mission or the file says.

    The work is done by any `executor` of `concurrent.futures`, or by so many processes (`jobs`);
    by one, run after run, from here. `on_result` is called with each row when its run is done. With
    `csv` every row is recorded at once in a journal beside that file, which is written at the end;
    what is recorded already is not done again, unless it is to be `fresh`, or has failed and is
    to be tried once more (`retry`). Plans are written into the folder `plans`.

    What goes wrong in a run is told in its row. Raises InputError for missions that are none and
    places that cannot be written, SolverError where the executor has cancelled runs, and
    KeyboardInterrupt when asked to stop, with all that was done recorded.

    >>> import tsplan
    >>> from tsplan.ts.builders import grid
    >>> missions = {
    ...     size: tsplan.Mission.of(
    ...         map=grid(1, size, labels={(0, size - 1): "dock"}),
    ...         team=[tsplan.Group.of("cart", {"r0c0": 2})],
    ...         formula="F[0,9] dock",
    ...         language="mtl",
    ...     )
    ...     for size in (3, 4)
    ... }
    >>> rows = tsplan.sweep(missions)
    >>> [(row["mission"], row["status"], row["value.travel"]) for row in rows]
    [(3, 'optimal', 2.0), (4, 'optimal', 3.0)]
    """
    jobs_wrong = Range(1, LARGEST, whole=True).complaint(jobs)
    if jobs_wrong is not None:
        raise InputError([Finding(f"jobs: {jobs_wrong}", "leave it out for one")])
    choice = SolverChoice(solver, time_limit, gap, threads, seed).checked()
    sweeping = Sweeping(
        tuple(run.chosen(choice) for run in runs_of(missions)),
        None if csv is None else Path(csv),
        None if plans is None else Path(plans),
        on_result,
    )
    sweeping.resume(fresh=fresh, retry=retry)
    return sweeping.work(executor, jobs)


def runs_of(missions: Missions) -> tuple[SweepRun, ...]:
    """The runs of a sweep file, a folder or some missions. Raises InputError."""
    if isinstance(missions, str | Path):
        place = Path(missions)
        return runs_of_folder(place) if place.is_dir() else load_sweep(place)
    if isinstance(missions, Mapping):
        return tuple(SweepRun({"mission": name}, mission) for name, mission in missions.items())
    listed = list(missions)
    names = [mission.name for mission in listed]
    known = all(names) and len(set(names)) == len(names)
    columns = names if known else range(1, len(listed) + 1)
    return tuple(
        SweepRun({"mission": name}, mission) for name, mission in zip(columns, listed, strict=True)
    )
