"""What one class of agents can do on the map, as arrays over edges and nodes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from tsplan.milp.model import Bools, Floats, Ints
from tsplan.mission.resources import Carries
from tsplan.ts.closures import FOREVER
from tsplan.ts.reachability import Lengths


@dataclass(frozen=True, eq=False)
class Outcomes:
    """Where the agents of actions end: a part `chance` of those of `edge` at `head`.

    An edge that is `ending` is entered at the last step alone: agents that are at its state then.
    """

    edge: Ints
    head: Ints
    chance: Floats
    ending: Bools


@dataclass(frozen=True, eq=False)
class Modes:
    """What the nodes of a map are that are states in a mode; the first of them are the states.

    Of nodes: `place` is the state of each, and agents at `settled` ones are there for certain
    though they may be up to `delay` steps late. Of edges: `travel` is for how many steps agents
    move, `arrives` after how many they stop; for `lingers` steps after its end agents count at its
    head from before, as they do for `delay` steps after they leave; -1 if they do not. Of nodes
    again, those that are `recent` tell what agents left before.

    Where groups of a swarm move together the nodes are the states, and `standing` says that those
    count from below, at the settled states, who wait there for `delay` steps.
    """

    delay: int
    place: Ints
    settled: Bools
    lingers: Ints
    travel: Ints
    arrives: Ints
    recent: Bools
    standing: bool = False

    def along(self, paths: Sequence[Ints], duration: Ints) -> Modes:
        """The modes with edges that are paths of these, whose durations are given."""
        late = [np.cumsum(duration[path]) * (self.travel[path] > 0) for path in paths]
        return replace(
            self,
            lingers=np.array([self.lingers[path[-1]] for path in paths], dtype=np.int64),
            travel=np.array([self.travel[path].sum() for path in paths], dtype=np.int64),
            arrives=np.array([ends.max() for ends in late], dtype=np.int64),
        )


@dataclass(frozen=True, eq=False)
class Layer:
    """What the map of structures of one configuration has beside the map itself.

    Its last node is nowhere: structures go there to be rebuilt, by the edges from `rides` on that
    end there, and new ones come from there by those that begin there. `reach` is the first step at
    which a structure can be at each node, `begins` that at which each edge can be entered. There
    are `modules` in each structure, and at most `most` structures. Layers of the same modules have
    the same `pool`.
    """

    rides: int
    reach: Ints
    begins: Ints
    modules: int
    most: int
    pool: int


_OF_EDGES = ("tail", "head", "duration", "cost", "risk", "group")


@dataclass(frozen=True, eq=False)
class ClassGraph:
    """What one class of interchangeable agents can do on the map.

    Arrays run over the edges this class may use; states are numbers of the whole map, or nodes
    where the class has `modes`. `group` is the number of an edge's capacity group, or -1. Agents
    that start under way are at the nodes `coming`, each of which has one edge: the rest of the
    move that they began before, which is entered at step 0.
    """

    capabilities: frozenset[str]
    start: Ints  # agents of this class at each state at step 0
    tail: Ints
    head: Ints
    duration: Ints
    cost: Floats
    risk: Floats  # in millionths
    group: Ints
    carries: Carries = ()  # what each of them carries at most
    outcomes: Outcomes | None = None  # where edges are actions; `head` is some other state then
    modes: Modes | None = None
    layer: Layer | None = None
    entries: tuple[Ints, Ints] | None = None  # first and last step at which each edge is entered
    coming: Ints = field(default_factory=lambda: np.empty(0, dtype=np.int64))

    @property
    def begun(self) -> Bools:
        """Which edges are the rest of a move that was begun before; it is no move any more."""
        return np.isin(self.tail, self.coming)

    @property
    def timed(self) -> Bools:
        """Which edges may not be entered at all steps; those of starts under way aside."""
        if self.entries is None:
            return np.zeros(len(self.tail), dtype=np.bool_)
        first, last = self.entries
        return ((first > 0) | (last < FOREVER)) & ~self.begun

    @property
    def timeless(self) -> ClassGraph:
        """The map as if every edge might be entered at any step: a relaxation of it."""
        return self if self.entries is None else replace(self, entries=None)

    @property
    def still(self) -> Bools:
        """Which edges are waits of any kind: agents neither move nor are they on their way."""
        return np.equal(self.travel, 0) & ~self.begun

    @property
    def landed(self) -> Ints:
        """How many agents begin to move at each node: those under way where they come to."""
        landed = self.start.copy()
        landed[self.coming] = 0
        edges = np.flatnonzero(self.begun)
        np.add.at(landed, self.head[edges], self.start[self.tail[edges]])
        return landed

    @property
    def wait(self) -> Bools:
        """Which edges are waits (self-loops)."""
        return np.equal(self.tail, self.head)

    @property
    def states(self) -> int:
        """How many states the map has: the first of the nodes."""
        return len(self.start) if self.layer is None else len(self.start) - 1

    @property
    def avoidable(self) -> Bools:
        """Which edges are moves from where agents can as well wait for a step.

        What rebuilds structures is not: all edges of one reconfiguration are entered at once.
        """
        ride = np.zeros(len(self.tail), dtype=np.bool_)
        ride[self.rides] = True
        waiting = np.zeros(len(self.start), dtype=np.bool_)
        waiting[self.tail[ride & self.still & (self.duration == 1)]] = True
        return ride & ~self.wait & waiting[self.tail]

    @property
    def travel(self) -> Ints:
        """For how many steps agents move along each edge, or are rebuilt."""
        if self.modes is not None:
            return self.modes.travel
        moving = ~self.wait & ~self.begun
        if self.layer is not None:  # who is rebuilt counts where that begins
            moving &= self.tail < len(self.start) - 1
        return self.duration * moving

    @property
    def rides(self) -> Ints:
        """The edges that lead from state to state, waits too."""
        return np.arange(len(self.tail) if self.layer is None else self.layer.rides)

    @property
    def arrives(self) -> Ints:
        """After how many steps agents on each edge move no more."""
        return self.travel if self.modes is None else self.modes.arrives

    def nodes(self, states: Ints, *, settled: bool = True) -> Ints:
        """The nodes of states; if `settled` those at which agents count from below."""
        if self.modes is None:
            return states
        mine = np.isin(self.modes.place, states)
        return np.flatnonzero(mine & self.modes.settled if settled else mine)

    def half(self, number: int) -> int:
        """The edge that is one of those to and from nowhere."""
        assert self.layer is not None
        return self.layer.rides + number

    def among(self, edges: Ints) -> ClassGraph:
        """The map with some of its edges alone; of structures, which are never rebuilt."""
        arrays: dict[str, Any] = {name: getattr(self, name)[edges] for name in _OF_EDGES}
        if self.entries is not None:
            arrays["entries"] = self.entries[0][edges], self.entries[1][edges]
        return replace(self, layer=None, **arrays)

    def with_edges_of(self, other: ClassGraph, half: Ints) -> ClassGraph:
        """The map with the edges of another by which structures are rebuilt behind its own."""
        assert other.layer is not None
        arrays: dict[str, Any] = {
            name: np.concatenate([getattr(self, name), getattr(other, name)[half]])
            for name in _OF_EDGES
        }
        layer = replace(
            other.layer,
            rides=len(self.tail),
            begins=np.concatenate([other.layer.reach[self.tail], other.layer.begins[half]]),
        )
        return replace(self, layer=layer, **arrays)

    @property
    def agents(self) -> int:
        """How many agents the class has, or of structures can have."""
        return int(self.start.sum()) if self.layer is None else self.layer.most

    @property
    def modules(self) -> int:
        """How many robots each agent of the class is: those of structures are several."""
        return 1 if self.layer is None else self.layer.modules

    def waits(self, state: int, horizon: int) -> tuple[Ints, Ints] | None:
        """Edges and steps by which an agent waits at a state all the time; None if it cannot."""
        if state in self.coming:
            return None
        edges, steps, node, step = [], [], state, 0
        while step < horizon:
            stays = np.flatnonzero((self.tail == node) & self.still & self._open(step))
            if not len(stays):
                return None
            edges.append(int(stays[0]))
            steps.append(step)
            node, step = int(self.head[stays[0]]), step + int(self.duration[stays[0]])
        return np.array(edges, dtype=np.int64), np.array(steps, dtype=np.int64)

    def _open(self, step: int) -> Bools:
        """Which edges may be entered at a step."""
        if self.entries is None:
            return np.ones(len(self.tail), dtype=np.bool_)
        return (self.entries[0] <= step) & (step <= self.entries[1])

    @cached_property
    def lengths(self) -> Lengths:
        """The durations of the edges, for shortest ways."""
        if self.outcomes is not None:
            edge = self.outcomes.edge
            tail, head, duration = self.tail[edge], self.outcomes.head, self.duration[edge]
            return Lengths(len(self.start), tail, head, duration)
        return Lengths(len(self.start), self.tail, self.head, self.duration)

    def earliest(self, horizon: int) -> Ints:
        """First step at which an agent of the class can be at each state; horizon + 1 if never."""
        if self.layer is not None:
            return np.minimum(self.layer.reach, horizon + 1)
        sources = np.flatnonzero(self.start)
        if not len(sources):
            return np.full(len(self.start), horizon + 1)
        if self.entries is not None:
            return self._first_there(horizon)
        distance = self.lengths.nearest(sources, limit=float(horizon))
        return np.where(np.isfinite(distance), distance, horizon + 1).astype(np.int64)

    def _first_there(self, horizon: int) -> Ints:
        """The same where edges may not be entered at all steps, step by step.

        An agent may have to leave a state before another edge can be entered, so that it is known
        of every step whether anybody can be there.
        """
        there = np.zeros((horizon + 1, len(self.start)), dtype=np.bool_)
        there[0] = self.start > 0
        ends = np.minimum(self.duration, horizon + 1)
        for step in range(horizon):
            gone = there[step, self.tail] & self._open(step) & (step + ends <= horizon)
            there[step + ends[gone], self.head[gone]] = True
        first = there.argmax(axis=0)
        return np.where(there.any(axis=0), first, horizon + 1)
