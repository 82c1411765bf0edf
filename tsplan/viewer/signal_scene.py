"""Pictures of a trajectory at any time: the plane with its moving points, or the signals.

Where there is no plane, a line moves over the signals.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tsplan.draw.canvas import WHITE
from tsplan.draw.palette import paints
from tsplan.draw.plane_map import draw_plane, paths_of, plane_of
from tsplan.draw.signal_chart import draw_signals
from tsplan.signals.motion_check import refuse_misfit
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.viewer.scene import Film, Size
from tsplan.viewer.signal_page import signal_parts

_PLACE = (0.07, 0.13, 0.56, 0.8)  # of the axes, as shares of the picture
_MARK = 9.0  # points across
_TIME = "#0b62c4"


class SignalScene(Film):
    """Pictures of one trajectory.

    Raises PlotUnavailableError without matplotlib, and PlanError for a trajectory without signals
    or of another mission.
    """

    def __init__(self, mission: SignalMission, trajectory: Trajectory, size: Size) -> None:
        refuse_misfit(trajectory, mission)
        super().__init__(size)
        self._paths = {}
        if len(trajectory.signals) > 1:
            plane = plane_of(trajectory, mission)
            self._paths = paths_of(trajectory, mission, plane)
            draw_plane(trajectory, mission, plane, self._axes)
        else:
            draw_signals(trajectory, mission, trajectory.signals, self._axes)
        self._axes.set_title("", loc="left")
        title = trajectory.mission.name or mission.name
        parts = signal_parts(mission, trajectory, (), ("", ""))
        self._beside((title, trajectory.horizon), parts, ())
        colours = paints(self._paths)
        look = {"marker": "o", "markersize": _MARK, "markeredgecolor": WHITE, "animated": True}
        self._marks = {
            name: self._axes.plot([], [], color=colours[name].colour, zorder=7, **look)[0]
            for name in self._paths
        }
        self._line = self._axes.axvline(0, color=_TIME, linewidth=1.5, animated=True)
        self._keep()

    def _ground_axes(self) -> Any:
        return self._figure.add_axes(_PLACE)

    def _moved(self, time: float) -> Iterator[Any]:
        for name, path in self._paths.items():
            steps = np.arange(path.shape[1])
            x, y = (float(np.interp(time, steps, row)) for row in path)
            self._marks[name].set_data([x], [y])
            yield self._marks[name]
        if not self._paths:
            self._line.set_xdata([time, time])
            yield self._line
