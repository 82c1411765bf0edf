"""Plans that were made while they were carried out: what comes after the last time is judged.

What has happened before is taken as it is told, but for who took part. The rest is judged as the
plan of the mission that was left, and the formula once more on the whole trace.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from tsplan.checking.check_report import Report, findings_of
from tsplan.checking.claimed_values import shown
from tsplan.errors import InputError
from tsplan.history.changed_formula import changed_mission
from tsplan.history.changed_map import Maps
from tsplan.history.joined_plan import rest_of_plan
from tsplan.history.past_moves import presences
from tsplan.history.past_paths import newcomers, robots_of
from tsplan.history.path_traces import path_trace
from tsplan.history.rest_mission import NobodyLeftError
from tsplan.logic import CountTrace, Formula, conjunction
from tsplan.logic.evaluation import robustness
from tsplan.logic.fraction import shares
from tsplan.name_runs import RunMap
from tsplan.plans.bundles import Agents
from tsplan.plans.structures import of_structures

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tsplan.history.rest_mission import Rest
    from tsplan.mission import Mission
    from tsplan.plans.bundles import Bundle
    from tsplan.plans.plan import Plan


class Left(NamedTuple):
    """What was left of a mission, and the plan for it; `problems` are those of what came before.

    Without a rest and problems nobody was left.
    """

    rest: Rest | None
    plan: Plan
    problems: list[str]


def left_over(mission: Mission, plan: Plan) -> Left:
    """What was left when a plan was replanned last, as far as the plan lets that be told."""
    steps = [world.step for world in plan.replanned]
    problems = [
        f"the plan was replanned at step {later} after it was at step {step}"
        for step, later in pairwise(steps)
        if later < step
    ]
    problems += _strangers(mission, plan)
    if problems:
        return Left(None, plan, problems)
    try:
        rest, cut = rest_of_plan(mission, plan)
    except NobodyLeftError:
        return Left(None, plan, [])
    except InputError as error:
        return Left(None, plan, [finding.message for finding in error.findings])
    if plan.horizon != rest.horizon:
        ends = f"the plan ends at step {plan.horizon} and the mission at step {rest.horizon}"
        return Left(None, plan, [ends])
    return Left(rest, cut, problems)


class Whole(NamedTuple):
    """A mission with what has changed of its formula, and what has happened and is planned."""

    mission: Mission
    trace: CountTrace

    @property
    def availability(self) -> float:
        """That of the formula."""
        return float(robustness(self.mission.counted, self.trace)[0])

    @property
    def satisfaction(self) -> Fraction | None:
        """How much holds of a formula that may hold in part."""
        return self._share(self.mission.formula) if self.mission.partial else None

    @property
    def preferences(self) -> tuple[Fraction, ...]:
        """How much holds of each preference."""
        return tuple(self._share(each.formula) for each in self.mission.prefer)

    def _share(self, formula: Formula) -> Fraction:
        tree = self.mission.tree(formula)
        return shares(tree, self.trace)[tree][0].fraction

    def unfounded(self, plan: Plan) -> Iterator[str]:
        """What a plan says of how much holds and is not so on the whole trace."""
        soft = None if plan.satisfaction is None else plan.satisfaction.fraction
        claims = [] if soft is None else [(soft, self.satisfaction)]
        wishes = (wish.fraction for wish in plan.preferences)
        for said, so in (*claims, *zip(wishes, self.preferences, strict=False)):
            if said != so:
                what = f"the plan says that {said} of a formula holds"
                yield f"{what}, and on the whole trace {so} does"


def whole(mission: Mission, plan: Plan) -> Whole:
    """The formula, on what has happened and what is planned."""
    mission = changed_mission(mission, plan.replanned)
    every = (mission.formula, *(each.formula for each in mission.prefer))
    maps = Maps(mission.system, plan.replanned)
    swarms = presences(mission, plan.moves, maps, plan.horizon)
    others = *swarms, *of_structures(plan.structures)
    where = mission.system, conjunction(every), robots_of(mission, plan), plan.horizon
    trace = path_trace(*where, others=others, executions=plan.executions)
    return Whole(mission, trace)


def taken(plan: Plan) -> str:
    """What a report on a plan that was replanned rests on."""
    return f"what happened before step {plan.replanned[-1].step} is taken as the plan tells it"


def ended(mission: Mission, plan: Plan) -> Report:
    """The report on a plan of which nobody is left, by what has happened."""
    on_whole = whole(mission, plan)
    actual = on_whole.availability
    problems = [
        f"the plan claims {item.name} {shown(item.value)}, and nobody is left"
        for item in plan.objective
        if item.value is not None
    ]
    problems += on_whole.unfounded(plan)
    if actual < 0 and not mission.partial:
        problems.append(f"the formula does not hold (its availability is {shown(actual)})")
    if plan.availability not in (None, actual):
        problems.append(f"the plan claims availability {plan.availability} and has {shown(actual)}")
    so = "the formula holds with" if actual >= 0 else "the formula has"
    held = f"nobody is left, and {so} availability {shown(actual)}"
    return Report(findings_of(problems), () if problems else (taken(plan), held), actual)


def on_whole_trace(mission: Mission, plan: Plan, availability: float) -> Iterator[str]:
    """Whether the formula has that availability on what has happened and what is planned."""
    on_whole = whole(mission, plan)
    if on_whole.availability != availability:
        yield (
            f"the formula has availability {shown(on_whole.availability)} on the whole trace, and "
            f"what is left of it has {shown(availability)}"
        )
    yield from on_whole.unfounded(plan)


def _first(path: Bundle) -> tuple[int, str] | None:
    """When and where somebody is first seen."""
    return (path.stays[0][0], path.stays[0][2]) if path.stays else None


def _strangers(mission: Mission, plan: Plan) -> Iterator[str]:
    """Agents that are neither the mission's nor have joined, and those that begin elsewhere."""
    joined = newcomers(mission, plan.replanned)
    known = RunMap([(rank.names, (0, rank.start)) for rank in mission.ranks])
    for names, group, step in joined:
        known.give(names, (step, group.at))
    for names, path in Agents.of(plan.agents).stretches:
        for part, begin in known.parts(names):
            if begin is None:
                yield f"agent {part.name()} is not in the team"
            elif isinstance(begin[1], str) and _first(path) != begin:
                yield f"agent {part.name()} does not begin at {begin[1]} at step {begin[0]}"
