"""A way that somebody follows as soon as it can, who was kept from going as planned."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from tsplan.mission.team import UnderWay

if TYPE_CHECKING:
    from tsplan.plans.agent_plans import Stay
    from tsplan.plans.bundles import Bundle
    from tsplan.ts import Edge, TransitionSystem


class Beginning(NamedTuple):
    """Where somebody is first and from which step on, and where it comes from, if from an edge."""

    state: str
    step: int = 0
    coming: str | None = None

    @classmethod
    def of(cls, start: str | UnderWay) -> Beginning:
        """That of a start in a mission."""
        if isinstance(start, UnderWay):
            return cls(start.target, start.arrives, start.origin)
        return cls(start)


class Followed(NamedTuple):
    """A path that follows another one; it leaves by the steps at which it was to.

    `arrived` is the step at which it comes to the last state of the way; None where it does not.
    """

    path: Bundle
    leaves: Mapping[int, int]
    arrived: int | None = None


class Follower(NamedTuple):
    """Follows ways on a map up to a horizon."""

    system: TransitionSystem
    horizon: int

    def follow(
        self, kind: Bundle, way: Bundle | None, begin: Beginning, pace: Callable[[Edge], int | None]
    ) -> Followed:
        """The path of somebody of a kind who begins somewhere and has a way to follow.

        It joins that where it first comes by, and stays where it cannot go on.
        """
        where, step, coming = begin
        made = replace(kind, coming=coming, heading=None)
        if step > self.horizon:
            return Followed(replace(made, stays=(), heading=where), {})
        ahead = () if way is None else way.stays
        joins = next((n for n, stay in enumerate(ahead) if stay[2] == where), len(ahead))
        heading = way.heading if way is not None and joins < len(ahead) else None
        stays: list[Stay] = []
        leaves: dict[int, int] = {}
        for target, planned in _rides(ahead[joins:], heading):
            leave = max(planned, step)  # nobody leaves before it has come
            edge = self.system.edges.get((where, target))
            lasts = None if edge is None else pace(edge)
            if lasts is None or leave >= self.horizon:
                joins = len(ahead)
                break
            stays.append((step, leave, where))
            leaves[planned] = leave
            where, step = target, leave + lasts
            if step > self.horizon:
                return Followed(replace(made, stays=tuple(stays), heading=where), leaves)
        stays.append((step, self.horizon, where))
        arrived = step if joins < len(ahead) else None
        return Followed(replace(made, stays=tuple(stays)), leaves, arrived)


def _rides(stays: tuple[Stay, ...], heading: str | None) -> Iterator[tuple[str, int]]:
    """Where a path goes, and when it leaves for there."""
    for before, after in pairwise(stays):
        yield after[2], before[1]
    if heading is not None and stays:
        yield heading, stays[-1][1]
