"""`tsplan show`: draw maps, missions, plans and trajectories, or say why a formula holds."""

from __future__ import annotations

import os
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, cast

from tsplan.checking.fitting import refuse_pathless
from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import (
    any_mission_of,
    executed_plan,
    files_of,
    fitted,
    mission_beside,
    refuse_place,
)
from tsplan.cli.output import remark, say
from tsplan.document.files import beginning
from tsplan.document.kinds import MISSION, SIGNALS, kind_of_data
from tsplan.draw.canvas import new_figure
from tsplan.draw.focus import Focus
from tsplan.draw.map import draw_map
from tsplan.draw.matplotlib_loading import PlotUnavailableError, library
from tsplan.draw.night import darkened
from tsplan.draw.picture_files import RESOLUTION, kind_of, save_picture
from tsplan.draw.starts import draw_mission
from tsplan.draw.timeline import draw_timeline
from tsplan.draw.trajectory_views import draw_trajectory
from tsplan.draw.views import PAGE, draw_page, draw_view
from tsplan.errors import Finding, InputError
from tsplan.explanation.why.trajectory_reasons import explain_wishes
from tsplan.explanation.why.witness_tree import explain_preferred
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.signals.result_check import load_result
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.ts.io.map_files import is_map, load_map, map_document

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator
    from pathlib import Path

    from tsplan.signals.result_check import AnyMission

_WINDOW = (10.0, 8.0)  # inches
_SCREENLESS = frozenset({"agg", "pdf", "ps", "svg", "cairo", "template"})


def run(options: argparse.Namespace) -> Exit:
    """Write the picture, print the reasons, or open a window."""
    reasons = _reasons(options) if options.why else None
    if options.output is not None:
        _save(options)
    if reasons is not None:
        say(reasons)
    elif options.output is None:
        with _own_backend():
            plt = _window()
            size = options.size or _WINDOW
            figure = plt.figure(figsize=size, dpi=options.dpi, layout="constrained")
            _painted(options, figure)
            plt.show()
    return Exit.DONE


@contextmanager
def _own_backend() -> Iterator[None]:
    """Let matplotlib choose a backend with windows; the environment's is not meant for us.

    A notebook leaves its own to every process it starts. Pictures in files need none at all.
    """
    former = os.environ.pop("MPLBACKEND", None)
    try:
        yield
    finally:
        if former is not None:
            os.environ["MPLBACKEND"] = former


def _save(options: argparse.Namespace) -> None:
    kind_of(options.output)
    _refuse_inputs(options, None)
    figure = None if options.size is None else new_figure(*options.size)
    dpi = options.dpi or RESOLUTION
    save_picture(_painted(options, figure), options.output, dpi=dpi, tell=remark)


def _painted(options: argparse.Namespace, figure: Any) -> Any:
    """The picture, light or dark."""
    drawn = _draw(options, figure)
    return darkened(drawn) if options.dark else drawn


def _refuse_inputs(options: argparse.Namespace, mission: AnyMission | None) -> None:
    """Do not draw over what is drawn."""
    inputs = [options.file, options.mission, options.executed, *files_of(mission)]
    refuse_place(options.output, "the picture", inputs)


def _reasons(options: argparse.Namespace) -> str:
    """Why a plan or a trajectory satisfies its formula, and what became of what is preferred."""
    if not _is_plan(options.file):
        what = "--why is about a plan, and this is none"
        raise InputError([Finding(what, "give the file that 'plan -o' wrote", str(options.file))])
    result, mission = fitted(options.file, load_result(options.file), options.mission)
    if isinstance(result, Plan) and isinstance(mission, Mission):
        tree, wishes = result.explain(mission), explain_preferred(result, mission)
    else:
        trajectory, signals = cast("Trajectory", result), cast("SignalMission", mission)
        tree, wishes = trajectory.explain(signals), explain_wishes(trajectory, signals)
    trees = [str(tree), *(f"preferred: {name}\n{tree}" for name, tree in wishes.items())]
    return "\n\n".join(trees)


def _window() -> Any:
    """Pyplot, if it can open a window."""
    plt = library("pyplot")
    if plt.get_backend().lower() in _SCREENLESS:
        raise PlotUnavailableError("there is no display to draw on; write a file with -o FILE.png")
    return plt


def _draw(options: argparse.Namespace, figure: Any) -> Any:
    """The picture of whatever the file holds, on a given figure or a new one."""
    ax = None if figure is None else figure.add_subplot()
    if _is_plan(options.file):
        return _draw_result(options, figure, ax)
    _refuse_focus(options, "none")
    kind = kind_of_data(map_document(options.file).data)
    if kind in (MISSION, SIGNALS):
        drawn = any_mission_of(options.file)
        _refuse_inputs(options, drawn)
        if isinstance(drawn, Mission):
            return draw_mission(drawn, ax)[0]
        return _draw_signals(None, drawn, options.view, figure)
    return draw_map(load_map(options.file), ax)[0]


def _draw_result(options: argparse.Namespace, figure: Any, ax: Any) -> Any:
    """A view of a plan or a trajectory; what can be seen without the mission where it is away."""
    result = load_result(options.file)
    lost = options.mission is None and mission_beside(options.file, result) is None
    if isinstance(result, Trajectory):
        _refuse_focus(options, "a trajectory")
    if lost and isinstance(result, Trajectory):
        return _draw_signals(result, None, options.view, figure)
    if lost and isinstance(result, Plan) and options.view in (None, "timeline"):
        refuse_pathless(result, str(options.file))
        return draw_timeline(result, None, ax, _focus(options, result, None))[0]
    result, mission = fitted(options.file, result, options.mission)
    _refuse_inputs(options, mission)
    if isinstance(mission, SignalMission):
        return _draw_signals(cast("Trajectory", result), mission, options.view, figure)
    plan, view = cast("Plan", result), options.view or PAGE
    focus = _focus(options, plan, mission)
    if view != PAGE:
        return draw_view(plan, mission, view, ax, focus)[0]
    if figure is not None:
        figure.clear()
    return draw_page(plan, mission, figure, focus)[0]


def _focus(options: argparse.Namespace, plan: Plan, mission: Mission | None) -> Focus:
    """What is looked at, as the options say."""
    executed = executed_plan(options.executed, mission)
    focus = Focus.of(options.step, options.agents, executed)
    focus.refuse_beyond(plan)
    return focus


def _refuse_focus(options: argparse.Namespace, what: str) -> None:
    """Options that are about plans of teams alone do not go unheeded."""
    given = {
        "--step": options.step is not None,
        "--agents": bool(options.agents),
        "--executed": options.executed is not None,
    }
    for name in (name for name, there in given.items() if there):
        words = f"{name} is about a plan, and this is {what}"
        raise InputError([Finding(words, "give the file that 'plan -o' wrote", str(options.file))])


def _draw_signals(
    trajectory: Trajectory | None, mission: SignalMission | None, view: str | None, figure: Any
) -> Any:
    """A view of a trajectory, or of what a mission asks for."""
    if figure is not None:
        figure.clear()
    return draw_trajectory(trajectory, mission, view or PAGE, on=figure)[0]


def _is_plan(path: Path) -> bool:
    """Whether a file is a plan or a trajectory, or broken JSON; maps may be in JSON, too."""
    text = beginning(path, 1000)
    marks = ('"tsplan-plan/', '"tsplan-trajectory/')
    if any(mark in text for mark in marks) or path.suffix.lower() != ".json":
        return any(mark in text for mark in marks)
    try:
        return not is_map(map_document(path))
    except InputError:
        return True
