"""Searching where groups are before how many agents they have.

Where an objective depends on the places of groups only, these are searched on a relaxation that
knows no sizes, and agents are counted into what is found; splits are bounded by tokens before. What
that leaves open is for the search of the whole model. In the end agents are shared evenly.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.groups.group_sizes import even_shares, smallest
from tsplan.encode.groups.token_flow import tokens
from tsplan.encode.model_objectives import GroupMoves, Splits
from tsplan.encode.objective_kinds import Grouping
from tsplan.encode.priced_objectives import Priced, Travel
from tsplan.encode.switches import Switch
from tsplan.milp.confirmation import tried
from tsplan.milp.model import Floats, Model
from tsplan.search.effort import Effort
from tsplan.search.group_travel import GroupTravel
from tsplan.search.guided_restriction import guided
from tsplan.search.lexicographic import Found
from tsplan.search.question import Kept, Question, start_in
from tsplan.search.search import Search

_COUNTING = 5.0  # seconds for agents to be counted into groups
_EVENING = 10.0  # seconds for each step of sharing agents evenly
_LATE = 1.0  # seconds of that even where no time is left
_SHORTENING = 3.0  # seconds for a point of few moves before agents' travel is minimised


@dataclass(eq=False)
class GroupSearch:
    """Searches one whole model by the places of its groups.

    `hear` takes points of the whole model and bounds in the own unit of what is told; `known` gives
    the best point so far.
    """

    setting: Setting
    encoded: Encoded
    effort: Effort
    clock: Clock
    hear: Callable[[Question, Point | None, float | None], None]
    known: Callable[[], Point | None]

    def answer(self, question: Question) -> Found:
        """What groups alone settle of a question: nothing where there is no plan and no proof.

        Bounds of tokens and of what groups travel are no certified ones.
        """
        if self.encoded.refuted:  # the whole model knows why, tokens and tours may know less
            return Found(None, None, -np.inf, proven=False)
        objective, kept = question.objective, question.kept
        bound = -np.inf
        if objective.grouping is Grouping.TOKENS and not kept.values:
            if Switch.TOKENS in self.effort.switches:
                bound = self._guided(question)
            bound = -np.inf if self.effort.certified else bound
            point = self.known()
            value = np.inf if point is None else objective.minimised(self.setting, point)
            if value <= bound or (question.first and point is not None):
                values = None if point is None else point.values
                best = None if point is None else value
                return Found(values, best, bound, proven=value <= bound)
        if objective.by_places and kept.by_places and Switch.PLACES in self.effort.switches:
            return self._by_places(question, bound)
        if isinstance(objective, Priced) and not self.effort.certified:
            bound = self._travelled(question, objective)
            point = self.known()
            value = np.inf if point is None else objective.minimised(self.setting, point)
            if point is not None and value <= bound:
                return Found(point.values, value, bound, proven=True)
            if np.isinf(bound) and bound > 0:
                return Found(None, None, bound, proven=True)
        if objective.grouping is Grouping.FEW_MOVES and kept.by_places:
            self._shortened(question)
        return Found(None, None, bound, proven=False)

    def _travelled(self, question: Question, objective: Priced) -> float:
        """A bound on a price where the number of splits is kept; plans that are found are kept."""
        encoded = question.kept.narrowed(self.setting, self.encoded)
        target = objective.target(self.setting, encoded)
        keep = partial(self._keep, question)
        travel = GroupTravel(encoded, objective, self.effort, self.clock, keep)
        known, bound = self.known(), -np.inf
        value = np.inf if known is None else objective.minimised(self.setting, known)
        for least in travel.bounds(question.kept.reached(Splits.name), value):
            bound = target.proven(least)
            self.hear(question, None, question.shown(target, bound))
        return bound

    def _keep(self, question: Question, values: Floats) -> None:
        """Hear of a point of a model that may have more columns, of what is kept."""
        self.hear(question, self._point(values[: self.encoded.model.size.columns]), None)

    def _guided(self, question: Question) -> float:
        """A bound on the number of splits; plans that are found on the way are kept."""
        bound = -np.inf
        target = question.objective.target(self.setting, self.encoded)
        ways = tokens(replace(self.setting, clock=self.clock))
        for splits, values in guided(ways, self.encoded, target.vector, self.clock, self._solve):
            if values is None:
                bound = splits
                if not self.effort.certified:
                    self.hear(question, None, question.shown(target, bound))
                continue
            told = None if self.effort.certified else question.shown(target, bound)
            self.hear(question, self._point(values), told)
            if question.first or self.clock.over:
                break
        return bound

    def _by_places(self, question: Question, bound: float) -> Found:
        """Search where the groups are. Without values: no plan if proven, else undecided."""
        assert self.encoded.occupied is not None
        encoded = question.kept.narrowed(self.setting, self.encoded.occupied)
        target = question.objective.target(self.setting, encoded)
        heard: list[Point] = []

        def report(values: Floats | None, _value: float | None, bound: float | None) -> None:
            point = None if values is None else self._counted(values, question.kept)
            if point is not None:
                heard.append(point)
            self.hear(question, point, question.shown(target, bound))

        search = Search(encoded, target, self.effort, self.clock, report)
        search.know(bound)
        start = None if question.first else start_in(encoded, self.known())
        found = search.minimise(start, first=question.first)
        if self.effort.record:
            question.note(self.effort.proofs, search.proof, places=True)
        if found.values is None or found.objective is None:
            return found
        last = question.objective.minimised(self.setting, heard[-1]) if heard else np.inf
        held = last <= found.objective
        return found if held else replace(found, values=None, proven=False, stopped_by=None)

    def _counted(self, values: Floats, kept: Kept) -> Point | None:
        """Agents counted into the groups of a point of the relaxation, if they can be."""
        encoded = kept.narrowed(self.setting, self.encoded)
        columns = self.encoded.indicators
        lower, upper = encoded.model.lower.copy(), encoded.model.upper.copy()
        lower[columns] = upper[columns] = np.round(values[columns])
        vector = Travel().vector(self.setting, encoded)
        model = encoded.model.with_bounds(lower, upper).with_objective(vector)
        found = self._solve(model)
        return None if found is None else self._point(found)

    def _shortened(self, question: Question) -> None:
        """A better point to begin with: where groups move little, agents travel little."""
        assert self.encoded.occupied is not None
        encoded = question.kept.narrowed(self.setting, self.encoded.occupied)
        target = GroupMoves().target(self.setting, encoded)
        travel = question.objective

        def report(values: Floats | None, _value: float | None, _bound: float | None) -> None:
            point = None if values is None else self._counted(values, question.kept)
            known = self.known()
            if point is None:
                return
            value = travel.minimised(self.setting, point)
            if known is None or value < travel.minimised(self.setting, known):
                self.hear(question, point, None)

        clock = self.clock.within(_SHORTENING)
        search = Search(encoded, target, self.effort, clock, report)
        search.minimise(start_in(encoded, self.known()))

    def evened(self, point: Point, kept: Kept) -> Point:
        """The point with its shares settled: nothing that was reached is lost."""
        encoded = kept.narrowed(self.setting, self.encoded)
        count = self.encoded.model.size.columns
        wide = encoded.model.size.columns - count
        least = smallest(self.encoded.swarms, point.values) if wide else 0.0
        values = np.append(point.values, np.full(wide, least))
        left = self.clock.left
        seconds = _EVENING if left is None else min(max(left, _LATE), _EVENING)

        def solve(model: Model) -> Floats | None:
            return None if self.clock.stop() else self._solve(model, seconds)

        fixed = self.encoded.indicators
        shared = even_shares(self.encoded.swarms, encoded.model, values, fixed, solve)
        return replace(point, values=shared[:count])

    def _solve(self, model: Model, seconds: float | None = None) -> Floats | None:
        """A point of a part of the problem, if it is found soon."""
        clock = self.clock.within(_COUNTING)
        options = self.effort.limited(clock)
        if seconds is not None:
            options = replace(options, time_limit=seconds)
        return tried(self.effort.solver, model, options)

    def _point(self, values: Floats) -> Point:
        return Point(self.encoded, values, tight=self.encoded.rho < 0)
