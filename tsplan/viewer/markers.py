"""What moves on a picture: agents as marks where there is room, as numbers where there is not."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from tsplan.draw.edge_layout import Point
from tsplan.draw.text_placement import direction
from tsplan.draw.tracks import Track, Whereabouts
from tsplan.viewer.positions import slot_points

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
class Markers:
    """What is to be drawn at one time: marks by class, and numbers as (class, agents, point)."""

    marks: dict[str, list[Point]] = field(default_factory=dict)
    numbers: list[tuple[str, int, Point]] = field(default_factory=list)
    counts: Counter[str] = field(default_factory=Counter)


def markers(found: Iterable[Track], ground: Ground, time: float) -> Markers:
    """Place all agents at a time; agents between two states count at none of them.

    Agents of one class that entered one edge together are a convoy: shown one by one or as one
    number, like those at a state.
    """
    drawn = Markers()
    there = [(track, track.at(time)) for track in found if track.present(time)]
    staffing: dict[str, Counter[str]] = {}
    convoys: Counter[tuple[str, Whereabouts]] = Counter()
    for track, where in there:
        if where.share:
            convoys[_convoy(track, where)] += track.count
        else:
            drawn.counts[where.source.state] += track.count
            staffing.setdefault(where.source.state, Counter())[track.class_name] += track.count
    for track, where in there:
        near = convoys[_convoy(track, where)] if where.share else drawn.counts[where.source.state]
        if near <= ground.most:
            drawn.marks.setdefault(track.class_name, []).extend(_marks(track, where, ground))
    for (class_name, where), agents in convoys.items():
        if agents > ground.most:
            drawn.numbers.append((class_name, agents, _pair(_middle(where, ground))))
    for state, classes in staffing.items():
        if drawn.counts[state] > ground.most:
            drawn.numbers += _stacked(classes, ground.places[state], ground)
    return drawn


def _convoy(track: Track, where: Whereabouts) -> tuple[str, Whereabouts]:
    """What agents have in common that are on one edge together."""
    source = where.source._replace(first=0, slot=0)
    return track.class_name, where._replace(
        source=source, target=where.target._replace(last=0, slot=0)
    )


def _marks(track: Track, where: Whereabouts, ground: Ground) -> list[Point]:
    """A point for each agent: its slots, or on the way from the one to the other."""
    slots = slot_points()
    made = []
    for number in range(track.count):
        begin, end = (
            slots[min(len(slots) - 1, stop.slot + number)] for stop in (where.source, where.target)
        )
        shift = (begin + (end - begin) * where.share).conjugate() * ground.distance
        made.append(_pair(_middle(where, ground) + shift))
    return made


def _middle(where: Whereabouts, ground: Ground) -> complex:
    """The middle of a group: at its state, or on the right of its edge."""
    begin, end = (complex(*ground.places[s.state]) for s in (where.source, where.target))
    aside = ASIDE * ground.radius * min(1.0, 6 * where.share, 6 * (1 - where.share))
    return begin + (end - begin) * where.share - 1j * direction(end - begin) * aside


def _pair(place: complex) -> Point:
    return place.real, place.imag


def _stacked(classes: Counter[str], at: Point, ground: Ground) -> list[tuple[str, int, Point]]:
    """One number for each class, one below the other."""
    height = 4.2 * ground.radius
    top = at[1] + (len(classes) - 1) * height / 2
    return [
        (name, agents, (at[0], top - place * height))
        for place, (name, agents) in enumerate(classes.items())
    ]
