"""Reading what a command is given."""

from __future__ import annotations

import os
import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tsplan.checking.fitting import refuse_impossible, refuse_pathless, with_groups
from tsplan.cli.output import remark
from tsplan.document.document import LARGEST_FILE
from tsplan.document.files import read_text
from tsplan.errors import Finding, InputError, PlanError, nearest, told
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission import Mission
from tsplan.mission.mission import digest_of
from tsplan.plans.plan import Plan
from tsplan.process.interrupt import alarm
from tsplan.signals.mission_order import rest
from tsplan.signals.motion_check import refuse_misfit
from tsplan.signals.result_check import load_result, mixed_up
from tsplan.signals.signal_files import load_any_mission
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.ts.io.map_settings import is_reference

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterable

    from tsplan.signals.result_check import AnyMission, Result

_READING = 2.0  # seconds that reading may always take: without it there is no answer at all
_CHOICES = ("solver", "time_limit", "gap", "threads", "seed")  # as options of a command


def any_mission_of(path: Path) -> AnyMission:
    """The mission of a file, for a team or over signals, its warnings written to stderr."""
    mission = load_any_mission(path)
    warn(mission.warnings)
    return mission


def mission_to_solve(
    options: argparse.Namespace, what: str
) -> tuple[AnyMission, SolverChoice, float]:
    """The mission of a command that solves and may write `what`, and what is chosen of the solver.

    Reading the mission is a part of the work: it has to keep the time limit, which is chosen less
    the seconds that it took; these come last. The solver and the place to write to are looked at.
    """
    refuse_place(options.output, what, [options.mission])
    limit = None if options.time_limit is None else max(options.time_limit, _READING)
    began = time.perf_counter()
    with alarm(limit, "the time limit was reached while the mission was read"):
        mission = any_mission_of(options.mission)
    loaded = time.perf_counter() - began
    refuse_place(options.output, what, files_of(mission))
    given = (getattr(options, name, None) for name in _CHOICES)
    choice = SolverChoice(*given).over(mission.solver)
    refuse_solver(choice.name or "highs")
    return mission, replace(choice, time_limit=rest(choice.time_limit, loaded)), loaded


def mission_and_result(mission_path: Path, path: Path) -> tuple[AnyMission, Result]:
    """The mission and the plan or trajectory of two files, or the findings of both."""
    findings: list[Finding] = []
    try:
        mission = any_mission_of(mission_path)
    except InputError as error:
        findings += error.findings
    try:
        result = load_result(path)
    except InputError as error:
        findings += error.findings
    if not findings and isinstance(mission, SignalMission) is not isinstance(result, Trajectory):
        findings = [mixed_up(mission, result, str(path))]
    if findings:
        raise InputError(findings)
    return mission, result


def warn(findings: Iterable[Finding]) -> None:
    """Write findings that do not stop the work, one a line."""
    marked = [replace(item, message=f"warning: {item.message}") for item in findings]
    for line in told(marked):
        remark(" ".join(line.splitlines()))


def fitted(path: Path, result: Result, given: Path | None) -> tuple[Result, AnyMission]:
    """A plan, complete, or a trajectory, and its mission: the given one or one found beside it.

    Raises PlanError if there is none, or if the result is empty, impossible, or of another mission.
    """
    if isinstance(result, Plan):
        refuse_pathless(result, str(path))
    else:
        refuse_misfit(result, None, str(path))
    mission = any_mission_of(given) if given is not None else mission_beside(path, result)
    if mission is None:
        noun = "plan" if isinstance(result, Plan) else "trajectory"
        name = result.mission.name
        what = f"the mission of the {noun} ('{name}') is in no YAML file beside it"
        raise PlanError([Finding(what, "name its file with --mission MISSION", str(path))])
    if isinstance(result, Plan) and isinstance(mission, Mission):
        result = with_groups(result, mission)
        refuse_impossible(result, mission, str(path))
    elif isinstance(result, Trajectory) and isinstance(mission, SignalMission):
        refuse_misfit(result, mission, str(path))
    else:
        raise PlanError([mixed_up(mission, result, str(path))])
    return result, mission


def result_to_show(options: argparse.Namespace, what: str) -> tuple[Result, AnyMission]:
    """The plan or trajectory and the mission of a command that shows them and may write `what`."""
    result, mission = fitted(options.plan, load_result(options.plan), options.mission)
    refuse_place(options.output, what, [options.plan, *files_of(mission)])
    return result, mission


def executed_plan(path: Path | None, mission: Mission | None) -> Plan | None:
    """What really happened, from its file, which is one of a plan; None where none is given.

    Raises InputError for another file, and PlanError for one that does not fit the mission.
    """
    if path is None:
        return None
    result = load_result(path)
    if not isinstance(result, Plan):
        what = "what happened is told by a plan, and this is a trajectory"
        raise InputError([Finding(what, "give a file of a plan", str(path))])
    refuse_pathless(result, str(path))
    if mission is None:
        return result
    result = with_groups(result, mission)
    refuse_impossible(result, mission, str(path))
    return result


def mission_beside(path: Path, result: Result) -> AnyMission | None:
    """The mission of a plan or trajectory, found by its digest among the YAML files beside it."""
    for other in sorted([*path.parent.glob("*.yaml"), *path.parent.glob("*.yml")]):
        try:
            if digest_of(read_text(other, most=LARGEST_FILE)) == result.mission.sha256:
                return load_any_mission(other)
        except InputError:
            continue
    return None


def refuse_place(path: Path | None, what: str, inputs: Iterable[Path | None] = ()) -> None:
    """Say at once that a file could not be written, not after the search.

    A file that is read, under whatever name, is not written over.
    """
    if path is None:
        return
    try:
        why = _unwritable(path, inputs)
    except (OSError, ValueError) as error:  # a folder on the way that nobody may look into
        why = (error.strerror if isinstance(error, OSError) else None) or str(error)
    if why is not None:
        words = f"cannot write {what}: {why}"
        raise InputError([Finding(words, "choose another file", str(path))])


def _unwritable(path: Path, inputs: Iterable[Path | None]) -> str | None:
    """Why a file cannot be written, as far as is seen before; None if nothing speaks against it."""
    folder = path.resolve().parent
    if path.is_dir():
        return "this is a directory"
    if not folder.is_dir():
        return "its directory does not exist"
    if not os.access(path if path.exists() else folder, os.W_OK):
        return "no permission"
    if any(_same(path, other) for other in inputs):
        return "this file is read by the same command"
    return None


def _same(path: Path, other: Path | None) -> bool:
    """Whether two names are of one file, by links too; a device or a pipe may serve twice."""
    try:
        return other is not None and other.is_file() and path.samefile(other)
    except OSError:
        return False


def files_of(mission: AnyMission | None) -> list[Path]:
    """The files that a mission was read from: its own, and its map's."""
    if mission is None or mission.origin is None:
        return []
    own, data = Path(mission.origin.source), mission.origin.data
    named = data.get("map") if isinstance(data, dict) else None
    named = named.get("file") if isinstance(named, dict) and is_reference(named) else named
    return [own, own.parent / named] if isinstance(named, str) else [own]


def refuse_solver(name: str) -> None:
    """A misspelt solver is wrong usage; one that is missing or not licensed fails later."""
    from tsplan.milp.solver import SOLVERS  # noqa: PLC0415  (needs numpy and scipy)

    if name.partition(":")[0] not in SOLVERS:
        raise InputError([Finding(f"there is no solver '{name}'", nearest(name, SOLVERS))])
