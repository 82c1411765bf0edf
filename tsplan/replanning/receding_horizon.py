"""Long missions planned in pieces: a window at a time, of which the first steps are kept.

Every window is planned for what the formula asks for within it (`tsplan.logic.first_steps`): what
may come to hold later counts as holding, so that nothing is asked for too early, and nothing that
has to hold is left out. Then its first steps are kept, and what is left is planned again from where
everybody is. The plan is judged as a whole in the end.

Source of the idea, for linear systems: A. Bemporad, M. Morari, "Control of systems integrating
logic, dynamics, and constraints", Automatica 35, 1999.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from tsplan.checking.plan_check import certify
from tsplan.clock import Clock
from tsplan.errors import Finding, InputError, MissionError
from tsplan.history.joined_plan import joined_plan
from tsplan.history.joined_structures import modules_along
from tsplan.history.past_paths import pace_of
from tsplan.history.past_structures import path_of, structure_pace
from tsplan.history.rest_mission import refuse_unknown_kinds
from tsplan.limits import MOST_STEPS, Range
from tsplan.logic.first_steps import within
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.outcomes import MissionRef, ObjectiveValue, Status, Timings
from tsplan.plans.plan import Plan
from tsplan.plans.worlds import World
from tsplan.replanning.replanner import left
from tsplan.run.planner import plan as plan_mission
from tsplan.stopping import StoppedBy

if TYPE_CHECKING:
    from tsplan.history.changed_map import Pace
    from tsplan.mission import Mission
    from tsplan.plans.structures import Structure
    from tsplan.replanning.replanner import Planner

_WIDER = 2  # times as long is the next window where there is no plan in one


@dataclass(frozen=True)
class Pieces:
    """How a mission is planned in pieces: windows of so many steps, of which some are kept.

    Raises InputError for numbers out of range.
    """

    window: int
    commit: int

    def __post_init__(self) -> None:
        findings = [
            Finding(f"{name}: {words}", "give a number of steps")
            for name in ("window", "commit")
            if (words := Range(1, MOST_STEPS, whole=True).complaint(getattr(self, name)))
        ]
        if not findings and self.commit > self.window:
            what = f"{self.commit} steps are kept of a window of {self.window}"
            findings = [Finding(what, "keep fewer of them, or make the window longer")]
        if findings:
            raise InputError(findings)


def plan_in_pieces(
    mission: Mission,
    window: int,
    commit: int,
    *,
    planner: Planner = plan_mission,
    on_piece: Callable[[int, int], object] = lambda _first, _last: None,
    **options: Any,
) -> Plan:
    """Plan a mission in windows of so many steps, of which the first `commit` are kept each time.

    Where there is no plan in a window it is made twice as long, in the end up to the horizon.
    `options` are those of `tsplan.plan` for each window, but for `time_limit`, which is for all of
    them together; `on_piece` hears of the first and the last step of each.

    The plan is feasible, and nothing is proven of its values, unless one window was enough. That
    there is none is proven only where the first window says so.

    Raises InputError for numbers of steps that are none, and MissionError for missions that cannot
    be planned again.
    """
    pieces = Pieces(window, commit)
    refuse_unknown_kinds(mission)
    if mission.partial:
        what = "a mission with a formula that may hold in part cannot be planned in pieces"
        raise MissionError([Finding(what, "plan it as a whole, or with a time limit")])
    return _Planning(mission, pieces, planner, on_piece, options).plan()


@dataclass(eq=False)
class _Planning:
    mission: Mission
    pieces: Pieces
    planner: Planner
    on_piece: Callable[[int, int], object]
    options: dict[str, Any]
    _parts: list[Plan] = field(default_factory=list, init=False)

    def plan(self) -> Plan:
        limit = self.options.pop("time_limit", None)
        clock = Clock(self.mission.solver.time_limit if limit is None else limit)
        made = self._window(self.mission, 0, self.pieces.window, clock)
        if self.mission.horizon <= self.pieces.window or not made.has_paths:
            return made
        plan, step = made, 0
        while plan.has_paths and step + self._length < self.mission.horizon:
            step += self.pieces.commit
            rest = left(self.mission, _extended(self.mission, plan), World(step)).rest
            made = self._window(rest.mission, step, self.pieces.window, clock)
            plan = replace(joined_plan(rest, made), replanned=())
        return self._whole(plan, step)

    @property
    def _length(self) -> int:
        """The steps of the last window."""
        return self._parts[-1].horizon

    def _window(self, mission: Mission, step: int, length: int, clock: Clock) -> Plan:
        """The plan of the first steps of a mission, or of more where these have none."""
        while True:
            length = min(length, mission.horizon)
            self.on_piece(step, step + length)
            short = mission
            if length < mission.horizon:
                goal = within(mission.counted, length)
                short = replace(
                    mission, formula=goal, text="", language="mtl", horizon=length, origin=None
                )
            limit = {} if clock.left is None else {"time_limit": max(clock.left, 0.1)}
            made = self.planner(short, **limit, **self.options)
            self._parts.append(made)
            infeasible = made.status is Status.INFEASIBLE
            if not infeasible or length == mission.horizon or clock.over or not step:
                return made
            length *= _WIDER

    def _whole(self, plan: Plan, step: int) -> Plan:
        """The plan of all pieces, judged as a whole."""
        mission, parts = self.mission, self._parts
        seconds = {
            name: sum(getattr(part.timings, name) for part in parts)
            for name in ("reduce", "build", "solve", "extract", "verify", "total")
        }
        note = f"planned in {len(parts)} windows of {self.pieces.window} steps"
        common: dict[str, Any] = {
            "mission": MissionRef(mission.name, mission.digest),
            "horizon": mission.horizon,
            "timings": Timings(**seconds),
            "size": max((part.size for part in parts), key=lambda size: size.columns),
        }
        if not plan.has_paths:
            why = parts[-1].stopped_by or StoppedBy.WINDOW
            words = f"there is no plan from step {step} on after what was kept before"
            return Plan(Status.NO_PLAN_FOUND, stopped_by=why, notes=(words, note), **common)
        made = replace(
            _extended(mission, plan),
            status=Status.FEASIBLE,
            stopped_by=StoppedBy.WINDOW,
            objective=tuple(ObjectiveValue(name, None) for name in mission.objective),
            availability=None,
            delay=None,
            preferences=(),
            verified=False,
            notes=(note,),
            **common,
        )
        return certify(mission, made)


def _extended(mission: Mission, plan: Plan) -> Plan:
    """A plan of the first steps in which everybody stays at the end where it has come to."""
    if plan.horizon >= mission.horizon:
        return plan
    bodies = tuple(_lasting(mission, each, plan.horizon) for each in plan.structures)
    modular = {each.class_name for each in bodies}
    stretches = [
        (names, _staying(mission, path, pace_of(path)))
        for names, path in Agents.of(plan.agents).stretches
        if path.class_name not in modular
    ]
    if bodies:
        stretches += modules_along(mission.agents, bodies)
    agents = Agents.along(stretches)
    return replace(plan, agents=agents, structures=bodies, horizon=mission.horizon)


def _lasting(mission: Mission, each: Structure, end: int) -> Structure:
    """A structure that was there at a step lasts until the end of the mission."""
    if each.last < end:
        return each
    path = _staying(mission, path_of(each), structure_pace(mission, each))
    return replace(each, stays=path.stays, heading=path.heading, last=mission.horizon)


def _staying(mission: Mission, path: Bundle, pace: Pace) -> Bundle:
    """A path up to a step, with a stay after it until the end of the mission."""
    last = mission.horizon
    if path.heading is None:
        first, _, state = path.stays[-1]
        return replace(path, stays=(*path.stays[:-1], (first, last, state)))
    if not path.stays:
        return path
    _, depart, state = path.stays[-1]
    lasts = pace(mission.system.edges[state, path.heading])
    arrives = depart + (lasts or 0)
    if arrives > last:
        return path
    return replace(path, stays=(*path.stays, (arrives, last, path.heading)), heading=None)
