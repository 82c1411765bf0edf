"""Swarms that never split as single agents.

A swarm that begins at one state and does not split is at one place with all its agents, or on its
way. So it goes as one agent does, and where a formula counts the agents of one swarm they are all
there or none is. The mission of these agents has a small model on a reduced map. It is a relaxation
where anything else than the formula asks for numbers, such as capacities.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.capability_mask import is_counted
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.groups.token_flow import Track, track_of
from tsplan.encode.preparation import on_reduced_maps
from tsplan.logic import Count, Execution, Formula, Known, walk
from tsplan.logic.traversal import fold
from tsplan.milp.model import Floats
from tsplan.milp.target import Target

_SOME = 0.5  # flows of single agents are 0 or 1


def lone(setting: Setting) -> Setting | None:
    """The setting in which every swarm is one agent; None where that would not say enough.

    That is where a swarm begins at several states, where something counts agents of several classes
    together, and where agents may be late, book or have constraints of the user's own.
    """
    swarms = [item for item in setting.classes if item.bounds is not None]
    nodes = list(walk(setting.goal))
    counts = [node for node in nodes if isinstance(node, Count)]
    if (
        setting.delay
        or setting.constraints
        or any(int((item.graph.start > 0).sum()) != 1 for item in swarms)
        or any(isinstance(node, Execution) for node in nodes)
        or any(_several(setting, node) for node in counts)
    ):
        return None

    def alone(node: Formula, below: tuple[Formula, ...]) -> Formula:
        if isinstance(node, Known):
            return Known(node.margin - setting.level)
        return _counted(setting, node) if isinstance(node, Count) else node.over(below)

    classes = tuple(_single(item) for item in setting.classes)
    goal = fold(setting.goal, alone)
    made = replace(setting, goal=goal, classes=classes, plain=None, beside=None, level=0)
    return on_reduced_maps(made)


def _able(setting: Setting, node: Count) -> list[AgentClass]:
    """The classes whose agents a count counts."""
    able = is_counted
    return [item for item in setting.classes if able(node.capability, item.graph.capabilities)]


def _several(setting: Setting, node: Count) -> bool:
    """Whether a count adds agents of a swarm to others."""
    able = _able(setting, node)
    return len(able) > 1 and any(item.bounds is not None for item in able)


def _counted(setting: Setting, node: Count) -> Count:
    """A count with its level, where a swarm is one agent."""
    assert isinstance(node.bound, int)
    upper = node.relation == "<="
    bound = node.bound - setting.level if upper else node.bound + setting.level
    swarms = [item for item in _able(setting, node) if item.bounds is not None]
    if swarms:
        agents = swarms[0].graph.agents
        if upper:
            bound = -1 if bound < 0 else int(bound >= agents)
        else:
            bound = 0 if bound <= 0 else 1 + (bound > agents)
    return replace(node, bound=bound)


def _single(item: AgentClass) -> AgentClass:
    """A swarm as one agent; other classes as they are."""
    if item.bounds is None:
        return item
    return replace(
        item, graph=replace(item.graph, start=np.minimum(item.graph.start, 1)), bounds=None
    )


def priced_as(target: Target, encoded: Encoded, setting: Setting) -> Target:
    """A target over flows of single agents that counts all agents of the swarms they stand for."""
    vector: Floats = target.vector.copy()
    for item, columns in zip(setting.classes, encoded.network.classes, strict=True):
        if item.bounds is not None:
            vector[columns.unrolled()[2]] *= item.graph.agents
    return replace(target, vector=vector)


def tracks(setting: Setting, encoded: Encoded, values: Floats) -> Iterator[Track]:
    """The edges of every swarm's map that its one agent enters, and when."""
    made = zip(setting.classes, encoded.setting.reduced, encoded.network.classes, strict=True)
    for item, reduced, columns in made:
        if item.bounds is not None:
            edge, step, column = columns.unrolled()
            taken = np.flatnonzero(values[column] > _SOME)
            yield track_of(reduced, item.graph, edge[taken], step[taken])
