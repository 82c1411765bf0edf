"""Planning again from a step of a plan on, from what the world is found to be there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Unpack

from tsplan.checking.fitting import refuse_pathless
from tsplan.checking.plan_check import certify
from tsplan.errors import Finding, PlanError
from tsplan.history.changed_map import Maps
from tsplan.history.joined_plan import joined_plan, planned_ahead, with_intended
from tsplan.history.past_paths import really
from tsplan.history.rest_mission import Rest, rest_of
from tsplan.logic.settled import settled
from tsplan.mission import Mission
from tsplan.mission.read import load_mission
from tsplan.parameters import step_within
from tsplan.plans.outcomes import MissionRef, Status
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import load_plan
from tsplan.replanning.world_values import Changes, world_of
from tsplan.run.planner import plan as plan_mission

if TYPE_CHECKING:
    from tsplan.plans.worlds import World

Planner = Callable[..., Plan]
"""Plans a mission, with a plan to `start` from, as `tsplan.plan` does."""


def replan(
    mission: Mission | str | Path,
    plan: Plan | str | Path,
    step: int,
    *,
    objective: Sequence[str] | None = None,
    options: dict[str, Any] | None = None,
    **changes: Unpack[Changes],
) -> Plan:
    """The plan of a mission from a step of another plan on, as things are there.

    What happened before the step is history; who is not named is where the plan has them. Agents
    may be `lost`, `moved` (elsewhere, or on an edge), `late` or `added`, places `closed` and
    `opened`, parts of the formula `withdrawn` and others `demanded`, and so on, see
    `tsplan.replanning.world_values.Changes`. What is left of the formula is planned for, from
    where everybody is; what has been achieved is not asked for again.

    The plan has all steps, those before `step` as they were, and `check` judges it. Its objectives
    are those of the rest. They are the mission's own, or others that are named here: `stability`
    asks for as few agents as can be that do not go on as planned. `options` are those of
    `tsplan.plan`.

    Where nothing can be saved the plan is infeasible, and `rest_mission` with the same arguments is
    the mission to be explained; its notes name parts of the formula that cannot hold any more.

    Raises PlanError for a plan without paths, a step that it does not have, and changes that cannot
    be; MissionError for missions that cannot be planned again (see docs/replanning.md).
    """
    mission, plan = _given(mission, plan)
    found = left(mission, plan, world_of(step, changes), objective)
    return planned_again(mission, plan, found, **(options or {}))


def rest_mission(
    mission: Mission | str | Path,
    plan: Plan | str | Path,
    step: int,
    *,
    objective: Sequence[str] | None = None,
    **changes: Unpack[Changes],
) -> Mission:
    """The mission that is left at a step of a plan, whose step 0 is that step; see `replan`.

    Raises as `replan` does.
    """
    mission, plan = _given(mission, plan)
    return left(mission, plan, world_of(step, changes), objective).rest.mission


class Left(NamedTuple):
    """What is left of a mission, and what was planned for that before."""

    rest: Rest
    before: Plan


def left(
    mission: Mission, plan: Plan, world: World, objective: Sequence[str] | None = None
) -> Left:
    """What is left of a mission in a world, and what a plan has for the same robots.

    Raises PlanError and MissionError as `replan` does.
    """
    refuse_pathless(plan)
    step_within(world.step, plan.horizon, PlanError)
    if plan.replanned and plan.replanned[-1].step > world.step:
        what = f"the plan has been replanned at step {plan.replanned[-1].step} before"
        raise PlanError([Finding(what, "name that step or a later one")])
    if objective is not None:
        world = replace(world, objective=tuple(objective))
    worlds = (*plan.replanned, world)
    past = really(mission, plan, world, Maps(mission.system, worlds))
    rest = rest_of(mission, worlds, past)
    before = planned_ahead(rest, plan)
    return Left(with_intended(rest, before), before)


def planned_again(
    mission: Mission, plan: Plan, found: Left, *, planner: Planner = plan_mission, **options: Any
) -> Plan:
    """The plan with another one for what has been found to be left; `planner` plans that."""
    rest, before = found
    if gone := impossible(rest):
        made = _infeasible(rest, gone)
    else:
        made = planner(rest.mission, start=before, **options)
    whole = joined_plan(rest, made, plan)
    return certify(mission, whole).with_mission(mission)


def impossible(rest: Rest) -> tuple[str, ...]:
    """The parts of the formula of which it is known already that they do not hold, as texts."""
    return tuple(
        str(part)
        for part, left in rest.parts
        if (known := settled(left)) is not None and not known.holds
    )


def _infeasible(rest: Rest, parts: Sequence[str]) -> Plan:
    """That there is no plan, since some parts cannot hold any more."""
    mission = rest.mission
    return Plan(
        Status.INFEASIBLE,
        MissionRef(mission.name, mission.digest),
        mission.horizon,
        notes=tuple(f"cannot hold any more: {part}" for part in parts),
    )


def _given(mission: Mission | str | Path, plan: Plan | str | Path) -> tuple[Mission, Plan]:
    return (
        mission if isinstance(mission, Mission) else load_mission(mission),
        plan if isinstance(plan, Plan) else load_plan(plan),
    )
