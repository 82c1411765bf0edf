"""Plan a mission of swarms: their moves, the sub-swarms these make, and paths for a few agents."""

from __future__ import annotations

from tsplan.encode.groups.group_measures import SwarmFlows
from tsplan.encode.groups.swarm_problem import SwarmProblem
from tsplan.encode.partial.partial_stages import is_soft
from tsplan.encode.partial.partial_swarms import SoftSwarms
from tsplan.mission import Mission
from tsplan.plans.decomposition import agents_of
from tsplan.run.run import Listener, Result, Run, Settings, Tell, Ways, claimed_depths
from tsplan.search.clock import Clock
from tsplan.search.effort import Effort

MOST_AGENTS = 1000
"""Agents up to which every one gets a path; for more, `tsplan.assign` makes them."""


class SwarmRun(Run[SwarmFlows]):
    """One planning run for one or several swarms."""

    def __init__(self, mission: Mission, settings: Settings, listener: Listener | None) -> None:
        super().__init__(mission, settings, listener)
        self._problem: SwarmProblem | None = None

    def prepare(self) -> None:
        """Make the problem of the mission."""
        self._problem = SwarmProblem(self._mission)

    def search(self, effort: Effort, clock: Clock, tell: Tell[SwarmFlows]) -> Result[SwarmFlows]:
        """Run all objectives of the problem."""
        assert self._problem is not None
        if is_soft(self._mission):
            outcome = SoftSwarms(self._mission, effort, clock, tell).solve()
        else:
            outcome = self._problem.solve(effort, clock, tell)
        return Result(
            outcome.flows,
            outcome.reached,
            outcome.proven,
            outcome.infeasible,
            outcome.stopped_by,
            outcome.size,
            None if outcome.flows is None else claimed_depths(self._mission, outcome.levels),
            outcome.notes,
        )

    def ways(self, found: SwarmFlows) -> Ways:
        """The moves of every swarm, and the paths of its agents if they are few."""
        moves = {swarm: tuple(found[swarm]) for swarm in found}
        few = self._mission.size <= MOST_AGENTS
        return Ways(
            moves=moves,
            agents=agents_of(self._mission, moves, self._settings.seed) if few else (),
        )
