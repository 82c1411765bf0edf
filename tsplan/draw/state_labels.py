"""What is written at each state: its name and labels, as large and as complete as there is room.

First all names and labels are tried, from large to small letters; then the labels alone; then
nothing is written, and the labels' colours go to a legend. Either every text of a kind fits or none
is written, because a map with some of its names looks as if the other states had none.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import NamedTuple

from tsplan.draw.canvas import TEXT, TINY, text_size
from tsplan.draw.edge_layout import Places
from tsplan.draw.text_placement import Box, Frame, Placement
from tsplan.ts import State, TransitionSystem
from tsplan.words import visible

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
    centre: complex
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

    def lines(self) -> Iterator[tuple[str, float, complex]]:
        """Each text with its size and its centre."""
        top = self.centre + self.height / 2 * 1j
        for text, size in self.parts:
            height = text_size(text, size)[1] * 1j
            yield text, size, top - height / 2
            top -= height


def state_labels(system: TransitionSystem, where: Places, frame: Frame) -> Mapping[str, StateLabel]:
    """What is written at every state, empty where nothing is."""
    at = {name: frame.at(where[name]) for name in system.states}
    nothing = {name: StateLabel("", "", TEXT, at[name], frozenset()) for name in system.states}
    if len(system.states) <= MOST_LABELLED:
        for named, size in product((True, False), _SIZES):
            found = _all_placed(system, at, frame, LabelStyle(named, size))
            if found is not None:
                return nothing | found
    return nothing


class LabelStyle(NamedTuple):
    """How all states are labelled: whether by their names too, and how large."""

    named: bool
    size: float


def _all_placed(
    system: TransitionSystem, at: Mapping[str, complex], frame: Frame, style: LabelStyle
) -> dict[str, StateLabel] | None:
    """The texts of one style, or None if one of them does not fit."""
    free = Placement(frame.page)
    placed: dict[str, StateLabel] = {}
    for name, state in system.states.items():
        if not state.shape:
            free.take(Box.around(at[name], DOT / 2, DOT / 2))
    for name, state in system.states.items():
        if style.named or state.labels:
            options = _possible(state, style, at[name], frame)
            label = free.first(options, lambda label: label.box)
            if label is None:
                return None
            placed[name] = label
    return placed


def _possible(
    state: State, style: LabelStyle, centre: complex, frame: Frame
) -> Iterator[StateLabel]:
    """What may be written: inside a state's shape, or around its dot, in one line or in more."""
    shown = visible(state.name) if style.named else ""
    listed = [
        visible(word) for word in sorted(state.labels) if not style.named or word != state.name
    ]
    for name in dict.fromkeys((shown, _folded(shown))):
        for words in dict.fromkeys((", ".join(listed), ",\n".join(listed))):
            label = StateLabel(name, words, style.size, centre, state.labels)
            if state.shape:
                xs, ys = zip(*state.shape, strict=True)
                across, up = ((max(part) - min(part)) * frame.scale for part in (xs, ys))
                if label.width <= across - 4 and label.height <= up - 2:
                    yield label
                continue
            across, up = label.width / 2 + DOT, label.height / 2 + DOT
            for shift in (-up * 1j, up * 1j, across, -across):  # below, above, right, left
                yield replace(label, centre=centre + shift)


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
