"""The independent check of a plan.

It reads nothing but the map, the team, the formula and what the plan says of its agents' paths and
its swarms' moves: it follows them over the map, counts who is where, and evaluates the formula as
written on those counts. Nothing of the model, the encoding or the solver enters, so a mistake there
cannot hide here.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tsplan.checking.check_report import Report, findings_of, refuse
from tsplan.checking.claimed_values import (
    false_objectives,
    near_enough,
    same,
    shown,
    unproven,
)
from tsplan.checking.closing import shut_in
from tsplan.checking.crowding import crowded
from tsplan.checking.expected_traffic import TOLERANCE, ExpectedTraffic, read_policies
from tsplan.checking.group_check import broken_bounds, misnamed, unrelated
from tsplan.checking.lateness import late
from tsplan.checking.measures import Number, measured
from tsplan.checking.plan_facts import facts_of
from tsplan.checking.replanned_check import ended, left_over, on_whole_trace, taken
from tsplan.checking.satisfaction_check import completed, false_claims
from tsplan.checking.supplied import unsupplied
from tsplan.checking.team_check import strangers, told
from tsplan.checking.traffic import Traffic, read_traffic
from tsplan.errors import SolverError
from tsplan.plans.double_booking import overbooked
from tsplan.plans.outcomes import ObjectiveValue
from tsplan.plans.plan import Plan
from tsplan.plans.presence import state_counts
from tsplan.words import known

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from tsplan.mission import Mission


def check(mission: Mission, plan: Plan) -> Report:
    """Judge a plan against its mission by the agents' paths and the swarms' moves alone.

    The report lists everything that is wrong at once; only when a path or a move is impossible are
    the counts, the formula and the objectives left out, because they would say nothing.
    """
    if not plan.has_paths:
        return Report(findings_of([f"a plan of status {plan.status} has no paths to check"]), ())
    if plan.replanned:
        return _replanned(mission, plan)
    traffic, problems = _judged(mission, plan)
    if traffic is None:
        return Report(findings_of(problems), ())
    values = measured(traffic)
    problems += [*_false_claims(plan, traffic, values), *unproven(plan, values)]
    facts = () if problems else facts_of(plan, traffic, values)
    told = {name: float(value) for name, value in values.items()}
    return Report(findings_of(problems), facts, traffic.availability, told)


def _replanned(mission: Mission, plan: Plan) -> Report:
    """The report on a plan that was replanned, by what comes after that."""
    left = left_over(mission, plan)
    if left.problems:
        return Report(findings_of(left.problems), ())
    if left.rest is None:
        return ended(mission, plan)
    report = check(left.rest.mission, left.plan)
    if not report.ok or report.availability is None:
        return report
    problems = list(on_whole_trace(mission, plan, report.availability))
    facts = () if problems else (taken(plan), *report.facts)
    return replace(report, findings=findings_of(problems), facts=facts)


def certify(mission: Mission, plan: Plan) -> Plan:
    """The plan marked as verified, if the check accepts it.

    What the plan leaves open is filled in: its availability and objectives, what it satisfies, and
    the moves and sub-swarms of swarms. What it claims is checked. Plans without paths are returned
    as they are. Raises SolverError with the findings for a plan that is refused.
    """
    if not plan.has_paths:
        return plan
    if plan.replanned:
        refuse([finding.message for finding in _replanned(mission, plan).findings])
        return replace(plan, verified=True)
    traffic, problems = _judged(mission, plan)
    if traffic is not None:
        values = measured(traffic)
        plan = _completed(plan, traffic, values)
        problems += _false_claims(plan, traffic, values)
    refuse(problems)
    return replace(plan, verified=True)


def with_values(mission: Mission, plan: Plan) -> Plan:
    """The plan with what it leaves open filled in, whether or not the check accepts it."""
    traffic, _ = _judged(mission, plan)
    return plan if traffic is None else _completed(plan, traffic, measured(traffic))


def objective_values(mission: Mission, plan: Plan) -> dict[str, float]:
    """Every objective's value, by name, computed from a plan that fits the map."""
    if plan.replanned:
        left = left_over(mission, plan)
        refuse(left.problems)
        if left.rest is None:  # of nobody
            return {}
        mission, plan = left.rest.mission, left.plan
    read = read_traffic if mission.expected is None else read_policies
    traffic, problems = read(mission, plan)
    if traffic is None:
        raise SolverError("\n".join(problems))
    return {name: float(value) for name, value in measured(traffic).items()}


