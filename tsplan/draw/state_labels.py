"""What is written at each state: its name and labels, as large and as complete as there is room.

First all names and labels are tried, from large to small letters; then the labels alone; then
nothing is written, and the labels' colours go to a legend. Either every text of a kind fits or none
is written, because a map with some of its names looks as if the other states had none.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

from tsplan.draw.canvas import TEXT, TINY, text_size
from tsplan.draw.text_placement import Box, Frame, Placement, Point
from tsplan.words import visible

if TYPE_CHECKING:
    from tsplan.draw.layout import Places
    from tsplan.ts import State, TransitionSystem

MOST_LABELLED = 400
"""States above which nothing is written at them."""

_SIZES = (TEXT, 7.0, 6.0, TINY)
_LESS = 0.86  # size of a label against that of a name
DOT = 5.0
"""Points across a state's dot, and from it to what is written there."""


@dataclass(frozen=True)
class StateLabel:
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
        """The rectangle of the texts."""
        return Box.around(self.centre, self.width / 2 + 1, self.height / 2 + 0.5)

    def lines(self) -> Iterator[tuple[str, float, Point]]:
        """Each text with its size and its centre."""
        x, top = self.centre[0], self.centre[1] + self.height / 2
        for text, size in self.parts:
            height = text_size(text, size)[1]
            yield text, size, (x, top - height / 2)
            top -= height


def state_labels(system: TransitionSystem, where: Places, frame: Frame) -> Mapping[str, StateLabel]:
    """What is written at every state, empty where nothing is."""
    nothing = {
        name: StateLabel("", "", TEXT, frame.at(where[name]), frozenset()) for name in system.states
    }
    if len(system.states) > MOST_LABELLED:
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
) -> dict[str, StateLabel] | None:
    """The texts of one kind and size, or None if one of them does not fit."""
    kind, size = how
    taken = Placement(frame.page)
    placed: dict[str, StateLabel] = {}
    for name, state in system.states.items():
        if not state.shape:
            taken.take(Box.around(frame.at(where[name]), DOT / 2, DOT / 2))
    for name, state in system.states.items():
        title, labels = kind(state)
        if not title and not labels:
            continue
        possible = _possible(state, (title, labels), size, (frame, frame.at(where[name])))
        label = next((label for label in possible if taken.free(label.box)), None)
        if label is None:
            return None
        taken.take(label.box)
        placed[name] = label
    return placed


def _possible(
    state: State, texts: tuple[str, tuple[str, ...]], size: float, place: tuple[Frame, Point]
) -> Iterator[StateLabel]:
    """What may be written: inside a state's shape, or around its dot, in one line or in more."""
    (title, labels), (frame, centre) = texts, place
    shown, listed = visible(title), [visible(label) for label in labels]
    names = dict.fromkeys((shown, _folded(shown)))
    words = dict.fromkeys((", ".join(listed), ",\n".join(listed)))
    limit = _extent(state, frame)
    seen = frozenset(labels) | ({title} & state.labels)
    for name in names:
        for word in words:
            label = StateLabel(name, word, size, centre, seen)
            if limit is None:
                yield from _around(label)
            elif label.width <= limit[0] and label.height <= limit[1]:
                yield label


def _extent(state: State, frame: Frame) -> tuple[float, float] | None:
    """Width and height of a state's shape in points; None without one."""
    if not state.shape:
        return None
    xs, ys = zip(*state.shape, strict=True)
    return (max(xs) - min(xs)) * frame.scale - 4, (max(ys) - min(ys)) * frame.scale - 2


def _around(label: StateLabel) -> Iterator[StateLabel]:
    """The same below, above, right and left of a dot."""
    (x, y), across, up = label.centre, label.width / 2 + DOT, label.height / 2 + DOT
    for centre in ((x, y - up), (x, y + up), (x + across, y), (x - across, y)):
        yield replace(label, centre=centre)


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
