"""Plans of robots that were kept from going on as planned, and follow as soon as they can."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from tsplan.history.joined_plan import planned_ahead, unjudged
from tsplan.mission.team import UnderWay
from tsplan.name_runs import RunMap
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.outcomes import ObjectiveValue

if TYPE_CHECKING:
    from tsplan.history.rest_mission import Rest
    from tsplan.mission import Mission, Rank
    from tsplan.plans.agent_plans import Stay
    from tsplan.plans.plan import Plan


def catching_up(rest: Rest, plan: Plan) -> Plan:
    """A plan of a rest in which everybody follows its way in a plan, as soon as it can.

    Whoever is where it should be does as planned. Whoever is late does not wait any more where it
    should have left, and whoever has lost its way, or finds an edge closed, stays. What was to be
    carried is carried when its way is gone; tasks are executed when they were to be. Nothing is
    known of such a plan until it is judged.
    """
    mission, ahead = rest.mission, planned_ahead(rest, plan)
    own = RunMap(Agents.of(ahead.agents).stretches)
    followed = [
        (part, _followed(mission, rank, path))
        for rank in mission.ranks
        for part, path in own.parts(rank.names)
    ]
    leaving = RunMap((part, way.leaves) for part, way in followed)
    return replace(
        unjudged(plan),
        horizon=mission.horizon,
        objective=tuple(ObjectiveValue(name, None) for name in mission.objective),
        agents=Agents.along((part, way.path) for part, way in followed),
        executions=ahead.executions,
        cargo=CargoRows.joined(
            row._replace(names=part, step=leaves[row.step])
            for row in CargoRows.of(ahead.cargo).order
            for part, leaves in leaving.parts(row.names)
            if leaves is not None and row.step in leaves
        ),
        replanned=(),
    )


class _Followed(NamedTuple):
    """A path that follows another one; it leaves by the steps at which it was to."""

    path: Bundle
    leaves: Mapping[int, int]


def _followed(mission: Mission, rank: Rank, path: Bundle | None) -> _Followed:
    coming = rank.start.origin if isinstance(rank.start, UnderWay) else None
    if isinstance(rank.start, UnderWay):
        where, step = rank.start.target, rank.start.arrives
    else:
        where, step = rank.start, 0
    kind = rank.class_name, rank.capabilities
    if step > mission.horizon:
        return _Followed(Bundle(*kind, (), where, coming=coming), {})
    ahead = () if path is None else path.stays
    begin = next((n for n, stay in enumerate(ahead) if stay[2] == where), len(ahead))
    heading = path.heading if path is not None and begin < len(ahead) else None
    stays: list[Stay] = []
    leaves: dict[int, int] = {}
    for target, planned in _rides(ahead[begin:], heading):
        leave = max(planned, step)  # nobody leaves before it has come
        edge = mission.system.edges.get((where, target))
        lasts = None if edge is None else edge.duration_for(rank.class_name)
        if lasts is None or leave >= mission.horizon:
            break
        stays.append((step, leave, where))
        leaves[planned] = leave
        where, step = target, leave + lasts
        if step > mission.horizon:
            return _Followed(Bundle(*kind, tuple(stays), where, coming=coming), leaves)
    stays.append((step, mission.horizon, where))
    return _Followed(Bundle(*kind, tuple(stays), None, coming=coming), leaves)


def _rides(stays: tuple[Stay, ...], heading: str | None) -> Iterator[tuple[str, int]]:
    """Where a path goes, and when it leaves for there."""
    for before, after in pairwise(stays):
        yield after[2], before[1]
    if heading is not None and stays:
        yield heading, stays[-1][1]
