"""Objectives one after the other: the first matters most, and what is reached is kept.

`travel`, `cost`, `agents` and a user's own objective are minimised as linear functions of the
flows. `availability` and `makespan` are levels of the model itself: raising every need by r, or
forbidding arrivals after a step. They are searched by bisection between the level of the best plan
known and a free bound, and each probe ends with its first plan or with a proof that there is none.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from tsplan.encode import objectives
from tsplan.encode.build import Encoded, Setting, reference, tight
from tsplan.encode.chains import chain_model, first_flows
from tsplan.encode.clock import Clock
from tsplan.encode.constraints import CountTerm, resolve
from tsplan.encode.ideas import Idea
from tsplan.encode.network import unroll
from tsplan.encode.outlook import Outlook
from tsplan.encode.search import Effort, Found, Search
from tsplan.milp.model import INFINITY, Draft, Floats
from tsplan.milp.solution import StoppedBy


@dataclass(frozen=True, eq=False)
class Point:
    """A point of a model: enough to read the agents' moves off it."""

    encoded: Encoded
    values: Floats
    tight: bool


@dataclass(frozen=True)
class Measured:
    """What a plan is worth, as the independent evaluator sees it."""

    availability: float
    makespan: int


@dataclass(frozen=True)
class Reached:
    """The value and the true bound of one objective."""

    name: str
    value: float | None
    bound: float | None


@dataclass(frozen=True, eq=False)
class Outcome:
    """What all stages together know."""

    point: Point | None
    reached: tuple[Reached, ...]
    proven: bool
    infeasible: bool
    stopped_by: StoppedBy | None
    size: tuple[int, int, int, int]
    levels: tuple[Reached, ...] = ()  # what an objective consists of that is settled in steps


@dataclass(frozen=True)
class Kept:
    """What earlier stages reached and later ones must not lose."""

    level: int = 0
    makespan: int | None = None
    rows: tuple[tuple[str, float], ...] = ()


