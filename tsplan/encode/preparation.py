"""From a mission to what every encoding starts from: classes of agents on maps of their own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.agent_classes import AgentClass, agent_classes, arrays_of
from tsplan.encode.capability_mask import is_counted
from tsplan.encode.class_graph import ClassGraph, Modes
from tsplan.encode.count_atoms import watched_states
from tsplan.encode.encoded import Setting
from tsplan.encode.enforced_capacities import Enforced
from tsplan.encode.expressions import Constraint
from tsplan.encode.late_modes import with_modes, with_standing
from tsplan.encode.map_reduction import Interest, Reduced, reduce, whole
from tsplan.encode.model_objectives import objectives_of
from tsplan.encode.own_constraints import edges_of, occupations_of, states_of
from tsplan.encode.quantities import FlowTerm
from tsplan.encode.structure_flows import Change, structure_classes
from tsplan.encode.switches import ALL_SWITCHES, Switch
from tsplan.logic import Execution, Formula, capabilities, positive, simplify, walk
from tsplan.milp.model import Bools, Floats
from tsplan.mission import Mission


def prepare(
    mission: Mission,
    constraints: Sequence[Constraint] = (),
    switches: frozenset[Switch] = ALL_SWITCHES,
    goal: Formula | None = None,
    *,
    clock: Clock | None = None,
    enforced: Enforced | None = None,
) -> Setting:
    """Sort the team into classes and reduce their graphs.

    `goal` is a positive formula in place of the mission's own goal; of the map's capacities only
    those `enforced` are kept, if that is given. Raises Halted when the clock is over before that is
    done.
    """
    plain = None
    if goal is None and mission.headroom is not None:
        plain = simplify(positive(mission.counted))
    goal = mission.goal if goal is None else goal
    classes, changes = _classes(mission, goal, constraints)
    arrays = arrays_of(mission.system, mission.team)
    if enforced is not None:
        classes, arrays = enforced.on(classes, arrays)
    setting = Setting(
        mission=mission,
        goal=goal,
        horizon=mission.horizon,
        classes=classes,
        reduced=tuple(whole(item.graph) for item in classes),
        arrays=arrays,
        delay=mission.delay,
        changes=changes,
        constraints=tuple(constraints),
        slack=np.inf if enforced is None else enforced.slack,
        switches=switches,
        clock=clock or Clock(),
        plain=plain,
    )
    setting = _on_late_maps(setting) if setting.delay else setting
    return on_reduced_maps(setting)


def delayed(setting: Setting, delay: int) -> Setting:
    """The setting of plans that hold though agents are so many steps late."""
    mission = replace(setting.mission, delay=delay)
    where = setting.constraints, setting.switches
    made = prepare(mission, *where, clock=setting.clock)
    return replace(made, mission=setting.mission, delay=made.delay)


def _on_late_maps(setting: Setting) -> Setting:
    """The setting on maps that tell how long agents have been where the goal counts them."""
    classes = []
    for item in setting.classes:
        able = item.graph.capabilities
        watched = watched_states(setting.goal, able, setting.mission.system, setting.arrays)
        if item.bounds is None:
            graph = with_modes(item.graph, *watched, setting.delay)
        else:
            graph = with_standing(item.graph, watched[0], setting.delay)
        classes.append(replace(item, graph=graph))
    reduced = tuple(whole(item.graph) for item in classes)
    return replace(setting, classes=tuple(classes), reduced=reduced)


def _classes(
    mission: Mission, goal: Formula, constraints: Sequence[Constraint]
) -> tuple[tuple[AgentClass, ...], tuple[Change, ...]]:
    """The classes that the problem tells apart, and how structures of modules become others."""
    asked = {*capabilities(goal), *(term.capability for term in occupations_of(constraints))}
    named = {name for name in asked if name is not None}
    priced = any(objective.priced for objective in objectives_of(mission))
    carrying = any(isinstance(node, Execution) for node in walk(goal))
    robots = agent_classes(
        mission.system,
        mission.team,
        named,
        bounds={} if mission.swarm is None else mission.swarm.each,
        unit=mission.cost_unit if priced else None,
        carrying=carrying,
        apart=mission.expected is not None and mission.expected.deterministic,
    )
    structures, changes = structure_classes(
        mission, named, len(robots), priced=priced, carrying=carrying
    )
    return (*robots, *structures), changes


def on_reduced_maps(setting: Setting) -> Setting:
    """The setting on reduced maps, or on whole ones where these would not be exact."""
    every = tuple(whole(item.graph) for item in setting.classes)
    setting = replace(setting, reduced=every, monotone=False)
    # quickest ways say nothing of uncertain moves
    if Switch.REDUCTION not in setting.switches or setting.mission.expected is not None:
        return setting
    if not all(objective.reducible(setting) for objective in objectives_of(setting.mission)):
        return setting
    interests = [_tolled(setting, item.graph) for item in setting.classes]
    if any(len(interest.tolls) > 1 for interest in interests):
        return setting  # ways may be quick, cheap or safe
    limited = any(matters.limited.any() or matters.narrow.any() for matters in interests)
    timed = any(item.graph.timed.any() for item in setting.classes)
    single = timed or any(each.watched.any() for each in interests)
    if setting.delay and (setting.arrays.group_capacity or single):
        return setting
    reduced: list[Reduced] = []
    for item, matters in zip(setting.classes, interests, strict=True):
        # where groups split and merge, and where cargo is handed over, is seen on the whole map
        if item.bounds is not None or item.graph.carries != ():
            reduced.append(whole(item.graph))
            continue
        short = reduce(item.graph, matters, setting.horizon, setting.clock)
        if short is None:
            return setting
        reduced.append(short)
    monotone = not limited and not setting.arrays.group_capacity and not timed
    return replace(setting, reduced=tuple(reduced), monotone=monotone)


def _tolled(setting: Setting, graph: ClassGraph) -> Interest:
    """Which states matter to a class, and what edges cost where quick ways may be worse."""
    tolls: list[Floats] = []
    for objective in objectives_of(setting.mission):
        toll = objective.toll(graph)
        if toll is not None and not any(np.array_equal(toll, other) for other in tolls):
            tolls.append(toll)
    return replace(interest(setting, graph), tolls=tuple(tolls))


def interest(setting: Setting, graph: ClassGraph, *, rebuilt: bool = True) -> Interest:
    """Which states the problem counts agents of a class at, and which it limits.

    With `rebuilt` those matter, too, where structures can be.
    """
    system, arrays, ability = setting.mission.system, setting.arrays, graph.capabilities
    wanted, limited = watched_states(setting.goal, ability, system, arrays)
    narrow, watched = np.zeros_like(limited), np.zeros(len(graph.tail), dtype=np.bool_)
    narrow[[state for state, _ in arrays.capacity]] = True
    for states in arrays.zone_states.values():
        narrow[states] = True
    for term in occupations_of(setting.constraints):
        if is_counted(term.capability, ability):
            if isinstance(term, FlowTerm):
                watched |= edges_of(term, arrays, graph)
            else:
                limited[states_of(term, system, arrays)] = True
    place = np.arange(len(graph.start)) if graph.modes is None else graph.modes.place
    limited[place[graph.tail[watched]]] = True  # who is there, and leaves by this edge, is told
    if graph.layer is not None and rebuilt:
        wanted[[change.state for change in setting.changes]] = True
    if graph.modes is None:
        relevant = np.logical_or(wanted, limited)
        return Interest(relevant, limited, narrow, watched, slack=setting.slack)
    late = _late_interest(graph, graph.modes, wanted, limited | narrow)
    return replace(late, watched=watched)


def _late_interest(graph: ClassGraph, modes: Modes, wanted: Bools, limited: Bools) -> Interest:
    """The nodes that matter where agents may be late.

    Who has left a limited state may wait next to it, where waiting may lead from node to node; and
    while it is told what an agent left, every edge is kept.
    """
    limited = limited[modes.place]
    relevant = np.append(wanted, np.zeros(len(limited) - len(wanted), dtype=np.bool_)) | limited
    relevant[graph.head[limited[graph.tail] | modes.recent[graph.tail]]] = True
    stays = graph.still & (graph.duration == 1)
    for _ in range(modes.delay):
        relevant[graph.head[stays & relevant[graph.tail]]] = True
    return Interest(relevant, limited, np.zeros_like(limited), np.zeros(0, dtype=np.bool_))
