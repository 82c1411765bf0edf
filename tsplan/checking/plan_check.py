"""The independent check of a plan.

It reads nothing but the map, the team, the formula and the agents' stays: it walks every path
over the map, counts who is where, and evaluates the formula as written on those counts. Nothing
of the model, the encoding or the solver enters, so a mistake there cannot hide here. A plan of
swarms is judged by its moves where it has no agents.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from tsplan.checking.claimed_values import false_objectives, shown, unproven
from tsplan.checking.measures import MEASURES
from tsplan.checking.path_segments import Leg, read_path
from tsplan.checking.satisfaction_check import (
    completed,
    count_trace,
    false_claims,
    fulfilments_of,
    satisfaction_of,
    spare_of,
)
from tsplan.checking.swarm_judge import Verdict, judged_swarms, swarm_completed, swarm_facts
from tsplan.checking.traffic import interval_counts, state_counts
from tsplan.errors import Finding, SolverError
from tsplan.mission.mission import Agent, Mission
from tsplan.plans.plan import AgentPlan, Bundle, ObjectiveValue, Plan
from tsplan.plans.summary import infinite_word

if TYPE_CHECKING:
    from collections.abc import Mapping

    from tsplan.logic.traces import CountTrace
    from tsplan.plans.satisfaction import Fulfilment, Satisfaction
    from tsplan.ts import TransitionSystem

Journeys: TypeAlias = "list[tuple[Bundle, tuple[Leg, ...]]]"

_SHOWN = 20  # findings of one kind that are listed before the rest is only counted


@dataclass(frozen=True)
class Report:
    """What the check found.

    `findings` is empty exactly if the plan is accepted. `availability` and `values` are computed
    from the paths; they are None and empty when the paths themselves are wrong. `facts` says in
    words what was found to hold.
    """

    findings: tuple[Finding, ...]
    facts: tuple[str, ...]
    availability: float | None = None
    values: Mapping[str, float] | None = None

    @property
    def ok(self) -> bool:
        """Whether the plan is accepted."""
        return not self.findings


def check(mission: Mission, plan: Plan) -> Report:
    """Judge a plan against its mission by the agents' stays alone.

    The report lists everything that is wrong at once; only when a path is impossible are the
    counts, the formula and the objectives left out, because they would say nothing.
    """
    if not plan.has_paths:
        return Report((_finding(f"a plan of status {plan.status} has no paths to check"),), ())
    findings, values = _judged(mission, plan)
    if values is None:
        return Report(_shortened(findings), ())
    findings += _claims(mission, plan, values)
    findings += [_finding(words) for words in unproven(plan, values.objectives)]
    facts = _facts(mission, plan, values) if not findings else ()
    measured = {name: float(value) for name, value in values.objectives.items()}
    return Report(_shortened(findings), facts, values.availability, measured)


def certify(mission: Mission, plan: Plan) -> Plan:
    """The plan marked as verified, if the check accepts it.

    An availability or objective that the plan leaves open is filled in with its value; what it
    claims is checked. Plans without paths are returned as they are. Raises SolverError with the
    findings for a plan that is refused.
    """
    if not plan.has_paths:
        return plan
    findings, values = _judged(mission, plan)
    if values is not None:
        plan = _completed(mission, plan, values)
        if mission.swarm is not None:
            plan = swarm_completed(mission, plan, _journeys(mission, plan)[0])
        findings += _claims(mission, plan, values)
    if findings:
        listed = "\n".join(str(finding) for finding in _shortened(findings))
        raise SolverError(f"the plan that was found does not stand up to the check:\n{listed}")
    return replace(plan, verified=True)


@dataclass(frozen=True)
class _Worth:
    """What a plan is worth: its formula's availability, its objectives, and what it satisfies.

    Objectives are exact; only an availability may be infinite.
    """

    availability: float
    objectives: Mapping[str, Fraction | float]
    satisfaction: Satisfaction | None = None
    preferences: tuple[Fulfilment, ...] = ()


def _judged(mission: Mission, plan: Plan) -> tuple[list[Finding], _Worth | None]:
    """What is wrong with the paths, and what they are worth unless a path is impossible."""
    findings = _horizon(mission, plan)
    if plan.agents or mission.swarm is None:
        findings += _team(mission, plan)
    if plan.moves and mission.swarm is None:
        findings.append(_finding("the plan moves swarms, and the mission has a team"))
    journeys, broken = _journeys(mission, plan)
    findings += broken
    if findings:
        return findings, None
    if mission.swarm is not None:
        verdict = judged_swarms(mission, plan, journeys)
        findings = [_finding(problem) for problem in verdict.problems]
        return findings, _swarm_worth(mission, verdict)
    findings += _crowded_states(mission.system, plan)
    findings += _crowded_edges(mission.system, plan, journeys)
    worth = _worth(mission, plan, journeys)
    if worth.availability < 0 and not mission.partial:
        findings.append(
            _finding(f"the formula does not hold (its availability is {shown(worth.availability)})")
        )
    return findings, worth


def _worth(mission: Mission, plan: Plan, journeys: Journeys) -> _Worth:
    """What the paths of a plan are worth."""
    values: dict[str, Fraction | float] = {
        name: Fraction(measure(journeys)) for name, measure in MEASURES.items()
    }
    availability = formula_robustness(mission, plan.bundles, plan.horizon)
    values["availability"] = availability
    if not mission.partial and not mission.prefer:
        return _Worth(availability, values)
    trace = count_trace(mission, plan.bundles, plan.horizon)
    return _with_satisfaction(mission, availability, values, trace)


def _swarm_worth(mission: Mission, verdict: Verdict) -> _Worth | None:
    """What the moves of swarms are worth, unless they are impossible."""
    if verdict.values is None or verdict.trace is None:
        return None
    if not mission.partial and not mission.prefer:
        return _Worth(verdict.values["availability"], verdict.values)
    availability = verdict.values["availability"]
    return _with_satisfaction(mission, availability, verdict.values, verdict.trace)


def _with_satisfaction(
    mission: Mission,
    availability: float,
    measured: Mapping[str, Fraction | float],
    trace: CountTrace,
) -> _Worth:
    """Worth with what is satisfied; availability as an objective is that of what holds."""
    values = dict(measured)
    values["availability"] = spare_of(mission, trace, availability)
    satisfaction, preferences = satisfaction_of(mission, trace), fulfilments_of(mission, trace)
    if satisfaction is not None and satisfaction.fraction is not None:
        values["satisfaction"] = satisfaction.fraction
    values["preferences"] = sum((item.worth for item in preferences), Fraction(0))
    return _Worth(availability, values, satisfaction, preferences)


def _completed(mission: Mission, plan: Plan, worth: _Worth) -> Plan:
    """The plan with what it leaves open filled in."""
    finite = {
        name: float(value) if math.isfinite(value) else None
        for name, value in worth.objectives.items()
    }
    actual = worth.availability if math.isfinite(worth.availability) else None
    items = plan.objective or tuple(ObjectiveValue(name, None) for name in mission.objective)
    return replace(
        plan,
        availability=actual if plan.availability is None else plan.availability,
        satisfaction=completed(plan.satisfaction, worth.satisfaction),
        preferences=plan.preferences or worth.preferences,
        objective=tuple(
            replace(item, value=finite.get(item.name)) if item.value is None else item
            for item in items
        ),
    )


def objective_values(mission: Mission, plan: Plan) -> dict[str, float]:
    """Every objective's value, by name, computed from the paths of a plan that fits the map."""
    journeys, broken = _journeys(mission, plan)
    if broken:
        raise SolverError("\n".join(str(finding) for finding in broken))
    if mission.swarm is not None:
        verdict = judged_swarms(mission, plan, journeys)
        found = _swarm_worth(mission, verdict)
        if found is None:
            raise SolverError("\n".join(verdict.problems))
    else:
        found = _worth(mission, plan, journeys)
    return {name: float(value) for name, value in found.objectives.items()}


