"""All agents of a plan that have paths: where they are expected, and what differs from that."""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.errors import Finding, InputError, nearest
from tsplan.history.past_structures import path_of
from tsplan.limits import clipped
from tsplan.monitoring.agent_tracks import (
    ON_ITS_WAY,
    PLANNED,
    Future,
    OnItsWay,
    Position,
    Route,
    Track,
    rolled,
    seen,
)
from tsplan.monitoring.planned_changes import Change, Codes, PlannedChanges
from tsplan.monitoring.rebuilding import Rebuild, Rebuilding
from tsplan.plans.agent_plans import Stay
from tsplan.plans.bundles import Bundle
from tsplan.words import nfc

if TYPE_CHECKING:
    from tsplan.plans.plan import Plan
    from tsplan.plans.structures import Structure

AWAY, LOST = -1, -2
"""What stands for an agent between two states, and for one that is lost, in arrays of positions."""

_BACK = -3  # an agent follows its path again


class Shift(NamedTuple):
    """Somebody with some capabilities stays otherwise than was expected before.

    `lost` are the agents that are: the robot, or the modules of the structure.
    """

    capabilities: frozenset[str]
    former: set[Stay]
    latter: set[Stay]
    lost: tuple[str, ...] = ()


@dataclass(slots=True)
class _Tracked:
    """An agent that does not simply follow its path; what was expected before is out of date."""

    track: Track
    future: Future
    version: int


