"""The views of a trajectory by name, and all of them on one page."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tsplan.draw.canvas import Picture, new_figure
from tsplan.draw.plane_map import draw_plane, plane_of
from tsplan.draw.plane_map import height_of as plane_height
from tsplan.draw.signal_chart import MOST_PANELS, draw_panels, draw_signals, panels_of, title_of
from tsplan.draw.signal_chart import height_of as chart_height
from tsplan.draw.views import PAGE, WIDTH
from tsplan.errors import Finding, InputError, nearest
from tsplan.signals.motion_check import refuse_misfit
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory

TRAJECTORY_VIEWS = ("signals", "plane", PAGE)
"""Every picture of a trajectory."""


def draw_trajectory(
    trajectory: Trajectory | None,
    mission: SignalMission | None = None,
    view: str = "",
    names: Sequence[str] = (),
    ax: Any = None,
    *,
    on: Any = None,
) -> Picture:
    """One of the `TRAJECTORY_VIEWS`: signals over time unless named.

    Without a trajectory there is what the mission asks for. `names` are the signals to show, in a
    plane two of them. A given `ax` is drawn on, or a whole empty figure, `on`. Raises InputError
    for unknown views and names, and PlanError for a trajectory without signals or of another
    mission.
    """
    if trajectory is not None:
        refuse_misfit(trajectory, mission)
    view = view or "signals"
    if view not in TRAJECTORY_VIEWS:
        found = Finding(f"there is no view '{view}' of signals", nearest(view, TRAJECTORY_VIEWS))
        raise InputError([found])
    if view == "plane":
        across, up = names or plane_of(trajectory, mission)
        ax = on.add_subplot() if on is not None else ax
        return draw_plane(trajectory, mission, (across, up), ax)
    if view == PAGE:
        return draw_signal_page(trajectory, mission, on)
    return draw_signals(trajectory, mission, names, ax, on=on)


def draw_signal_page(
    trajectory: Trajectory | None, mission: SignalMission | None, figure: Any = None
) -> tuple[Any, tuple[Any, ...]]:
    """The plane, where there are two signals, above the signals over time; figure and axes.

    A given `figure` is drawn on as it is.
    """
    if trajectory is not None:
        refuse_misfit(trajectory, mission)
    panels = panels_of(trajectory, mission)[:MOST_PANELS]
    system = mission.system.signals if mission is not None else {}
    several = len(trajectory.signals if trajectory is not None else system) > 1
    heights = [plane_height(trajectory, mission)] if several else []
    heights.append(chart_height(panels))
    whole = figure if figure is not None else new_figure(WIDTH, sum(heights))
    parts = whole.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0]
    every = []
    if several:
        every.append(draw_plane(trajectory, mission, None, parts[0].add_subplot())[1])
    every += draw_panels(parts[-1], panels, title_of(trajectory, mission))[1]
    return whole, tuple(every)
