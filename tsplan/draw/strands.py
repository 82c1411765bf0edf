"""The lines of a map's paths as data: who takes which edge, and when they arrive.

A line is a path that agents share or, where there are more paths than can be told apart, all paths
of a class. Of what happened there are lines as of a plan, which then has pale ones.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from types import MappingProxyType

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw.focus import Focus
from tsplan.draw.palette import HUES, STROKES, Paint, Palette, paints, pale
from tsplan.draw.tracks import Track, agents_of, by_class, tracks
from tsplan.mission import Mission
from tsplan.plans.cargo_rows import AgentLoads, loads_of
from tsplan.plans.plan import Plan
from tsplan.plans.supplies import Loads, together

MOST_PATHS = len(HUES) * len(STROKES) - 8
"""Distinct paths that are drawn one by one; more cannot be told apart."""

Pair = tuple[str, str]
_EMPTY: AgentLoads = MappingProxyType({})


@dataclass
class Passage:
    """Uses of an edge by one strand: how many agents in all, and when they arrive.

    `arrivals` have a step up to the horizon each, and whether the agents rest there then; `loads`
    what they carry along the edge, by the step of arrival.
    """

    agents: int = 0
    arrivals: list[tuple[int, bool]] = field(default_factory=list)
    loads: dict[int, Loads] = field(default_factory=dict)


@dataclass(frozen=True)
class Strand:
    """One line on the map: a path that agents share, or all paths of a class.

    `names` are the tracks that it stands for and `ids` their agents, where it is one path.
    """

    words: str
    paint: Paint
    agents: int
    passages: Mapping[Pair, Passage]
    names: tuple[str, ...] = ()
    ids: Sequence[str] = ()
    planned: bool = False

    @property
    def colour(self) -> str:
        """The colour of its line: pale where it was only planned."""
        return pale(self.paint.colour) if self.planned else self.paint.colour

    @property
    def stroke(self) -> str:
        """The style of its line: dashed where it was only planned."""
        return "--" if self.planned else self.paint.stroke


@dataclass(frozen=True)
class Drawing:
    """The lines to draw, and of whom: of a plan, or of what happened, with `planned` lines too."""

    plan: Plan
    tracks: tuple[Track, ...]
    strands: tuple[Strand, ...]
    joined: bool


def drawing_of(plan: Plan, mission: Mission, palette: Palette, focus: Focus) -> Drawing:
    """The lines of a plan, or of what happened with those of the plan below them."""
    moving, loads = focus.chosen(tracks(plan, mission), plan), loads_of(plan.cargo)
    strands, joined = strands_of(moving, plan.horizon, palette, loads)
    executed = focus.executed
    if executed is None:
        return Drawing(plan, moving, strands, joined=joined)
    refuse_misfit(executed, mission)
    happened, told = focus.chosen(tracks(executed, mission), executed), loads_of(executed.cargo)
    full, joined_too = strands_of(happened, executed.horizon, palette, told)
    if joined != joined_too:  # one kind of lines for both
        joined = True
        strands, _ = strands_of(moving, plan.horizon, palette, loads, most=-1)
        full, _ = strands_of(happened, executed.horizon, palette, told, most=-1)
    given = {name: strand.paint for strand in strands for name in strand.ids}
    full = tuple(
        replace(
            strand, paint=given.get(strand.ids[0], strand.paint) if strand.ids else strand.paint
        )
        for strand in full
    )
    planned = tuple(replace(strand, planned=True) for strand in strands)
    return Drawing(executed, happened, (*planned, *full), joined=joined)


def strands_of(
    found: Sequence[Track],
    horizon: int,
    palette: Palette,
    loads: AgentLoads = _EMPTY,
    *,
    most: int = MOST_PATHS,
) -> tuple[tuple[Strand, ...], bool]:
    """The lines to draw, one for each track that leaves its start or, joined, for each class.

    The second value says whether they are joined, as more than `most` are. `loads` are what agents
    carry (`loads_of`).
    """
    moving = [track for track in found if track.moves]
    if len(moving) <= most:
        given = paints(str(number) for number in range(len(moving)))
        return tuple(
            Strand(
                track.short,
                paint,
                track.width,
                _passages([track], horizon, loads),
                (track.name,),
                track.ids,
            )
            for track, paint in zip(moving, given.values(), strict=True)
        ), False
    strands = []
    for name, group in by_class(moving).items():
        apart = bool(group[0].ids)
        agents = agents_of(group if apart else (one for one in found if one.class_name == name))
        words = f"{agents:,} {name} {'on' if apart else 'in'} {len(group):,} "
        words += "paths" if apart else "groups"
        passages = _passages(group, horizon, loads)
        strands.append(Strand(words, palette.classes[name], agents, passages))
    return tuple(strands), True


def lanes_of(strands: Sequence[Strand]) -> Mapping[Pair, tuple[int, ...]]:
    """The numbers of the strands on each directed edge, from the middle of the way outwards."""
    lanes: dict[Pair, list[int]] = {}
    for number, strand in enumerate(strands):
        for pair in strand.passages:
            lanes.setdefault(pair, []).append(number)
    return {pair: tuple(numbers) for pair, numbers in lanes.items()}


def _passages(group: Sequence[Track], horizon: int, loads: AgentLoads) -> Mapping[Pair, Passage]:
    found: dict[Pair, Passage] = {}
    for track in group:
        last = max((stop.first for stop in track.stays(horizon)), default=horizon)
        for here, there in pairwise(track.stops):
            if here.state == there.state:
                continue
            passage = found.setdefault((here.state, there.state), Passage())
            passage.agents += track.width
            own = track.load(here.last, loads)
            if own:
                before = passage.loads.get(there.first, {})
                passage.loads[there.first] = together([before, own])
            if there.first <= horizon:
                rests = there.last > there.first or there.first == last
                passage.arrivals.append((there.first, rests))
    return found