def formula_robustness(mission: Mission, bundles: tuple[Bundle, ...], horizon: int) -> float:
    """Counting robustness at step 0 of the mission's formula as written, on the agents' counts."""
    from tsplan.logic.evaluation import robustness  # noqa: PLC0415  (the parser is slow to import)

    return float(robustness(mission.counted, count_trace(mission, bundles, horizon))[0])


def _horizon(mission: Mission, plan: Plan) -> list[Finding]:
    if plan.horizon == mission.horizon:
        return []
    return [
        _finding(f"the plan ends at step {plan.horizon} and the mission at step {mission.horizon}")
    ]


def _team(mission: Mission, plan: Plan) -> list[Finding]:
    """Whether the agents of the plan are exactly those of the mission, where they start."""
    if len(plan.agents) == mission.size and all(map(_same, plan.agents, mission.agents)):
        return []
    findings = []
    seen: set[str] = set()
    team = {agent.id: agent for agent in mission.agents}
    for planned in plan.agents:
        agent = team.get(planned.id)
        if agent is None:
            findings.append(_finding(f"agent {planned.id} is not in the team"))
            continue
        if planned.id in seen:
            findings.append(_finding(f"agent {planned.id} is there twice"))
        seen.add(planned.id)
        if planned.class_name != agent.class_name:
            findings.append(
                _finding(
                    f"agent {agent.id} is of class {agent.class_name}, not {planned.class_name}"
                )
            )
        if planned.capabilities != agent.capabilities:
            findings.append(_finding(f"agent {agent.id} has other capabilities in the mission"))
        if planned.stays and planned.stays[0][2] != agent.start:
            start = planned.stays[0][2]
            findings.append(_finding(f"agent {agent.id} starts at {agent.start}, not at {start}"))
    if len(seen) < len(team):
        findings += [_finding(f"agent {name} has no path") for name in team if name not in seen]
    return findings


