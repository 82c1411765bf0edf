"""A bound and plans of missions with many tasks, by routes of single agents.

The linear program of such a mission has hundreds of thousands of columns, and says little before it
has hundreds of cuts. Routes say more (`search.routes.route_program`), in programs that have a row
for every task, and steps at which their agents are together are soon found
(`search.routes.narrowing`). With these steps held the routes are nearly always a plan.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.milp.confirmation import tried
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Floats, Model
from tsplan.milp.target import Target
from tsplan.search.dive import fractional
from tsplan.search.effort import Effort
from tsplan.search.rounding import Rounding
from tsplan.search.routes.errands import Errand, errands_of
from tsplan.search.routes.narrowing import Narrowing, Settled
from tsplan.search.routes.route_program import SCALE, Routed, RouteProgram
from tsplan.search.routes.shifted_plans import shifted_plans
from tsplan.search.routes.window_tree import WindowTree

MANY = 30
"""Errands from which on routes are looked for."""

_MOST = 10_000_000  # values of all routes: some hundred megabytes
_WIDEST = 12  # errands at one place, whose memories are told apart
_EXACT = 2.0**58  # sums up to this are whole in 64 bits
_BOUND, _PLANS = 0.3, 0.5  # of the time that is left; the latter for the bound, too
_RAISING = 0.8  # of the time that is left, for better bounds once there are plans
_CLOSE = 1e-4  # of its value, between a program and its bound
_NEAR = 1.0  # between a small program and its bound: plans differ by whole numbers
_MEMORIES = 25  # times that more is remembered before windows are narrowed
_IDLE = 8  # tries without a better plan, in a row: what is left is for other ways
_HELD = 5.0  # seconds for a plan with given steps, where linear programs come to none


@dataclass(frozen=True, eq=False)
class RoutePlans:
    """Tells of one model how little its target can be, and finds plans.

    There is nothing to tell where a target is not a sum of whole costs of moves, where agents have
    to keep more than the formula and the map, and of fewer than `many` errands.
    """

    encoded: Encoded
    target: Target
    effort: Effort
    clock: Clock
    many: int = MANY

    @property
    def possible(self) -> bool:
        """Whether costs are such that whole numbers tell of routes."""
        target, flows = self.target, self.encoded.flows
        other = np.ones(len(target.vector), dtype=np.bool_)
        other[flows] = False
        largest = float(target.vector.max(initial=0.0)) * SCALE * self.encoded.network.horizon
        agents = sum(item.graph.agents for item in self.encoded.network.classes)
        whole = bool(target.step) and bool((target.vector >= 0).all())
        return whole and not target.vector[other].any() and largest * (agents + 1) ** 2 < _EXACT

    def bound(self) -> int | None:
        """What the target comes to at least; None where that is not told."""
        return None if self._bounded is None else self._bounded[1].bound

    def raised(self, enough: Callable[[], float]) -> Iterator[int]:
        """Better and better bounds, up to what is `enough`."""
        if self._bounded is None:
            return
        program, routed = self._bounded
        spent = self.clock.elapsed
        left = spent if self.clock.left is None else _RAISING * self.clock.left
        program.clock = self.clock.within(left)
        yield from WindowTree(program, _MOST).raised(routed, enough)

    @cached_property
    def _bounded(self) -> tuple[RouteProgram, Routed] | None:
        """The program in which agents may be relieved, and what it comes to."""
        if self._loose is None:
            return None
        # routes forget the same whether they count in parts or not
        known = self._loose[0].program.remembered
        program = self._program(errands_of(self.encoded), share=_BOUND, known=known)
        if program is None:
            return None
        routed = program.solve(_NEAR)
        while not program.clock.over and program.remember(routed, _MOST):
            near = max(_NEAR, _CLOSE * routed.bound)
            better = program.solve(near)
            routed = replace(better, bound=max(better.bound, routed.bound))
        return program, routed

    def flows(self) -> Iterator[Floats]:
        """Flows of plans, each better than the ones before."""
        if self._loose is None:
            return
        narrowing, loose = self._loose
        shifted = shifted_plans(self.encoded, self.target, self.effort, self.clock)
        told = False
        for plan in () if shifted is None else shifted.flows():
            told = True
            yield plan
        if told:
            return
        found = narrowing.settled(loose)
        if found is None:
            return
        yield from self._plan(narrowing.program, found)
        idle = 0
        for better in narrowing.better(found, loose):
            idle = idle + 1 if better is None else 0
            if better is not None:
                yield from self._plan(narrowing.program, better)
            if idle >= _IDLE:
                break

    @cached_property
    def _loose(self) -> tuple[Narrowing, Settled] | None:
        """The program in which errands are run whole, in their own windows."""
        errands = errands_of(self.encoded, whole=True)
        program = self._program(errands, share=_PLANS)
        if program is None:
            return None
        narrowing = Narrowing(program, errands, _MOST)
        return narrowing, narrowing.solved(narrowing.widest, _MEMORIES)

    def _program(
        self,
        errands: tuple[Errand, ...],
        *,
        share: float,
        known: Sequence[Mapping[int, Sequence[int]]] | None = None,
    ) -> RouteProgram | None:
        """A program in a part of the time; with what is `known` to be remembered, of a bound."""
        if len(errands) < self.many or not self.possible:
            return None
        clock = self._part(share)
        kept = [{node: list(own) for node, own in of.items()} for of in known or ()]
        parts = known is not None
        program = RouteProgram(
            self.encoded.network, self.target.vector, errands, clock, parts, kept
        )
        return program if program.widest <= _WIDEST and program.size <= _MOST else None

    def _part(self, share: float) -> Clock:
        """The clock of a part of the time that is left."""
        left = self.clock.left
        return self.clock if left is None else self.clock.within(share * left)

    def _plan(self, program: RouteProgram, found: Settled) -> Iterator[Floats]:
        """The flows of settled routes, or of a plan with the same steps."""
        whole = program.flows(found.routed)
        if whole is not None:
            yield whole[self.encoded.flows]
            return
        upper = self.encoded.model.upper.copy()
        for errand, (step, _) in zip(program.errands, found.windows, strict=True):
            upper[errand.columns[errand.steps != step]] = 0.0
        model = self.encoded.model.with_objective(self.target.vector)
        values = self._held(model.with_bounds(model.lower, upper))
        if values is not None:
            yield values[self.encoded.flows]

    def _held(self, model: Model) -> Floats | None:
        """A point with whole agents of a model whose steps are given."""
        rounding = Rounding(self.encoded, self.target, self.effort, self.clock)
        lp = WarmLP(model, self.clock.stop)
        values = lp.solve(time_limit=self.clock.left).values
        if values is not None and not len(fractional(values, self.encoded.indicators)):
            values = rounding.near(lp, model, values)
            if values is not None:
                return values
        options = self.effort.options(self.clock.within(_HELD), self.target)
        return tried(self.effort.solver, model, options)
