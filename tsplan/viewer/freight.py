"""What moves with agents: everything that is carried along an edge entered at a step, together.

Structures that are rebuilt are told of in the same way: as words at their state for some time.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import NamedTuple

from tsplan.draw.edge_layout import Point
from tsplan.draw.text_placement import direction
from tsplan.draw.tracks import Track
from tsplan.mission import Mission
from tsplan.plans.cargo_rows import AgentLoads
from tsplan.plans.plan import Plan
from tsplan.plans.supplies import Loads, load_words, together
from tsplan.viewer.markers import Ground


class Freight(NamedTuple):
    """What is carried from a state to another, there at step `come`, by all who left at `left`."""

    source: str
    target: str
    left: int
    come: int
    words: str

    def share(self, time: float) -> float:
        """How much of the way is behind it; 0 at the states.

        >>> Freight("p", "q", 2, 6, "2 brick").share(3)
        0.25
        """
        return (time - self.left) / (self.come - self.left) if self.left < time < self.come else 0.0


def freights(found: Iterable[Track], loads: AgentLoads) -> tuple[Freight, ...]:
    """Everything that the agents of a plan's tracks carry, in the order of time."""
    ways: dict[tuple[str, str, int, int], Loads] = {}
    for track in found:
        for here, there in pairwise(track.stops):
            if own := track.load(here.last, loads):
                way = (here.state, there.state, here.last, there.first)
                ways[way] = together([ways.get(way, {}), own])
    said = (Freight(*way, load_words(load)) for way, load in ways.items())
    return tuple(sorted(said, key=lambda freight: (freight.left, freight.come)))


def rebuildings(plan: Plan, mission: Mission) -> Iterator[Freight]:
    """What is rebuilt, in words that stay at its state until that is done."""
    bodies = {each.id: each.configuration for each in plan.structures}
    for each in plan.rebuilt:
        rule = mission.modular.reconfigurations[each.rule]
        parts = Counter(bodies[name] for name in each.parts)
        before, after = (
            " + ".join(f"{count} {name}" if count > 1 else name for name, count in side.items())
            for side in (parts, dict(rule.made))
        )
        words = f"{before} \u2192 {after}"
        yield Freight(each.state, each.state, each.step, each.step + rule.duration, words)


def freight_point(
    freight: Freight, ground: Ground, time: float, extent: tuple[float, float]
) -> Point:
    """The middle of its words, further on the right of the way than those who carry it.

    `extent` is how wide and tall the words are, in dots.
    """
    if freight.source == freight.target:  # what is rebuilt there
        x, y = ground.places[freight.source]
        return x, y - 3.0 * ground.radius - extent[1]
    begin, end = (complex(*ground.places[state]) for state in (freight.source, freight.target))
    along = direction(end - begin)
    reach = (extent[0] * abs(along.imag) + extent[1] * abs(along.real)) / 2
    aside = 3.0 * ground.radius + reach
    middle = begin + (end - begin) * freight.share(time) - 1j * along * aside
    return middle.real, middle.imag
