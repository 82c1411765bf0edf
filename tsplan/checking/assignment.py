"""From the moves of swarms to one path per agent, judged by the check."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import chain
from typing import TYPE_CHECKING

from tsplan.checking.plan_check import certify
from tsplan.checking.traffic import read_traffic
from tsplan.errors import Finding, PlanError
from tsplan.mission.team import UnderWay
from tsplan.parameters import refuse_options
from tsplan.plans.bundles import Agents, Stretch
from tsplan.plans.decomposition import paths_of
from tsplan.plans.moves import Move

if TYPE_CHECKING:
    from tsplan.mission import Mission, Rank
    from tsplan.plans.plan import Plan


def assign(mission: Mission, plan: Plan, *, seed: int | None = None) -> Plan:
    """The plan of a mission with swarms with a path for every agent, judged by the check.

    The paths of a swarm's agents together make exactly its moves. They are the same for equal plans
    and seeds; another seed gives them to other agents. Raises PlanError for a plan without moves or
    with moves that the mission does not allow, and SolverError if the check refuses the plan.
    """
    if not plan.moves:
        what = "the plan has no moves of swarms to make paths of"
        raise PlanError([Finding(what, "plan a mission with a swarm")])
    refuse_options(seed=seed)
    others = Agents.of(plan.agents).only(lambda bundle: bundle.class_name not in plan.moves)
    _, problems = read_traffic(mission, replace(plan, agents=others))
    if problems:
        raise PlanError(Finding(words, "name the mission that was planned") for words in problems)
    walked: dict[int, list[Stretch]] = defaultdict(list)
    for name, moves in plan.moves.items():
        ranks = [rank for rank in mission.ranks if rank.class_name == name]
        begun = _begun(ranks) if mission.horizon else ()
        made = paths_of(mission, ranks, (*begun, *moves), seed, late=bool(plan.delay))
        for rank, stretches in zip(ranks, made, strict=True):
            walked[rank.group] += stretches
    place = {group.class_name: number for number, group in enumerate(mission.team)}
    for stretch in others.stretches:
        walked[place.get(stretch.path.class_name, -1)].append(stretch)
    agents = Agents.along(chain.from_iterable(walked[group] for group in sorted(walked)))
    return certify(mission, replace(plan, agents=agents)).with_mission(mission)


def _begun(ranks: Iterable[Rank]) -> Iterator[Move]:
    """The rest of the moves of agents that start under way, which plans do not name."""
    counts: Counter[UnderWay] = Counter()
    for rank in ranks:
        if isinstance(rank.start, UnderWay):
            counts[rank.start] += rank.names.size
    for start, count in counts.items():
        yield Move(0, start.place, start.target, count)
