"""Where everybody is at one moment: badges at the states, and on the ways between them.

What is carried stands beside those who carry it, and what lies at a state is written there.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

from tsplan.draw import canvas
from tsplan.draw.badges import BADGE, Badge, draw_badge, draw_badges, place_badge
from tsplan.draw.canvas import DARK, SMALL, WHITE
from tsplan.draw.map import DrawnMap
from tsplan.draw.palette import Paint
from tsplan.draw.starts import write_stocks
from tsplan.draw.step_axes import DWELL
from tsplan.draw.text_placement import Box, direction
from tsplan.draw.tracks import Track
from tsplan.explanation.why.stock_lines import StockLine
from tsplan.plans.cargo_rows import AgentLoads
from tsplan.plans.supplies import Loads, load_words, together

_WHITE = Paint(WHITE)
_MOST_BADGES = 5  # at one state; of more there is one with all agents
_ASIDE = (0.75, 1.75, -0.75, 2.75, -1.75)  # of a badge, from the middle of the way to its right
_SHIFTS = (0.0, -0.06, 0.06, -0.12, 0.12)  # of the way, where others are in the way
_DOT = 10.0  # square points of those who are on the way where there is no room for badges

PaintOf: TypeAlias = Callable[[Track], Paint]


class Way(NamedTuple):
    """From a state to another, so much of the way done; who paints it."""

    source: str
    target: str
    share: float
    paint: Paint


class Moment(NamedTuple):
    """Who is where: agents by state and paint, and by way; what is carried along each way."""

    staying: Mapping[str, Counter[Paint]]
    travelling: Counter[Way]
    loads: Mapping[Way, Loads]


def moment_of(found: Sequence[Track], step: float, paint_of: PaintOf, loads: AgentLoads) -> Moment:
    """Who is where at a moment, which may lie between two steps; a structure counts once."""
    staying: dict[str, Counter[Paint]] = {}
    travelling: Counter[Way] = Counter()
    carried: dict[Way, Loads] = {}
    for track in found:
        if not track.present(step):
            continue
        where, paint = track.at(step, DWELL), paint_of(track)
        if not where.share:
            staying.setdefault(where.source.state, Counter())[paint] += track.count
            continue
        way = Way(where.source.state, where.target.state, where.share, paint)
        travelling[way] += track.count
        if own := track.load(where.source.last, loads):
            carried[way] = together([carried.get(way, {}), own])
    return Moment(staying, travelling, carried)


def draw_moment(drawn: DrawnMap, moment: Moment, stocks: Sequence[StockLine], step: float) -> None:
    """Badges with numbers, or rings and dots without room for them; what lies and is carried."""
    rows = {state: _row(there) for state, there in moment.staying.items()}
    draw_badges(drawn, rows, "agents")
    _draw_travelling(drawn, moment)
    near = round(step)
    time = near if abs(step - near) <= DWELL else step  # so long nobody has set out with anything
    there: dict[str, Loads] = {}
    for line in stocks:
        if amount := line.at(time):
            there.setdefault(line.state, {})[line.resource.name] = amount
    write_stocks(drawn, there, "stock")


def _row(there: Counter[Paint]) -> list[Badge]:
    if len(there) > _MOST_BADGES:
        return [Badge(there.total(), _WHITE)]
    return [Badge(count, paint) for paint, count in there.items()]


def _draw_travelling(drawn: DrawnMap, moment: Moment) -> None:
    small: list[Way] = []
    for way, count in moment.travelling.items():
        centre = None if drawn.dense else place_badge(drawn, _beside(drawn, way))
        if centre is None:
            small.append(way)
            continue
        draw_badge(drawn, centre, Badge(count, way.paint), "on the way")
        if load := moment.loads.get(way):
            _write_load(drawn, centre, load_words(load, "\n"))
    if small:
        points = [drawn.frame.back(next(_beside(drawn, way))) for way in small]
        style = {"c": [way.paint.colour for way in small], "edgecolors": DARK, "linewidths": 0.5}
        xs, ys = zip(*points, strict=True)
        drawn.ax.scatter(xs, ys, s=_DOT, zorder=7, gid="on the way", **style)


def _beside(drawn: DrawnMap, way: Way) -> Iterator[complex]:
    """Places for those on a way: on its right, there first where they are."""
    start, goal = map(drawn.frame.at, drawn.line(way.source, way.target))
    side = -1j * direction(goal - start) * BADGE
    for more in _ASIDE:
        for shift in _SHIFTS:
            share = min(max(way.share + shift, 0.0), 1.0)
            yield start + (goal - start) * share + side * (0.0 if drawn.dense else more)


def _write_load(drawn: DrawnMap, centre: complex, words: str) -> None:
    """What they carry, beside their badge where there is room."""
    wide, tall = canvas.text_size(words, SMALL)
    across, up = (BADGE + wide) / 2 + 2, (BADGE + tall) / 2 + 1
    at = drawn.placement.first(
        [centre + shift for shift in (across, -across, -up * 1j, up * 1j)],
        lambda place: Box.around(place, wide / 2 + 1, tall / 2),
    )
    if at is not None:
        drawn.write(words, at, SMALL, bbox=canvas.halo(), gid="load")
