"""`tsplan show`: draw a map, a mission or a plan, or say why a plan satisfies its formula."""

from __future__ import annotations

import os
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from tsplan.checking.fitting import refuse_pathless
from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import files_of, fitted, mission_beside, mission_of, refuse_place
from tsplan.cli.output import remark, say
from tsplan.document import read_document
from tsplan.document.files import beginning
from tsplan.document.kinds import MISSION, kind_of_data
from tsplan.draw.map import draw_map
from tsplan.draw.matplotlib_loading import PlotUnavailableError, library
from tsplan.draw.picture_files import kind_of, save
from tsplan.draw.starts import draw_mission
from tsplan.draw.timeline import draw_timeline
from tsplan.draw.views import PAGE, draw_page, draw_view
from tsplan.errors import Finding, InputError
from tsplan.explanation.why.witness_tree import explain_preferred
from tsplan.plans.plan_file import load_plan
from tsplan.ts.io.map_files import load_map

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator
    from pathlib import Path

    from tsplan.mission import Mission

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
            _draw(options, plt.figure(figsize=(10, 8), layout="constrained"))
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
    save(_draw(options, None), options.output, tell=remark)


def _refuse_inputs(options: argparse.Namespace, mission: Mission | None) -> None:
    """Do not draw over what is drawn."""
    inputs = [options.file, options.mission, *files_of(mission)]
    refuse_place(options.output, "the picture", inputs)


def _reasons(options: argparse.Namespace) -> str:
    """Why the plan satisfies its formula, and what became of what is preferred."""
    if not _is_plan(options.file):
        what = "--why is about a plan, and this is none"
        raise InputError([Finding(what, "give the file that 'plan -o' wrote", str(options.file))])
    plan, mission = fitted(options.file, load_plan(options.file), options.mission)
    trees = [str(plan.explain(mission))]
    for name, tree in explain_preferred(plan, mission).items():
        trees.append(f"preferred: {name}\n{tree}")
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
        return _draw_plan(options, figure, ax)
    if kind_of_data(read_document(options.file).data) == MISSION:
        drawn = mission_of(options.file)
        _refuse_inputs(options, drawn)
        return draw_mission(drawn, ax)[0]
    return draw_map(load_map(options.file), ax)[0]


def _draw_plan(options: argparse.Namespace, figure: Any, ax: Any) -> Any:
    """A view of a plan; without its mission, the timeline, which needs no map."""
    plan = load_plan(options.file)
    refuse_pathless(plan, str(options.file))
    alone = options.view in (None, "timeline") and options.mission is None
    if alone and mission_beside(options.file, plan) is None:
        return draw_timeline(plan, None, ax)[0]
    plan, mission = fitted(options.file, plan, options.mission)
    _refuse_inputs(options, mission)
    view = options.view or PAGE
    if view != PAGE:
        return draw_view(plan, mission, view, ax)[0]
    if figure is not None:
        figure.clear()
    return draw_page(plan, mission, figure)[0]


def _is_plan(path: Path) -> bool:
    """Whether a file is JSON, which maps and missions are not."""
    return '"tsplan-plan/' in beginning(path, 1000) or path.suffix.lower() == ".json"
