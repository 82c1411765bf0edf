"""Plan a mission: encode, solve, split into paths, and have the plan judged before it is shown."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tsplan.encode.encoded import Point
from tsplan.encode.read_back import listed, moves_of
from tsplan.errors import SolverError
from tsplan.exact import digits
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission import Mission
from tsplan.plans.decomposition import paths_of
from tsplan.plans.moves import Move
from tsplan.plans.plan import AgentPlan, Plan
from tsplan.run.own_terms import worth
from tsplan.run.problem import Problem, Tuning
from tsplan.run.run import Listener, Result, Run, Tell, Ways, claimed_depths
from tsplan.search.clock import Clock
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Reached
from tsplan.words import known

MOST_AGENTS = 1000
"""Agents up to which every one of a swarm gets a path; for more, `tsplan.assign` makes them."""


def plan(
    mission: Mission | Problem,
    *,
    time_limit: float | None = None,
    solver: str | None = None,
    gap: float | None = None,
    threads: int | None = None,
    seed: int | None = None,
    encoding: str = "tight",
    without: tuple[str, ...] = (),
    on_event: Listener | None = None,
) -> Plan:
    """Plan a mission, or a `Problem` made from one: a verified plan, or why there is none.

    `time_limit` is in seconds, `gap` relative; what is None comes from the mission. `on_event` is
    called with every `Event`; when it returns True the search stops and the best plan is kept.
    Ctrl-C does the same. What `on_event` raises ends the search and is raised here. `without` names
    ideas of the tight encoding to switch off. The plan of a swarm mission has its moves and
    sub-swarms, and the agents' paths too if there are at most 1,000; `assign` makes them for more.

    Raises MissionError for unknown names, InputError for numbers out of range,
    SolverUnavailableError for a solver that cannot be used, and SolverError when a solver fails or
    a plan is refused by the independent check.
    """
    choice = SolverChoice(solver, time_limit, gap, threads, seed).checked()
    tuning = Tuning.named(encoding, without)
    problem = mission if isinstance(mission, Problem) else Problem(mission, tuning)
    return MissionRun(problem, choice, on_event).plan()


class MissionRun(Run[Point]):
    """One planning run for a mission or a problem made of it."""

    def __init__(self, problem: Problem, choice: SolverChoice, listener: Listener | None) -> None:
        super().__init__(problem.mission, choice, listener)
        self._problem = problem
        self._reached: dict[str, Reached] = {}

    def prepare(self) -> None:
        """Sort the team into classes and reduce their maps."""
        self._problem.prepared(self._clock)

    def search(self, effort: Effort, clock: Clock, tell: Tell[Point]) -> Result[Point]:
        """Run all objectives of the problem."""
        outcome = self._problem.solve(effort, clock, tell)
        self._reached = {item.name: item for item in outcome.reached}
        return Result(
            outcome.point,
            outcome.reached,
            outcome.proven,
            outcome.infeasible,
            outcome.stopped_by,
            outcome.size,
            None if outcome.point is None else claimed_depths(self._mission, outcome.levels),
            outcome.notes,
        )

    def ways(self, found: Point) -> Ways:
        """The moves of every swarm, and one path per agent in the order of the team.

        Those of swarms are left out where there are more than `MOST_AGENTS` agents in all.
        """
        setting, mission, seed = self._problem.setting, self._mission, self._choice.seed
        begins = np.cumsum([0, *(group.count for group in mission.team)]).tolist()
        agents: list[AgentPlan | None] = [None] * mission.size
        moves: dict[str, tuple[Move, ...]] = {}
        few = mission.size <= MOST_AGENTS
        for item, entered in moves_of(setting, found):
            made_moves = listed(setting, item, entered)
            if item.bounds is not None:
                (group,) = item.groups
                moves[mission.team[group].class_name] = made_moves
                if not few:
                    continue
            members = [
                agent
                for group in item.groups
                for agent in mission.agents[begins[group] : begins[group + 1]]
            ]
            made = paths_of(mission, members, made_moves, seed)
            taken = 0
            for group in item.groups:
                count = mission.team[group].count
                agents[begins[group] : begins[group] + count] = made[taken : taken + count]
                taken += count
        return Ways(moves=moves, agents=tuple(agent for agent in agents if agent is not None))

    def _certified(self, made: Plan) -> Plan:
        """The plan after the check of the mission and of the user's own constraints."""
        plan = super()._certified(made)
        if not plan.has_paths:
            return plan
        if broken := self._problem.broken(plan):
            raise SolverError(f"the plan breaks an own constraint: {'; '.join(broken)}")
        own = self._problem.own
        if not own.expression.terms:
            return plan
        value = own.expression.constant + worth(
            own.expression.terms, plan, self._problem.mission.system
        )
        bound = known(self._reached["own"].bound) if "own" in self._reached else None
        what = "own objective, maximised:" if own.maximised else "own objective"
        note = f"{what} {digits(value)} (bound {'open' if bound is None else digits(bound)})"
        return replace(plan, notes=(note, *plan.notes))
