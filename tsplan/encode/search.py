"""Minimise one linear objective over an encoded problem: LP, cuts, dive, tree, then the solver.

Flows are continuous at first. With the witnesses fixed each class is a network flow, so its
solution is nearly always whole; where it is not, the witnesses are fixed and the flows made
integer, and if that fails the full integer model decides. An answer is only ever given for whole
agents; a bound of the relaxation is a bound of the problem.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy import sparse

from tsplan.encode.build import Encoded
from tsplan.encode.clock import Clock
from tsplan.encode.dive import Earliest, Picker, dive, fractional, largest
from tsplan.encode.ideas import Idea
from tsplan.encode.separation import violated
from tsplan.encode.tree import Grown, Tree, Witnessing
from tsplan.encode.wholeness import Rounding
from tsplan.errors import SolverError
from tsplan.milp.model import Floats, Ints, Model, Tag
from tsplan.milp.solution import Options, Progress, Solution, Status, StoppedBy
from tsplan.milp.solver import Solver
from tsplan.milp.warm import LPResult, WarmLP

_ROUNDS = 12  # of separation at the root
_PATIENCE = 5.0  # seconds the tree may take before the solver's own search begins
_LONG = 2.0  # seconds at the root after which a second dive is worth its while
_REST = 0.5  # of what the tree has gained may be left for it to go on
_WHOLE = 1e-6


@dataclass(frozen=True)
class Effort:
    """How to solve: the solver and its settings, and which ideas to use."""

    solver: Solver
    gap: float = 0.0
    threads: int | None = None
    seed: int | None = None
    log: Callable[[str], None] | None = None
    ideas: frozenset[Idea] = frozenset(Idea)


@dataclass(frozen=True, eq=False)
class Found:
    """The best point known, a true lower bound, and whether the search was carried to its end.

    `values` None with `proven` means that there is no point (better than the cutoff).
    """

    values: Floats | None
    objective: float | None
    bound: float
    proven: bool
    stopped_by: StoppedBy | None = None


Reporter = Callable[[Floats | None, float | None, float | None], None]


class Search:
    """One search for the least value of `objective` on one model.

    `scout` and `rescue`, where set, are asked for the flows of some plan: before the first LP, and
    after it if there may be a plan and none is known. `step` is the least distance of two values
    that plans can have; by default 1 for whole coefficients.
    """

    def __init__(
        self,
        encoded: Encoded,
        objective: Floats,
        effort: Effort,
        clock: Clock,
        report: Reporter,
        *,
        step: float | None = None,
    ) -> None:
        self._encoded = encoded
        self._model = encoded.model.with_objective(objective)
        self._effort = effort
        self._clock = clock
        self._report = report
        whole = bool((objective == np.round(objective)).all())
        self._step = float(whole) if step is None else step
        self._values: Floats | None = None
        self._value = np.inf
        self._bound = -np.inf
        self._lp: WarmLP | None = None
        self._began = clock.elapsed
        self.scout: Callable[[], Floats | None] | None = None
        self.rescue: Callable[[], Floats | None] | None = None
        self.patience = _PATIENCE

    def minimise(self, start: Floats | None = None, *, first: bool = False) -> Found:
        """The least value, or with `first` any point. `start` is a known point of this model."""
        if self._encoded.refuted:
            return Found(None, None, np.inf, proven=True)
        if start is not None:
            self._accept(start)
        self._send(self.scout)
        if self._closed or (first and self._values is not None):
            return self._found(proven=self._closed)
        if self._effort.ideas & {Idea.DIVE, Idea.TREE}:
            try:
                proven = self._by_lp(first=first)
            except SolverError:  # numerical trouble: the solver's own search may do without
                proven = False
            if proven or (first and self._values is not None) or self._clock.over:
                return self._found(proven=proven)
        return self._by_solver(first=first)

    def know(self, bound: float) -> None:
        """Take over a bound that has been proven elsewhere."""
        self._raise_bound(bound)

    def dive_for(self, pick: Picker) -> Floats | None:
        """The point that a dive by `pick` finds, however often it goes wrong, or None."""
        if self._encoded.refuted:
            return None
        lp = self._warm()
        root = lp.solve(time_limit=self._clock.left)
        if root.status == "optimal":
            dived = dive(lp, self._encoded.indicators, root, self._clock, pick=pick)
            if dived.values is not None:
                self._keep(dived.values)
        return self._values

    def _send(self, scout: Callable[[], Floats | None] | None) -> None:
        """Keep the point of this model that has the flows which `scout` brings, if there is one."""
        flows = scout() if scout is not None and self._values is None else None
        if flows is not None:
            self.adopt(flows)

    def adopt(self, flows: Floats) -> Floats | None:
        """Keep and return the best point of this model with the given flows, if there is one."""
        columns = self._encoded.flows
        lower, upper = self._model.lower.copy(), self._model.upper.copy()
        lower[columns] = upper[columns] = np.round(flows)
        fixed = self._model.with_bounds(lower, upper)
        values = self._call(fixed, Options(), self._clock.within(5.0)).values
        if values is not None:
            self._accept(values)
        return values

    def _accept(self, values: Floats) -> None:
        """Keep a point of whole agents if it is better than the one known."""
        value = float(self._model.objective @ values)
        if value < self._value - _WHOLE:
            self._values, self._value = values, value
            self._report(values, value, self._bound if np.isfinite(self._bound) else None)

    def _raise_bound(self, bound: float) -> None:
        trusted = bound - max(1e-5, 1e-9 * abs(bound))
        rounded = np.ceil(trusted) if self._step and np.isfinite(bound) else bound
        if rounded > self._bound:
            self._bound = float(rounded)
            self._report(None, None if self._values is None else self._value, self._bound)

    @property
    def _closed(self) -> bool:
        """Whether nothing better by the wanted gap can exist."""
        if self._values is None:
            return False
        slack = self._effort.gap * max(abs(self._value), 1e-9)
        return self._bound >= self._value - slack - _WHOLE

    @property
    def _cutoff(self) -> float | None:
        """Only points below this are of interest to the LPs."""
        return None if self._values is None else self._value - self._step + 1e-4 + 1e-7

    def _found(self, *, proven: bool) -> Found:
        stopped = None
        if self._values is None:
            bound = np.inf if proven else self._bound
        else:
            bound = self._value if proven else min(self._bound, self._value)
            if self._closed and bound < self._value - _WHOLE:
                stopped = StoppedBy.GAP
        if not proven and stopped is None and not self._closed:
            stopped = StoppedBy.INTERRUPT if self._clock.stop() else StoppedBy.TIME_LIMIT
        value = None if self._values is None else self._value
        return Found(self._values, value, bound, proven or self._closed, stopped)

    # --- the LP side -------------------------------------------------------------------------

    def _by_lp(self, *, first: bool) -> bool:
        """Root LP with cuts, dive, tree. True if that settled the question."""
        lp = self._warm()
        root = lp.solve(time_limit=self._clock.left)
        if root.status == "optimal":
            root = self._tighten(lp, root, first=first)
        if root.status != "optimal":
            return root.status == "infeasible"
        self._raise_bound(root.objective)
        self._send(self.rescue)
        if first and self._values is not None:
            return self._closed
        if Idea.DIVE in self._effort.ideas and not self._closed and self._dive(lp, root):
            return True
        if self._closed or (first and self._values is not None):
            return self._closed
        return self._grow(lp, first=first) if Idea.TREE in self._effort.ideas else False

    def _dive(self, lp: WarmLP, root: LPResult) -> bool:
        """Look for points by diving; True if there is none."""
        encoded = self._encoded
        turns = 20 + len(encoded.indicators) // 10
        pickers: list[Picker] = [largest]
        if self._clock.elapsed - self._began > _LONG:  # a tree will not get far soon
            pickers.append(Earliest(encoded.indicators, encoded.steps, encoded.groups))
        for pick in pickers:
            dived = dive(
                lp,
                encoded.indicators,
                root,
                self._clock,
                cutoff=self._cutoff,
                turns=turns,
                pick=pick,
            )
            if dived.values is not None:
                self._keep(dived.values)
            if dived.refuted or self._closed:
                break
        return dived.refuted

    def _tighten(self, lp: WarmLP, root: LPResult, *, first: bool) -> LPResult:
        """Add violated visit cuts, to the LP and to the model, while they raise the bound."""
        if Idea.LAZY not in self._effort.ideas or first:
            return root
        for _ in range(_ROUNDS):
            assert root.values is not None
            columns = self._model.size.columns
            cuts = violated(self._encoded.families, root.values, columns)
            if cuts is None or self._clock.over:
                break
            lp.add_rows(cuts, np.zeros(cuts.shape[0]), np.full(cuts.shape[0], np.inf))
            self._model = _with_cuts(self._model, cuts)
            before = root.objective
            root = lp.solve(time_limit=self._clock.left)
            if root.status != "optimal" or root.objective < before + 1e-3 * max(abs(before), 1.0):
                break
        return root

    def _grow(self, lp: WarmLP, *, first: bool) -> bool:
        again = lp.solve(time_limit=self._clock.left)
        if again.status != "optimal":
            return False
        witnessing = Witnessing(self._encoded.indicators, self._encoded.groups)
        tree = Tree(lp, witnessing, max(self._step, _WHOLE))
        budget = max(self.patience, 15 * (self._clock.elapsed - self._began))
        cutoff = None if self._values is None else self._value
        grown = tree.grow(again, self._clock.within(budget), cutoff, first=first)
        if not grown.done and self._nearly(grown, again.objective):
            self._raise_bound(grown.bound)
            if grown.values is not None:
                self._keep(grown.values)
            grown = tree.go_on(self._clock.within(budget), first=first)
        self._raise_bound(grown.bound)
        whole = grown.values is None or self._whole(grown.values)
        return grown.done and whole

    def _nearly(self, grown: Grown, root: float) -> bool:
        """Whether the tree has closed most of the gap, so that it may well close the rest."""
        best = self._value if grown.values is None else float(self._model.objective @ grown.values)
        left = best - self._step - grown.bound
        return bool(np.isfinite(best)) and left <= _REST * (grown.bound - root)

    def _keep(self, values: Floats) -> None:
        """Keep a point whose indicators are whole, its flows made whole where they are not."""
        near = self._nearby(values)
        if near is None:
            near = self._repaired(values)
        if near is not None:
            self._accept(near)

    def _whole(self, values: Floats) -> bool:
        """Keep such a point; True if whole agents are proven to be no worse than its parts."""
        aim = float(self._model.objective @ values) + max(self._step, _WHOLE) - 1e-4
        for attempt in (self._nearby, self._repaired):
            found = attempt(values)
            if found is not None:
                self._accept(found)
                if float(self._model.objective @ found) <= aim:
                    return True
        return False

    def _nearby(self, values: Floats) -> Floats | None:
        """A point of whole agents by rounding."""
        encoded = self._encoded
        if not len(fractional(values, encoded.flows)):
            return self._rounded(values)
        rounding = Rounding(self._warm(), self._model, encoded.indicators, encoded.flows)
        near = rounding.whole(values, self._clock.within(5.0))
        return None if near is None else self._rounded(near)

    def _repaired(self, values: Floats) -> Floats | None:
        """The best point of whole agents with the witnesses of `values`, if the solver finds it."""
        logic = self._encoded.indicators
        fixed = self._model.with_bounds(
            _placed(self._model.lower, logic, np.round(values)),
            _placed(self._model.upper, logic, np.round(values)),
        )
        return self._call(fixed, Options(), self._clock.within(5.0)).values

    def _rounded(self, values: Floats) -> Floats:
        """The point without the last digits of its whole numbers."""
        return np.where(self._model.integer, np.round(values), values)

    def _warm(self) -> WarmLP:
        if self._lp is None:
            self._lp = WarmLP(self._model, self._clock.stop)
        return self._lp

    # --- the solver's side -------------------------------------------------------------------

    def _by_solver(self, *, first: bool) -> Found:
        """The general MIP solver: continuous flows first, then whole agents if need be."""
        model = self._model
        if Idea.CONTINUOUS in self._effort.ideas:
            loose = model.integer.copy()
            loose[self._encoded.flows] = False
            solution = self._call(model.with_integrality(loose), Options(first=first), self._clock)
            self._note(solution)
            settled = self._settled(solution)
            if settled is not None:
                return settled
            if first and self._values is not None:
                return self._found(proven=False)
        solution = self._call(model, Options(first=first), self._clock)
        self._note(solution)
        if solution.values is not None:
            self._accept(solution.values)
        proven = solution.status in (Status.OPTIMAL, Status.INFEASIBLE)
        return self._found(proven=proven)

    def _settled(self, solution: Solution) -> Found | None:
        """What the relaxed model decides; None where whole agents have to be asked for."""
        if solution.status == Status.INFEASIBLE:
            return self._found(proven=True)
        if solution.values is not None:
            same = self._whole(solution.values)
            if solution.status == Status.OPTIMAL and same:
                return self._found(proven=True)
        if self._clock.over or self._closed:
            return self._found(proven=self._closed)
        return None

    def _note(self, solution: Solution) -> None:
        if solution.bound is not None and self._encoded.rho < 0:
            self._raise_bound(solution.bound)

    def _call(self, model: Model, options: Options, clock: Clock) -> Solution:
        features = self._effort.solver.features
        start = self._values if "start" in features else None
        asked = replace(
            options,
            time_limit=clock.left,
            gap=self._effort.gap,
            absolute_gap=self._step - 1e-4 if self._step else 0.0,
            threads=self._effort.threads,
            seed=self._effort.seed,
            start=start,
            log=self._effort.log,
        )
        return self._effort.solver.solve(model, asked, self._watch)

    def _watch(self, progress: Progress) -> bool:
        self._report(None, progress.objective, progress.bound)
        return self._clock.stop()


def _placed(bounds: Floats, columns: Ints, values: Floats) -> Floats:
    placed = bounds.copy()
    placed[columns] = values[columns]
    return placed


def _with_cuts(model: Model, cuts: sparse.csr_array) -> Model:
    count, more = model.matrix.shape[0], cuts.shape[0]
    return replace(
        model,
        matrix=sparse.csr_array(sparse.vstack([model.matrix, cuts], format="csr")),
        row_lower=np.append(model.row_lower, np.zeros(more)),
        row_upper=np.append(model.row_upper, np.full(more, np.inf)),
        tags=(*model.tags, Tag("visit", count, count + more)),
    )