def _judged(mission: Mission, plan: Plan) -> tuple[Traffic | None, list[str]]:
    """What a plan does unless that is impossible, and everything that is wrong about it."""
    ends = f"the plan ends at step {plan.horizon} and the mission at step {mission.horizon}"
    problems = [] if plan.horizon == mission.horizon else [ends]
    if mission.expected is not None:
        problems += [f"{told(bundle.agents)} has a path" for bundle in plan.bundles]
        expected, wrong = read_policies(mission, plan)
        problems += wrong
        problems += [] if expected is None else _broken_formula(expected)
        return expected, problems
    if plan.policies:
        problems.append("the plan has policies, and the moves of the mission are certain")
    problems += strangers(mission, plan)
    traffic, impossible = read_traffic(mission, plan)
    problems += impossible
    if traffic is None or problems:
        return None, problems
    problems += [
        *crowded(traffic),
        *shut_in(traffic),
        *broken_bounds(traffic),
        *unsupplied(traffic),
        *map(str, overbooked(traffic.ledger.uses, traffic.present, mission.booking)),
        *_short_delay(traffic),
        *_disorderly(traffic),
        *_broken_formula(traffic),
        *misnamed(plan.groups, traffic),
    ]
    # relatives are told by the places of sub-swarms, which must be right for that
    return traffic, problems or list(unrelated(plan.groups, traffic))


def _short_delay(traffic: Traffic) -> Iterator[str]:
    """Whether agents may be as late in the plan as the mission asks for."""
    delay, asked = traffic.delay, traffic.mission.delay
    aim = "delay" in traffic.mission.objective
    if delay < asked or (delay > asked and not aim):
        wanted = f"at least {asked}" if aim else str(asked)
        yield f"the plan is for agents up to {delay} steps late, and the mission asks for {wanted}"


def _disorderly(traffic: Traffic) -> Iterator[str]:
    """Paths of swarms by which fewer agents stand somewhere than by the rule for their moves."""
    states = tuple(traffic.mission.system.states)
    for swarm in traffic.swarms if traffic.delay else ():
        if not swarm.bundles:
            continue
        own, rule = (
            state_counts(where.sure, states, traffic.horizon)
            for where in (late(swarm.bundles, traffic.delay), traffic.late(swarm, traffic.delay))
        )
        for row, step in np.argwhere(own < rule)[:1].tolist():
            yield (
                f"by the agents' paths {own[row, step]} of {swarm.class_name} have been at "
                f"{states[row]} long enough at step {step}, and {rule[row, step]} if who came last "
                "leaves first"
            )


def _broken_formula(traffic: Traffic) -> Iterator[str]:
    """Whether the formula holds, with the mission's margin, where it must hold as a whole."""
    mission = traffic.mission
    if mission.partial:
        return
    least = 0.0 if mission.expected is None else -TOLERANCE
    if traffic.availability < least:
        yield f"the formula does not hold (its availability is {shown(traffic.availability)})"
    elif mission.headroom is not None:
        slack = traffic.robustness(mission.goal)
        if slack < least:
            short = f"{shown(-slack)} short of the mission's margin"
            yield f"the formula holds, but some demand falls {short}"


def _completed(plan: Plan, traffic: Traffic, values: Mapping[str, Number]) -> Plan:
    """The plan with what it leaves open filled in."""
    finite = {name: known(float(value)) for name, value in values.items()}
    items = plan.objective or [ObjectiveValue(name, None) for name in traffic.mission.objective]
    actual = known(traffic.availability)
    if isinstance(traffic, ExpectedTraffic):
        plan = replace(plan, policies=traffic.policies)
        items = [_closed(item, values[item.name]) for item in items if item.name in values]
    return replace(
        with_moves(plan, traffic),
        stocks=plan.stocks or traffic.ledger.histories,
        availability=actual if plan.availability is None else plan.availability,
        delay=traffic.delay if "delay" in values else plan.delay,
        satisfaction=completed(plan.satisfaction, traffic.satisfaction),
        preferences=plan.preferences or traffic.preferences,
        objective=tuple(
            replace(item, value=finite.get(item.name)) if item.value is None else item
            for item in items
        ),
    )


def _closed(item: ObjectiveValue, actual: Number) -> ObjectiveValue:
    """An objective whose bound is the value that is measured, where floats tell no difference."""
    near = item.bound is not None and near_enough(item.bound, float(actual))
    return replace(item, bound=float(actual)) if near else item


def with_moves(plan: Plan, traffic: Traffic) -> Plan:
    """The plan with the moves and the sub-swarms of its swarms where it names none."""
    return replace(
        plan, moves={**traffic.moves, **plan.moves}, groups=plan.groups or traffic.groups
    )


def _false_claims(plan: Plan, traffic: Traffic, values: Mapping[str, Number]) -> list[str]:
    """What the plan says about itself and is not so."""
    problems = list(false_claims(plan, traffic.satisfaction, traffic.preferences))
    actual = known(traffic.availability)
    if not same(traffic.mission, plan.availability, actual):
        problems.append(f"the plan claims availability {plan.availability} and has {actual}")
    if plan.delay not in (None, traffic.delay):
        problems.append(f"the plan claims delay {plan.delay} and has {traffic.delay}")
    if plan.stocks != traffic.ledger.histories:
        problems.append("the plan's account of stocks is not what its cargo and executions make")
    return [*problems, *false_objectives(traffic.mission, plan, values)]