def _same(planned: AgentPlan, agent: Agent) -> bool:
    """Whether an agent of a plan is the one of the mission, where it starts."""
    name, class_name, capabilities, start = agent
    return (
        planned.id == name
        and planned.class_name == class_name
        and planned.capabilities == capabilities
        and (not planned.stays or planned.stays[0][2] == start)
    )


def _journeys(mission: Mission, plan: Plan) -> tuple[Journeys, list[Finding]]:
    """Every path read against the map, one for all agents that share it."""
    journeys: Journeys = []
    findings = []
    for bundle in plan.bundles:
        path = read_path(mission.system, bundle, plan.horizon)
        journeys.append((bundle, path.legs))
        who = _who(plan, bundle)
        findings += [_finding(f"{who} {problem}") for problem in path.problems]
    return journeys, findings


def _who(plan: Plan, bundle: Bundle) -> str:
    first = f"agent {plan.agents[bundle.agents[0]].id}"
    more = len(bundle.agents) - 1
    return f"{first} (and {more} on the same path)" if more else first


def _crowded_states(system: TransitionSystem, plan: Plan) -> list[Finding]:
    limited = [name for name, state in system.states.items() if state.capacity is not None]
    counts = state_counts(plan.bundles, limited, plan.horizon)
    findings = []
    for name, row in zip(limited, counts, strict=True):
        capacity = system.states[name].capacity
        findings += _over(row, capacity or 0, f"at {name}")
    return findings


def _crowded_edges(system: TransitionSystem, plan: Plan, journeys: Journeys) -> list[Finding]:
    findings = []
    for capacity, edges in system.capacity_groups:
        group = frozenset(edges)
        row = interval_counts(
            (
                (leg.entered, leg.left - 1, len(bundle.agents))
                for bundle, legs in journeys
                for leg in legs
                if (leg.edge.source, leg.edge.target) in group
            ),
            plan.horizon,
        )
        source, target = edges[0]
        where = f"on the edge from {source} to {target}"
        findings += _over(row, capacity, where + (" and back" if len(edges) > 1 else ""))
    return findings


def _over(
    row: np.ndarray[tuple[int, ...], np.dtype[np.int64]], limit: int, where: str
) -> list[Finding]:
    return [
        _finding(f"{row[step]} agents are {where} at step {step}, which holds {limit}")
        for step in np.flatnonzero(row > limit).tolist()
    ]


def _claims(mission: Mission, plan: Plan, worth: _Worth) -> list[Finding]:
    """Whether what the plan says about itself is so."""
    findings = false_claims(plan, worth.satisfaction, worth.preferences)
    actual = worth.availability if math.isfinite(worth.availability) else None
    if plan.availability != actual:
        findings.append(
            _finding(f"the plan claims availability {plan.availability} and has {actual}")
        )
    objectives = [_finding(text) for text in false_objectives(mission, plan, worth.objectives)]
    return findings + objectives


def _facts(mission: Mission, plan: Plan, worth: _Worth) -> tuple[str, ...]:
    endless = infinite_word(plan)
    values_found = (
        *_held(worth, shown(worth.availability)),
        *(f"{name} is {shown(worth.objectives[name], endless)}" for name in mission.objective),
    )
    if mission.swarm is not None:
        return (*swarm_facts(mission, plan, worth.objectives), *values_found)
    capacities = any(state.capacity is not None for state in mission.system.states.values())
    fits = ["every capacity is kept"] if capacities or mission.system.capacity_groups else []
    return (
        f"the team is the mission's: {len(plan.agents)} agents, each with one path from its start",
        f"every path follows the map's edges at their durations up to step {plan.horizon}",
        *fits,
        *values_found,
    )


def _held(worth: _Worth, availability: str) -> list[str]:
    """What holds of the formula and of the preferences."""
    if worth.satisfaction is not None and worth.satisfaction.fraction != 1:
        facts = [f"the formula holds in part, with satisfaction {worth.satisfaction.fraction}"]
    else:
        facts = [f"the formula holds, with availability {availability}"]
    return facts + [
        f"preference '{item.name}' is met"
        if item.met
        else f"preference '{item.name}' is not met (its fraction is {item.fraction})"
        for item in worth.preferences
    ]


def _shortened(findings: list[Finding]) -> tuple[Finding, ...]:
    """The first findings, and how many more there are."""
    if len(findings) <= _SHOWN:
        return tuple(findings)
    rest = _finding(f"and {len(findings) - _SHOWN} more")
    return (*findings[:_SHOWN], rest)


def _finding(message: str) -> Finding:
    return Finding(message, source="plan")
