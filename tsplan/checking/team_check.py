"""Whether the agents of a plan are exactly those of the mission, where they start."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from tsplan.mission.team import UnderWay
from tsplan.name_runs import Names, Run, RunMap
from tsplan.plans.bundles import Agents

if TYPE_CHECKING:
    from tsplan.mission import Mission, Rank
    from tsplan.plans.bundles import Bundle
    from tsplan.plans.plan import Plan


def strangers(mission: Mission, plan: Plan) -> Iterator[str]:
    """Agents of the plan that are not the mission's, and those that have no path or several.

    The agents of a swarm have paths all of them or none.
    """
    named = {bundle.class_name for bundle in plan.bundles}
    classes = {group.class_name for group in mission.team}
    pathless = {c for c in classes - named if mission.group_bounds(c) is not None}
    ranks = [rank for rank in mission.ranks if rank.class_name not in pathless]
    roster = RunMap((rank.names, rank) for rank in ranks)
    there: dict[Rank, list[Run]] = defaultdict(list)
    for names, path in Agents.of(plan.agents).stretches:
        for part, rank in roster.parts(names):
            if rank is None:
                yield f"{told(Names((part,)))} is not in the team"
                continue
            there[rank].append(part)
            yield from (
                f"{told(Names((part,)))} {words}" for words in _unlike(path, rank, plan.horizon)
            )
    for mine in there.values():
        mine.sort()
        yield from (f"{told(Names((part,)))} is there twice" for part in _repeated(mine))
    yield from (f"{told(Names((part,)))} has no path" for part in _missing(ranks, there))


def told(names: Sequence[str], common: str = "more") -> str:
    """Agents by the first of them, and how many there are beside it."""
    more = len(names) - 1
    return f"agent {names[0]} (and {more} {common})" if more else f"agent {names[0]}"


def _unlike(path: Bundle, rank: Rank, horizon: int) -> Iterator[str]:
    """What is not so of agents of a rank that take a path."""
    if path.class_name != rank.class_name:
        yield f"is of class {rank.class_name}, not {path.class_name}"
    if path.capabilities != rank.capabilities:
        yield "has other capabilities in the mission"
    if isinstance(rank.start, UnderWay):
        yield from _unlike_arrival(path, rank.start, horizon)
    elif path.coming is not None:
        yield f"starts at {rank.start}, and not on the way from {path.coming}"
    elif path.stays and path.stays[0][2] != rank.start:
        yield f"starts at {rank.start}, not at {path.stays[0][2]}"


def _unlike_arrival(path: Bundle, start: UnderWay, horizon: int) -> Iterator[str]:
    """What is not so of agents that start under way: where they come from, and when they arrive."""
    arrival = f"starts on the way from {start.origin} to {start.target} until step {start.arrives}"
    if path.coming != start.origin:
        yield f"{arrival}, and not on the way from {path.coming or 'anywhere'}"
    elif start.arrives > horizon:
        if path.stays or path.heading != start.target:
            yield f"{arrival}, and the plan has it elsewhere before"
    elif not path.stays or path.stays[0][0] != start.arrives or path.stays[0][2] != start.target:
        first = f"first at {path.stays[0][2]} at step {path.stays[0][0]}" if path.stays else "never"
        yield f"{arrival}, and is {first} by the plan"


def _repeated(runs: Iterable[Run]) -> Iterator[Run]:
    """The names that runs in the order of their numbers have once more."""
    seen: Run | None = None
    for run in runs:
        again = None if seen is None else seen.common(run)
        if again is not None:
            yield again
        if seen is None or run.last > seen.last:
            seen = run


def _missing(ranks: Iterable[Rank], there: Mapping[Rank, Sequence[Run]]) -> Iterator[Run]:
    """The names of ranks that no run has; those of a rank are in the order of their numbers."""
    for rank in ranks:
        names, begin = rank.names, rank.names.first
        for run in there.get(rank, ()):
            if run.first > begin:
                yield names.part(begin - names.first, run.first - names.first)
            begin = max(begin, run.last + 1)
        if begin <= names.last:
            yield names.part(begin - names.first, names.size)
