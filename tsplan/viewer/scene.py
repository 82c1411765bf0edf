"""Pictures of a plan at any time: the map with its agents, beside it the formula ticking off.

What stays the same is painted once; for each picture the rest is painted on a copy of it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw.canvas import POINTS, figure_class
from tsplan.draw.map import Scene as MapScene
from tsplan.draw.map import base, finish
from tsplan.draw.matplotlib_loading import lacking, library
from tsplan.draw.palette import Palette
from tsplan.viewer.formula_rows import formula_parts
from tsplan.viewer.markers import Ground, Picture, picture
from tsplan.viewer.page_data import class_colors
from tsplan.viewer.positions import slots_within
from tsplan.viewer.status_panel import StatusPanel
from tsplan.viewer.tracks import movers

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

Pixels: TypeAlias = npt.NDArray[np.uint8]
Size: TypeAlias = tuple[int, int]

DOTS = 100  # per inch
MOST_COUNTED = 60
"""States up to which each one's agents are written beside it."""

_MARKERS = ("o", "s", "^", "D", "v", "h")
_SHARE = 0.66  # of the width, for the map
_WIDEST = 60  # dots around a state that single agents may take


@dataclass(frozen=True)
class _Artists:
    """What is painted anew for every picture."""

    marks: dict[str, Any]
    counts: dict[str, Any]
    numbers: list[Any]


