"""Putting a plan's page where a person sees it."""

from __future__ import annotations

import os
import re
import tempfile
import webbrowser
from pathlib import Path

from tsplan.document.files import write_whole
from tsplan.draw.focus import Focus
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.viewer.webpage import page


def write_page(
    mission: Mission | SignalMission,
    result: Plan | Trajectory,
    path: Path | None = None,
    executed: Plan | None = None,
) -> Path:
    """Write the page of a plan or a trajectory; return its path.

    Unless a path is given it is a new temporary file, which is left for the browser: that
    reads it at a time of its own.
    """
    content = page(mission, result, executed).encode()
    if path is None:
        stem = re.sub(r"[^\w-]+", "-", result.mission.name)[:40].strip("-") or "plan"
        handle, name = tempfile.mkstemp(prefix=f"tsplan-{stem}-", suffix=".html")
        os.close(handle)
        path = Path(name)
    write_whole(path, content)
    return path


def show_page(
    mission: Mission | SignalMission,
    result: Plan | Trajectory,
    path: Path | None = None,
    *,
    executed: Plan | None = None,
    step: float | None = None,
) -> Path:
    """Write the page and return its path; without a given one, open it too, at a step.

    What really happened may be shown beside the plan, as another plan of its mission.
    """
    if step is not None and isinstance(result, Plan):
        Focus(step, (), executed).refuse_beyond(result)
    written = write_page(mission, result, path, executed)
    if path is None:
        open_page(written, step)
    return written


def page_link(path: Path, step: float | None = None) -> str:
    """The address of a page, at a step.

    >>> page_link(Path("/tmp/plan.html"), 12)
    'file:///tmp/plan.html#step=12'
    """
    return path.resolve().as_uri() + ("" if step is None else f"#step={step:g}")


def open_page(path: Path, step: float | None = None) -> bool:
    """Show a page in the person's browser, at a step; False if there is none to be found."""
    try:
        return webbrowser.open(page_link(path, step))
    except webbrowser.Error:
        return False
