"""How maps, formulas and plans show themselves in a notebook: the page's data as still SVG."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable
from itertools import chain

from tsplan.draw.palette import HUES, PLAIN, Paint
from tsplan.draw.step_axes import HALF
from tsplan.draw.text_placement import Box, Placement
from tsplan.draw.timeline import IDLE, keys_of, stay_reaches, way_reaches
from tsplan.draw.timeline_rows import path_rows, rows_of
from tsplan.draw.tracks import agents_of, tracks
from tsplan.logic.nodes import Formula
from tsplan.logic.text import operator_text
from tsplan.plans.plan import Plan
from tsplan.plans.summary import infinite_word, objective_line, outcome
from tsplan.ts import TransitionSystem
from tsplan.viewer import svg
from tsplan.viewer.page_data import Json, map_data
from tsplan.words import number

MOST_STATES = 3000
"""States of a map that is drawn; a larger one shows only its size."""

MOST_NODES = 150
"""Nodes of a formula that are drawn."""

MOST_ROWS = 40
"""Rows of a plan's timeline."""

_WIDTH = 640.0
_HIGHEST = 640.0
_MARGIN = 14.0
_LABELLED = 150  # states up to which names are written
_ROW = 18.0
_INDENT = 18.0
_DEEPEST = 25  # levels of a formula that are indented
_SMALL = 9.0


def map_svg(system: TransitionSystem) -> str:
    """A map: shapes, edges, states, and names where they fit."""
    title = f"{system.name or 'map'}: {len(system.states):,} states, {len(system.edges):,} edges"
    if len(system.states) > MOST_STATES:
        return svg.picture([svg.text(title, 8, 18)], svg.width_of(title) + 16, 28, title)
    sheet = _Sheet(map_data(system))
    parts = [*_shapes(sheet), _edges(sheet), *_dots(sheet), *_names(sheet)]
    return svg.picture(parts, sheet.width, sheet.height, title)


class _Sheet:
    """A map fitted into a picture; upwards is upwards."""

    def __init__(self, data: Json) -> None:
        self.edges, self.states = data["edges"], data["states"]
        self.named = len(self.states) <= _LABELLED
        corners = chain.from_iterable(state["shape"] or () for state in self.states)
        xs, ys = zip(*((s["x"], s["y"]) for s in self.states), *corners, strict=True)
        self._left, self._top = min(xs), max(ys)
        across, up = max(xs) - self._left, self._top - min(ys)
        free = (_WIDTH - 2 * _MARGIN, _HIGHEST - 2 * _MARGIN)
        self._scale = min(free[0] / (across or 1.0), free[1] / (up or 1.0)) if across or up else 1.0
        self.width = max(across * self._scale + 2 * _MARGIN, 160.0)
        self.height = up * self._scale + 2 * _MARGIN + _SMALL

    def at(self, x: float, y: float) -> tuple[float, float]:
        """A point of the map in pixels."""
        return _MARGIN + (x - self._left) * self._scale, _MARGIN + (self._top - y) * self._scale

    def line(self, points: list[tuple[float, float]]) -> str:
        """The path through some points of the map."""
        return "M" + "L".join("{:.1f} {:.1f}".format(*self.at(*point)) for point in points)


def _paint(state: Json) -> Paint:
    return Paint(state["color"] or PLAIN.colour)


def _shapes(sheet: _Sheet) -> list[str]:
    """All shapes of one colour as one path."""
    by_colour: dict[str, list[str]] = defaultdict(list)
    for state in sheet.states:
        if state["shape"]:
            by_colour[_paint(state).pale].append(sheet.line(state["shape"]) + "Z")
    return [
        svg.element("path", d="".join(paths), fill=fill, stroke="#b0b0b0", stroke_width=0.7)
        for fill, paths in by_colour.items()
    ]


def _edges(sheet: _Sheet) -> str:
    ends = ((sheet.states[edge["from"]], sheet.states[edge["to"]]) for edge in sheet.edges)
    lines = [sheet.line([(a["x"], a["y"]), (b["x"], b["y"])]) for a, b in ends]
    width = 0.8 if sheet.named else 0.4
    return svg.element("path", d="".join(lines), stroke="#8c8c8c", stroke_width=width, fill="none")


def _dots(sheet: _Sheet) -> list[str]:
    radius = 3.5 if sheet.named else 1.5
    border = {"stroke": "#333333", "stroke_width": 0.5}
    return [
        svg.element("circle", cx=x, cy=y, r=radius, fill=_paint(state).colour, **border)
        for state in sheet.states
        if not state["shape"]
        for x, y in [sheet.at(state["x"], state["y"])]
    ]


def _names(sheet: _Sheet) -> list[str]:
    """Names, below the dots or in the shapes, each where it hides no other."""
    taken = Placement(Box(0.0, -math.inf, sheet.width, math.inf))
    halo = {"paint_order": "stroke", "stroke": "#ffffff", "stroke_width": 2}
    found = []
    for state in sheet.states if sheet.named else ():
        name, (x, y) = state["name"], sheet.at(state["x"], state["y"])
        y += _SMALL / 3 if state["shape"] else _SMALL + 3.5
        half = svg.width_of(name, _SMALL) / 2
        x = min(max(x, half), sheet.width - half)
        box = Box(x - half, y - _SMALL, x + half, y + 2)
        if taken.free(box):
            taken.take(box)
            found.append(svg.text(name, x, y, _SMALL, text_anchor="middle", **halo))
    return found


