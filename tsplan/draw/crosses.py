"""Where nobody may go for some steps, or from a step on: crosses on a map, with the steps."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from tsplan.draw.canvas import Entry

if TYPE_CHECKING:
    from tsplan.plans.worlds import Place, World
    from tsplan.ts import TransitionSystem

Spans: TypeAlias = "tuple[tuple[int, int | None], ...]"
"""First and last steps, the latter None where it goes on for good."""

COLOUR = "#b3261e"
_SIGN = "\u00d7"
_SHARES = (0.5, 0.4, 0.6, 0.3, 0.7)
_POINTS = (9.0, 13.0, 18.0)  # from a state to its cross


def closures(system: TransitionSystem, worlds: Iterable[World] = ()) -> Mapping[Place, Spans]:
    """When states and edges are closed: by the map, and by what worlds say of them.

    >>> from tsplan.plans.worlds import Closed, Opened, World
    >>> from tsplan.ts import Edge, State, TransitionSystem
    >>> edge = Edge("p", "q", closed=((4, 9),))
    >>> system = TransitionSystem.build([State("p"), State("q")], [edge])
    >>> shut = World(2, closed=(Closed(("p", "q")), Closed("q", 5)))
    >>> dict(closures(system, [shut, World(8, opened=(Opened("p", "q"),))]))
    {'q': ((2, 5),), ('p', 'q'): ((4, 9), (2, 7))}
    """
    found: dict[Place, list[tuple[int, int | None]]] = defaultdict(list)
    for name, state in system.states.items():
        found[name] += state.closed
    for pair, edge in system.edges.items():
        found[pair] += edge.closed
    for world in worlds:
        for closed in world.closed:
            found[closed.place].append((world.step, closed.until))
        for opened in world.opened:
            spans = found[opened.source, opened.target]
            spans[:] = [(first, world.step - 1 if last is None else last) for first, last in spans]
    return {place: tuple(spans) for place, spans in found.items() if spans}


def entries(found: Mapping[Place, Spans]) -> list[Entry]:
    """What the crosses stand for."""
    if not found:
        return []
    look = {"marker": "x", "markersize": 6, "color": COLOUR, "linestyle": ""}
    return [Entry.line("closed, at these steps", **look)]


class Cross(NamedTuple):
    """What is written at a closed place: the `words`, or the `sign` where there is no room.

    `centres` are places of the page for that, the best first.
    """

    words: str
    centres: tuple[complex, ...]
    sign: str = _SIGN


def crosses(found: Mapping[Place, Spans], at: Callable[[str], complex]) -> Iterator[Cross]:
    """A cross at every place that is closed, with its steps; `at` says where states are."""
    for ends, spans in _once(found):
        yield Cross(f"{_SIGN} {_told(spans)}", tuple(_centres([at(state) for state in ends])))


def _once(found: Mapping[Place, Spans]) -> Iterator[tuple[Sequence[str], Spans]]:
    """States, and edges by their ends: both directions as one where they are closed alike."""
    for place, spans in found.items():
        if isinstance(place, str):
            yield (place,), spans
        elif found.get(place[::-1]) != spans or place <= place[::-1]:
            yield place, spans


def _centres(ends: Sequence[complex]) -> Iterator[complex]:
    """Places of the page for a cross at a state, or between two, the best first."""
    begin, way = ends[0], ends[-1] - ends[0]
    if way:
        yield from (begin + way * share for share in _SHARES)
    else:
        for far in _POINTS:
            yield from (begin + far * turn for turn in (-1j, 1j, 1 + 1j, 1 - 1j, -1 - 1j, -1 + 1j))


def _told(spans: Spans) -> str:
    """The steps of some spans, in words."""
    return ", ".join(
        f"from {first}" if last is None else str(first) if first == last else f"{first}-{last}"
        for first, last in spans
    )
