"""Plans of robots that were kept from going on as planned, and follow as soon as they can."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.history.joined_plan import planned_ahead, unjudged
from tsplan.history.joined_structures import modules_along
from tsplan.history.past_paths import pace_of
from tsplan.name_runs import Run, RunMap
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.outcomes import ObjectiveValue
from tsplan.replanning.followed_path import Beginning, Followed, Follower
from tsplan.replanning.followed_structures import followed_structures

if TYPE_CHECKING:
    from tsplan.history.rest_mission import Rest
    from tsplan.mission import Mission, Rank
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
        if mission.team[rank.group].configuration is None
        for part, path in own.parts(rank.names)
    ]
    bodies = followed_structures(mission, ahead)
    leaving = RunMap(
        [
            *((part, way.leaves) for part, way in followed),
            *((Run.of(name), leaves) for name, leaves in bodies.leaves.items()),
        ]
    )
    modules = modules_along(mission.agents, bodies.structures) if bodies.structures else ()
    return replace(
        unjudged(plan),
        horizon=mission.horizon,
        objective=tuple(ObjectiveValue(name, None) for name in mission.objective),
        agents=Agents.along([*((part, way.path) for part, way in followed), *modules]),
        structures=bodies.structures,
        rebuilt=bodies.rebuilt,
        executions=ahead.executions,
        cargo=CargoRows.joined(
            row._replace(names=part, step=leaves[row.step])
            for row in CargoRows.of(ahead.cargo).order
            for part, leaves in leaving.parts(row.names)
            if leaves is not None and row.step in leaves
        ),
        replanned=(),
    )


def _followed(mission: Mission, rank: Rank, path: Bundle | None) -> Followed:
    """What a robot of a rank does that was to take a path."""
    kind = Bundle(rank.class_name, rank.capabilities, (), None)
    follower = Follower(mission.system, mission.horizon)
    return follower.follow(kind, path, Beginning.of(rank.start), pace_of(kind))
