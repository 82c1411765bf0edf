"""Pictures of a plan at any time: the map with its agents, beside it the formula ticking off.

What stays the same is painted once; for each picture the rest is painted on a copy of it.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw.canvas import POINTS, figure_class, halo, text_size
from tsplan.draw.edge_layout import Point
from tsplan.draw.map import DrawnMap, base, finish
from tsplan.draw.matplotlib_loading import lacking, library
from tsplan.draw.palette import Palette, classes_of
from tsplan.draw.tracks import tracks
from tsplan.explanation.why.stock_lines import stock_lines
from tsplan.mission import Mission
from tsplan.plans.cargo_rows import loads_of
from tsplan.plans.plan import Plan
from tsplan.plans.supplies import load_words
from tsplan.viewer.formula_rows import Part, formula_parts
from tsplan.viewer.freight import freight_point, freights, rebuildings
from tsplan.viewer.markers import Ground, Markers, markers
from tsplan.viewer.positions import slots_within, with_slots
from tsplan.viewer.status_panel import LegendLine, StatusPanel
from tsplan.words import visible

Pixels: TypeAlias = npt.NDArray[np.uint8]
Size: TypeAlias = tuple[int, int]

DOTS = 100  # per inch
MOST_COUNTED = 60
"""States up to which each one's agents are written beside it."""

_MARKERS = ("o", "s", "^", "D", "v", "h")
_SHARE = 0.66  # of the width, for the map
_SUPPLY, _SUPPLY_LINE = 7.5, 12.5  # points of letters, dots of a line
_INK = "#1b222c"
_WIDEST = 60  # dots around a state that single agents may take


