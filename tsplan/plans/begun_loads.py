"""What robots and structures bring that start under way with some load."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tsplan.mission.team import UnderWay
from tsplan.name_runs import Run, RunMap

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from tsplan.mission import Mission
    from tsplan.plans.bundles import Agents
    from tsplan.plans.loading import Walker
    from tsplan.plans.structures import Structure


class BegunLoad(NamedTuple):
    """Each of some robots in a row brings an amount of a resource; `who` is their common path."""

    names: Run
    who: Walker
    resource: str
    amount: float


def begun_loads(
    mission: Mission, robots: Agents, structures: Iterable[Structure]
) -> Iterator[BegunLoad]:
    """What those bring that start under way, as far as they are there: modules as a structure."""
    ranks = [rank for rank in mission.ranks if isinstance(rank.start, UnderWay)]
    paths = RunMap(robots.stretches if ranks else ())
    for rank in ranks:
        assert isinstance(rank.start, UnderWay)
        for part, path in paths.parts(rank.names):
            if path is not None:
                for name, amount in rank.start.carrying:
                    yield BegunLoad(part, path, name, amount)
    for each in structures:
        rank_of = mission.roster.get(each.modules[0]) if each.coming is not None else None
        if rank_of is not None and isinstance(rank_of.start, UnderWay):
            for name, amount in rank_of.start.carrying:
                yield BegunLoad(Run.of(each.id), each, name, amount)