class Scene:
    """Pictures of one plan, all of one size; `letters` are those that no font could draw.

    Raises PlotUnavailableError without matplotlib, and PlanError for a plan without paths or one
    that does not fit the mission's map.
    """

    def __init__(self, mission: Mission, plan: Plan, size: Size) -> None:
        refuse_misfit(plan, mission)
        figure = figure_class()  # says what to install where matplotlib is missing

        self._figure = figure(figsize=(size[0] / DOTS, size[1] / DOTS), dpi=DOTS)
        self._canvas = library("backends.backend_agg").FigureCanvasAgg(self._figure)
        self._movers = movers(mission, plan)
        self._colors = class_colors(mission)
        self._axes = self._figure.add_axes((0.0, 0.07, _SHARE, 0.91))
        ground = base(Palette(mission.system), self._axes, ())
        finish(ground)
        title = plan.mission.name or mission.system.name
        self._panel = StatusPanel(self._figure, (title, plan.horizon), _SHARE)
        self._panel.show(formula_parts(mission, plan))
        self._panel.legend([*self._legend(mission), *self._map_legend()])
        with lacking() as self.letters:
            self._canvas.draw()
        self.ground = self._ground(mission, ground)
        self._artists = self._made(mission)
        self._still = self._canvas.copy_from_bbox(self._figure.bbox)

    @property
    def size(self) -> Size:
        """Width and height in dots."""
        width, height = self._canvas.get_width_height()
        return int(width), int(height)

    def at(self, time: float) -> Pixels:
        """The picture at a time between 0 and the horizon: (height, width, 3)."""
        self._canvas.restore_region(self._still)
        shown = picture(self._movers, self.ground, time)
        for artist in [*self._marks(shown), *self._counts(shown), *self._numbers(shown)]:
            self._axes.draw_artist(artist)
        self._panel.paint(time)
        return np.asarray(self._canvas.buffer_rgba())[..., :3].copy()

    def _ground(self, mission: Mission, drawn: MapScene) -> Ground:
        """The states in dots of the figure, and how large marks may be there."""
        names = list(drawn.where)
        points = self._axes.transData.transform([drawn.where[name] for name in names])
        at = {name: (float(x), float(y)) for name, (x, y) in zip(names, points, strict=True)}
        lengths = sorted(
            length
            for source, target in mission.system.edges
            if (length := math.dist(at[source], at[target])) > 0
        )
        room = lengths[len(lengths) // 4] if lengths else min(self.size) / 2
        radius = min(7.0, max(2.4, room * 0.09))
        for name, sign in drawn.signs.items():
            if sign.parts:  # agents stand below what is written on their state, but in its shape
                middle = drawn.frame.at(drawn.where[name])[1]
                written = max(middle - sign.box.bottom, 0.0) * DOTS / POINTS
                floor = self._floor(mission.system.states[name].shape) + 1.3 * radius
                below = max(floor, at[name][1] - written - 1.6 * radius)
                at[name] = at[name][0], min(at[name][1], below)
        return Ground(at, radius, slots_within(min(room * 0.42, _WIDEST) / (2.35 * radius)))

    def _floor(self, shape: Sequence[tuple[float, float]] | None) -> float:
        """The lowest dot of a shape; without one there is no floor."""
        if not shape:
            return -math.inf
        return float(self._axes.transData.transform(list(shape))[:, 1].min())

    def _legend(self, mission: Mission) -> list[tuple[str, str, str]]:
        agents = dict.fromkeys(self._colors, 0)
        for group in mission.team:
            agents[group.class_name] += group.count
        return [
            (f"{agents[name]:,} {name}", color, _MARKERS[place % len(_MARKERS)])
            for place, (name, color) in enumerate(self._colors.items())
        ]

    def _map_legend(self) -> list[tuple[str, str, str]]:
        """What stands beside the map otherwise: the panel has that place here."""
        legend = self._axes.get_legend()
        if legend is None:
            return []
        legend.remove()
        found = []
        for handle, text in zip(legend.legend_handles, legend.get_texts(), strict=True):
            area = hasattr(handle, "get_facecolor")
            color = handle.get_facecolor() if area else handle.get_color()
            words = text.get_text().replace(r"\$", "$")  # the panel reads no formulas of TeX
            found.append((words, library("colors").to_hex(color), "s" if area else "_"))
        return found

    def _made(self, mission: Mission) -> _Artists:
        dots = (2 * self.ground.radius * 72 / DOTS) ** 2
        marks = {
            name: self._axes.scatter(
                [],
                [],
                s=dots,
                color=color,
                marker=_MARKERS[place % len(_MARKERS)],
                edgecolors="white",
                linewidths=0.8,
                transform=library("transforms").IdentityTransform(),
                animated=True,
                zorder=6,
            )
            for place, (name, color) in enumerate(self._colors.items())
        }
        for scatter in marks.values():
            scatter.set_offset_transform(library("transforms").IdentityTransform())
        counts = {}
        if len(mission.system.states) <= MOST_COUNTED:
            below = -(self.ground.distance + self.ground.radius + 9)
            counts = {
                name: self._text((x, y + below), 8.5, color="#1b222c", weight="bold")
                for name, (x, y) in self.ground.places.items()
            }
        return _Artists(marks, counts, [])

    def _text(self, at: tuple[float, float], size: float, **looks: Any) -> Any:
        return self._axes.text(
            *at,
            "",
            fontsize=size,
            ha="center",
            va="center",
            transform=None,
            animated=True,
            parse_math=False,
            **looks,
        )

    def _marks(self, shown: Picture) -> list[Any]:
        drawn = []
        for name, points in shown.marks.items():
            artist = self._artists.marks[name]
            artist.set_offsets(points)
            drawn.append(artist)
        return drawn

    def _counts(self, shown: Picture) -> list[Any]:
        """How many agents are at each state that has some."""
        drawn = []
        for name, agents in shown.counts.items():
            artist = self._artists.counts.get(name)
            if artist is not None:
                artist.set_text(str(agents))
                drawn.append(artist)
        return drawn

    def _numbers(self, shown: Picture) -> list[Any]:
        """Numbers in the colour of their class; the texts are kept for the next pictures."""
        kept = self._artists.numbers
        while len(kept) < len(shown.numbers):
            kept.append(self._text((0, 0), max(6.0, 1.9 * self.ground.radius), color="white"))
        for artist, (name, agents, at) in zip(kept, shown.numbers, strict=False):
            artist.set_position(at)
            artist.set_text(str(agents))
            artist.set_bbox(
                {"boxstyle": "round,pad=0.25", "color": self._colors[name], "linewidth": 0}
            )
        return kept[: len(shown.numbers)]
