"""Missions over signals, as the search for an explanation asks about them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from tsplan.clock import Clock
from tsplan.errors import SolverError, SolverUnavailableError
from tsplan.explanation.explanation import Fact
from tsplan.explanation.whynot.least_relaxation import least_miss, relaxation
from tsplan.explanation.whynot.occurrences import Occurrence
from tsplan.explanation.whynot.signal_constraints import (
    SignalWording,
    relaxed_signals,
    signal_bounds,
)
from tsplan.explanation.whynot.signal_edits import candidates, touched
from tsplan.explanation.whynot.signal_facts import Finders
from tsplan.explanation.whynot.subject import Subject
from tsplan.plans.outcomes import MissionRef, Status
from tsplan.signals.aims import Aim
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.synthesiser import synthesise_mission
from tsplan.signals.trajectory import Trajectory
from tsplan.stopping import StoppedBy
from tsplan.words import number

if TYPE_CHECKING:
    from tsplan.explanation.explanation import SoftConstraint
    from tsplan.explanation.whynot.mission_numbers import Edit, Number
    from tsplan.explanation.whynot.subject import Constraints, Question
    from tsplan.run.events import Event
    from tsplan.signals.synthesis import Synthesis


@dataclass(frozen=True, eq=False)
class Signals(Subject[SignalMission]):
    """A mission over signals."""

    @property
    def bounds(self) -> tuple[SoftConstraint, ...]:
        """Starts, bounds of controls, limits and bounds of signals."""
        return signal_bounds(self.mission)

    @cached_property
    def wording(self) -> SignalWording:
        """Words and places for what can be taken out."""
        return SignalWording(self.mission)

    def plain(self) -> SignalMission:
        """The mission that asks for no more than that its formula holds, as a whole."""
        return relaxed_signals(self.mission, ())

    def without(self, gone: Iterable[SoftConstraint]) -> SignalMission:
        """The plain mission without some of its constraints."""
        return relaxed_signals(self.mission, gone)

    def planned(
        self,
        question: SignalMission | Synthesis,
        time_limit: float | None,
        solver: str | None,
        enough: Callable[[Event], bool] | None = None,
    ) -> Trajectory:
        """What synthesis finds in some seconds; nothing where far bounds are too much for it.

        Where only trajectories on the border of the formula are found, which floats may round to
        its other side, the most robust one is looked for.
        """
        del enough  # nothing is told of trajectories on the way
        clock = Clock(time_limit)
        found = _synthesised(question, clock.left, solver)
        if found.stopped_by is StoppedBy.PRECISION and isinstance(question, SignalMission):
            robust = replace(question, objective=(Aim((("robustness", 1.0),)),))
            found = _synthesised(robust, clock.left, solver)
        return found

    def facts(self) -> Iterator[Fact]:
        """What the intervals that signals can reach forbid."""
        for fact in Finders(self.wording).facts():
            self.pause()
            yield fact

    def measured(self, ask: Callable[[Question], Any]) -> Iterator[Fact]:
        """By how much the formula is missed at best."""
        problem = least_miss(self.mission)
        found = None if problem is None else ask(problem)
        if problem is not None and found is not None and found.status is Status.OPTIMAL:
            by = problem.found(found)
            parts = self.wording.parts({item for group in self.groups for item in group})
            place = self.wording.sources.place(Occurrence(()))
            text = (
                f"at best the formula is missed by {number(by)}: the greatest robustness of all "
                f"trajectories is {number(-by)}"
            )
            yield Fact("robustness", text, place, (*parts, *map(self.wording.fact, self.bounds)))

    def candidates(self, conflict: Constraints) -> list[Edit]:
        """Everything that can be tried against one conflict, each once."""
        return candidates(self.wording, conflict)

    def touched(self, number: Number) -> Constraints:
        """What an edit of a number weakens at most; nothing where that cannot be said."""
        return touched(self.mission, number)

    def guessed(self, edit: Edit, ask: Callable[[Question], Any]) -> int | None:
        """The least amount of a real number, by one program."""
        problem = relaxation(self.mission, edit)
        found = None if problem is None else ask(problem)
        if problem is None or found is None or not found.has_signals:
            return None
        return max(1, round(problem.found(found) / edit.unit))


def _synthesised(
    question: SignalMission | Synthesis, time_limit: float | None, solver: str | None
) -> Trajectory:
    try:
        return synthesise_mission(question, time_limit=time_limit, solver=solver)
    except SolverUnavailableError:
        raise
    except SolverError:
        mission = question if isinstance(question, SignalMission) else question.mission
        ref = MissionRef(mission.name, mission.digest)
        return Trajectory(Status.NO_PLAN_FOUND, ref, mission.horizon, StoppedBy.PRECISION)
