"""Paths until a step as worlds say that they were, and where they end."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeAlias, TypeVar

from tsplan.errors import Finding, PlanError
from tsplan.plans.agent_plans import Stay, joined
from tsplan.plans.worlds import OnEdge, World

if TYPE_CHECKING:
    from tsplan.history.changed_map import Maps
    from tsplan.plans.bundles import Bundle

Whereabouts: TypeAlias = str | OnEdge
"""The state that somebody is at, or between which states and until when somebody is under way."""


def told_of(world: World) -> tuple[str, ...]:
    """Everybody of whom a world tells."""
    return (*world.lost, *world.moved, *world.late)


def clipped(stays: Iterable[Stay], last: int) -> tuple[Stay, ...]:
    """Stays as far as they begin by a step, ending there at the latest.

    >>> clipped([(0, 2, "p"), (4, 9, "q"), (11, 12, "p")], 6)
    ((0, 2, 'p'), (4, 6, 'q'))
    """
    return tuple((first, min(end, last), state) for first, end, state in stays if first <= last)


def ahead(stays: Iterable[Stay], step: int) -> tuple[Stay, ...]:
    """What of some stays lies ahead of a step, which is step 0 then.

    >>> ahead([(0, 2, "p"), (4, 9, "q"), (11, 12, "p")], 6)
    ((0, 3, 'q'), (5, 6, 'p'))
    """
    return tuple(
        (max(first, step) - step, last - step, state)
        for first, last, state in stays
        if last >= step
    )


def followed_by(stays: Iterable[Stay], later: Iterable[Stay], step: int) -> tuple[Stay, ...]:
    """Stays before a step, and after them those of a path whose step 0 is that step.

    >>> followed_by([(0, 7, "p")], [(0, 1, "p"), (3, 9, "q")], 4)
    ((0, 5, 'p'), (7, 13, 'q'))
    """
    after = ((first + step, last + step, state) for first, last, state in later)
    return tuple(joined([*clipped(stays, step - 1), *after]))


def until(path: Bundle, step: int) -> Bundle:
    """A path until a step, heading for where it goes on if it is on an edge then.

    >>> from tsplan.plans.bundles import Bundle
    >>> made = until(Bundle("a", frozenset(), ((0, 2, "p"), (4, 9, "q")), None), 3)
    >>> made.stays, made.heading
    (((0, 2, 'p'),), 'q')
    """
    stays = clipped(path.stays, step)
    later = path.stays[len(stays) :]
    away = not stays or stays[-1][1] < step
    heading = (later[0][2] if later else path.heading) if away else None
    return replace(path, stays=stays, heading=heading)


def place_of(
    path: Bundle, names: Sequence[str], worlds: Sequence[World], way: OnEdge | None
) -> Whereabouts:
    """Where somebody is at the end of a path, given how it is under way by the map.

    Worlds tell of it by any of some names.
    """
    depart, state = (path.stays[-1][1:]) if path.stays else (-1, None)
    if state is not None and depart >= worlds[-1].step:
        return state
    for world in worlds:
        if world.step <= depart:
            continue
        moved, late = _told(world.moved, names), _told(world.late, names)
        if isinstance(moved, OnEdge):
            way = moved
        if late is not None and way is not None:
            way = replace(way, arrives=way.arrives + late)
    if way is None:
        what = f"{names[0]} is nowhere after step {depart}, and it is not said where it goes"
        raise PlanError([Finding(what, f"say where it is at step {worlds[-1].step}")])
    if way.arrives <= worlds[-1].step:
        what = f"{names[0]} is to be on its way to {way.target} at step {worlds[-1].step}"
        raise PlanError([Finding(f"{what}, and arrives there at step {way.arrives}")])
    return way


_T = TypeVar("_T")


def _told(said: Mapping[str, _T], names: Iterable[str]) -> _T | None:
    return next((said[name] for name in names if name in said), None)


def told_path(world: World, maps: Maps, name: str, path: Bundle) -> Bundle:
    """The path until the step of a world of somebody of whom that tells by a name.

    Raises PlanError for what cannot be.
    """
    return _As(world, maps).told(name, path)


@dataclass(frozen=True)
class _As:
    """Paths as a world says that they were until its step."""

    world: World
    maps: Maps

    def told(self, name: str, path: Bundle) -> Bundle:
        """The path of somebody."""
        world = self.world
        self._refuse_twice(name)
        if name in world.lost:
            return replace(path, stays=clipped(path.stays, world.step - 1), heading=None)
        if name in world.moved:
            return self._moved(name, path)
        return self._late(name, path) if name in world.late else until(path, world.step)

    def _refuse_twice(self, name: str) -> None:
        said = [word for word in ("lost", "moved", "late") if name in getattr(self.world, word)]
        if len(said) > 1:
            raise PlanError(
                [Finding(f"agent {name} is said to be {' and '.join(said)}", "say one")]
            )

    def _moved(self, name: str, path: Bundle) -> Bundle:
        step, place = self.world.step, self.world.moved[name]
        before = clipped(path.stays, step - 1)
        if isinstance(place, OnEdge):
            ends = [place.source, place.target]
            if place.arrives <= step:
                what = f"agent {name} arrives at step {place.arrives}, and it is step {step}"
                raise PlanError([Finding(what, f"write a later step, or that it is at {ends[1]}")])
        else:
            ends = [place]
        for state in ends:
            self.maps.known_state(state, f"agent {name}")
        if isinstance(place, OnEdge):
            return replace(path, stays=before, heading=place.target)
        return replace(path, stays=tuple(joined([*before, (step, step, place)])), heading=None)

    def _late(self, name: str, path: Bundle) -> Bundle:
        step, late = self.world.step, self.world.late[name]
        made = until(path, step)
        if made.heading is not None:  # it is on the edge still
            return made
        *before, (first, last, state) = made.stays
        if not (before or path.coming):
            what = f"agent {name} has not moved by step {step}, so it is not late"
            raise PlanError([Finding(what, "say where it is with 'moved'")])
        if first + late <= step:
            return replace(made, stays=(*before, (first + late, last, state)))
        return replace(made, stays=tuple(before), heading=state)
