"""Plan a mission of swarms: objectives one after the other, then how many agents go where.

Objectives that do not depend on sizes are first searched on the occupied model, which is much
smaller: its bound is a bound of the problem, and its best point settles the matter if agents can be
counted into its groups. Where they cannot, the counted model decides.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import TypeAlias

import numpy as np

from tsplan.encode.build import Encoded
from tsplan.encode.clock import Clock
from tsplan.encode.ideas import Idea
from tsplan.encode.network import Network
from tsplan.encode.search import Effort, Found, Reporter, Search
from tsplan.encode.stages import Reached
from tsplan.encode.swarm.goals import OF_GROUPS, VECTORS, late
from tsplan.encode.swarm.model import SwarmModel, moves_of
from tsplan.encode.swarm.scouting import scout
from tsplan.encode.swarm.shares import even_shares, sizes, with_smallest
from tsplan.milp.model import INFINITY, Floats, Model
from tsplan.milp.solution import Options, Solution, Status, StoppedBy
from tsplan.mission import Mission
from tsplan.results import Move

SwarmFlows: TypeAlias = Mapping[str, tuple[Move, ...]]
Tell: TypeAlias = Callable[[str, "SwarmFlows | None", "float | None", "float | None"], None]

_COUNTING = 10.0  # seconds for counting agents into known groups
_SHORTENING = 3.0  # seconds for a point of few moves before agents' travel is minimised
_FEASIBLE = 1e-6


@dataclass(frozen=True, eq=False)
class SwarmOutcome:
    """What all stages together know; `flows` are the moves of each swarm by its class name.

    `levels` has what is proven of the depths of a formula that may hold in part.
    """

    flows: SwarmFlows | None
    reached: tuple[Reached, ...]
    proven: bool
    infeasible: bool
    stopped_by: StoppedBy | None
    size: tuple[int, int, int, int]
    levels: tuple[Reached, ...] = ()


@dataclass(frozen=True)
class _Kept:
    """What earlier stages reached and later ones must not lose."""

    rows: tuple[tuple[str, float], ...] = ()
    makespan: int | None = None

    @property
    def of_groups(self) -> bool:
        """Whether it says nothing about sizes."""
        return all(name in OF_GROUPS for name, _ in self.rows)


@dataclass(eq=False)
class SwarmStages:
    """Runs the objectives of one problem in order; points are those of the counted model."""

    mission: Mission
    model: SwarmModel
    effort: Effort
    clock: Clock
    tell: Tell
    _point: Floats | None = field(default=None, init=False)
    _kept: _Kept = field(default=_Kept(), init=False)
    _stopped: StoppedBy | None = field(default=None, init=False)

    def run(self) -> SwarmOutcome:
        """All stages until the time is up; the best plan known is kept throughout."""
        names = self.mission.objective
        reached: list[Reached] = []
        proven = True
        if not names or names[0] not in VECTORS:
            found = self._search("splits", self._kept, first=True)
            if self._point is None:
                return self._outcome((), proven=False, infeasible=found.proven)
        for name in names:
            result, exact, impossible = self._stage(name)
            if self._point is None:
                return self._outcome((), proven=False, infeasible=impossible)
            reached.append(result)
            proven = proven and exact
        return self._outcome(tuple(reached), proven=proven, infeasible=False)

    def _outcome(
        self, reached: tuple[Reached, ...], *, proven: bool, infeasible: bool
    ) -> SwarmOutcome:
        size = self.model.counted.model.size
        stopped = None if proven or infeasible else self._stopped or self._limit()
        flows = None
        if self._point is not None:
            self._point = self._evened(self._point)
            flows = self._flows(self._point)
            reached = tuple(self._again(item, self._point) for item in reached)
        return SwarmOutcome(
            flows,
            reached,
            proven,
            infeasible,
            stopped,
            (size.columns, size.integers, size.rows, size.nonzeros),
        )

    def _again(self, item: Reached, point: Floats) -> Reached:
        """What is reached in the end: even shares may be better in what was not proven."""
        if item.name == "makespan":
            return replace(item, value=self._last_move(point))
        return replace(item, value=self._shown(item.name, self._value(item.name, point)))

    def _limit(self) -> StoppedBy:
        return StoppedBy.INTERRUPT if self.clock.stop() else StoppedBy.TIME_LIMIT

    def _stage(self, name: str) -> tuple[Reached, bool, bool]:
        """One objective: what is reached, whether that is proven, whether there is no plan."""
        if name == "makespan":
            return (*self._makespan(), False)
        found = self._search(name, self._kept)
        if self._point is None:
            return Reached(name, None, None), False, found.proven
        value = self._value(name, self._point)
        self._kept = replace(self._kept, rows=(*self._kept.rows, (name, value)))
        self._stopped = self._stopped or found.stopped_by
        exact = found.proven and found.stopped_by is None
        bound = min(found.bound, value) if np.isfinite(found.bound) else None
        return Reached(name, self._shown(name, value), self._shown(name, bound)), exact, False

    def _shown(self, name: str, value: float | None) -> float | None:
        """An objective's value as its name means it; the smallest sub-swarm is maximised."""
        if value is None:
            return None
        return 0.0 - value if name == "balance" else value

    # --- one objective -------------------------------------------------------------------------

    def _search(self, name: str, kept: _Kept, *, first: bool = False) -> Found:
        """The least value of an objective: by groups alone if that settles it."""
        self.tell(name, None, None, None)
        bound = -np.inf
        if name == "splits" and kept == _Kept():
            bound = self._scouted(first=first)
            known = np.inf if self._point is None else self._value(name, self._point)
            if known <= bound or (first and self._point is not None):
                value = None if self._point is None else known
                return Found(self._point, value, bound, proven=known <= bound)
        if name in OF_GROUPS and kept.of_groups:
            found = self._by_groups(name, kept, bound, first=first)
            settled = found.values is not None or (found.proven and found.objective is None)
            if settled or self.clock.over:
                return found
            bound = found.bound
        if name == "travel" and kept.of_groups:
            self._shortened(kept)
        found = self._by_counts(name, kept, first=first)
        return replace(found, bound=max(found.bound, bound))

    def _scouted(self, *, first: bool) -> float:
        """A bound on the number of splits; plans that are found on the way are kept."""
        bound = -np.inf
        for splits, point in scout(
            self.mission, self.model, self.clock, lambda model: self._solve(model, Options())
        ):
            if point is None:
                bound = splits
                self.tell("splits", None, None, bound)
                continue
            self._point = point
            self.tell("splits", self._flows(point), splits, bound)
            if first:
                break
        return bound

    def _by_groups(self, name: str, kept: _Kept, bound: float, *, first: bool) -> Found:
        """Search where the groups are. Without values: no plan if proven, else undecided."""
        encoded = self._narrowed(self.model.occupied, kept)
        vector = VECTORS[name](self.model, encoded.model.size.columns)
        heard: list[Floats] = []
        report = self._hearing(name, kept, heard)
        search = Search(encoded, vector, self.effort, self.clock, report)
        search.know(bound)
        start = None if first else self._start(encoded)
        found = search.minimise(start, first=first)
        if found.values is None:
            return found
        held = heard and self._value(name, heard[-1]) <= (found.objective or 0.0) + _FEASIBLE
        return found if held else Found(None, found.objective, found.bound, proven=False)

    def _hearing(self, name: str, kept: _Kept, heard: list[Floats]) -> Reporter:
        """Hears of groups, counts agents into them, and keeps and tells what can be counted."""

        def report(values: Floats | None, value: float | None, bound: float | None) -> None:
            point = None if values is None else self._counted(values, kept)
            if point is not None:
                heard.append(point)
                self._point = point
            flows = None if point is None else self._flows(point)
            self.tell(name, flows, value if values is None or point is not None else None, bound)

        return report

    def _by_counts(self, name: str, kept: _Kept, *, first: bool) -> Found:
        encoded = self._narrowed(self.model.counted, kept)
        if name == "balance":
            encoded, vector = self._balancing(encoded)
        else:
            vector = VECTORS[name](self.model, encoded.model.size.columns)
        columns = self.model.counted.model.size.columns

        def report(values: Floats | None, value: float | None, bound: float | None) -> None:
            flows = None if values is None else self._flows(values)
            self.tell(name, flows, self._shown(name, value), self._shown(name, bound))

        # a tree on the witnesses leaves open where the groups go: that is the solver's part
        plain = replace(self.effort, ideas=self.effort.ideas - {Idea.TREE})
        search = Search(encoded, vector, plain, self.clock, report)
        found = search.minimise(None if first else self._start(encoded), first=first)
        if found.values is not None:
            self._point = found.values[:columns]
        return found

    def _balancing(self, encoded: Encoded) -> tuple[Encoded, Floats]:
        """The model with a column for the smallest sub-swarm's size, which is maximised."""
        found = sizes(self.model)
        model = with_smallest(encoded.model, found, float(found.most.max(initial=0.0)))
        vector = np.zeros(model.size.columns)
        vector[-1] = -1.0
        flows = np.append(encoded.flows, model.size.columns - 1)
        return replace(encoded, model=model, flows=flows), vector

    def _makespan(self) -> tuple[Reached, bool]:
        assert self._point is not None
        low, high = 0, self._last_move(self._point)
        while low < high and not self.clock.over:
            probe = (low + high) // 2
            kept = replace(self._kept, makespan=probe)
            before = self._point
            found = self._search("splits", kept, first=True)
            if found.values is not None:
                high = min(probe, self._last_move(self._point))
            elif found.proven:
                low = probe + 1
            else:
                self._point = before
                break
            self.tell("makespan", None, high, low)
        self._kept = replace(self._kept, makespan=high)
        return Reached("makespan", high, low), low >= high

    # --- models and points ---------------------------------------------------------------------

    def _narrowed(self, encoded: Encoded, kept: _Kept) -> Encoded:
        """A model within what earlier stages reached."""
        model = encoded.model
        if kept.makespan is not None:
            upper = model.upper.copy()
            for swarm in self.model.swarms:
                upper[late(swarm, kept.makespan)] = 0.0
            model = model.with_bounds(model.lower, upper)
        for name, value in kept.rows:
            if name == "balance":
                model = self._at_least(model, -value)
                continue
            vector = VECTORS[name](self.model, model.size.columns)
            slack = 1e-6 * max(1.0, abs(value))
            model = model.with_row(vector, -INFINITY, value + slack, f"kept {name}")
        return replace(encoded, model=model)

    def _at_least(self, model: Model, size: float) -> Model:
        """The model in which every sub-swarm has at least `size` agents, by a fixed column."""
        wide = with_smallest(model, sizes(self.model), size)
        lower = wide.lower.copy()
        lower[-1] = size
        return wide.with_bounds(lower, wide.upper)

    def _start(self, encoded: Encoded) -> Floats | None:
        """The present point cut or filled up to a model, where it is one of its points."""
        point = self._point
        if point is None:
            return None
        count = encoded.model.size.columns
        if count > len(point):
            smallest = -self._value("balance", point)
            point = np.append(point, np.full(count - len(point), smallest))
        point = np.clip(point[:count], encoded.model.lower, encoded.model.upper)
        return point if encoded.model.violation(point) < _FEASIBLE else None

    def _counted(self, values: Floats, kept: _Kept) -> Floats | None:
        """Agents counted into the groups of a point of the occupied model, if they can be."""
        encoded = self._narrowed(self.model.counted, kept)
        columns = self.model.counted.indicators
        lower, upper = encoded.model.lower.copy(), encoded.model.upper.copy()
        lower[columns] = upper[columns] = np.round(values[columns])
        model = encoded.model.with_bounds(lower, upper)
        vector = VECTORS["travel"](self.model, model.size.columns)
        return self._solve(model.with_objective(vector), Options()).values

    def _shortened(self, kept: _Kept) -> None:
        """A better point to begin with: where groups move little, agents travel little."""
        encoded = self._narrowed(self.model.occupied, kept)
        vector = VECTORS["moves"](self.model, encoded.model.size.columns)

        def report(values: Floats | None, _value: float | None, _bound: float | None) -> None:
            point = None if values is None else self._counted(values, kept)
            if point is None:
                return
            travel = self._value("travel", point)
            if self._point is None or travel < self._value("travel", self._point):
                self._point = point
                self.tell("travel", self._flows(point), travel, None)

        clock = self.clock.within(_SHORTENING)
        Search(encoded, vector, self.effort, clock, report).minimise(self._start(encoded))

    def _solve(self, model: Model, options: Options) -> Solution:
        left = self.clock.within(_COUNTING).left
        asked = replace(
            options, time_limit=left, threads=self.effort.threads, seed=self.effort.seed
        )
        return self.effort.solver.solve(model, asked)

    def _evened(self, point: Floats) -> Floats:
        """The point with its shares settled: nothing that was reached is lost."""
        encoded = self._narrowed(self.model.counted, self._kept)
        count = self.model.counted.model.size.columns
        wide = encoded.model.size.columns - count
        fixed = self.model.counted.indicators
        values = np.append(point, np.full(wide, -self._value("balance", point) if wide else 0.0))

        def solve(model: Model) -> Solution:
            if self.clock.stop():
                return Solution(Status.UNKNOWN, StoppedBy.INTERRUPT)
            asked = Options(time_limit=_COUNTING / 2, threads=self.effort.threads)
            return self.effort.solver.solve(model, asked)

        return even_shares(self.model, encoded.model, values, fixed, solve)[:count]

    # --- reading points ------------------------------------------------------------------------

    def _value(self, name: str, point: Floats) -> float:
        """An objective's value, as it is minimised."""
        if name == "balance":
            found = sizes(self.model)
            size = found.base.copy()
            np.add.at(size, found.index, np.round(point[found.flow]))
            held = np.round(point[found.group]) > 0
            return -float(size[held].min(initial=INFINITY))
        return float(np.round(VECTORS[name](self.model, len(point)) @ point))

    def _last_move(self, point: Floats) -> int:
        last = 0
        for swarm in self.model.swarms:
            edge, step, column = swarm.entered.unrolled()
            graph = swarm.entered.graph
            made = (point[column] > 0.5) & ~graph.wait[edge]  # noqa: PLR2004 - a 0/1 column
            last = max(last, int((step + graph.duration[edge])[made].max(initial=0)))
        return last

    def _flows(self, point: Floats) -> SwarmFlows:
        """The moves of every swarm in a point."""
        return flows_of(self.mission, self.model.agents, point)


def flows_of(mission: Mission, agents: Network, point: Floats) -> SwarmFlows:
    """The moves of every swarm in a point of a counted model with the flows `agents`."""
    names = tuple(mission.system.states)
    found = {}
    for group, moves in zip(mission.team, moves_of(agents, point), strict=True):
        listed = (
            Move(when, names[source], names[target], number)
            for source, target, when, number in zip(
                *(column.tolist() for column in moves), strict=True
            )
        )
        found[group.class_name] = tuple(sorted(listed))
    return found