class Fleet:
    """The robots and structures of a plan on a map, from step 0 on."""

    def __init__(
        self, plan: Plan, states: Iterable[str], edges: Container[tuple[str, str]]
    ) -> None:
        bundles, horizon = [*plan.robots, *map(_bundle, plan.structures)], plan.horizon
        robots = {name for each in plan.robots for name in each.agents}
        self.agents = (
            *(name for name in plan.agent if name in robots),
            *(each.id for each in plan.structures),
        )
        self.states = tuple(states)
        self._horizon = horizon
        self._edges = edges
        self._number = {state: number for number, state in enumerate(self.states)}
        self._row = {name: row for row, name in enumerate(self.agents)}
        self._modules = {self._row[each.id]: each.modules for each in plan.structures}
        self._rebuilding = Rebuilding(plan.rebuilt, plan.structures, self._row)
        self._bundle: list[Bundle] = [bundles[0]] * len(self.agents) if bundles else []
        self._routes: dict[int, Route] = {}
        self._tracked: dict[int, _Tracked] = {}
        self._versions = 0  # of futures, so that what is out of date is known
        self._off = np.zeros(len(self.agents), dtype=np.bool_)
        self._expected: Codes = np.full(len(self.agents), AWAY)
        self._changed: dict[int, list[tuple[int, int, int]]] = defaultdict(list)
        self._at = -1
        changes: list[Change] = []
        ways: list[list[int]] = []
        for number, bundle in enumerate(bundles):
            ways.append([self._row[name] for name in bundle.agents])
            self._routes[id(bundle)] = Route(bundle.stays, bundle.heading, horizon, bundle.coming)
            for row in ways[-1]:
                self._bundle[row] = bundle
            changes += (Change(s, number, code) for s, code in self._codes(bundle.stays, horizon))
        self._planned = PlannedChanges(changes, ways)

    def advance(self, step: int) -> None:
        """Go on to the next step; agents are expected where their ways lead them."""
        for row, version, code in self._changed.pop(step, ()):
            tracked = self._tracked.get(row)
            if tracked is not None and tracked.version == version:
                if code == _BACK:
                    del self._tracked[row]
                    self._off[row] = False
                else:
                    self._expected[row] = code
        if step == self._at:
            return
        self._at = step
        rows, codes = self._planned.at(step)
        if self._tracked:
            planned = ~self._off[rows]
            rows, codes = rows[planned], codes[planned]
        self._expected[rows] = codes

    def see(self, positions: Mapping[str, Position] | Codes, now: int) -> list[Shift]:
        """What differs from what was expected at a step.

        Raises InputError with everything that is wrong with the positions, and changes nothing.
        """
        if isinstance(positions, Mapping):
            reports = list(self._named(positions, now))
        else:
            reports = list(self._numbered(positions))
        shifts = [self._moved(row, position, now) for row, position in reports]
        return [*shifts, *self._rebuild({row for row, _ in reports}, now)]

    def _codes(self, stays: Iterable[Stay], horizon: int) -> Iterator[tuple[int, int]]:
        """From which step on which code is expected."""
        ends: int | None = None
        for first, last, state in stays:
            if ends is not None and ends < first:
                yield ends, AWAY
            yield first, self._number[state]
            ends = last + 1
        if ends is not None and ends <= horizon:
            yield ends, AWAY

    def _numbered(self, positions: Codes) -> Iterator[tuple[int, Position | OnItsWay]]:
        codes = np.asarray(positions)
        if codes.shape != self._expected.shape or codes.dtype.kind not in "iu":
            what = f"the positions are an array of {codes.dtype} of the shape {codes.shape}"
            remedy = f"give {len(self.agents):,} whole numbers, in the order of `agents`"
            raise InputError([Finding(what, remedy)])
        rows = np.flatnonzero(codes != self._expected).tolist()
        found, wrong = [], []
        for row, code in zip(rows, codes[rows].tolist(), strict=True):
            if not LOST <= code < len(self.states):
                remedy = f"states are 0..{len(self.states) - 1}; {AWAY} is away, {LOST} lost"
                wrong.append(Finding(f"{self.agents[row]} is at {code}", remedy))
            elif self._expected[row] == LOST:
                wrong.append(self._is_lost(row))
            else:
                found.append((row, _position(code, self.states)))
        if wrong:
            raise InputError(wrong)
        yield from found

    def _named(
        self, positions: Mapping[str, Position], now: int
    ) -> Iterator[tuple[int, Position | OnItsWay]]:
        found, wrong, told = [], [], set[int]()
        for given, position in positions.items():
            name = nfc(given) if isinstance(given, str) else given
            row = self._row.get(name)
            row = self._row_of(name, position, now) if row is None else row
            if row in told:
                wrong.append(Finding(f"{self.agents[row]} is told of twice", "say it once"))
                continue
            told.update(() if row is None else (row,))
            if row is None:
                remedy = nearest(name, self._row) if isinstance(name, str) else "give ids of agents"
                wrong.append(Finding(f"the plan has no agent {clipped(name)} with a path", remedy))
                continue
            fault = self._fault(row, position, now)
            if fault is not None:
                wrong.append(Finding(f"{name} is at {clipped(position)}", fault))
            elif self._expected[row] == LOST and position is not None:
                wrong.append(self._is_lost(row))
            elif not self._is_expected(row, position, now):
                found.append((row, position))
        if wrong:
            raise InputError(wrong)
        yield from found

    def _row_of(self, module: str, position: object, now: int) -> int | None:
        """The structure that a module is part of which is told to be at a position.

        Where it should be being rebuilt and is at a state, that has not begun.
        """
        *before, row = self._rebuilding.lives(module, now) or (None,)
        if row is None or not before or not isinstance(position, str):
            return row
        track = self._track(row, now)
        return before[-1] if track.place < 0 and (track.arrives or 0) > now else row

    def _fault(self, row: int, position: object, now: int) -> str | None:
        """What to do about a position that is none."""
        if position is None or (isinstance(position, str) and position in self._number):
            return None
        if isinstance(position, str):
            return nearest(position, self._number)
        if isinstance(position, tuple) and position in self._edges:
            return None
        if position == self._route(row).edge(-1) or self._goes_in(row, position, now):
            return None
        return "give a state, an edge of the map as (from, to), or None for an agent that is lost"

    def _is_lost(self, row: int) -> Finding:
        what = f"{self.agents[row]} was lost before, and what is lost is gone for good"
        return Finding(what, "make a monitor of a plan with the agents that are there")

    def _is_expected(self, row: int, position: Position, now: int) -> bool:
        code = int(self._expected[row])
        if position is None:
            return code == LOST
        if isinstance(position, str):
            return code == self._number[position]
        if code != AWAY:
            return False
        track = self._track(row, now)
        edge = track.route.edge(track.place) if track.strayed is None else track.strayed
        return edge == position or self._goes_in(row, position, now)

    def _track(self, row: int, step: int) -> Track:
        """Where an agent is at a step, as far as it is known."""
        tracked = self._tracked.get(row)
        if tracked is not None:
            return rolled(tracked.track, tracked.future, step)
        return rolled(self._route(row).beginning, PLANNED, step)

    def _route(self, row: int) -> Route:
        return self._routes[id(self._bundle[row])]

    def _moved(self, row: int, position: Position | OnItsWay, now: int) -> Shift:
        """An agent is elsewhere than it was expected."""
        before = max(now - 1, 0)
        if self._goes_in(row, position, before):
            self._rebuilding.into[row].begun = before
            return self._shift(row, self._route(row).end, now)
        return self._shift(row, seen(self._track(row, before), position, now), now)

    def _goes_in(self, row: int, position: object, step: int) -> bool:
        """Whether it is being rebuilt that is where it is to be, on the way from there to there."""
        if row not in self._rebuilding.into:
            return False
        track, there = self._track(row, step), self._route(row).stays[-1][2]
        at_end = track.strayed is None and not track.lost and track.place == track.route.end.place
        return at_end and position in (ON_ITS_WAY, (there, there))

    def _rebuild(self, told: Collection[int], now: int) -> Iterator[Shift]:
        """What waits for others, or does not any more, since some are elsewhere."""
        rows = deque(told)
        while rows:
            each = self._rebuilding.into.get(rows.popleft())
            if each is None:
                continue
            begins = each.ready([self._arrival(row) for row in each.parts], self._horizon)
            if begins == each.begins:
                continue
            each.begins = begins
            left = [row for row in each.parts if not self._is_gone(row)]
            yield from (self._shift(row, self._waiting(row, each, now), now) for row in left)
            for row, later in zip(each.made, each.later, strict=True):
                seen_there = row in told and self._track(row, now).place >= 0
                if not (seen_there or self._is_gone(row)):
                    comes = self._horizon + 1 if begins is None else begins + later
                    yield self._shift(row, replace(self._route(row).beginning, arrives=comes), now)
                    rows.append(row)

    def _is_gone(self, row: int) -> bool:
        """Whether somebody is lost."""
        return row in self._tracked and self._tracked[row].track.lost

    def _arrival(self, row: int) -> int | None:
        """When somebody comes to the end of its path, as things are; None if it does not."""
        tracked = self._tracked.get(row)
        if tracked is None:
            return self._route(row).beginning.arrival(PLANNED)
        return tracked.track.arrival(tracked.future)

    def _waiting(self, row: int, rebuild: Rebuild, now: int) -> Track:
        """Where a structure is that is to be rebuilt, as that is to begin."""
        track, end = self._track(row, now), self._route(row).end
        if track.lost or track.strayed is not None or track.place != end.place:
            return track
        if rebuild.begins is not None and rebuild.begins < now:
            return end
        return replace(end, arrives=None)  # it is not rebuilt yet

    def _shift(self, row: int, track: Track, now: int) -> Shift:
        """An agent goes on otherwise than it was expected to."""
        bundle, tracked = self._bundle[row], self._tracked.get(row)
        former = PLANNED if tracked is None else tracked.future
        future = track.future(now, self._rebuilding.ends(row, self._horizon))
        self._versions += 1
        self._tracked[row], self._off[row] = _Tracked(track, future, self._versions), True
        self._expected[row] = LOST if track.lost else AWAY
        lost = self._modules.get(row, (self.agents[row],)) if track.lost else ()
        for step, code in self._told(track, future):
            if step <= now:
                self._expected[row] = code
            else:
                self._changed[step].append((row, self._versions, code))
        upto = max(former.upto, future.upto)
        old, new = (track.route.ahead(each, now, upto) for each in (former, future))
        return Shift(bundle.capabilities, old - new, new - old, lost)

    def _told(self, track: Track, future: Future) -> Iterator[tuple[int, int]]:
        """From which step on an agent is expected where, until it follows its path again."""
        route = track.route
        yield from self._codes(future.stays, route.horizon)
        if future.upto < len(route.stays):
            yield route.stays[future.upto][0], _BACK


def _bundle(each: Structure) -> Bundle:
    """The path of a structure; one that is made of others comes from where that is done."""
    coming = each.stays[0][2] if each.first else each.coming
    return replace(path_of(each), agents=(each.id,), coming=coming)


def _position(code: int, states: Sequence[str]) -> Position | OnItsWay:
    if code == LOST:
        return None
    return ON_ITS_WAY if code == AWAY else states[code]
