"""Whether a plan can be read together with a mission at all, before anything is made of both."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.errors import Finding, PlanError, nearest

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan


def refuse_misfit(plan: Plan, mission: Mission, source: str = "plan") -> None:
    """Raise PlanError if the plan has no paths, or is of another map, team or horizon.

    This is far less than `check` asks: a plan that breaks the formula still fits.
    """
    findings = _no_paths(plan, source) or [
        *_strange_states(plan, mission, source),
        *_strange_classes(plan, mission, source),
    ]
    if not findings and plan.horizon < mission.horizon:
        what = f"the plan ends at step {plan.horizon} and the mission at step {mission.horizon}"
        findings = [Finding(what, _OTHER, source)]
    if findings:
        raise PlanError(findings)


def refuse_impossible(plan: Plan, mission: Mission, source: str = "plan") -> None:
    """Raise PlanError as `refuse_misfit`, and for paths and moves that the map does not allow."""
    refuse_misfit(plan, mission, source)
    findings = [Finding(words, _OTHER, source) for words in _impossible(plan, mission)]
    if findings:
        raise PlanError(findings)


_OTHER = "name the mission that was planned"


def _impossible(plan: Plan, mission: Mission) -> list[str]:
    """What nobody could do on the map: paths of agents, moves of swarms, sub-swarms of none."""
    from tsplan.checking.group_check import misnamed  # noqa: PLC0415  (needed here alone)
    from tsplan.checking.traffic import read_traffic  # noqa: PLC0415  (as above)

    traffic, problems = read_traffic(mission, plan)
    return problems if traffic is None else list(misnamed(plan.groups, traffic))


def with_groups(plan: Plan, mission: Mission) -> Plan:
    """The plan with the sub-swarms of its swarms, where its file leaves them out."""
    from tsplan.checking.plan_check import with_moves  # noqa: PLC0415  (needed here alone)
    from tsplan.checking.traffic import read_traffic  # noqa: PLC0415  (as above)

    if plan.groups or not plan.moves:
        return plan
    traffic, _ = read_traffic(mission, plan)
    return plan if traffic is None else with_moves(plan, traffic)


def refuse_pathless(plan: Plan, source: str = "plan") -> None:
    """Raise PlanError if the plan has no paths."""
    findings = _no_paths(plan, source)
    if findings:
        raise PlanError(findings)


def _no_paths(plan: Plan, source: str) -> list[Finding]:
    if plan.has_paths:
        return []
    what = f"a plan of status {plan.status} has no paths"
    return [Finding(what, "plan the mission again with more time or fewer demands", source)]


def _strange_states(plan: Plan, mission: Mission, source: str) -> list[Finding]:
    known = mission.system.states
    seen = {*plan.states, *(b.heading for b in plan.bundles if b.heading is not None)}
    seen.update(end for group in plan.groups for end in group.edge or ())
    return [
        Finding(f"the mission's map has no state '{state}'", nearest(state, known), source)
        for state in sorted(seen - set(known))[:1]
    ]


def _strange_classes(plan: Plan, mission: Mission, source: str) -> list[Finding]:
    known = {group.class_name for group in mission.team}
    return [
        Finding(f"the mission's team has no class '{name}'", nearest(name, known), source)
        for name in sorted({bundle.class_name for bundle in plan.bundles} - known)[:1]
    ]
