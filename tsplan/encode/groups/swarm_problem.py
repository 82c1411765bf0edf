"""A mission of swarms as a problem that can be solved."""

from __future__ import annotations

from functools import cached_property

from tsplan.encode.groups.swarm_model import SwarmModel, swarm_model
from tsplan.encode.groups.swarm_stages import SwarmOutcome, SwarmStages, Tell
from tsplan.mission import Mission
from tsplan.search.clock import Clock, Halted
from tsplan.search.effort import Effort


class SwarmProblem:
    """A mission of swarms and its model, made when first needed."""

    def __init__(self, mission: Mission) -> None:
        self.mission = mission

    @cached_property
    def model(self) -> SwarmModel:
        """The encoded mission."""
        return swarm_model(self.mission)

    def solve(self, effort: Effort, clock: Clock, tell: Tell) -> SwarmOutcome:
        """Run all objectives; `tell` hears of stages, plans and bounds."""
        try:
            with clock.timed("build"):
                model = swarm_model(self.mission, clock=clock)
        except Halted as halted:
            return SwarmOutcome.nothing(halted)
        return SwarmStages(self.mission, model, effort, clock, tell).run()
