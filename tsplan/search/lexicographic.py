"""Objectives one after the other: the first matters most, and what is reached is kept.

`travel`, `cost`, `agents` and a user's own objective are minimised as linear functions of the
flows. `availability` and `makespan` are levels of the model itself: raising every need by r, or
forbidding arrivals after a step. They are searched by bisection between the level of the best plan
known and a free bound, and each probe ends with its first plan or with a proof that there is none.

What a plan is worth is measured on its moves, never read from columns: a point on the way may have
columns that count too little or too much, its moves are what agents do.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial

import numpy as np

from tsplan.encode import objectives
from tsplan.encode.assemble import Encoded, Setting, reference, tight
from tsplan.encode.expressions import NO_OWN, Own
from tsplan.encode.flow_network import unroll
from tsplan.encode.memory import Watch
from tsplan.encode.options import Idea
from tsplan.encode.own_constraints import resolve
from tsplan.encode.robustness_bound import Outlook
from tsplan.errors import SolverError
from tsplan.milp.model import Draft, Floats
from tsplan.milp.solution import StoppedBy
from tsplan.search.chained_witnesses import chain_model, first_flows
from tsplan.search.clock import Clock, Halted
from tsplan.search.effort import Effort
from tsplan.search.search import Found, Search
from tsplan.search.target import CLOSED, Target


@dataclass(frozen=True, eq=False)
class Point:
    """A point of a model: enough to read the agents' moves off it."""

    encoded: Encoded
    values: Floats
    tight: bool


@dataclass(frozen=True)
class Reached:
    """What a plan comes to in one objective, and the true bound, both in its own unit."""

    name: str
    value: float | None
    bound: float | None

    @property
    def proven(self) -> bool:
        """Whether no plan does better."""
        return self.value is not None and self.value == self.bound


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
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Kept:
    """What earlier stages reached and later ones must not lose; rows hold values of targets."""

    level: int = 0
    makespan: int | None = None
    rows: tuple[tuple[str, float], ...] = ()


