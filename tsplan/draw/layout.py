"""What is drawn where of a map: the places of its states, and the lines between them.

Every picture and the page draw these; nothing here is random, so the same map always looks the
same.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import NamedTuple

from tsplan.draw.edge_layout import Places, computed
from tsplan.ts import TransitionSystem
from tsplan.ts.edges import Duration
from tsplan.ts.state_places import Point, own_place

_GAP = 0.2  # of the size of a map: between two of its levels


class Link(NamedTuple):
    """Two connected states, drawn as one line; `words` are those of the durations both ways."""

    source: str
    target: str
    one_way: bool
    words: str


def places(system: TransitionSystem) -> Places:
    """Coordinates of every state, in the order of the map.

    A state's own `at`, else the centroid of its `shape`. States with neither are placed beside
    their neighbours, or all by the edges if no state has coordinates. Levels lie side by side.

    >>> from tsplan.ts import Edge, State, TransitionSystem
    >>> square = ((0, 0), (2, 0), (2, 2), (0, 2))
    >>> map = TransitionSystem.build([State("p", at=(5, 1)), State("q", shape=square)], [])
    >>> dict(places(map))
    {'p': (5.0, 1.0), 'q': (1.0, 1.0)}
    """
    own = {name: place for name, state in system.states.items() if (place := own_place(state))}
    known = _side_by_side(system, own)
    if len(known) == len(system.states):
        return known
    return computed(system, known)


def _side_by_side(system: TransitionSystem, known: dict[str, Point]) -> dict[str, Point]:
    """The places of states of several levels, which else would lie on each other.

    Where states have shapes, these are drawn where they are, and so are the levels.
    """
    level = {name: system.states[name].level for name in known}
    order = list(dict.fromkeys(level.values()))
    if len(order) < 2 or any(state.shape for state in system.states.values()):  # noqa: PLR2004
        return known
    xs, ys = zip(*known.values(), strict=True)
    width, height = max(xs) - min(xs), max(ys) - min(ys)
    apart = width + max(_GAP * max(width, height), 1.0)
    return {name: (x + apart * order.index(level[name]), y) for name, (x, y) in known.items()}


def bounds(system: TransitionSystem, where: Places) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of all states and their shapes."""
    corners = [point for state in system.states.values() for point in state.shape or ()]
    xs, ys = zip(*where.values(), *corners, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def links(system: TransitionSystem) -> tuple[Link, ...]:
    """Every pair of connected states once, in the order of the map; waits are none."""
    found = []
    for (source, target), edge in system.edges.items():
        back = system.edges.get((target, source))
        if source != target and (back is None or source < target):
            words = duration_words(edge.duration, (back or edge).duration)
            found.append(Link(source, target, back is None, words))
    return tuple(found)


def duration_words(there: Duration, back: Duration) -> str:
    """A duration as it is written on an edge: one number, or a range where classes or ways differ.

    >>> duration_words(2, 2), duration_words(1, 3), duration_words({"a": 1, "default": 2}, 2)
    ('2', '1-3', '1-2')
    """
    every = [n for d in (there, back) for n in (d.values() if isinstance(d, Mapping) else (d,))]
    least, most = min(every), max(every)
    return str(least) if least == most else f"{least}-{most}"


def usual_duration(system: TransitionSystem) -> str:
    """The words of the duration of most edges, which are not repeated on each; else one step."""
    words = Counter(link.words for link in links(system))
    most, number = words.most_common(1)[0] if words else ("1", 1)
    return most if 2 * number > words.total() else "1"
