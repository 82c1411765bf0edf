"""Plan a mission of swarms: objectives one after the other, then how many agents go where.

Objectives that do not depend on sizes are first searched on the occupied model, which is much
smaller: its bound is a bound of the problem, and its best point settles the matter if agents can be
counted into its groups. Where they cannot, the counted model decides.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import TypeAlias

import numpy as np

from tsplan.encode.assemble import Encoded
from tsplan.encode.groups.group_measures import SwarmFlows, flows_of, last_move, minimised, worth
from tsplan.encode.groups.group_objectives import OF_GROUPS, VECTORS, target
from tsplan.encode.groups.group_sizes import even_shares, sizes, with_smallest
from tsplan.encode.groups.guided_restriction import scout
from tsplan.encode.groups.kept import Kept
from tsplan.encode.groups.swarm_model import SwarmModel
from tsplan.encode.options import Idea
from tsplan.errors import SolverError
from tsplan.milp.confirmation import tried
from tsplan.milp.model import Floats, Model
from tsplan.milp.solution import Options, StoppedBy
from tsplan.mission import Mission
from tsplan.search.clock import Clock, Halted
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Reached
from tsplan.search.search import Found, Reporter, Search
from tsplan.search.target import Target

Tell: TypeAlias = Callable[[str, "SwarmFlows | None", "float | None", "float | None"], None]

_COUNTING = 10.0  # seconds for counting agents into known groups
_EVENING, _LATE = 5.0, 0.5  # seconds for even shares, and where the time is up
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
    notes: tuple[str, ...] = ()

    @classmethod
    def nothing(cls, halted: Halted) -> SwarmOutcome:
        """What is known where no model was made."""
        notes = (halted.words,) if halted.words else ()
        return cls(None, (), False, False, halted.reason, (0, 0, 0, 0), notes=notes)


@dataclass(frozen=True)
class _Ask:
    """What one search is for: the least value of an objective, or its `first` plan.

    `stage` is the objective whose values are told meanwhile, where that is another one.
    """

    name: str
    kept: Kept
    first: bool = False
    stage: str = ""

    @property
    def told(self) -> str:
        """The objective whose values are told."""
        return self.stage or self.name


@dataclass(eq=False)
class SwarmStages:
    """Runs the objectives of one problem in order; points are those of the counted model."""

    mission: Mission
    model: SwarmModel
    effort: Effort
    clock: Clock
    tell: Tell
    _point: Floats | None = field(default=None, init=False)
    _kept: Kept = field(default=Kept(), init=False)
    _stopped: StoppedBy | None = field(default=None, init=False)
    _notes: list[str] = field(default_factory=list, init=False)

    def run(self) -> SwarmOutcome:
        """All stages until the time is up; the best plan known is kept throughout."""
        names = self.mission.objective
        reached: list[Reached] = []
        if not names or names[0] not in VECTORS:
            found = self._search(_Ask("splits", self._kept, first=True))
            if self._point is None:
                return self._outcome((), infeasible=found.proven)
        for name in names:
            result, impossible = self._guarded(name)
            if self._point is None:
                return self._outcome((), infeasible=impossible)
            reached.append(result)
        return self._outcome(tuple(reached), infeasible=False)

    def _outcome(self, reached: tuple[Reached, ...], *, infeasible: bool) -> SwarmOutcome:
        size = self.model.counted.model.size
        flows = None
        if self._point is not None:
            point = self._point = self._evened(self._point)
            flows = self._flows(point)
            # even shares may be better in what was not proven
            reached = tuple(
                replace(item, value=worth(self.model, item.name, point)) for item in reached
            )
        proven = flows is not None and all(item.proven for item in reached)
        stopped = None
        if not proven and not infeasible:
            stopped = self._stopped or self.clock.stopped_by or StoppedBy.PRECISION
        return SwarmOutcome(
            flows,
            reached,
            proven,
            infeasible,
            stopped,
            (size.columns, size.integers, size.rows, size.nonzeros),
            notes=tuple(self._notes),
        )

    def _guarded(self, name: str) -> tuple[Reached, bool]:
        """One stage; where the solver contradicts itself, the plan that is known is kept."""
        try:
            return self._stage(name)
        except Halted as halted:
            self._notes += [halted.words] if halted.words else []
            self._stopped = self._stopped or halted.reason
            return Reached(name, None, None), False
        except SolverError as error:
            if self._point is None:
                raise
            self._notes.append(f"{name} is not proven: {error}")
            self._stopped = self._stopped or StoppedBy.PRECISION
            return Reached(name, None, None), False

    def _stage(self, name: str) -> tuple[Reached, bool]:
        """One objective: its bound, and whether there is no plan at all."""
        if name == "makespan":
            return self._makespan(), False
        found = self._search(_Ask(name, self._kept))
        if self._point is None:
            return Reached(name, None, None), found.proven
        value = self._value(name, self._point)
        self._kept = replace(self._kept, rows=(*self._kept.rows, (name, value)))
        self._stopped = self._stopped or found.stopped_by
        bound = min(found.bound, value) if np.isfinite(found.bound) else None
        if bound is not None and name == "balance":
            bound = 0.0 - bound
        return Reached(name, None, bound), False

    # --- one objective -------------------------------------------------------------------------

    def _search(self, ask: _Ask) -> Found:
        """The least value of an objective: by groups alone if that settles it."""
        name, kept = ask.name, ask.kept
        self.tell(ask.told, None, None, None)
        bound = -np.inf
        if name == "splits" and kept == Kept():
            bound = self._scouted(first=ask.first)
            known = np.inf if self._point is None else self._value(name, self._point)
            if known <= bound or (ask.first and self._point is not None):
                value = None if self._point is None else known
                return Found(self._point, value, bound, proven=known <= bound)
        if name in OF_GROUPS and kept.of_groups:
            found = self._by_groups(ask, bound)
            settled = found.values is not None or (found.proven and found.objective is None)
            if settled or self.clock.over:
                return found
            bound = found.bound
        if name == "travel" and kept.of_groups:
            self._shortened(kept)
        return self._by_counts(ask, bound)

    def _scouted(self, *, first: bool) -> float:
        """A bound on the number of splits; plans that are found on the way are kept."""
        bound = -np.inf
        for splits, point in scout(self.mission, self.model, self.clock, self._solve):
            if point is None:
                bound = splits
                self.tell("splits", None, None, bound)
                continue
            self._point = point
            self.tell("splits", self._flows(point), splits, bound)
            if first or self.clock.over:
                break
        return bound

    def _by_groups(self, ask: _Ask, bound: float) -> Found:
        """Search where the groups are. Without values: no plan if proven, else undecided."""
        name, kept, first = ask.name, ask.kept, ask.first
        encoded = self._narrowed(self.model.occupied, kept)
        aim = target(self.model, name, encoded.model.size.columns)
        heard: list[Floats] = []
        report = self._hearing(ask, heard)
        search = Search(encoded, aim, self.effort, self.clock, report)
        search.know(bound)
        start = None if first else self._start(encoded)
        found = search.minimise(start, first=first)
        if found.values is None:
            return found
        held = heard and self._value(name, heard[-1]) <= (found.objective or 0.0)
        return found if held else Found(None, found.objective, found.bound, proven=False)

    def _hearing(self, ask: _Ask, heard: list[Floats]) -> Reporter:
        """Hears of groups, counts agents into them, and keeps and tells what can be counted.

        A search for any plan has no bound that could be told.
        """

        def report(values: Floats | None, _value: float | None, bound: float | None) -> None:
            point = None if values is None else self._counted(values, ask.kept)
            if point is not None:
                heard.append(point)
            self._heard(ask.told, point, None if ask.first else bound)

        return report

    def _heard(self, name: str, point: Floats | None, bound: float | None) -> None:
        """Keep a point of the counted model, and tell of it and of a bound in the own unit."""
        if point is not None:
            self._point = point
        best = None if self._point is None else worth(self.model, name, self._point)
        if point is not None or bound is not None:
            self.tell(name, None if point is None else self._flows(point), best, bound)

    def _by_counts(self, ask: _Ask, bound: float) -> Found:
        name, kept, first = ask.name, ask.kept, ask.first
        encoded = self._narrowed(self.model.counted, kept)
        if name == "balance":
            encoded, aim = self._balancing(encoded)
        else:
            aim = target(self.model, name, encoded.model.size.columns)
        columns = self.model.counted.model.size.columns

        def report(values: Floats | None, _value: float | None, bound: float | None) -> None:
            shown = None if first or bound is None else aim.own(bound)
            self._heard(ask.told, None if values is None else values[:columns], shown)

        # a tree on the witnesses leaves open where the groups go: that is the solver's part
        plain = replace(self.effort, ideas=self.effort.ideas - {Idea.TREE})
        search = Search(encoded, aim, plain, self.clock, report)
        search.know(bound)
        return search.minimise(None if first else self._start(encoded), first=first)

    def _balancing(self, encoded: Encoded) -> tuple[Encoded, Target]:
        """The model with a column for the smallest sub-swarm's size, which is maximised."""
        found = sizes(self.model)
        model = with_smallest(encoded.model, found, float(found.most.max(initial=0.0)))
        vector = np.zeros(model.size.columns)
        vector[-1] = -1.0
        flows = np.append(encoded.flows, model.size.columns - 1)
        return replace(encoded, model=model, flows=flows), Target(vector, Fraction(-1))

    def _makespan(self) -> Reached:
        assert self._point is not None
        low, high = 0, last_move(self.model, self._point)
        while low < high and not self.clock.over:
            probe = (low + high) // 2
            kept = replace(self._kept, makespan=probe)
            before = self._point
            found = self._search(_Ask("splits", kept, first=True, stage="makespan"))
            if found.values is not None:
                high = min(probe, last_move(self.model, self._point))
            elif found.proven:
                low = probe + 1
            else:
                self._point = before
                self._stopped = self._stopped or found.stopped_by
                break
            self.tell("makespan", None, high, low)
        self._kept = replace(self._kept, makespan=high)
        return Reached("makespan", None, low)

    # --- models and points ---------------------------------------------------------------------

    def _narrowed(self, encoded: Encoded, kept: Kept) -> Encoded:
        return kept.narrow(self.model, encoded)

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

    def _counted(self, values: Floats, kept: Kept) -> Floats | None:
        """Agents counted into the groups of a point of the occupied model, if they can be."""
        encoded = self._narrowed(self.model.counted, kept)
        columns = self.model.counted.indicators
        lower, upper = encoded.model.lower.copy(), encoded.model.upper.copy()
        lower[columns] = upper[columns] = np.round(values[columns])
        model = encoded.model.with_bounds(lower, upper)
        vector = VECTORS["travel"](self.model, model.size.columns)
        return self._solve(model.with_objective(vector))

    def _shortened(self, kept: Kept) -> None:
        """A better point to begin with: where groups move little, agents travel little."""
        encoded = self._narrowed(self.model.occupied, kept)
        aim = target(self.model, "moves", encoded.model.size.columns)

        def report(values: Floats | None, _value: float | None, _bound: float | None) -> None:
            point = None if values is None else self._counted(values, kept)
            if point is None:
                return
            travel = self._value("travel", point)
            if self._point is None or travel < self._value("travel", self._point):
                self._heard("travel", point, None)

        clock = self.clock.within(_SHORTENING)
        Search(encoded, aim, self.effort, clock, report).minimise(self._start(encoded))

    def _solve(self, model: Model) -> Floats | None:
        """A point of a part of the problem, if it is found soon."""
        options = Options(
            time_limit=self.clock.within(_COUNTING).left,
            threads=self.effort.threads,
            seed=self.effort.seed,
            stop=self.clock.stop,
        )
        return tried(self.effort.solver, model, options)

    def _evened(self, point: Floats) -> Floats:
        """The point with its shares settled: nothing that was reached is lost."""
        encoded = self._narrowed(self.model.counted, self._kept)
        count = self.model.counted.model.size.columns
        wide = encoded.model.size.columns - count
        fixed = self.model.counted.indicators
        values = np.append(point, np.full(wide, -self._value("balance", point) if wide else 0.0))

        def solve(model: Model) -> Floats | None:
            if self.clock.stop():
                return None
            left = self.clock.left
            seconds = _EVENING if left is None else min(max(left, _LATE), _EVENING)
            options = Options(time_limit=seconds, threads=self.effort.threads, stop=self.clock.stop)
            return tried(self.effort.solver, model, options)

        return even_shares(self.model, encoded.model, values, fixed, solve)[:count]

    # --- reading points ------------------------------------------------------------------------

    def _value(self, name: str, point: Floats) -> float:
        return minimised(self.model, name, point)

    def _flows(self, point: Floats) -> SwarmFlows:
        return flows_of(self.mission, self.model.agents, point)
