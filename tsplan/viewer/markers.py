"""What moves on a picture: agents as marks where there is room, as numbers where there is not."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from tsplan.viewer.positions import slot_points
from tsplan.viewer.tracks import Mover, Whereabouts

Point: TypeAlias = tuple[float, float]

ASIDE = 1.3
"""How far to the right of an edge agents travel, in radii of their marks."""


@dataclass(frozen=True)
class Ground:
    """Where the states are on a picture, in dots, and what one agent's mark takes there.

    Up to `most` agents at one state, or on one edge together, are shown one by one.
    """

    places: Mapping[str, Point]
    radius: float
    most: int

    @property
    def distance(self) -> float:
        """Dots between neighbouring slots."""
        return 2.35 * self.radius


@dataclass
class Picture:
    """What is to be drawn at one time: marks by class, and numbers as (class, agents, point)."""

    marks: dict[str, list[Point]] = field(default_factory=dict)
    numbers: list[tuple[str, int, Point]] = field(default_factory=list)
    counts: Counter[str] = field(default_factory=Counter)


def picture(movers: Iterable[Mover], ground: Ground, time: float) -> Picture:
    """Place all agents at a time; agents between two states count at none of them."""
    drawn = Picture()
    there = [(m, m.at(time)) for m in movers if m.present(time)]
    convoys: dict[tuple[str, Whereabouts], list[tuple[Mover, Whereabouts]]] = {}
    staffing: dict[str, Counter[str]] = {}
    for mover, where in there:
        if where.share:
            key = (mover.class_name, _without_slots(where))
            convoys.setdefault(key, []).append((mover, where))
        else:
            state = where.source.state
            drawn.counts[state] += mover.count
            staffing.setdefault(state, Counter())[mover.class_name] += mover.count
    for mover, where in there:
        if not where.share and drawn.counts[where.source.state] <= ground.most:
            drawn.marks.setdefault(mover.class_name, []).extend(_marks(mover, where, ground))
    for (class_name, where), convoy in convoys.items():
        _travelling(drawn, ground, class_name, where, convoy)
    for state, classes in staffing.items():
        if drawn.counts[state] > ground.most:
            drawn.numbers += _stacked(classes, ground.places[state], ground)
    return drawn


def _without_slots(where: Whereabouts) -> Whereabouts:
    return where._replace(
        source=where.source._replace(first=0, slot=0), target=where.target._replace(last=0, slot=0)
    )


def _travelling(
    drawn: Picture,
    ground: Ground,
    class_name: str,
    where: Whereabouts,
    convoy: Sequence[tuple[Mover, Whereabouts]],
) -> None:
    """Agents of one class that entered one edge together."""
    agents = sum(mover.count for mover, _ in convoy)
    if agents > ground.most:
        drawn.numbers.append((class_name, agents, point(where, ground)))
        return
    for mover, own in convoy:
        drawn.marks.setdefault(class_name, []).extend(_marks(mover, own, ground))


def _marks(mover: Mover, where: Whereabouts, ground: Ground) -> list[Point]:
    """A point for each agent: its slots, or on the way from the one to the other."""
    x, y = point(where, ground)
    slots = slot_points()
    made = []
    for number in range(mover.count):
        a = slots[min(len(slots) - 1, where.source.slot + number)]
        b = slots[min(len(slots) - 1, where.target.slot + number)]
        dx, dy = (p + (q - p) * where.share for p, q in zip(a, b, strict=True))
        made.append((x + dx * ground.distance, y - dy * ground.distance))
    return made


def point(where: Whereabouts, ground: Ground) -> Point:
    """The middle of a group: at its state, or on the right of its edge."""
    (ax, ay), (bx, by) = ground.places[where.source.state], ground.places[where.target.state]
    share = where.share
    x, y = ax + (bx - ax) * share, ay + (by - ay) * share
    length = ((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5
    if not share or not length:
        return x, y
    aside = ASIDE * ground.radius * min(1.0, 6 * share, 6 * (1 - share)) / length
    return x + (by - ay) * aside, y - (bx - ax) * aside


def _stacked(classes: Counter[str], at: Point, ground: Ground) -> list[tuple[str, int, Point]]:
    """One number for each class, one below the other."""
    height = 4.2 * ground.radius
    top = at[1] + (len(classes) - 1) * height / 2
    return [
        (name, agents, (at[0], top - place * height))
        for place, (name, agents) in enumerate(classes.items())
    ]
