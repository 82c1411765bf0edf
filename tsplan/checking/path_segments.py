"""What agents do between and during their stays, read against the map."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from tsplan.mission import Group
    from tsplan.plans.agent_plans import Stay
    from tsplan.plans.bundles import Bundle
    from tsplan.ts import Edge, TransitionSystem


class Segment(NamedTuple):
    """Time of some agents on one edge: from step `entered` until `left`, `times` in a row.

    `left` lies beyond the horizon when the agents are still on the edge there.
    """

    edge: Edge
    entered: int
    left: int
    agents: int
    times: int = 1


def together(segments: Iterable[Segment]) -> tuple[Segment, ...]:
    """Segments of many paths, those on one edge at the same time as one."""
    edges: dict[tuple[str, str], Edge] = {}
    counts: Counter[tuple[tuple[str, str], int, int, int]] = Counter()
    for edge, entered, left, agents, times in segments:
        edges[edge.pair] = edge
        counts[edge.pair, entered, left, times] += agents
    return tuple(
        Segment(edges[pair], entered, left, agents, times)
        for (pair, entered, left, times), agents in counts.items()
    )


class Path(NamedTuple):
    """The segments of a path in order, and what is wrong with it (then some may be missing)."""

    segments: tuple[Segment, ...]
    problems: tuple[str, ...]


Travellers: TypeAlias = "Bundle | Group"
"""Agents of one class with the same capabilities."""

Pace: TypeAlias = "Callable[[Edge], int | None]"
"""How many steps each edge takes, None where it cannot be used."""


def read_path(
    system: TransitionSystem,
    bundle: Bundle,
    horizon: int,
    begin: int = 0,
    pace: Pace | None = None,
) -> Path:
    """The segments of a bundle's path, with everything the map does not allow about it.

    It begins at step `begin`; of agents that are `coming` then, when the team says so. With a
    `pace`, that says how many steps each edge takes.
    """
    pace = pace or (lambda edge: edge.duration_for(bundle.class_name))
    if bundle.coming is not None:
        if not bundle.stays:
            return Path((), ())
        begin = bundle.stays[0][0]
    problems = _out_of_order(bundle.stays, horizon, begin)
    if problems:
        return Path((), tuple(problems))
    agents = len(bundle.agents)
    segments: list[Segment] = []
    for place, (first, last, state) in enumerate(bundle.stays):
        problems += unwelcome(system, bundle, state, first)
        rides = [(state, first, 1, last - first)] if last > first else []
        if place + 1 < len(bundle.stays):
            arrival, _, target = bundle.stays[place + 1]
            rides.append((target, last, arrival - last, 1))
        for target, step, spent, times in rides:
            edge = usable_edge(system, bundle, (state, target), step, problems)
            if edge is None:
                continue
            if pace(edge) != spent:
                problems.append(
                    f"takes the edge from {state} to {target} at step {step} in {spent} steps "
                    f"instead of {pace(edge)}"
                )
            segments.append(Segment(edge, step, step + spent * times, agents, times))
    segments += _unfinished(system, bundle, horizon, pace, problems)
    return Path(tuple(segments), tuple(dict.fromkeys(problems)))


def _out_of_order(stays: Sequence[Stay], horizon: int, begin: int) -> list[str]:
    if not stays:
        return ["has no stays: the agent is lost"]
    problems = []
    if stays[0][0] != begin:
        problems.append(f"is first seen at step {stays[0][0]} instead of {begin}")
    before = -1
    for first, last, state in stays:
        if last < first:
            problems.append(f"leaves {state} at step {last}, before it comes at step {first}")
        if first <= before:
            problems.append(f"is at {state} from step {first} on and elsewhere until step {before}")
        before = max(before, last)
    if before > horizon:
        problems.append(f"stays until step {before}, beyond the horizon {horizon}")
    return problems


def unwelcome(system: TransitionSystem, who: Travellers, state: str, step: int) -> list[str]:
    """Whether the map has a state and lets somebody be there; what is wrong in words."""
    if state not in system.states:
        return [f"is at '{state}' at step {step}, which the map does not have"]
    missing = sorted(system.states[state].needs - who.capabilities)
    return [f"is at {state} at step {step}, which needs {', '.join(missing)}"] if missing else []


def usable_edge(
    system: TransitionSystem,
    who: Travellers,
    ends: tuple[str, str],
    step: int,
    problems: list[str],
) -> Edge | None:
    """The edge between two states if somebody may use it; what is wrong goes to `problems`."""
    edge = system.edges.get(ends)
    how = f"waits at {ends[0]}" if ends[0] == ends[1] else f"goes from {ends[0]} to {ends[1]}"
    if edge is None:
        problems.append(f"{how} at step {step}, and the map has no such edge")
        return None
    missing = sorted(edge.needs - who.capabilities)
    if missing:
        problems.append(f"{how} at step {step} by an edge that needs {', '.join(missing)}")
    if edge.duration_for(who.class_name) is None:
        problems.append(f"{how} at step {step} by an edge that class {who.class_name} lacks")
        return None
    return edge


def _unfinished(
    system: TransitionSystem, bundle: Bundle, horizon: int, pace: Pace, problems: list[str]
) -> list[Segment]:
    """The segment an agent is on at the horizon, if its last stay ends before it."""
    _, last, state = bundle.stays[-1]
    if last == horizon:
        if bundle.heading is not None:
            problems.append(f"is at {state} at the horizon and also heads for {bundle.heading}")
        return []
    agents = len(bundle.agents)
    if bundle.heading is not None:
        edge = usable_edge(system, bundle, (state, bundle.heading), last, problems)
        if edge is None:
            return []
        arrival = last + (pace(edge) or 0)
        if arrival <= horizon:
            what = f"left {state} for {bundle.heading} at step {last}"
            problems.append(f"{what} and does not arrive at step {arrival}")
        return [Segment(edge, last, arrival, agents)]
    options = [
        Segment(edge, last, last + duration, agents)
        for edge in system.leaving(state)
        if edge.needs <= bundle.capabilities
        and (duration := pace(edge)) is not None
        and last + duration > horizon
    ]
    if len(options) != 1:
        what = "no edge is long enough" if not options else "several edges are possible"
        problems.append(f"is nowhere after step {last}: {what} and the plan names no heading")
        return []
    return options
