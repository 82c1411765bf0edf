"""Minimise one linear objective over an encoded problem: LP, cuts, dive, tree, then the solver.

Flows are continuous at first. With the witnesses fixed each class is a network flow, so its
solution is nearly always whole; where it is not, the witnesses are fixed and the flows made
integer, and if that fails the full integer model decides. An answer is only ever given for whole
agents; a bound of the relaxation is a bound of the problem.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Protocol

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.class_shares import with_shares
from tsplan.encode.encoded import Encoded
from tsplan.encode.switches import Switch
from tsplan.errors import SolverError
from tsplan.milp.confirmation import confirmed
from tsplan.milp.lp import MOMENT, PATIENCE, LPResult
from tsplan.milp.model import Floats, Model
from tsplan.milp.proof_tree import Leaf, ProofTree
from tsplan.milp.proven_lp import ProvenLP
from tsplan.milp.solution import Progress, Solution, Status
from tsplan.milp.target import Target
from tsplan.search.branch_and_bound import BranchAndBound, Explored
from tsplan.search.dive import Earliest, Picker, dive, fractional, largest, plunge
from tsplan.search.effort import Effort
from tsplan.search.in_turns import in_turns
from tsplan.search.lexicographic import Found
from tsplan.search.neighbourhood import Improving
from tsplan.search.rounding import Rounding
from tsplan.search.search_proof import rests_on, search_proof
from tsplan.search.separation import Separation
from tsplan.search.standing import Reporter, Standing

_PATIENCE = 5.0  # seconds the tree may take before the solver's own search begins
_SLOW = 1.0  # seconds of the first linear program after which a plan comes before cuts
_LONG = 2.0  # seconds at the root after which a second dive is worth its while
_NEAR = 1 / 3  # of the time that is left may be spent near the best point
_REST = 0.5  # of what the tree has gained may be left for it to go on
_SMALL = 50_000  # nonzeros up to which a model counts as small
_FEW, _EACH = 50, 50  # linear programs of the tree's first turn there: so many, or one for each
# so many nonzeros: larger programs take longer, but their trees are more often done soon
_TURNS = 1.0  # seconds after which the tree searches alone
_SPRINT = 0.1  # seconds of the general solver's first turn, if all before took less


class Guide(Protocol):
    """Knows of bounds and plans by other means than the model's programs."""

    def bound(self) -> int | None:
        """What no plan is below, as a value of the target; None where that is not told."""

    def flows(self) -> Iterator[Floats]:
        """Flows of plans, one after the other."""

    def raised(self, enough: Callable[[], float]) -> Iterator[int]:
        """Better bounds, one after the other, as far as they are below what is `enough`."""


