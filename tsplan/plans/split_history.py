"""What becomes of a plan's sub-swarms, in words: where they begin, split, merge and end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from tsplan.plans.moves import leaving

if TYPE_CHECKING:
    from tsplan.plans.moves import Move, Node
    from tsplan.plans.plan import Plan
    from tsplan.plans.subswarms import SubSwarm


class Event(NamedTuple):
    """Something that happens at a step; `kind` orders what happens at the same one."""

    step: int
    kind: int
    words: str


_BEGIN, _MERGE, _SPLIT, _END = range(4)


def timeline(plan: Plan) -> list[str]:
    r"""One line for the start, every merge, every split and the end, in the order of the steps.

    >>> from tsplan.plans.moves import Move
    >>> from tsplan.plans.subswarms import SubSwarm
    >>> from tsplan.plans.outcomes import MissionRef
    >>> from tsplan.plans.plan import Plan
    >>> moves = (Move(0, "p", "p", 2), Move(0, "p", "q", 3))
    >>> groups = (SubSwarm("s:1", "s", 0, 0, 5, "p"), SubSwarm("s:2", "s", 1, 1, 2, "p"),
    ...           SubSwarm("s:3", "s", 1, 1, 3, "q"))
    >>> plan = Plan("optimal", MissionRef("", ""), 1, moves={"s": moves}, groups=groups)
    >>> print("\n".join(timeline(plan)))
    step 0: 5 at p
    step 0: 5 at p split: 3 to q, 2 wait
    step 1: 2 at p, 3 at q
    """
    several = len(plan.moves) > 1
    events = [
        Event(step, kind, _listed(plan.groups_at(step), several=several))
        for step, kind in ((0, _BEGIN), (plan.horizon, _END))
    ]
    for swarm, moves in plan.moves.items():
        who = f" {swarm}" if several else ""
        groups = [group for group in plan.groups if group.swarm == swarm]
        events += _merges(_arrivals(moves, groups, plan.horizon), who)
        events += _splits(leaving(moves), who)
    lines = (f"step {item.step}: {item.words}" for item in sorted(events))
    return list(dict.fromkeys(lines))  # start and end may be one


def _listed(groups: tuple[SubSwarm, ...], *, several: bool) -> str:
    """Sub-swarms of one step: how many agents are where."""
    return ", ".join(
        f"{group.size:,}{f' {group.swarm}' if several else ''} {group.place}" for group in groups
    )


def _splits(gone: dict[Node, tuple[Move, ...]], who: str) -> Iterator[Event]:
    for (state, step), moves in gone.items():
        if len(moves) > 1:
            parts = sorted(moves, key=lambda move: (move.is_wait, -move.count, move.target))
            shown = ", ".join(
                f"{move.count:,} " + ("wait" if move.is_wait else f"to {move.target}")
                for move in parts
            )
            total = sum(move.count for move in moves)
            yield Event(step, _SPLIT, f"{total:,}{who} at {state} split: {shown}")


def _merges(came: dict[Node, list[Move]], who: str) -> Iterator[Event]:
    for (state, step), moves in came.items():
        if len(moves) > 1:
            counts = sorted((move.count for move in moves), reverse=True)
            shown = " + ".join(f"{count:,}" for count in counts)
            yield Event(step, _MERGE, f"{shown}{who} merge at {state}")


def _arrivals(
    moves: tuple[Move, ...], groups: list[SubSwarm], horizon: int
) -> dict[Node, list[Move]]:
    """The moves by where they arrive up to the horizon: a sub-swarm on an edge says until when."""
    until = {(*group.edge, group.first - 1): group.last for group in groups if group.edge}
    arrivals: dict[Node, list[Move]] = {}
    for move in moves:
        last = until.get((move.source, move.target, move.step), move.step)
        if last < horizon:  # what is on an edge at the last step arrives later
            arrivals.setdefault((move.target, last + 1), []).append(move)
    return arrivals
