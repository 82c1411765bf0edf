"""What a map may say but its author probably did not mean."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from itertools import pairwise

from tsplan.errors import Finding, nearest
from tsplan.ts.reachability import reachable
from tsplan.ts.system import TransitionSystem
from tsplan.ts.waits import without_wait

_SHOWN = 5


def lint(
    system: TransitionSystem,
    *,
    used_labels: Collection[str] | None = None,
    starts: Iterable[str] | None = None,
) -> list[Finding]:
    """Warnings about a map; an empty list where nothing looks odd.

    - states that no agent can reach: from `starts` where they are given, else by any move at all;
    - dead ends: states that no edge leaves, not even a wait;
    - states that agents have to leave at once, because nobody can wait there;
    - edges that open between two closed times, but not for as long as they take;
    - one-way traps: groups of states that can be entered but never left again;
    - with `used_labels`, labels that are not among them, and the other way round.
    """
    warnings = [
        *_unreachable(system, starts),
        *_dead_ends(system),
        *_restless(system),
        *_brief(system),
        *_traps(system),
    ]
    if used_labels is not None:
        warnings += _labels(system, used_labels)
    return warnings


def listed(names: Collection[str]) -> str:
    """Names in quotes; of many the first ones, and how many more there are."""
    shown = ", ".join(f"'{name}'" for name in list(names)[:_SHOWN])
    return shown if len(names) <= _SHOWN else f"{shown} and {len(names) - _SHOWN} more"


def _unreachable(system: TransitionSystem, starts: Iterable[str] | None) -> Iterator[Finding]:
    if starts is not None:
        inside = frozenset(reachable(system, starts))
        lost = [name for name in system.states if name not in inside]
        reason = "cannot be reached from where agents start"
    else:
        entered = {edge.target for edge in system.edges.values() if not edge.is_wait}
        lost = [name for name in system.states if name not in entered and len(system.states) > 1]
        reason = "cannot be reached from any other state"
    for name in lost:
        yield Finding(f"the state '{name}' {reason}", "add an edge that leads to it, or drop it")


def _dead_ends(system: TransitionSystem) -> Iterator[Finding]:
    for name in system.states:
        if not system.leaving(name):
            message = f"no edge leaves the state '{name}', not even a wait"
            yield Finding(message, "add a wait there (`waiting: true` adds one to every state)")


def _restless(system: TransitionSystem) -> Iterator[Finding]:
    """States with edges, but none to themselves."""
    names = [name for name in without_wait(system) if system.leaving(name)]
    if names:
        where = listed(names)
        if len(names) == len(system.states) > 1:
            where = "any state"
        message = f"nobody can wait at {where}: agents have to move on at once"
        yield Finding(message, "add `waiting: true`, or an edge from the state to itself")


def _brief(system: TransitionSystem) -> Iterator[Finding]:
    """Edges with gaps between closed spans that nobody can use."""
    for edge in system.edges.values():
        steps = edge.shortest() or 1
        for (_, last), (first, _) in pairwise(edge.closed):
            if first - last - 1 < steps:
                way = f"the edge from '{edge.source}' to '{edge.target}'"
                message = (
                    f"{way} is open at the steps {last + 1} to {first - 1}, too briefly to use"
                )
                yield Finding(message, f"it takes {steps} steps; close it then, or open it longer")


def _traps(system: TransitionSystem) -> Iterator[Finding]:
    """Strongly connected components that are entered and never left."""
    import networkx as nx  # noqa: PLC0415 - slow to import

    parts = nx.condensation(system.graph)
    ends = (
        data["members"]
        for part, data in parts.nodes(data=True)
        if parts.in_degree(part) and not parts.out_degree(part)
    )
    order = {name: index for index, name in enumerate(system.states)}
    groups = [sorted(end, key=lambda name: order[name]) for end in ends]
    for members in sorted(groups, key=lambda group: order[group[0]]):
        if any(system.leaving(name) for name in members):
            message = f"once at {listed(members)}, an agent cannot go anywhere else"
            yield Finding(message, "add an edge that leads back, if that is not meant")


def _labels(system: TransitionSystem, used: Collection[str]) -> Iterator[Finding]:
    for label, states in system.labels.items():
        if label not in used:
            message = f"the label '{label}' of {listed(states)} is not used"
            yield Finding(message, "drop it, or use it in the formula")
    for label in sorted(set(used) - set(system.labels)):
        yield Finding(f"no state carries the label '{label}'", nearest(label, system.labels))
