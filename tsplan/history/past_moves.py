"""What swarms have done until a step, and how many of them are where then."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.errors import Finding, PlanError, nearest
from tsplan.mission import Group
from tsplan.mission.team import UnderWay
from tsplan.plans.moves import Move
from tsplan.plans.presence import Presence

if TYPE_CHECKING:
    from tsplan.history.changed_map import Maps
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan
    from tsplan.plans.subswarms import SubSwarm
    from tsplan.plans.worlds import World


def swarms_of(mission: Mission) -> tuple[Group, ...]:
    """The swarms among the classes of a mission."""
    return tuple(g for g in mission.team if mission.group_bounds(g.class_name) is not None)


def moves_before(plan: Plan, step: int) -> dict[str, tuple[Move, ...]]:
    """The moves of every swarm that begin before a step."""
    return {
        swarm: tuple(move for move in moves if move.step < step)
        for swarm, moves in plan.moves.items()
    }


def presences(
    mission: Mission,
    moves: Mapping[str, Sequence[Move]],
    maps: Maps | None = None,
    last: int = 0,
) -> Iterator[Presence]:
    """Who is where by the moves of swarms: whoever leaves a state, by a wait too, is there.

    With `maps` those count, too, who have come at the `last` step, which nobody leaves.
    """
    for swarm in swarms_of(mission):
        mine = moves.get(swarm.class_name, ())
        there: Counter[tuple[str, int]] = Counter()
        for move in mine:
            there[move.source, move.step] += move.count
        if maps is not None:
            there.update({(s, last): n for s, n in _places(swarm, mine, maps, last)[0].items()})
        for (state, step), count in there.items():
            yield Presence(state, step, step, count, swarm.capabilities)


def swarms_now(
    mission: Mission, moves: Mapping[str, Sequence[Move]], worlds: Sequence[World], maps: Maps
) -> Iterator[Group]:
    """The swarms that begin where they are at the step of the last of some worlds.

    Raises PlanError for numbers of swarms and states that are not there.
    """
    world = worlds[-1]
    known = {swarm.class_name for swarm in swarms_of(mission)}
    for name, numbers in world.numbers.items():
        if name not in known:
            raise PlanError([Finding(f"there is no swarm '{name}'", nearest(name, known))])
        for state in numbers:
            maps.known_state(state, f"some of {name}")
    for swarm in swarms_of(mission):
        at, ways = _places(swarm, moves.get(swarm.class_name, ()), maps, world.step)
        at |= world.numbers.get(swarm.class_name, {})
        starts = tuple((state, count) for state, count in at.items() if count)
        if not starts and not ways:
            raise PlanError([Finding(f"nobody of {swarm.class_name} is left", "plan without it")])
        yield replace(swarm, starts=starts, coming=tuple(ways.items()))


def _places(
    swarm: Group, moves: Iterable[Move], maps: Maps, step: int
) -> tuple[dict[str, int], dict[UnderWay, int]]:
    """How many of a swarm are at each state at a step, and on each edge until when."""
    at: Counter[str] = Counter()
    ways: Counter[UnderWay] = Counter()

    def put(source: str, target: str, arrives: int, count: int) -> None:
        if arrives == step:
            at[target] += count
        elif arrives > step:
            ways[UnderWay(source, target, arrives - step)] += count

    for state, count in swarm.starts:
        put(state, state, 0, count)
    for way, count in swarm.coming:
        put(way.origin, way.target, way.arrives, count)
    for move in moves:
        edge = maps.at(move.step).edges[move.source, move.target]
        put(*edge.pair, move.step + (edge.duration_for(swarm.class_name) or 0), move.count)
    return dict(at), dict(ways)


def joined_moves(
    before: Mapping[str, Sequence[Move]], after: Mapping[str, Sequence[Move]], step: int
) -> dict[str, tuple[Move, ...]]:
    """The moves before a step, and those of a plan whose step 0 is that step."""
    return {
        swarm: (*before.get(swarm, ()), *(m._replace(step=m.step + step) for m in moves))
        for swarm, moves in after.items()
    }


def joined_groups(
    before: Iterable[SubSwarm], after: Iterable[SubSwarm], step: int
) -> tuple[SubSwarm, ...]:
    """The sub-swarms before a step, and those of a plan whose step 0 is that step."""
    past = [each for each in before if each.first < step]
    names = {each.id for each in past}
    past = [
        replace(
            each,
            last=min(each.last, step - 1),
            children=tuple(child for child in each.children if child in names),
        )
        for each in past
    ]
    return (*past, *(_later(each, step) for each in after))


def groups_from(groups: Iterable[SubSwarm], step: int) -> tuple[SubSwarm, ...]:
    """The sub-swarms from a step on, which is their step 0."""
    return tuple(_later(each, -step) for each in groups if each.first >= step)


def _later(group: SubSwarm, steps: int) -> SubSwarm:
    """A sub-swarm so many steps later; its name tells at which step it was planned."""
    mark = f"@{abs(steps)}"

    def named(name: str) -> str:
        return name + mark if steps > 0 else name.removesuffix(mark)

    return replace(
        group,
        id=named(group.id),
        first=group.first + steps,
        last=group.last + steps,
        parents=tuple(map(named, group.parents)),
        children=tuple(map(named, group.children)),
    )