def formula_svg(formula: Formula) -> str:
    """A formula as a tree: one node a line, each below the one it belongs to."""
    rows: list[tuple[int, str, int]] = []  # level, words, row of the parent
    waiting = [(formula, 0, 0)]
    while waiting and len(rows) < MOST_NODES:
        node, level, parent = waiting.pop()
        rows.append((min(level, _DEEPEST), operator_text(node), parent))
        here = len(rows) - 1
        waiting += [(child, level + 1, here) for child in reversed(node.children)]
    if waiting:
        rows.append((0, "... and more", len(rows)))
    parts = []
    for place, (level, content, parent) in enumerate(rows):
        x, y = 10 + level * _INDENT, place * _ROW + 14
        if level:
            over, up = 10 + rows[parent][0] * _INDENT, parent * _ROW + 14
            d = f"M{over:.0f} {up + 4:.0f}V{y:.0f}H{x - 4:.0f}"
            parts.append(svg.element("path", d=d, stroke="#999999", stroke_width=1, fill="none"))
        parts.append(svg.element("circle", cx=x, cy=y, r=3.2, fill=HUES[level % 2]))
        parts.append(svg.text(content, x + 8, y + 4))
    width = max(10 + level * _INDENT + 20 + svg.width_of(content) for level, content, _ in rows)
    return svg.picture(parts, width, len(rows) * _ROW + 10, "formula")


def plan_html(plan: Plan) -> str:
    """A plan: what is known about it, and who is where when."""
    endless = infinite_word(plan)
    facts = [("mission", plan.mission.name or "mission"), ("outcome", outcome(plan))]
    facts += [("objective", objective_line(item, endless)) for item in plan.objective]
    if plan.has_paths and all(item.name != "availability" for item in plan.objective):
        facts.append(("availability", number(plan.availability, endless)))
    facts.append(("horizon", f"{plan.horizon} steps, {len(plan.agents):,} agents"))
    facts += [("note", note) for note in plan.notes]
    drawn = timeline_svg(plan) if plan.agents else ""
    return svg.element("div", facts_table(facts) + drawn)


def facts_table(facts: Iterable[tuple[str, str]]) -> str:
    """A table of two columns: what a fact is about, and what is known."""
    left = {"style": "text-align:left"}
    lines = (
        svg.element("th", svg.words(name), **left) + svg.element("td", svg.words(value), **left)
        for name, value in facts
    )
    table = svg.element("tbody", "".join(svg.element("tr", line) for line in lines))
    return svg.element("table", table)


def timeline_svg(plan: Plan) -> str:
    """A row for each agent, or for each path of a large team: states by colour, ways hatched."""
    moving = tracks(plan, modules=True)
    rows = rows_of(plan, moving) or path_rows(moving)
    shown, hidden = rows[:MOST_ROWS], rows[MOST_ROWS:]
    keys = keys_of(moving, plan.horizon, None)
    left = max(svg.width_of(row.name) for row in shown) + 12
    step = (_WIDTH - left - 10) / (plan.horizon + 1)
    parts = [svg.stripes()]
    for place, row in enumerate(shown):
        y = 8 + place * _ROW
        parts.append(svg.text(row.name, left - 6, y + 12, text_anchor="end"))
        for begin, end in way_reaches(row, plan.horizon):
            place_on = (left + (begin + HALF) * step, y, (end - begin) * step)
            parts.append(_bar(place_on, "", fill="url(#tsplan-way)"))
        for state, (begin, end) in stay_reaches(row, plan.horizon):
            place_on = (left + (begin + HALF) * step, y, (end - begin) * step)
            parts += _stay(place_on, state, keys.get(state, IDLE).paint)
    bottom = 8 + len(shown) * _ROW
    parts += step_numbers(plan.horizon, left, step, bottom)
    if hidden:
        words = f"... and {agents_of(hidden):,} agents on {len(hidden):,} more paths"
        parts.append(svg.text(words, 8, bottom + 32))
    return svg.picture(
        parts, _WIDTH, bottom + (40 if hidden else 22), f"{plan.mission.name}: who is where"
    )


def _bar(at: tuple[float, float, float], content: str, **looks: object) -> str:
    """A bar from its left upper corner, so many pixels long."""
    x, y, width = at
    return svg.element("rect", content, x=x, y=y, width=width, height=_ROW - 3, **looks)


def _stay(at: tuple[float, float, float], state: str, paint: Paint) -> list[str]:
    """A bar with its state's name: written on it if there is room, shown when it is pointed at."""
    x, y, width = at
    title = svg.element("title", svg.words(state))
    bar = _bar(at, title, fill=paint.colour, stroke="#ffffff", stroke_width=0.8)
    if svg.width_of(state, _SMALL) + 4 > width:
        return [bar]
    style = {"text_anchor": "middle", "fill": paint.ink, "pointer_events": "none"}
    return [bar, svg.text(state, x + width / 2, y + 11, _SMALL, **style)]


def step_numbers(horizon: int, left: float, step: float, y: float) -> list[str]:
    """Numbers of steps below the rows, as many as there is room for."""
    wide = svg.width_of(str(horizon), _SMALL) + 10
    every = next(n * 10**p for p in range(8) for n in (1, 2, 5) if n * 10**p * step >= wide)
    return [
        svg.text(str(number), left + (number + 0.5) * step, y + 10, _SMALL, text_anchor="middle")
        for number in range(0, horizon + 1, every)
    ]
