"""Who enters which edge when in a plan: by agents' paths, structures' ways and swarms' moves."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, NamedTuple

from tsplan.checking.path_segments import read_path
from tsplan.checking.structure_check import structure_path

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from tsplan.checking.path_segments import Segment
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan


class Entry(NamedTuple):
    """Agents with the same capabilities that enter an edge, named by its ends, at a step."""

    edge: tuple[str, str]
    step: int
    agents: int
    capabilities: frozenset[str]


def entries_of(mission: Mission, plan: Plan) -> Iterator[Entry]:
    """Every entry of an edge, waits too, as the map reads the plan.

    Structures of modules enter edges as one agent does, as they count; a swarm's capability is its
    name.
    """
    for bundle in plan.robots:
        path = read_path(mission.system, bundle, plan.horizon)
        yield from _along(path.segments, bundle.capabilities)
    for each in plan.structures:
        yield from _along(structure_path(mission, each).segments, each.capabilities)
    told = {group.swarm for group in plan.groups}
    for swarm in sorted(told.intersection(plan.moves)):
        for step, source, target, count in plan.moves[swarm]:
            yield Entry((source, target), step, count, frozenset({swarm}))


def _along(segments: Iterable[Segment], able: frozenset[str]) -> Iterator[Entry]:
    for edge, entered, left, agents, times in segments:
        for step in range(entered, left, (left - entered) // times):
            yield Entry(edge.pair, step, agents, able)


def entering(
    entries: Iterable[Entry], capability: str | None
) -> Counter[tuple[tuple[str, str], int]]:
    """How many agents with a capability (None: all) enter each edge at each step."""
    found: Counter[tuple[tuple[str, str], int]] = Counter()
    for edge, step, agents, able in entries:
        if capability is None or capability in able:
            found[edge, step] += agents
    return found