class Film(ABC):
    """Pictures of one size: what stays, and on it what is painted for each time anew.

    `letters` are those that no font could draw. Raises PlotUnavailableError without matplotlib.
    """

    def __init__(self, size: Size) -> None:
        figure = figure_class()  # says what to install where matplotlib is missing
        self._figure = figure(figsize=(size[0] / DOTS, size[1] / DOTS), dpi=DOTS)
        self._canvas = library("backends.backend_agg").FigureCanvasAgg(self._figure)
        self._axes = self._ground_axes()
        self.letters: Mapping[str, None] = {}

    @abstractmethod
    def _ground_axes(self) -> Any:
        """The axes that things move on."""

    @abstractmethod
    def _moved(self, time: float) -> Iterator[Any]:
        """What is painted anew at a time."""

    def _beside(
        self, what: tuple[str, int], parts: Sequence[Part], legend: Sequence[LegendLine]
    ) -> None:
        """The panel of the formula, and then everything that stays is painted."""
        panel = StatusPanel(self._figure, what, _SHARE)
        panel.show(parts)
        panel.legend([*legend, *self._own_legend()])
        self._panel = panel
        with lacking() as self.letters:
            self._canvas.draw()

    def _keep(self) -> None:
        """Remember what is painted: it stays in every picture."""
        self._still = self._canvas.copy_from_bbox(self._figure.bbox)

    @property
    def size(self) -> Size:
        """Width and height in dots."""
        width, height = self._canvas.get_width_height()
        return int(width), int(height)

    def at(self, time: float) -> Pixels:
        """The picture at a time between 0 and the horizon: (height, width, 3)."""
        self._canvas.restore_region(self._still)
        for artist in self._moved(time):
            self._axes.draw_artist(artist)
        self._panel.paint(time)
        return np.asarray(self._canvas.buffer_rgba())[..., :3].copy()

    def _dots(self, points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
        """Points of the axes in dots of the figure."""
        found = self._axes.transData.transform(list(points)) if points else ()
        return [(float(x), float(y)) for x, y in found]

    def _own_legend(self) -> Iterator[LegendLine]:
        """What stands beside the axes otherwise: the panel has that place here."""
        legend = self._axes.get_legend()
        if legend is None:
            return
        legend.remove()
        for handle, text in zip(legend.legend_handles, legend.get_texts(), strict=True):
            words = text.get_text().replace(r"\$", "$")  # the panel reads no formulas of TeX
            if hasattr(handle, "get_facecolor"):
                colour, marker = handle.get_facecolor(), "s"
            elif handle.get_linestyle() == "None":  # a mark alone, or words alone
                colour, marker = handle.get_markeredgecolor(), handle.get_marker()
            else:
                colour, marker = handle.get_color(), "_"
            yield words, library("colors").to_hex(colour), marker


class Scene(Film):
    """Pictures of one plan.

    Raises PlotUnavailableError without matplotlib, and PlanError for a plan without paths or one
    that does not fit the mission's map.
    """

    def __init__(self, mission: Mission, plan: Plan, size: Size) -> None:
        refuse_misfit(plan, mission)
        super().__init__(size)
        self._tracks = with_slots(tracks(plan, mission, moving=True))
        colours = {name: paint.colour for name, paint in Palette.of(mission).classes.items()}
        self._looks = {
            name: (colour, _MARKERS[place % len(_MARKERS)])
            for place, (name, colour) in enumerate(colours.items())
        }
        drawn = base(Palette(mission.system), self._axes, ())
        finish(drawn, "")
        title = plan.mission.name or mission.system.name
        kinds = classes_of(mission).items()
        classes = [(kind.words(name), *self._looks[name]) for name, kind in kinds]
        self._beside((title, plan.horizon), formula_parts(mission, plan), classes)
        self.ground = self._ground(mission, drawn)
        self._marks = {name: self._mark(*look) for name, look in self._looks.items()}
        self._counts = self._count_texts() if len(mission.system.states) <= MOST_COUNTED else {}
        self._numbers: list[Any] = []
        self._stocks = stock_lines(plan, mission)
        carried = freights(self._tracks, loads_of(plan.cargo))
        self._freights = (*carried, *rebuildings(plan, mission))
        self._supplies: list[Any] = []
        self._keep()

    def _ground_axes(self) -> Any:
        return self._figure.add_axes((0.0, 0.07, _SHARE, 0.91))

    def _moved(self, time: float) -> Iterator[Any]:
        yield from self._changed(markers(self._tracks, self.ground, time))
        yield from self._supply_texts(time)

    def _ground(self, mission: Mission, drawn: DrawnMap) -> Ground:
        """The states in dots of the figure, and how large marks may be there."""
        at = dict(zip(drawn.where, self._dots(list(drawn.where.values())), strict=True))
        lengths = sorted(
            length
            for source, target in mission.system.edges
            if (length := math.dist(at[source], at[target])) > 0
        )
        room = lengths[len(lengths) // 4] if lengths else min(self.size) / 2
        radius = min(7.0, max(2.4, room * 0.09))
        for name, label in drawn.labels.items():
            if label.parts:  # agents stand below what is written on their state, but in its shape
                middle = drawn.frame.at(drawn.where[name]).imag
                written = max(middle - label.box.bottom, 0.0) * DOTS / POINTS
                shape = self._dots(mission.system.states[name].shape or ())
                floor = min((y for _, y in shape), default=-math.inf) + 1.3 * radius
                below = max(floor, at[name][1] - written - 1.6 * radius)
                at[name] = at[name][0], min(at[name][1], below)
        return Ground(at, radius, slots_within(min(room * 0.42, _WIDEST) / (2.35 * radius)))

    def _mark(self, colour: str, marker: str) -> Any:
        """All marks of one class."""
        page = library("transforms").IdentityTransform()
        edge = {"edgecolors": "white", "linewidths": 0.8, "animated": True, "zorder": 6}
        dots = (2 * self.ground.radius * POINTS / DOTS) ** 2
        made = self._axes.scatter(
            [], [], s=dots, color=colour, marker=marker, transform=page, **edge
        )
        made.set_offset_transform(page)
        return made

    def _count_texts(self) -> dict[str, Any]:
        """How many agents are at each state, below it."""
        below = self.ground.distance + self.ground.radius + 9
        return {
            name: self._text((x, y - below), 8.5, color=_INK, weight="bold")
            for name, (x, y) in self.ground.places.items()
        }

    def _text(self, at: tuple[float, float], size: float, **looks: Any) -> Any:
        looks |= {"ha": "center", "va": "center", "transform": None, "parse_math": False}
        return self._axes.text(*at, "", fontsize=size, animated=True, **looks)

    def _changed(self, shown: Markers) -> Iterator[Any]:
        """What is painted anew: marks, how many agents each state has, numbers by class."""
        for name, points in shown.marks.items():
            self._marks[name].set_offsets(points)
            yield self._marks[name]
        for name, agents in shown.counts.items():
            if name in self._counts:
                self._counts[name].set_text(str(agents))
                yield self._counts[name]
        kept = self._kept(self._numbers, len(shown.numbers), 1.9 * self.ground.radius, "white")
        for artist, (name, agents, at) in zip(kept, shown.numbers, strict=True):
            box = {"boxstyle": "round,pad=0.25", "color": self._looks[name][0], "linewidth": 0}
            artist.set(position=at, text=str(agents), bbox=box)
            yield artist

    def _kept(self, texts: list[Any], number: int, size: float, color: str) -> list[Any]:
        """So many texts, which are kept for the next pictures."""
        while len(texts) < number:
            texts.append(self._text((0, 0), max(6.0, size), color=color))
        return texts[:number]

    def supplied(self, time: float) -> list[tuple[str, Point]]:
        """What lies at the states, below how many agents are there, and what is on the way."""
        on_the_way = (freight for freight in self._freights if freight.share(time))
        moved, lines = [], Counter[str]()
        for freight in on_the_way:
            x, y = freight_point(freight, self.ground, time, _extent(freight.words))
            if freight.source == freight.target:  # one line below the other
                y -= _SUPPLY_LINE * lines[freight.source]
                lines[freight.source] += 1
            moved.append((freight.words, (x, y)))
        return [*(self._lying(time) if self._counts else ()), *moved]

    def _supply_texts(self, time: float) -> Iterator[Any]:
        """The same, to be painted anew."""
        shown = self.supplied(time)
        texts = self._kept(self._supplies, len(shown), _SUPPLY, _INK)
        for artist, (words, at) in zip(texts, shown, strict=True):
            artist.set(position=at, text=visible(words, "\n"), bbox=halo())
            yield artist

    def _lying(self, time: float) -> list[tuple[str, Point]]:
        """What lies at each state at a time, a line for each resource."""
        there: dict[str, list[str]] = {}
        for line in self._stocks:
            if amount := line.at(time):
                words = load_words({line.resource.name: amount})
                there.setdefault(line.state, []).append(words)
        below = self.ground.distance + self.ground.radius + 16
        return [
            ("\n".join(words), (x, y - below - _SUPPLY_LINE * len(words) / 2))
            for state, words in there.items()
            for x, y in [self.ground.places[state]]
        ]


def _extent(words: str) -> Size:
    """How wide and tall words about resources are, in dots."""
    across, tall = text_size(words, _SUPPLY)
    return round(across * DOTS / POINTS), round(tall * DOTS / POINTS)
