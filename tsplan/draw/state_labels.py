"""What is written at each state: its name and labels, as large and as complete as there is room.

First all names and labels are tried, from large to small letters; then the labels alone; then
nothing is written, and the labels' colours go to a legend. Either every sign of a kind fits or none
is written, because a map with some of its names looks as if the other states had none.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from tsplan.draw.canvas import TEXT, TINY, text_size
from tsplan.draw.text_placement import Box, Frame, Point, Room
from tsplan.words import visible

if TYPE_CHECKING:
    from tsplan.draw.layout import Places
    from tsplan.ts import State, TransitionSystem

MOST_SIGNS = 400
"""States above which nothing is written at them."""

_SIZES = (TEXT, 7.0, 6.0, TINY)
_LESS = 0.86  # size of a label against that of a name
_DOT = 5.0  # points from a state's dot to its sign


@dataclass(frozen=True)
class Sign:
    """A state's name and labels, each of one or more lines or empty, around a point of the page."""

    name: str
    words: str
    size: float
    centre: Point
    labels: frozenset[str]

    @cached_property
    def parts(self) -> tuple[tuple[str, float], ...]:
        """The texts from top to bottom with their sizes."""
        both = ((self.name, self.size), (self.words, self.size * _LESS))
        return tuple((text, size) for text, size in both if text)

    @cached_property
    def width(self) -> float:
        """Points across."""
        return max((text_size(*part)[0] for part in self.parts), default=0.0)

    @cached_property
    def height(self) -> float:
        """Points from top to bottom."""
        return sum(text_size(*part)[1] for part in self.parts)

    @property
    def box(self) -> Box:
        """The rectangle of the sign."""
        x, y = self.centre
        across, up = self.width / 2 + 1, self.height / 2 + 0.5
        return Box(x - across, y - up, x + across, y + up)

    def lines(self) -> Iterator[tuple[str, float, Point]]:
        """Each text with its size and its centre."""
        x, top = self.centre[0], self.centre[1] + self.height / 2
        for text, size in self.parts:
            height = text_size(text, size)[1]
            yield text, size, (x, top - height / 2)
            top -= height


def signs(system: TransitionSystem, where: Places, frame: Frame) -> Mapping[str, Sign]:
    """The sign of every state, empty where nothing is written."""
    nothing = {
        name: Sign("", "", TEXT, frame.at(where[name]), frozenset()) for name in system.states
    }
    if len(system.states) > MOST_SIGNS:
        return nothing
    for kind in (_name_and_labels, _labels_alone):
        for size in _SIZES:
            found = _all_placed(system, where, frame, (kind, size))
            if found is not None:
                return nothing | found
    return nothing


Kind = Callable[["State"], tuple[str, tuple[str, ...]]]


def _name_and_labels(state: State) -> tuple[str, tuple[str, ...]]:
    return state.name, tuple(label for label in sorted(state.labels) if label != state.name)


def _labels_alone(state: State) -> tuple[str, tuple[str, ...]]:
    return "", tuple(sorted(state.labels))


def _all_placed(
    system: TransitionSystem, where: Places, frame: Frame, how: tuple[Kind, float]
) -> dict[str, Sign] | None:
    """The signs of one kind and size, or None if one of them does not fit."""
    kind, size = how
    room = Room(frame.page)
    placed: dict[str, Sign] = {}
    for name, state in system.states.items():
        if not state.shape:
            x, y = frame.at(where[name])
            room.take(Box(x - _DOT / 2, y - _DOT / 2, x + _DOT / 2, y + _DOT / 2))
    for name, state in system.states.items():
        title, labels = kind(state)
        if not title and not labels:
            continue
        tried = _tried(state, (title, labels), size, frame)
        sign = next((s for s in tried(frame.at(where[name])) if room.free(s.box)), None)
        if sign is None:
            return None
        room.take(sign.box)
        placed[name] = sign
    return placed


def _tried(
    state: State, texts: tuple[str, tuple[str, ...]], size: float, frame: Frame
) -> Callable[[Point], Iterator[Sign]]:
    """A state's possible signs: inside its shape, or around its dot, in one line or in more."""
    title, labels = texts
    shown, listed = visible(title), [visible(label) for label in labels]
    names = dict.fromkeys((shown, _folded(shown)))
    words = dict.fromkeys((", ".join(listed), ",\n".join(listed)))
    limit = _extent(state, frame)

    def possible(centre: Point) -> Iterator[Sign]:
        for name in names:
            for word in words:
                sign = Sign(name, word, size, centre, frozenset(labels) | ({title} & state.labels))
                if limit is None:
                    yield from _around(sign)
                elif sign.width <= limit[0] and sign.height <= limit[1]:
                    yield sign

    return possible


def _extent(state: State, frame: Frame) -> tuple[float, float] | None:
    """Width and height of a state's shape in points; None without one."""
    if not state.shape:
        return None
    xs, ys = zip(*state.shape, strict=True)
    return (max(xs) - min(xs)) * frame.scale - 4, (max(ys) - min(ys)) * frame.scale - 2


def _around(sign: Sign) -> Iterator[Sign]:
    """A sign below, above, right and left of a dot."""
    (x, y), across, up = sign.centre, sign.width / 2 + _DOT, sign.height / 2 + _DOT
    for centre in ((x, y - up), (x, y + up), (x + across, y), (x - across, y)):
        yield Sign(sign.name, sign.words, sign.size, centre, sign.labels)


def _folded(name: str) -> str:
    r"""A long name in two lines, broken where it has a seam nearest to its middle.

    >>> _folded("meeting_small")
    'meeting_\nsmall'
    """
    seams = [match.end() for match in re.finditer(r"[_\s.:/-]+", name) if match.end() < len(name)]
    if not seams:
        return name
    seam = min(seams, key=lambda place: abs(place - len(name) / 2))
    return f"{name[:seam].rstrip()}\n{name[seam:]}"
