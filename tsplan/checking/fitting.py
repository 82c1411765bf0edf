"""Whether a plan can be read together with a mission at all, before anything is made of both."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tsplan.checking.group_check import misnamed
from tsplan.checking.plan_check import with_moves
from tsplan.checking.replanned_check import left_over
from tsplan.checking.traffic import read_traffic
from tsplan.errors import Finding, PlanError, nearest

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

_OTHER = "name the mission that was planned"


def refuse_pathless(plan: Plan, source: str = "plan") -> None:
    """Raise PlanError if the plan has no paths."""
    if not plan.has_paths:
        what = f"a plan of status {plan.status} has no paths"
        remedy = "plan the mission again with more time or fewer demands"
        raise PlanError([Finding(what, remedy, source)])


def refuse_misfit(plan: Plan, mission: Mission, source: str = "plan") -> None:
    """Raise PlanError if the plan has no paths, or is of another map, team or horizon.

    This is far less than `check` asks: a plan that breaks the formula still fits.
    """
    refuse_pathless(plan, source)
    misfits = list(_strangers(plan, mission))
    if not misfits and plan.horizon < mission.horizon:
        what = f"the plan ends at step {plan.horizon} and the mission at step {mission.horizon}"
        misfits = [(what, _OTHER)]
    if misfits:
        raise PlanError(Finding(what, remedy, source) for what, remedy in misfits)


def refuse_impossible(plan: Plan, mission: Mission, source: str = "plan") -> None:
    """Raise PlanError as `refuse_misfit`, and for paths and moves that the map does not allow."""
    refuse_misfit(plan, mission, source)
    problems: list[str] = []
    if plan.replanned:  # what happened before is a fact
        rest, plan, problems = left_over(mission, plan)
        mission = mission if rest is None else rest.mission
    traffic, wrong = (None, []) if problems else read_traffic(mission, plan)
    problems += wrong
    if traffic is not None:
        problems += misnamed(plan.groups, traffic)
    if problems:
        raise PlanError(Finding(words, _OTHER, source) for words in problems)


def with_groups(plan: Plan, mission: Mission) -> Plan:
    """The plan with the sub-swarms of its swarms, where its file leaves them out."""
    if plan.groups or not plan.moves:
        return plan
    traffic, _ = read_traffic(mission, plan)
    return plan if traffic is None else with_moves(plan, traffic)


def _strangers(plan: Plan, mission: Mission) -> Iterator[tuple[str, str]]:
    """A state of the plan that the map does not have, and a class that nobody is of."""
    used = {*plan.states, *(end for group in plan.groups for end in group.edge or ())}
    used.update(bundle.heading for bundle in plan.bundles if bundle.heading is not None)
    states = mission.system.states
    for state in sorted(used.difference(states))[:1]:
        yield f"the mission's map has no state '{state}'", nearest(state, states)
    classes = {group.class_name for group in mission.team}
    for name in sorted({bundle.class_name for bundle in plan.bundles} - classes)[:1]:
        yield f"the mission's team has no class '{name}'", nearest(name, classes)
