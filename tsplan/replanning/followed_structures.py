"""Structures of modules that follow a plan as soon as they can, and become others when all are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from operator import attrgetter
from typing import TYPE_CHECKING

from tsplan.history.past_structures import path_of, structure_pace
from tsplan.replanning.followed_path import Beginning, Followed, Follower

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan
    from tsplan.plans.structures import Rebuilt, Structure


@dataclass(frozen=True)
class FollowedStructures:
    """What `structures` do and what is `rebuilt`; `leaves` has by which steps they leave."""

    structures: tuple[Structure, ...]
    rebuilt: tuple[Rebuilt, ...]
    leaves: Mapping[str, Mapping[int, int]]


def followed_structures(mission: Mission, plan: Plan) -> FollowedStructures:
    """The structures of a plan as soon as they can, from where modules of a mission begin.

    A reconfiguration waits for all its parts. Where one of them does not come the others stay.
    """
    following = _Following(mission, {each.id: each for each in plan.structures})
    for each in plan.structures:
        if not each.first:
            rank = mission.roster.get(each.modules[0])
            assert rank is not None
            following.follow(each, Beginning.of(rank.start))
    for rebuilt in sorted(plan.rebuilt, key=attrgetter("step")):
        following.rebuild(rebuilt)
    return following.told()


@dataclass(eq=False)
class _Following:
    mission: Mission
    planned: Mapping[str, Structure]
    _ways: dict[str, Followed] = field(default_factory=dict, init=False)
    _bodies: dict[str, Structure] = field(default_factory=dict, init=False)
    _rebuilt: list[Rebuilt] = field(default_factory=list, init=False)

    def follow(self, each: Structure, begin: Beginning, first: int = 0) -> None:
        """Let a structure go its way, from its first step on."""
        mission = self.mission
        follower, way = Follower(mission.system, mission.horizon), path_of(each)
        made = follower.follow(way, way, begin, structure_pace(mission, each))
        self._ways[each.id] = made
        self._bodies[each.id] = replace(
            each,
            first=first,
            last=mission.horizon,
            stays=made.path.stays,
            heading=made.path.heading,
            coming=made.path.coming,
        )

    def rebuild(self, rebuilt: Rebuilt) -> None:
        """Begin a reconfiguration when all its parts are there."""
        arrived = [
            way.arrived if (way := self._ways.get(name)) is not None else None
            for name in rebuilt.parts
        ]
        there = [step for step in arrived if step is not None]
        begin = max([rebuilt.step, *there])
        if len(there) < len(arrived) or begin >= self.mission.horizon:
            return
        for name in rebuilt.parts:
            body = self._bodies[name]
            first, _, state = body.stays[-1]
            stays = (*body.stays[:-1], (first, begin, state))
            self._bodies[name] = replace(body, stays=stays, last=begin)
        done = begin + self.mission.modular.reconfigurations[rebuilt.rule].duration
        made = rebuilt.made if done <= self.mission.horizon else ()
        for name in made:
            self.follow(self.planned[name], Beginning(rebuilt.state, done), done)
        self._rebuilt.append(replace(rebuilt, step=begin, made=made))

    def told(self) -> FollowedStructures:
        """All of them, in the order in which they come to be."""
        order = sorted(self._bodies.values(), key=attrgetter("first"))
        leaves = {name: way.leaves for name, way in self._ways.items()}
        return FollowedStructures(tuple(order), tuple(self._rebuilt), leaves)
