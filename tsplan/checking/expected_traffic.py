"""What policies come to: expected numbers, by following them over the map from the start.

Nothing but the map, the team and the policies is read. The part of a class that is at a state at a
step is divided by the policy's probabilities, and each action's by those of its outcomes.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from tsplan.checking.class_traffic import ClassTraffic
from tsplan.checking.path_segments import Segment, unwelcome
from tsplan.checking.traffic import Traffic
from tsplan.mission import Group
from tsplan.plans.ledger import Ledger
from tsplan.plans.policies import Policy, expected_counts

if TYPE_CHECKING:
    from tsplan.logic import Formula
    from tsplan.milp.model import Floats
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

ROUNDING = 1e-9
"""By which probabilities may miss 1 in all: their last digits are rounded."""

Kind: TypeAlias = tuple[str, frozenset[str]]
"""The name of a class and what its agents can do."""


@dataclass(frozen=True)
class ExpectedTraffic(Traffic):
    """What all agents of a mission are expected to do; segments have expected numbers of agents."""

    policies: tuple[Policy, ...] = field(default=())

    def counts(self, states: Sequence[str], capability: str | None = None) -> Floats:
        """Expected agents with a capability (all for None) at each of `states` and step."""
        return expected_counts(self.policies, states, self.horizon, capability)

    def robustness(self, formula: Formula) -> float:
        """By how much expected numbers meet a formula; what is only rounded off is nothing."""
        found = super().robustness(formula)
        return 0.0 if abs(found) <= ROUNDING else found


def read_policies(mission: Mission, plan: Plan) -> tuple[ExpectedTraffic | None, list[str]]:
    """What a plan is expected to do, and everything that is wrong with its policies."""
    starts: dict[Kind, dict[str, float]] = {}
    for group in mission.team:
        at = starts.setdefault((group.class_name, group.capabilities), defaultdict(float))
        for state, count in group.starts:
            at[state] += count
    given = {(policy.class_name, policy.capabilities): policy for policy in plan.policies}
    problems = [f"the team has no {_named(kind)}" for kind in given.keys() - starts.keys()]
    problems += [f"{_named(kind)} has no policy" for kind in starts.keys() - given.keys()]
    if len(given) < len(plan.policies):
        problems.append("a class has two policies")
    classes, followed = [], []
    for kind in (kind for kind in starts if kind in given):
        traffic, policy, wrong = _followed(mission, given[kind], starts[kind], plan.horizon)
        problems += [f"{_named(kind)} {words}" for words in dict.fromkeys(wrong)]
        classes.append(traffic)
        followed.append(policy)
    if problems:
        return None, problems
    made = ExpectedTraffic(
        mission, plan.horizon, tuple(classes), Ledger(), policies=tuple(followed)
    )
    return made, [*_misjudged(plan, made)]


def _named(kind: Kind) -> str:
    name, able = kind
    return f"class {name}" + (f" with {', '.join(sorted(able))}" if able else "")


def _followed(
    mission: Mission, policy: Policy, start: Mapping[str, float], horizon: int
) -> tuple[ClassTraffic, Policy, list[str]]:
    """What one class does by its policy, with the numbers expected, and what is wrong."""
    system, taken = mission.system, policy.taken
    who = Group(policy.class_name, policy.capabilities, ())
    present: dict[int, dict[str, float]] = defaultdict(lambda: defaultdict(float))
    present[0].update(start)
    numbers: dict[str, Floats] = {}
    segments, problems = [], [*_unsound(mission, policy)]
    for step in range(horizon + 1):
        for state, agents in present.pop(step, {}).items():
            problems += unwelcome(system, who, state, step)
            numbers.setdefault(state, np.zeros(horizon + 1))[step] = agents
            if step == horizon:
                continue
            choices = taken.get((state, step), ())
            if not choices:
                problems.append(f"has no action at {state} at step {step}, where it may be")
            total = sum(chance for _, chance in choices)
            for name, chance in choices:
                action = system.actions.get((state, name))
                if action is None:
                    continue  # which was told of
                part = agents * chance / total
                end = step + action.duration
                # an expected number: what is summed over segments is an expected value
                segments.append(Segment(action.edge, step, end, part))  # type: ignore[arg-type]
                arrivals = present[step + action.duration]
                for target, likely in action.possible:
                    arrivals[target] = arrivals.get(target, 0.0) + part * likely
    expected = {
        state: tuple(numbers[state].tolist()) for state in system.states if state in numbers
    }
    made = Policy(policy.class_name, policy.capabilities, policy.choices, expected)
    return ClassTraffic(policy.class_name, tuple(segments), (), 0), made, problems


def _unsound(mission: Mission, policy: Policy) -> Iterator[str]:
    """Actions that are none, probabilities that do not add up, chance where there may be none."""
    rules = mission.expected
    for (state, step), choices in policy.taken.items():
        for name, _ in choices:
            if (state, name) not in mission.system.actions:
                yield f"takes '{name}' at {state} at step {step}, which is no action there"
        total = sum(chance for _, chance in choices)
        if abs(total - 1) > ROUNDING:
            yield f"takes actions at {state} at step {step} with probability {total:.10g} in all"
        if rules is not None and rules.deterministic and len(choices) > 1:
            yield f"leaves it to chance what to do at {state} at step {step}"


TOLERANCE = 1e-6
"""By which expected numbers may differ, in agents: solvers keep rows of a model as far as this."""


def _misjudged(plan: Plan, traffic: ExpectedTraffic) -> Iterator[str]:
    """Expected numbers that a plan names and that do not come of its policies."""
    if all(not policy.expected for policy in plan.policies):
        return
    states = tuple(traffic.mission.system.states)
    for policy, true in zip(_in_order(plan, traffic), traffic.policies, strict=True):
        strange = sorted(policy.expected.keys() - set(states))
        if strange or any(len(v) != plan.horizon + 1 for v in policy.expected.values()):
            yield f"the numbers of {policy.class_name} are not of the map's states and steps"
            continue
        claimed = expected_counts([policy], states, plan.horizon)
        actual = expected_counts([true], states, plan.horizon)
        for row, step in np.argwhere(np.abs(claimed - actual) > TOLERANCE)[:3].tolist():
            yield (
                f"{claimed[row, step]:.10g} agents of {policy.class_name} are said to be expected "
                f"at {states[row]} at step {step}, and {actual[row, step]:.10g} are"
            )


def _in_order(plan: Plan, traffic: ExpectedTraffic) -> list[Policy]:
    """The policies of a plan in the order in which they were followed."""
    given = {(policy.class_name, policy.capabilities): policy for policy in plan.policies}
    return [given[policy.class_name, policy.capabilities] for policy in traffic.policies]
