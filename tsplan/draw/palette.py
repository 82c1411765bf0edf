"""Colours for states, labels and classes, the same in every picture of a mission.

The eight hues were chosen by search so that every two of them differ clearly (25 or more in
CIELAB) for people with any of the three kinds of colour blindness, and so that their lightness
rises in equal steps of 8, which tells them apart in a grey print. More names than hues get the
same hues with a hatch. Travel is always white with grey stripes.

Source of the colour-blindness model used in that search: G. Machado, M. Oliveira, L. Fernandes, "A
physiologically-based model for simulation of color vision deficiency", IEEE TVCG 2009.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple

from tsplan.draw.colours import colour_of, ink_on, mixed
from tsplan.mission import Mission
from tsplan.ts import TransitionSystem
from tsplan.words import many

HUES = ["#7753bf", "#ed6915", "#843b65", "#bac268", "#4d895a", "#9be1af", "#384801", "#f37fbd"]
"""Colours in the order in which they are given out: neighbours differ much in lightness."""

_ENDWISE = HUES[::-1]

HATCHES = ("", "..", "xx", "||", "oo", "++")
"""Hatches, in matplotlib's letters, of the first eight names, the next eight, ..."""

STROKES = ("-", "--", "-.", ":")
"""Line styles that go with the hatches where there is no area to hatch."""


@dataclass(frozen=True, slots=True)
class Paint:
    """How something is painted: its colour (`#rrggbb`), its hatch and the text's colour on it."""

    colour: str
    hatch: str = ""

    @property
    def ink(self) -> str:
        """Black or white, whichever is read better on the colour."""
        return ink_on(self.colour)

    @property
    def pale(self) -> str:
        """The colour mixed with white, for large areas behind other things."""
        return mixed(self.colour, "#ffffff", 0.72)

    @property
    def soft(self) -> Paint:
        """The same paint a little lighter, for areas with text on them."""
        return Paint(mixed(self.colour, "#ffffff", 0.35), self.hatch)

    @property
    def stroke(self) -> str:
        """The line style (matplotlib's letters) that stands for the hatch."""
        return STROKES[HATCHES.index(self.hatch) % len(STROKES)] if self.hatch in HATCHES else "-"


def pale(colour: str) -> str:
    """The colour of what was planned, where what happened has the colour itself.

    >>> pale("#2f5f9e")
    '#97afce'
    """
    return mixed(colour, "#ffffff", 0.5)


PLAIN = Paint("#dedede")
"""States without any label."""

TRAVEL = Paint("#ffffff", "////")
"""Time on the way from one state to another."""

TRAVEL_STRIPE = "#9a9a9a"
"""The colour of travel's stripes."""

GOOD, BAD = "#1f6f50", "#b3261e"
"""What holds and what fails; always together with a sign or a word, never by colour alone."""


def paints(names: Iterable[str], hues: Sequence[str] = HUES) -> Mapping[str, Paint]:
    """A paint for every name, in the order of names and hues; the same names get the same ones.

    >>> paints(["scout", "heavy"])["heavy"]
    Paint(colour='#ed6915', hatch='')
    """
    given = {}
    for number, name in enumerate(dict.fromkeys(names)):
        turn, place = divmod(number, len(hues))
        given[name] = Paint(hues[place], HATCHES[turn % len(HATCHES)])
    return MappingProxyType(given)


class TeamClass(NamedTuple):
    """How many agents a class has, and what they can do; of a configuration, its modules."""

    agents: int
    capabilities: tuple[str, ...]
    modules: int = 0

    def words(self, name: str) -> str:
        """The class in words, or the configuration."""
        return (
            f"{name} of {many(self.modules, 'module')}"
            if self.modules
            else f"{self.agents:,} {name}"
        )


def classes_of(mission: Mission) -> dict[str, TeamClass]:
    """The classes of a team by their names, in its order; swarms are classes too.

    Instead of a class of modules there are the configurations that their structures can have.
    """
    found: dict[str, TeamClass] = {}
    pools = mission.modular.pools(mission.team)
    shapes = {number: pool.shapes for pool in pools for number in pool.groups}
    for number, group in enumerate(mission.team):
        for shape in shapes.get(number, (None,)):
            kind = group if shape is None else mission.modular.shaped(group, shape)
            name, modules = (group.class_name, 0) if shape is None else (shape.name, shape.modules)
            agents, able, _ = found.get(name, TeamClass(0, ()))
            more = tuple(dict.fromkeys((*able, *sorted(kind.capabilities))))
            there = shape is None or shape.name == group.configuration
            agents += mission.modular.structures(group).count if there else 0
            found[name] = TeamClass(agents, more, modules)
    return found


@dataclass(frozen=True)
class Palette:
    """All paints of one map and team.

    Labels and classes are painted in the order in which the map and the team name them, labels with
    the hues from the other end, so that few of each never look alike. A state has the colour that
    the map gives it, or that one of its labels names; else its labels' paint: states with the same
    labels look the same.
    """

    system: TransitionSystem
    class_names: tuple[str, ...] = ()

    @classmethod
    def of(cls, mission: Mission) -> Palette:
        """The palette of a mission."""
        return cls(mission.system, tuple(classes_of(mission)))

    @cached_property
    def classes(self) -> Mapping[str, Paint]:
        """A paint for each class of agents."""
        return paints(self.class_names)

    @cached_property
    def labels(self) -> Mapping[str, Paint]:
        """A paint for each label: that of the first state that carries it and no other label."""
        alone = {
            next(iter(state.labels)): self.states[name]
            for name, state in reversed(tuple(self.system.states.items()))
            if len(state.labels) == 1
        }
        return MappingProxyType(dict(paints(self.system.labels, _ENDWISE)) | alone)

    @cached_property
    def states(self) -> Mapping[str, Paint]:
        """A paint for each state."""
        kinds = {name: ", ".join(sorted(s.labels)) for name, s in self.system.states.items()}
        own = {name: paint for name in kinds if (paint := self._own(name)) is not None}
        given = paints((kinds[name] for name in kinds if kinds[name] and name not in own), _ENDWISE)
        return MappingProxyType(
            {name: own.get(name) or given.get(kind, PLAIN) for name, kind in kinds.items()}
        )

    def _own(self, name: str) -> Paint | None:
        """The colour that the map names for a state, or one of its labels; None without any."""
        state = self.system.states[name]
        words = map(colour_of, (state.color, *sorted(state.labels)))
        return next((Paint(colour) for colour in words if colour is not None), None)
