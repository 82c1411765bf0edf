"""Missions of swarms that hold as far as possible: first what is to hold, then how.

As for teams, what a plan can satisfy is settled first, on the model that counts agents. Then
everything that it satisfies becomes the formula of another mission, with the other objectives.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, partial

from tsplan.encode.agent_classes import agent_classes, map_arrays
from tsplan.encode.assemble import Asking, Encoded, Setting
from tsplan.encode.groups.group_demands import Wanting
from tsplan.encode.groups.group_measures import SwarmFlows, flows_of
from tsplan.encode.groups.swarm_model import swarm_model
from tsplan.encode.groups.swarm_problem import SwarmProblem
from tsplan.encode.groups.swarm_stages import SwarmOutcome, Tell
from tsplan.encode.map_reduction import whole
from tsplan.encode.partial.maximise import Settling
from tsplan.encode.partial.partial_model import Ground, demand_of, everything
from tsplan.encode.partial.partial_stages import (
    FIRST,
    Choice,
    chosen,
    first_of,
    refuse_if_too_large,
    trial,
    why_open,
    wishes_of,
    worth_of,
)
from tsplan.logic import Formula
from tsplan.mission import Mission
from tsplan.search.clock import Clock
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Point, Reached


@dataclass(frozen=True, eq=False)
class SoftSwarms:
    """A mission of swarms of which some need not hold, and how it is searched."""

    mission: Mission
    effort: Effort
    clock: Clock
    tell: Tell

    def solve(self) -> SwarmOutcome:
        """All objectives, the first of which says what is to hold."""
        mission = self.mission
        first = first_of(mission)
        refuted = False
        worth = partial(worth_of, self._setting)
        settling = Settling(self._ground(), self.effort, self.clock, self._told(), first, worth)
        if mission.partial:
            refuse_if_too_large(mission)
            self.tell(first, None, None, None)
            tried = _after(mission, mission.goal, ()).solve(
                self.effort, trial(settling.clock), _unheard
            )
            if tried.flows is not None:
                return self._rest(mission.goal, Reached(first, 1.0, 1.0), tried)
            refuted = tried.infeasible
        choice = chosen(settling, self._setting, refuted=refuted)
        return self._rest(choice.goal, choice.objective, self._settled(choice))

    def _settled(self, choice: Choice) -> SwarmOutcome:
        """What is known when it is settled what is to hold."""
        settled = choice.settled
        return SwarmOutcome(
            None if settled.point is None else self._flows(settled.point),
            (),
            settled.proven,
            settled.infeasible,
            settled.stopped_by,
            settled.size,
            settled.levels,
        )

    def _rest(self, goal: Formula, reached: Reached, settled: SwarmOutcome) -> SwarmOutcome:
        """The other objectives of plans for what is to hold; `settled` knows one of these plans."""
        if settled.flows is None:
            return settled
        names = tuple(name for name in self.mission.objective if name not in FIRST)
        outcome = _after(self.mission, goal, names).solve(self.effort, self.clock, self.tell)
        others = outcome.reached or tuple(Reached(name, None, None) for name in names)
        return replace(
            outcome,
            flows=outcome.flows or settled.flows,
            reached=(reached, *others),
            proven=outcome.proven and settled.proven,
            infeasible=False,
            stopped_by=why_open(settled.stopped_by, outcome.stopped_by, refuted=outcome.infeasible),
            levels=settled.levels,
        )

    # --- models --------------------------------------------------------------------------------

    def _ground(self) -> Ground:
        """Models of all plans of the swarms, with the flows of their agents as the network."""
        goal = everything(demand_of(self.mission), wishes_of(self.mission))

        def assemble(ask: Asking) -> Encoded:
            model = swarm_model(self.mission, Wanting(goal, ask), self.clock)
            return replace(model.counted, network=model.agents)

        return Ground(assemble, self.mission.horizon)

    @cached_property
    def _setting(self) -> Setting:
        """The swarms as classes, on the whole map."""
        mission = self.mission
        classes = tuple(
            agent_classes(mission.system, [group], group.capabilities)[0] for group in mission.team
        )
        reduced = tuple(whole(item.graph) for item in classes)
        arrays = map_arrays(mission.system)
        return Setting(mission, mission.goal, mission.horizon, classes, reduced, arrays)

    def _flows(self, point: Point) -> SwarmFlows:
        return flows_of(self.mission, point.encoded.network, point.values)

    def _told(self) -> Callable[[str, Point | None, float | None, float | None], None]:
        def told(stage: str, point: Point | None, value: float | None, bound: float | None) -> None:
            self.tell(stage, None if point is None else self._flows(point), value, bound)

        return told


def _after(mission: Mission, goal: Formula, objective: tuple[str, ...]) -> SwarmProblem:
    """The mission of what is to hold, in which every margin is kept already."""
    rules = mission.swarm
    assert rules is not None
    changed = replace(
        mission,
        formula=goal,
        objective=objective,
        prefer=(),
        swarm=replace(rules, margin=Fraction(0)),
        warnings=(),
    )
    return SwarmProblem(changed)


def _unheard(*_: object) -> None:
    """A try's bounds are not those of the objective."""