@dataclass(eq=False)
class Stages:
    """Runs the objectives of a problem in order."""

    setting: Setting
    effort: Effort
    clock: Clock
    measure: Callable[[Point], Measured]
    tell: Callable[[str, Point | None, float | None, float | None], None]
    objective: tuple[str, ...]
    own: tuple[tuple[CountTerm, float], ...] = ()
    tight: bool = True
    known: Floats | None = None  # flows of a plan that is known
    _point: Point | None = field(default=None, init=False)
    _kept: Kept = field(default=Kept(), init=False)
    _stopped: StoppedBy | None = field(default=None, init=False)
    _size: tuple[int, int, int, int] = field(default=(0, 0, 0, 0), init=False)

    def run(self) -> Outcome:
        """All stages until the time is up; the best plan known is kept throughout."""
        names = self.objective
        first = self._first_plan(linear=names[0] if names and names[0] in _LINEAR else None)
        if self._point is None:
            return self._outcome((), proven=False, infeasible=first.proven)
        reached = []
        proven = True
        for number, name in enumerate(names):
            result, certain = self._stage(name, first if number == 0 else None)
            reached.append(result)
            proven = proven and certain
        return self._outcome(tuple(reached), proven=proven, infeasible=False)

    def _outcome(self, reached: tuple[Reached, ...], *, proven: bool, infeasible: bool) -> Outcome:
        stopped = None if proven or infeasible else self._stopped or StoppedBy.TIME_LIMIT
        return Outcome(self._point, reached, proven, infeasible, stopped, self._size)

    def _first_plan(self, linear: str | None) -> Found:
        """Any plan; a linear first objective is minimised to its end at once."""
        encoded = self._build(self._kept)
        objective = self._linear(encoded, linear or "travel")
        return self._search(encoded, objective, linear or "first plan", first=linear is None)

    def _stage(self, name: str, done: Found | None) -> tuple[Reached, bool]:
        if name in _LINEAR:
            return self._minimise(name, done)
        if name == "availability":
            if np.isinf(self._outlook()):  # the formula is true whatever the agents do
                return Reached(name, None, None), True
            return self._availability() if self.tight else self._minimise(name, None)
        return self._makespan()

    # --- linear objectives -------------------------------------------------------------------

    def _minimise(self, name: str, done: Found | None) -> tuple[Reached, bool]:
        found = done
        if found is None:
            encoded = self._build(self._kept)
            found = self._search(encoded, self._linear(encoded, name), name)
        if found.objective is None:
            found = self._as_it_is(name, found)
        value = found.objective
        assert value is not None
        self._kept = replace(self._kept, rows=(*self._kept.rows, (name, value)))
        self._stopped = self._stopped or found.stopped_by
        exact = found.proven and found.stopped_by is None
        bound = self._shown(name, found.bound if np.isfinite(found.bound) else None)
        return Reached(name, self._shown(name, value), bound), exact

    def _as_it_is(self, name: str, found: Found) -> Found:
        """The present plan's value where a later stage ran out of time before finding a point."""
        point = self._point
        assert point is not None
        value = float(self._linear(point.encoded, name) @ point.values)
        return replace(found, values=point.values, objective=value)

    def _linear(self, encoded: Encoded, name: str) -> Floats:
        count = encoded.model.size.columns
        if name == "travel":
            return objectives.travel(encoded.network, count)
        if name == "cost":
            return objectives.cost(encoded.network, count)
        vector = np.zeros(count)
        if name == "agents":
            vector[encoded.stayers] = -1.0
        elif name == "availability":
            vector[encoded.rho] = -1.0
        else:
            mission = self.setting.mission
            columns, values, _ = resolve(
                self.own, mission.system, self.setting.arrays, encoded.network
            )
            np.add.at(vector, columns, values)
        return vector

    def _shown(self, name: str, value: float | None) -> float | None:
        """An objective's value as its name means it, from the value that was minimised."""
        if value is None:
            return None
        if name == "availability":
            return 0.0 - value
        return value + self.setting.mission.size if name == "agents" else value

    # --- levels ------------------------------------------------------------------------------

    def _availability(self) -> tuple[Reached, bool]:
        assert self._point is not None
        low = self.measure(self._point).availability
        high = self._outlook()
        while low < high and not self.clock.over:
            probe = int(low + (high - low + 1) // 2)
            found = self._probe(replace(self._kept, level=probe), "availability")
            if found.values is not None:
                low = max(float(probe), self.measure(self._point).availability)
            elif found.proven:
                high = probe - 1
            else:
                break
            self.tell("availability", None, low, high)
        self._kept = replace(self._kept, level=int(low))
        return Reached("availability", low, max(high, low)), low >= high

    def _makespan(self) -> tuple[Reached, bool]:
        assert self._point is not None
        low, high = 0, self.measure(self._point).makespan
        while low < high and not self.clock.over:
            probe = (low + high) // 2
            found = self._probe(replace(self._kept, makespan=probe), "makespan")
            if found.values is not None:
                high = min(probe, self.measure(self._point).makespan)
            elif found.proven:
                low = probe + 1
            else:
                break
            self.tell("makespan", None, high, low)
        self._kept = replace(self._kept, makespan=high)
        return Reached("makespan", high, low), low >= high

    def _probe(self, kept: Kept, name: str) -> Found:
        """Any plan that keeps what `kept` says; travel guides the search."""
        encoded = self._build(kept)
        return self._search(encoded, self._linear(encoded, "travel"), name, first=True)

    def _outlook(self) -> float:
        """The free bound on availability: every atom on its own, by team and travel times."""
        setting = self.setting
        network = unroll([item.graph for item in setting.reduced], setting.horizon, Draft())
        outlook = Outlook(setting.goal, network, setting.requirement(0))
        return outlook.best(setting.goal, 0)

    # --- models ------------------------------------------------------------------------------

    def _build(self, kept: Kept) -> Encoded:
        if self.tight:
            encoded = replace(tight(self.setting, kept.level), level=kept.level)
        else:
            most = max(self._outlook(), 0.0)
            high = kept.level if np.isinf(most) else int(most)
            encoded = reference(self.setting, (kept.level, high))
        model = encoded.model
        if kept.makespan is not None:
            upper = model.upper.copy()
            upper[objectives.late_moves(encoded.network, kept.makespan)] = 0.0
            model = model.with_bounds(model.lower, upper)
        encoded = replace(encoded, model=model)
        encoded = self._with_rows(encoded, kept)
        size = encoded.model.size
        self._size = (size.columns, size.integers, size.rows, size.nonzeros)
        return encoded

    def _with_rows(self, encoded: Encoded, kept: Kept) -> Encoded:
        """The model with the values that earlier objectives must keep."""
        model = encoded.model
        for name, value in kept.rows:
            vector = self._linear(encoded, name)
            slack = 1e-6 * max(1.0, abs(value))
            model = model.with_row(vector, -INFINITY, value + slack, f"kept {name}")
        return replace(encoded, model=model)

    def _search(
        self, encoded: Encoded, objective: Floats, name: str, *, first: bool = False
    ) -> Found:
        def report(values: Floats | None, value: float | None, bound: float | None) -> None:
            point = None if values is None else Point(encoded, values, self.tight)
            self.tell(name, point, self._shown(name, value), self._shown(name, bound))

        self.tell(name, None, None, None)
        effort = self.effort
        if not self.tight:
            effort = replace(effort, ideas=frozenset())
        search = Search(encoded, objective, effort, self.clock, report)
        if encoded.shared and Idea.CHAINS in effort.ideas:
            chained = partial(self._chained, encoded, effort)
            if self._point is None:
                search.scout = chained
            else:
                search.rescue = chained
        if self.known is not None and self._point is None:
            search.scout = self._recalled
        found = search.minimise(None if first else self._start(encoded), first=first)
        if found.values is not None:
            self._point = Point(encoded, found.values, self.tight)
        return found

    def _recalled(self) -> Floats | None:
        return self.known

    def _chained(self, encoded: Encoded, effort: Effort) -> Floats | None:
        """Flows of a plan found by way of the chained restriction, in a part of the time."""
        restricted = self._restricted(encoded)
        left = self.clock.left
        budget = _CHAIN_SECONDS if left is None else min(_CHAIN_SECONDS, left / 2)
        objective = self._linear(restricted, "travel")
        return first_flows(restricted, objective, effort, self.clock.within(budget))

    def _restricted(self, encoded: Encoded) -> Encoded:
        """The chained model within the bounds and kept rows of the exact one."""
        restricted = chain_model(self.setting, encoded.level)
        model = restricted.model
        upper = model.upper.copy()
        upper[restricted.flows] = encoded.model.upper[encoded.flows]
        restricted = replace(restricted, model=model.with_bounds(model.lower, upper))
        return self._with_rows(restricted, self._kept)

    def _start(self, encoded: Encoded) -> Floats | None:
        """The present point, where it is one of this model too."""
        point = self._point
        if point is None or len(point.values) != encoded.model.size.columns:
            return None
        return point.values if encoded.model.violation(point.values) < _FEASIBLE else None


_FEASIBLE = 1e-6
_CHAIN_SECONDS = 15.0
_LINEAR = frozenset({"travel", "cost", "agents", "own"})
