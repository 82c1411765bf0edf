"""`tsplan show`: draw a map, a mission or a plan."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_of
from tsplan.draw.map import PlotUnavailableError, draw_map, draw_mission, draw_plan, pyplot
from tsplan.errors import Finding, InputError, PlanError
from tsplan.results.planfile import load_plan, write_whole

if TYPE_CHECKING:
    import argparse
    from pathlib import Path

    from tsplan.mission import Mission
    from tsplan.results.plan import Plan

_RESOLUTION = 150  # dots per inch


def run(asked: argparse.Namespace) -> Exit:
    """Draw the file and write the picture, or open a window."""
    plt = pyplot()
    if asked.output is not None:
        plt.switch_backend("Agg")
    elif plt.get_backend().lower() in {"agg", "pdf", "ps", "svg", "cairo", "template"}:
        raise PlotUnavailableError("there is no display to draw on; write a file with -o FILE.png")
    figure, _ = _drawn(asked)
    if asked.output is None:
        plt.show()
    else:
        _write(figure, asked.output)
    return Exit.DONE


def _drawn(asked: argparse.Namespace) -> tuple[Any, Any]:
    """The picture of whatever the file holds."""
    if _is_plan(asked.file):
        plan = load_plan(asked.file)
        if not plan.has_paths:
            what = f"a plan of status {plan.status} has no paths to draw"
            raise PlanError([Finding(what, "", str(asked.file))])
        mission = mission_of(asked.mission) if asked.mission else _beside(asked.file, plan)
        _refuse_stranger(asked.file, plan, mission)
        return draw_plan(plan, mission)
    from tsplan.document import read_document  # noqa: PLC0415  (plans do not need it)

    data = read_document(asked.file).data
    if isinstance(data, dict) and ("spec" in data or "format" in data):
        return draw_mission(mission_of(asked.file))
    from tsplan.ts.read import load_map  # noqa: PLC0415

    return draw_map(load_map(asked.file))


def _is_plan(path: Path) -> bool:
    """Whether a file is JSON, which maps and missions are not."""
    if path.suffix.lower() == ".json":
        return True
    try:
        with path.open(encoding="utf-8", errors="replace") as stream:
            return '"tsplan-plan/' in stream.read(1000)
    except OSError:
        return False  # the reader of missions says what is wrong


def _beside(path: Path, plan: Plan) -> Mission | None:
    """The mission of a plan, found by its digest among the YAML files beside it."""
    from tsplan.document import read_document  # noqa: PLC0415
    from tsplan.mission import load_mission  # noqa: PLC0415

    for other in sorted([*path.parent.glob("*.yaml"), *path.parent.glob("*.yml")]):
        try:
            if read_document(other).digest == plan.mission.sha256:
                return load_mission(other)
        except InputError:
            continue
    return None


def _refuse_stranger(path: Path, plan: Plan, mission: Mission | None) -> None:
    """A plan can only be drawn on a map that has its states."""
    if mission is None:
        return
    strange = [state for state in plan.states if state not in mission.system.states]
    if strange:
        what = f"the mission's map has no state '{strange[0]}'"
        raise PlanError([Finding(what, "name the mission that was planned", str(path))])


def _write(figure: Any, path: Path) -> None:
    kind = path.suffix.lstrip(".").lower() or "png"
    known = figure.canvas.get_supported_filetypes()
    if kind not in known:
        what = f"pictures cannot be written as '.{kind}'"
        raise InputError([Finding(what, "use .png, .svg or .pdf", str(path))])
    content = io.BytesIO()
    figure.savefig(content, format=kind, dpi=_RESOLUTION)
    write_whole(path, content.getvalue())
