"""What a plan for a mission without some constraints fulfils of these all the same.

A plan that breaks fewer constraints than were taken out answers more questions than the one that it
was found for, and the check that says so takes no solve. Whatever the plan is judged to keep is put
back one by one; where the number or the start of robots was open, who came from where tells.

Source: model rotation in the search for minimal unsatisfiable sets, A. Belov and J. Marques-Silva,
"Accelerating MUS extraction with recursive model rotation", FMCAD 2011.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, TypeAlias

from tsplan.checking.plan_check import certify
from tsplan.checking.traffic import read_traffic
from tsplan.errors import SolverError
from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.whynot.occurrences import without
from tsplan.explanation.whynot.relaxing import can_idle, relaxed
from tsplan.explanation.whynot.soft_constraints import occurrence_of
from tsplan.logic import Always, capabilities
from tsplan.logic.evaluation import robustness
from tsplan.plans.count_traces import count_trace
from tsplan.run.problem import Problem

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from tsplan.explanation.whynot.subject import Constraints
    from tsplan.mission import Group, Mission
    from tsplan.plans.plan import Plan

    _Judge: TypeAlias = Callable[[Constraints], bool]


def broken_by(
    mission: Mission,
    groups: Sequence[Sequence[SoftConstraint]],
    gone: Constraints,
    question: Mission | Problem,
    plan: Plan,
) -> Constraints:
    """Those of some constraints that a plan without them breaks, or may break.

    `groups` are the parts of each conjunct; those of one are looked at together first.
    """
    team = {item for item in gone if item.kind in ("team", "start")}
    # who leaves a depot late may be in the way of a limit that is put back
    if len(gone) == 1 or (team and not can_idle(mission)):
        return gone
    posed = question.mission if isinstance(question, Problem) else question
    judged = None
    if gone.difference(team) and _told_by_counts(mission, gone):
        judged = _by_counts(mission, posed, plan)
    elif not team:  # depots are made for what is left of the formula
        judged = _by_check(mission, plan)
    for some in _tried(groups, gone):
        fewer = gone.difference(some)
        if fewer != gone and judged is not None and judged(fewer):
            gone = fewer
    return gone.difference(_at_home(mission, posed, team, plan)) if team else gone


def _told_by_counts(mission: Mission, gone: Constraints) -> bool:
    """Whether the numbers of agents at states tell which of the constraints a plan keeps."""
    more = mission.swarm or mission.delay or mission.books or mission.resources
    return not more and all(item.kind in ("formula", "team", "start") for item in gone)


def _by_counts(mission: Mission, posed: Mission, plan: Plan) -> _Judge | None:
    """Whether a plan keeps the formula without some of its parts; all else is as it was asked."""
    traffic, _ = read_traffic(posed, plan)
    if traffic is None:
        return None
    states = tuple(posed.system.states)
    able = (None, *capabilities(mission.translated(mission.formula)))
    trace = count_trace(posed.system, {name: traffic.counts(states, name) for name in able})
    before = posed.horizon - mission.horizon

    def judged(gone: Constraints) -> bool:
        formula = without(mission.formula, (occurrence_of(i) for i in gone if i.kind == "formula"))
        later = Always(before, before, mission.translated(formula))
        return bool(robustness(later, trace)[0] >= 0)

    return judged


def _by_check(mission: Mission, plan: Plan) -> _Judge:
    """Whether a plan is one of the mission without some constraints, by the check alone."""
    plan = replace(plan, availability=None, objective=(), satisfaction=None, preferences=())

    def judged(gone: Constraints) -> bool:
        question = relaxed(mission, gone)
        problem = question if isinstance(question, Problem) else Problem(question)
        try:
            return not problem.broken(certify(problem.mission, plan))
        except SolverError:
            return False

    return judged


def _tried(
    groups: Sequence[Sequence[SoftConstraint]], gone: Constraints
) -> Iterator[Iterable[SoftConstraint]]:
    """What is put back at a time: the parts of a conjunct together, then each thing alone.

    Numbers and starts are not judged here.
    """
    yield from (group for group in groups if len(gone.intersection(group)) > 1)
    alone = (item for item in gone if item.kind not in ("team", "start"))
    yield from ([item] for item in sorted(alone, key=repr))


def _at_home(
    mission: Mission, question: Mission, gone: Iterable[SoftConstraint], plan: Plan
) -> Iterator[SoftConstraint]:
    """Numbers and starts that were open, and that the robots which left their depots keep.

    Whoever is left over idles, and whoever leaves late waits where it arrives: nobody is in its way
    there, nor is it in anybody's.
    """
    home = {depot: entry for entry, group in enumerate(question.team) for depot, _ in group.starts}
    used: list[Counter[str]] = [Counter() for _ in mission.team]
    for bundle in plan.robots:
        (_, _, depot), *stays = bundle.stays
        begun = stays[0][2] if stays else bundle.heading
        if begun is not None:
            used[home[depot]][begun] += len(bundle.agents)
    for item in gone:
        (entry,) = item.key
        if item in _kept(mission.team[entry], entry, used[entry]):
            yield item


def _kept(group: Group, entry: int, used: Counter[str]) -> tuple[SoftConstraint, ...]:
    """Which of an entry's number and start some robots keep by where they begin."""
    number, start = SoftConstraint("team", (entry,)), SoftConstraint("start", (entry,))
    if used <= Counter(dict(group.starts)):
        return number, start
    if used.total() <= group.count:
        return (number,)
    return (start,) if set(used) <= {state for state, _ in group.starts} else ()
