"""Putting a plan's page where a person sees it."""

from __future__ import annotations

import os
import re
import tempfile
import webbrowser
from pathlib import Path

from tsplan.document.files import write_whole
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.viewer.webpage import page


def write_page(mission: Mission, plan: Plan, path: Path | None = None) -> Path:
    """Write the page of a plan, to a new temporary file unless a path is given; return its path.

    A temporary file is left for the browser, which reads it at a time of its own.
    """
    content = page(mission, plan).encode()
    if path is None:
        stem = re.sub(r"[^\w-]+", "-", plan.mission.name)[:40].strip("-") or "plan"
        handle, name = tempfile.mkstemp(prefix=f"tsplan-{stem}-", suffix=".html")
        os.close(handle)
        path = Path(name)
    write_whole(path, content)
    return path


def show_page(mission: Mission, plan: Plan, path: Path | None = None) -> Path:
    """Write the page of a plan and return its path; without a given one, open it too."""
    written = write_page(mission, plan, path)
    if path is None:
        open_page(written)
    return written


def open_page(path: Path) -> bool:
    """Show a page in the person's browser; False if there is none to be found."""
    try:
        return webbrowser.open(path.resolve().as_uri())
    except webbrowser.Error:
        return False