@dataclass(eq=False)
class Stages:
    """Runs the objectives of a problem in order."""

    setting: Setting
    effort: Effort
    clock: Clock
    measure: Callable[[Point, str], float]
    tell: Callable[[str, Point | None, float | None, float | None], None]
    objective: tuple[str, ...]
    own: Own = NO_OWN
    tight: bool = True
    known: Floats | None = None  # flows of a plan that is known
    _point: Point | None = field(default=None, init=False)
    _kept: Kept = field(default=Kept(), init=False)
    _stopped: StoppedBy | None = field(default=None, init=False)
    _size: tuple[int, int, int, int] = field(default=(0, 0, 0, 0), init=False)
    _notes: list[str] = field(default_factory=list, init=False)

    def __post_init__(self) -> None:
        self.setting = replace(self.setting, clock=self.clock)

    def run(self) -> Outcome:
        """All stages until the time is up; the best plan known is kept throughout."""
        names = self.objective
        try:
            first = self._first_plan(linear=names[0] if names and names[0] in _LINEAR else None)
        except Halted as halted:
            first = self._halted(halted)
        if self._point is None:
            return self._outcome((), infeasible=first.proven)
        reached = [
            self._guarded(name, first if number == 0 else None) for number, name in enumerate(names)
        ]
        return self._outcome(tuple(reached), infeasible=False)

    def _outcome(self, reached: tuple[Reached, ...], *, infeasible: bool) -> Outcome:
        point = self._point
        if point is not None:
            reached = tuple(replace(item, value=self._worth(point, item.name)) for item in reached)
        proven = point is not None and all(item.proven for item in reached)
        stopped = None
        if not proven and not infeasible:
            stopped = self._stopped or self.clock.stopped_by or StoppedBy.PRECISION
        notes = tuple(self._notes)
        return Outcome(point, reached, proven, infeasible, stopped, self._size, notes=notes)

    def _worth(self, point: Point, name: str) -> float:
        """An objective's value in the plan of a point."""
        if name != "own":
            return self.measure(point, name)
        target = self._target(point.encoded, name)
        return target.own(target.value(point.values))

    def _guarded(self, name: str, done: Found | None) -> Reached:
        """One stage; where the solver contradicts itself, the plan that is known is kept."""
        try:
            return self._stage(name, done)
        except Halted as halted:
            self._halted(halted)
            return Reached(name, None, None)
        except SolverError as error:
            self._notes.append(f"{name} is not proven: {error}")
            self._stopped = self._stopped or StoppedBy.PRECISION
            return Reached(name, None, None)

    def _halted(self, halted: Halted) -> Found:
        """A search whose model was not made."""
        self._stopped = self._stopped or halted.reason
        self._notes += [halted.words] if halted.words else []
        return Found(None, None, -np.inf, proven=False, stopped_by=halted.reason)

    def _first_plan(self, linear: str | None) -> Found:
        """Any plan; a linear first objective is minimised to its end at once."""
        encoded = self._build(self._kept)
        target = self._target(encoded, linear or "travel")
        return self._search(encoded, target, linear or "first plan", first=linear is None)

    def _stage(self, name: str, done: Found | None) -> Reached:
        if name in _LINEAR:
            return self._minimise(name, done)
        if name == "availability":
            if np.isinf(self._outlook()):  # the formula is true whatever the agents do
                return Reached(name, None, np.inf)
            return self._availability() if self.tight else self._minimise(name, None)
        return self._makespan()

    # --- linear objectives -------------------------------------------------------------------

    def _minimise(self, name: str, done: Found | None) -> Reached:
        found = done
        if found is None:
            encoded = self._build(self._kept)
            found = self._search(encoded, self._target(encoded, name), name)
        point = self._point
        assert point is not None
        target = self._target(point.encoded, name)
        if not target.step:
            self._notes.append(f"{name} is told apart to {CLOSED:.0e} of its size")
        value = target.value(point.values)
        self._kept = replace(self._kept, rows=(*self._kept.rows, (name, value)))
        self._stopped = self._stopped or found.stopped_by
        bound = value if found.proven else found.bound
        return Reached(name, None, target.own(bound) if np.isfinite(bound) else None)

    def _target(self, encoded: Encoded, name: str) -> Target:
        """A linear objective over the columns of a model."""
        count = encoded.model.size.columns
        if name == "travel":
            return Target(objectives.travel(encoded.network, count))
        if name == "cost":
            unit = self.setting.mission.system.cost_unit
            return Target(objectives.cost(encoded.network, count), unit)
        if name == "own":
            return self._own(encoded)
        vector = np.zeros(count)
        if name == "agents":
            vector[encoded.stayers] = -1.0
            return Target(vector, constant=Fraction(self.setting.mission.size))
        vector[encoded.rho] = -1.0
        return Target(vector, Fraction(-1))

    def _own(self, encoded: Encoded) -> Target:
        """A user's own sum, counted in whole units where its coefficients allow it."""
        system, arrays = self.setting.mission.system, self.setting.arrays
        terms: dict[int, Fraction] = {}
        constant = self.own.expression.constant
        for term, factor in self.own.expression.terms:
            columns, fixed = resolve(term, system, arrays, encoded.network)
            constant += factor * fixed
            for column in columns.tolist():
                terms[column] = terms.get(column, Fraction(0)) + factor
        most = self.setting.mission.size
        maximise = self.own.maximised
        count = encoded.model.size.columns
        return Target.of(terms, count, constant, most=most, maximise=maximise)

    # --- levels ------------------------------------------------------------------------------

    def _availability(self) -> Reached:
        assert self._point is not None
        low = self.measure(self._point, "availability")
        high = self._outlook()
        while low < high and not self.clock.over:
            probe = int(low + (high - low + 1) // 2)
            found = self._probe(replace(self._kept, level=probe), "availability", high)
            if found.values is not None:
                low = max(float(probe), self.measure(self._point, "availability"))
            elif found.proven:
                high = probe - 1
            else:
                self._stopped = self._stopped or found.stopped_by
                break
            self.tell("availability", None, low, high)
        self._kept = replace(self._kept, level=int(low))
        return Reached("availability", None, max(high, low))

    def _makespan(self) -> Reached:
        assert self._point is not None
        low, high = 0, int(self.measure(self._point, "makespan"))
        while low < high and not self.clock.over:
            probe = (low + high) // 2
            found = self._probe(replace(self._kept, makespan=probe), "makespan", low)
            if found.values is not None:
                high = min(probe, int(self.measure(self._point, "makespan")))
            elif found.proven:
                low = probe + 1
            else:
                self._stopped = self._stopped or found.stopped_by
                break
            self.tell("makespan", None, high, low)
        self._kept = replace(self._kept, makespan=high)
        return Reached("makespan", None, low)

    def _probe(self, kept: Kept, name: str, bound: float) -> Found:
        """Any plan that keeps what `kept` says; travel guides the search.

        `bound` is what is known of the objective that is probed.
        """
        try:
            encoded = self._build(kept)
        except Halted as halted:
            return self._halted(halted)
        return self._search(encoded, self._target(encoded, "travel"), name, first=True, known=bound)

    def _outlook(self) -> float:
        """The free bound on availability: every atom on its own, by team and travel times."""
        setting = self.setting
        network = unroll(
            [item.graph for item in setting.reduced], setting.horizon, Draft(Watch(self.clock))
        )
        outlook = Outlook(setting.goal, network, setting.requirement(0))
        return outlook.best(setting.goal, 0)

    # --- models ------------------------------------------------------------------------------

    def _build(self, kept: Kept) -> Encoded:
        with self.clock.timed("build"):
            return self._built(kept)

    def _built(self, kept: Kept) -> Encoded:
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
            model = self._target(encoded, name).kept(model, value, f"kept {name}")
        return replace(encoded, model=model)

    def _search(
        self,
        encoded: Encoded,
        target: Target,
        name: str,
        *,
        first: bool = False,
        known: float | None = None,
    ) -> Found:
        """Search a model for the least value of a target, or for its `first` plan.

        What is told is the stage's own objective: with `first` that is not the target, so only the
        `known` bound is told.
        """
        best: float | None = None

        def report(values: Floats | None, _value: float | None, bound: float | None) -> None:
            nonlocal best
            point = None if values is None else Point(encoded, values, self.tight)
            if point is not None:
                self._point = point
                best = None if name == "first plan" else self._worth(point, name)
            told = known if first else None if bound is None else target.own(bound)
            if point is not None or told is not None:
                self.tell(name, point, best, told)

        self.tell(name, None, None, None)
        effort = self.effort
        if not self.tight:
            effort = replace(effort, ideas=frozenset())
        search = Search(encoded, target, effort, self.clock, report)
        if encoded.shared and Idea.CHAINS in effort.ideas:
            chained = partial(self._chained, encoded, effort)
            if self._point is None:
                search.scout = chained
            else:
                search.rescue = chained
        if self.known is not None and self._point is None:
            search.scout = self._recalled
        return search.minimise(None if first else self._start(encoded), first=first)

    def _recalled(self) -> Floats | None:
        return self.known

    def _chained(self, encoded: Encoded, effort: Effort) -> Floats | None:
        """Flows of a plan found by way of the chained restriction, in a part of the time."""
        try:
            restricted = self._restricted(encoded)
        except Halted:  # the search hears of that by itself
            return None
        left = self.clock.left
        budget = _CHAIN_SECONDS if left is None else min(_CHAIN_SECONDS, left / 2)
        target = self._target(restricted, "travel")
        return first_flows(restricted, target, effort, self.clock.within(budget))

    def _restricted(self, encoded: Encoded) -> Encoded:
        """The chained model within the bounds and kept rows of the exact one."""
        with self.clock.timed("build"):
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
