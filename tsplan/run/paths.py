"""From a point of a model to what a plan says of everybody: moves of swarms, paths of agents."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain
from typing import TypedDict

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.policy_reading import policies_of
from tsplan.encode.read_back import (
    carried_at,
    executions_of,
    listed,
    modules_at,
    moves_of,
    node_names,
)
from tsplan.mission import Rank
from tsplan.name_runs import Run, RunMap
from tsplan.plans.agent_entries import MOST_LISTED
from tsplan.plans.agent_plans import joined
from tsplan.plans.bundles import Agents, Bundle, Stretch
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.decomposition import Walked, decompose, paths_of
from tsplan.plans.loading import loading
from tsplan.plans.moves import Move
from tsplan.plans.policies import Policy
from tsplan.plans.structure_paths import module_plan, structures_of
from tsplan.plans.structures import Rebuilt, Structure, module_paths
from tsplan.plans.supplies import ExecutedTask
from tsplan.run.kept_paths import kept_paths

MOST_AGENTS = MOST_LISTED
"""Agents up to which every one of a swarm gets a path; for more, `tsplan.assign` makes them."""


class Ways(TypedDict, total=False):
    """Where everybody goes, and how late that may be, as fields of a plan."""

    agents: Agents
    moves: dict[str, tuple[Move, ...]]
    executions: tuple[ExecutedTask, ...]
    structures: tuple[Structure, ...]
    rebuilt: tuple[Rebuilt, ...]
    cargo: CargoRows
    policies: tuple[Policy, ...]
    delay: int | None


def _promised(setting: Setting, point: Point) -> int | None:
    """How late agents may be, where the mission says anything of that."""
    mission = setting.mission
    if not mission.delay and "delay" not in mission.objective:
        return None
    return point.encoded.setting.delay


def _by_nodes(
    setting: Setting,
    item: AgentClass,
    ranks: Sequence[Rank],
    moves: Sequence[Move],
    seed: int | None,
) -> Walked:
    """The paths of a class whose map has modes, so that its agents count as its flow does."""
    graph, names = item.graph, node_names(setting, item)
    assert graph.modes is not None
    ends = (graph.tail.tolist(), graph.head.tolist(), graph.duration.tolist())
    durations = {(names[tail], names[head]): d for tail, head, d in zip(*ends, strict=True)}
    states = (setting.arrays.names[place] for place in graph.modes.place.tolist())
    state = dict(zip(names, states, strict=True))

    def on_the_map(path: Bundle) -> Bundle:
        stays = tuple(joined((*span, state[node]) for *span, node in path.stays))
        return replace(path, stays=stays, heading=path.heading and state[path.heading])

    made = decompose(ranks, moves, durations, setting.horizon, seed)
    return tuple(
        tuple(Stretch(each.names, on_the_map(each.path)) for each in stretches)
        for stretches in made
    )


def _walked(
    setting: Setting,
    item: AgentClass,
    moves: Sequence[Move],
    seed: int | None,
    known: Iterable[Run] = (),
) -> Iterator[tuple[Rank, Sequence[Stretch]]]:
    """The robots of a class rank by rank, with their paths, but for those whose are `known`."""
    given = RunMap((names, True) for names in known)
    parts = [
        (rank, rank._replace(names=part))
        for rank in setting.mission.ranks
        if rank.group in item.groups
        for part, has in given.parts(rank.names)
        if not has
    ]
    ranks = [part for _, part in parts]
    if not ranks:
        return
    if item.graph.modes is None or item.bounds is not None:
        late = item.graph.modes is not None
        walked = paths_of(setting.mission, ranks, moves, seed, late=late)
    else:
        walked = _by_nodes(setting, item, ranks, moves, seed)
    for (rank, _), stretches in zip(parts, walked, strict=True):
        yield rank, stretches


def ways_of(setting: Setting, point: Point, seed: int | None) -> Ways:
    """The moves of every swarm, and one path per agent in the order of the team; or policies.

    Those of swarms are left out where there are more than `MOST_AGENTS` agents in all.
    """
    mission = setting.mission
    if mission.expected is not None:
        return Ways(policies=tuple(policies_of(setting, point)))
    walked: dict[Rank, list[Stretch]] = defaultdict(list)
    moves: dict[str, tuple[Move, ...]] = {}
    for item, entered in moves_of(point):
        if item.shape is not None:
            continue
        kept, others = kept_paths(setting, point, item, entered)
        for rank, stretch in kept:
            walked[rank].append(stretch)
        made = listed(setting, item, others)
        if item.bounds is not None:
            begun = {start.place for start in setting.arrays.coming}
            own = tuple(move for move in made if move.source not in begun)
            moves[mission.team[item.groups[0]].class_name] = own
            if mission.size > MOST_AGENTS:
                continue
        known = [stretch.names for _, stretch in kept]
        for rank, stretches in _walked(setting, item, made, seed, known):
            walked[rank] = sorted([*walked[rank], *stretches], key=lambda each: each.names)
    structures, rebuilt = structures_of(mission, modules_at(setting, point))
    modules = module_paths(structures)
    for rank in mission.ranks if structures else ():
        if mission.team[rank.group].configuration:
            walked[rank] = [
                Stretch(Run.of(agent.id), module_plan(agent, modules[agent.id]))
                for agent in rank.agents
            ]
    paths = Agents.along(chain.from_iterable(walked.get(rank, ()) for rank in mission.ranks))
    names = setting.arrays.names
    done = [(step, names[state], task.task) for task, state, step in executions_of(point)]
    return Ways(
        moves=moves,
        agents=paths,
        executions=tuple(ExecutedTask(task, state, step) for step, state, task in sorted(done)),
        structures=structures,
        rebuilt=rebuilt,
        delay=_promised(setting, point),
        cargo=loading(mission, paths, structures, carried_at(setting, point)),
    )