class Search:
    """One search for the least value of a target on one model.

    `scout` and `rescue`, where set, are asked for the flows of some plan: before the first LP, and
    after it if there may be a plan and none is known. `guide`, where set, is asked for a bound and
    for flows of better and better plans once the scout is back.
    """

    def __init__(
        self, encoded: Encoded, target: Target, effort: Effort, clock: Clock, report: Reporter
    ) -> None:
        self._encoded = encoded
        self._target = target
        self._model = encoded.model.with_objective(target.vector)
        self._effort = effort
        self._clock = clock
        self._known = Standing(target, report, effort.choice.gap, encoded.refuted)
        self._lp: ProvenLP | None = None
        self._shared = False  # whether the best witnesses are known, but for classes in parts
        self._rounding = Rounding(encoded, target, effort, clock)
        self._began = clock.elapsed
        self._leaves: tuple[Leaf, ...] = ()  # of what proves the exact bound
        self._alone = effort.certified  # whether no solver's word counts
        self.scout: Callable[[], Floats | None] | None = None
        self.rescue: Callable[[], Floats | None] | None = None
        self.guide: Guide | None = None
        self.patience = _PATIENCE

    def minimise(self, start: Floats | None = None, *, first: bool = False) -> Found:
        """The least value, or with `first` any point. `start` is a known point of this model."""
        self._known.first = first
        if start is not None:
            self._known.accept(start, self._model)
        if not self.done:
            self._send(self.scout)
        if not self.done and self.guide is not None:
            self._follow(self.guide)
            self._improve()
        if not self.done and self._effort.switches & {Switch.DIVE, Switch.TREE}:
            try:
                self._by_lp()
            except SolverError:  # numerical trouble: the solver's own search may do without
                self._lp = None
        if not (self.done or self._alone or self._clock.over) and self._shared:
            self._by_shares()
        if not (self.done or self._alone or self._clock.over):
            self._by_solver(self._clock)
        return replace(self._known.found(self._clock), rests=rests_on(self._encoded, self._model))

    @property
    def done(self) -> bool:
        """Whether the question is answered."""
        return self._known.done

    @property
    def proof(self) -> ProofTree:
        """What proves the exact bound, or that there is no point; if it was recorded."""
        return search_proof(self._encoded, self._model, self._known, self._leaves, self._clock)

    def know(self, bound: float, *, exact: bool = False) -> None:
        """Take over a bound that has been proven elsewhere, as a value of the target."""
        self._known.know(bound, exact=exact)

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
        return self._known.values

    def _send(self, scout: Callable[[], Floats | None] | None) -> None:
        """Keep the point of this model that has the flows which `scout` brings, if there is one."""
        flows = scout() if scout is not None and self._known.values is None else None
        if flows is not None:
            self.adopt(flows)

    def _follow(self, guide: Guide) -> None:
        """Take in what a guide tells, as long as there is anything to find out."""
        bound = guide.bound()
        if bound is not None:
            self.know(float(bound))
        flows: Iterator[Floats | int] = guide.flows()
        turns = in_turns(flows, guide.raised(lambda: self._known.value))
        for found in () if self.done else turns:
            if isinstance(found, int):
                self.know(float(found))
            else:
                self.adopt(found)
            if self.done:
                break

    def adopt(self, flows: Floats) -> Floats | None:
        """Keep and return the best point of this model with the given flows, if there is one."""
        if self._encoded.refuted:  # whatever its rows say
            return None
        values = self._rounding.carrying(self._model, flows, self._known.values)
        if values is not None:
            self._known.accept(values, self._model)
        return values

    # --- the LP side -------------------------------------------------------------------------

    def _by_lp(self) -> None:
        """Root LP with cuts, dives, tree; cuts that take long wait until there is some plan."""
        lp = self._warm()
        root = self._judged(lp.solve(time_limit=self._clock.left))
        switches = self._effort.switches
        parts = self._encoded, self._model, switches, self._clock, self._known.raise_bound
        # where a guide told more than the program says, so it most often does with all cuts
        told = root is not None and self.guide is not None and self._known.bound > root.objective
        cuts = None if self._known.first or told else Separation(*parts)
        blind = self._known.values is None
        spent = self._clock.elapsed - self._began
        if not blind or spent < _SLOW:
            root = self._tightened(lp, root, cuts, max(_SLOW - spent, 0.0) if blind else np.inf)
        if root is not None and not self.done:
            self._send(self.rescue)
        self._descend(lp, root)
        if cuts is not None and cuts.open and root is not None and not self.done:
            again = self._judged(lp.solve(time_limit=self._clock.left))
            root = self._tightened(lp, again, cuts, np.inf)
            self._descend(lp, root)
        if root is not None and not self.done and Switch.TREE in switches:
            self._grow(lp)

    def _judged(self, root: LPResult) -> LPResult | None:
        """What the program of all points says; None where it has no solution to go on with."""
        if root.status in ("infeasible", "optimal"):
            self._leaves = (Leaf((), root.proof),)
        if root.status == "infeasible":
            self._known.none_below(self._known.cutoff)
        if root.status != "optimal":
            return None
        self._known.raise_bound(root.objective)
        return root

    def _tightened(
        self, lp: ProvenLP, root: LPResult | None, cuts: Separation | None, seconds: float
    ) -> LPResult | None:
        """The program with more cuts, which the model gets, too."""
        if root is None or cuts is None or self.done:
            return root
        try:
            return self._judged(cuts.tightened(lp, root, seconds))
        finally:
            self._model = cuts.model

    def _descend(self, lp: ProvenLP, root: LPResult | None) -> None:
        """Dive from the root; what that finds is made better if all is slow."""
        if root is not None and not self.done and Switch.DIVE in self._effort.switches:
            self._dive(lp, root)
            if self._long:
                self._improve()

    def _dive(self, lp: ProvenLP, root: LPResult) -> None:
        """Look for points by diving, or find that there is none."""
        encoded = self._encoded
        turns = 20 + len(encoded.indicators) // 10
        pickers: list[Picker] = [largest]
        if self._long:
            self._plunge(lp, root)
            pickers.append(Earliest(encoded.indicators, encoded.steps, encoded.choices))
        for pick in pickers:
            cutoff = self._known.cutoff
            # where some plan is known, time is better spent near it than on slow programs
            spent = self._clock.elapsed - self._began
            most = np.inf if cutoff is None or not self._long else spent / 2
            dived = dive(
                lp,
                encoded.indicators,
                root,
                self._clock.within(most),
                cutoff=cutoff,
                turns=turns,
                pick=pick,
            )
            if dived.values is not None:
                self._keep(dived.values)
            if dived.refuted and not self._effort.record:  # the tree writes down what proves it
                self._known.none_below(cutoff)
            if self.done:
                break

    @property
    def _long(self) -> bool:
        """Whether the root has taken so long that a tree will not get far soon."""
        return self._clock.elapsed - self._began > _LONG

    def _improve(self) -> None:
        """Look for better points near the best one, for a part of the time that is left."""
        if self._known.values is None or self.done:
            return
        left, spent = self._clock.left, self._clock.elapsed - self._began
        clock = self._clock.within(spent if left is None else min(spent, _NEAR * left))
        encoded = replace(self._encoded, model=self._model)
        improving = Improving(encoded, self._target, self._effort, clock)
        for better in improving.steps(self._model, self._known.values, spent / 2):
            self._known.accept(better, self._model)
            if self.done:
                break

    def _plunge(self, lp: ProvenLP, root: LPResult) -> None:
        """Look for a point with few linear programs."""
        found = plunge(lp, self._encoded.choices, root, self._clock, cutoff=self._known.cutoff)
        if found is not None and found.values is not None:
            values = found.values
            if not len(fractional(values, self._encoded.indicators)):
                self._keep(values)

    def _grow(self, lp: ProvenLP) -> None:
        root = lp.solve(time_limit=self._clock.left)
        if root.status != "optimal":
            return
        encoded = self._encoded
        tree = BranchAndBound(lp, encoded.indicators, encoded.choices, self._target, root)
        tree.record = self._effort.record
        if self._alone:
            self._settle(tree)
            return
        budget = max(self.patience, 15 * (self._clock.elapsed - self._began))
        self._take_turns(tree, _TURNS)
        if not self.done and not self._shared:
            explored = self._climb(tree, budget)
            if not self.done and not self._shared and self._nearly(explored, root.objective):
                self._climb(tree, budget)

    def _settle(self, tree: BranchAndBound) -> None:
        """Let the tree decide everything; while there is no point the solver may look for one."""
        others = np.setdiff1d(np.flatnonzero(self._model.integer), self._encoded.indicators)

        def hear(values: Floats) -> float:
            self._keep(values)
            return self._known.value

        tree.deepen(others, hear)
        seconds = _TURNS
        while not self.done and not self._clock.over:
            explored = self._climb(tree, seconds)
            if explored.done or (self._known.first and explored.values is not None):
                break
            if self._known.values is None and not self._clock.over:
                self._by_solver(self._clock.within(seconds))
            seconds *= 2

    def _take_turns(self, tree: BranchAndBound, seconds: float) -> None:
        """Let the tree and the general solver search in turn while the model is small.

        Either may be many times faster than the other. Each turn of the solver is as long as all
        that went before, and each of the tree four times its last one, so that neither costs more
        than about the time that the other takes. After so many `seconds` the solver has a last one.
        """
        most = max(_FEW, self._model.matrix.nnz // _EACH)
        while self._model.matrix.nnz <= _SMALL and not self._clock.over:
            self._climb(tree, seconds, most)
            spent = self._clock.elapsed - self._began
            if self.done or self._shared:
                return
            self._by_solver(self._clock.within(max(min(spent, seconds), _SPRINT)))
            if self.done or spent > seconds:
                return
            most *= 4

    def _climb(self, tree: BranchAndBound, seconds: float, most: float = np.inf) -> Explored:
        """Let the tree search for so many seconds or programs, and take in what it finds."""
        blind = self._known.values is None
        clock = self._clock.within(seconds)
        explored = tree.run(clock, self._known.value, first=self._known.first, most=most)
        self._leaves = tree.leaves or self._leaves
        if explored.done and explored.values is None and blind and np.isinf(explored.bound):
            self._known.refute()
            return explored
        self._known.raise_bound(explored.bound)
        if explored.values is not None and explored.done and not self._alone:
            self._whole(explored.values)
            self._shared = not self.done and bool(self._encoded.served)
        elif explored.values is not None:
            self._keep(explored.values)
        return explored

    def _nearly(self, explored: Explored, root: float) -> bool:
        """Whether the tree has closed most of the gap, so that it may well close the rest."""
        best = self._known.value if explored.values is None else self._target.value(explored.values)
        left = best - self._target.step - explored.bound
        return bool(np.isfinite(best)) and left <= _REST * (explored.bound - root)

    def _keep(self, values: Floats) -> None:
        """Keep a point whose indicators are whole, its flows made whole where they are not."""
        near = self._rounding.near(self._warm(), self._model, values)
        if near is None:
            near = self._rounding.best(self._model, values, self._known.values)
        if near is not None:
            self._known.accept(near, self._model)

    def _whole(self, values: Floats) -> None:
        """Keep such a point; a better one of its witnesses is looked for if it is not the best."""
        near = self._rounding.near(self._warm(), self._model, values)
        if near is not None:
            self._known.accept(near, self._model)
        if not self.done:
            best = self._rounding.best(self._model, values, self._known.values)
            if best is not None:
                self._known.accept(best, self._model)

    def _warm(self) -> ProvenLP:
        if self._lp is None:
            # programs of expected numbers are degenerate, and slow by the simplex method
            slow = self._encoded.network.expected
            patience = MOMENT if slow else PATIENCE
            self._lp = ProvenLP(
                self._model,
                self._clock.stop,
                patience=patience,
                degenerate=slow,
                tally=self._effort.tally,
            )
        return self._lp

    # --- the solver's side -------------------------------------------------------------------

    def _by_solver(self, clock: Clock) -> None:
        """The general MIP solver: continuous flows first, then whole agents if need be."""
        model = self._model
        if Switch.CONTINUOUS in self._effort.switches:
            loose = model.integer.copy()
            loose[self._encoded.loosened] = False
            relaxed = model.with_integrality(loose)
            solution = self._ask(relaxed, clock)
            if solution.values is not None and solution.status is Status.OPTIMAL:
                self._whole(solution.values)
            elif solution.values is not None:
                self._keep(solution.values)
            if self.done or clock.over:
                return
        self._ask(model, clock)

    def _by_shares(self) -> None:
        """The solver with parts of agents alone, but whole shares of the classes in every task."""
        network = self._encoded.network
        count = self._model.size.columns
        model, start = with_shares(self._encoded.served, network, self._model, self._known.values)
        loose = model.integer.copy()
        loose[self._encoded.loosened] = False
        options = self._effort.options(self._clock, self._target, start)
        asked = model.with_integrality(loose)
        solution = confirmed(self._effort.solver, asked, options, self._watch)
        if solution.bound is not None:
            self._known.raise_bound(solution.bound, exact=False)
        if solution.values is not None and not self.done:
            self._whole(solution.values[:count])

    def _ask(self, model: Model, clock: Clock) -> Solution:
        """The solver's answer about the whole question, confirmed; all of it is taken in."""
        options = self._effort.options(clock, self._target, self._known.values)
        options = replace(options, first=self._known.first)
        solution = confirmed(self._effort.solver, model, options, self._watch)
        if solution.status is Status.INFEASIBLE:
            if self._known.values is not None:
                raise SolverError("the solver calls a model infeasible of which a plan is known")
            if not self._alone:
                self._known.refute(sure=False)
        elif solution.bound is not None and not self._alone:
            self._known.raise_bound(solution.bound, exact=False)
        if solution.values is not None and model is self._model:
            self._known.accept(solution.values, self._model)
        return solution

    def _watch(self, progress: Progress) -> bool:
        if progress.bound is not None and not self._alone:
            self._known.raise_bound(progress.bound, exact=False)
        return self._clock.stop()
