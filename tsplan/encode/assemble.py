"""From a problem to a model: the tight and the reference encoding behind one result."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from tsplan.encode import objectives
from tsplan.encode.agent_classes import AgentClass, MapArrays, agent_classes, map_arrays
from tsplan.encode.capacities import capacity_rows
from tsplan.encode.count_atoms import Requirement, requirement
from tsplan.encode.demand_rows import SiteColumns, Staffing
from tsplan.encode.demand_runs import Family
from tsplan.encode.expressions import Constraint
from tsplan.encode.flow_network import Network, unroll
from tsplan.encode.map_reduction import Interest, Reduced, reduce, whole
from tsplan.encode.memory import Watch
from tsplan.encode.options import ALL_IDEAS, Idea
from tsplan.encode.own_constraints import constraint_rows, states_of, terms_of
from tsplan.encode.precedence import legs_of, route_rows
from tsplan.encode.reference import ReferenceEncoder
from tsplan.encode.robustness_bound import Outlook
from tsplan.encode.witness import Ways, WitnessEncoder, Witnesses
from tsplan.logic import Count, Formula, capabilities, walk
from tsplan.milp.model import Draft, Ints, Model
from tsplan.mission import Mission
from tsplan.search.clock import Clock


@dataclass(frozen=True, eq=False)
class Setting:
    """What both encodings start from; the classes' graphs are reduced where that is exact."""

    mission: Mission
    goal: Formula  # positive normal form of counting atoms
    horizon: int
    classes: tuple[AgentClass, ...]
    reduced: tuple[Reduced, ...]
    arrays: MapArrays
    constraints: tuple[Constraint, ...] = ()
    ideas: frozenset[Idea] = ALL_IDEAS
    monotone: bool = False  # nothing bounds a count from above
    clock: Clock = field(default_factory=Clock)  # heard while models are made

    def requirement(self, level: int) -> Callable[[Count], Requirement]:
        """How atoms are read when availability `level` is asked for."""
        return lambda atom: requirement(atom, self.mission.system, self.arrays, level)


@dataclass(frozen=True, eq=False)
class Encoded:
    """A model and what its columns mean.

    `indicators` are the 0/1 columns of the logic and `steps` when what they stand for begins (tight
    encoding only); `groups` are those of them of which at most one is 1, in the order of their
    steps. `shared` says that some eventuality lies under an always,
    `level` which availability was asked for. `rho` is the availability's column in the reference
    encoding.
    """

    model: Model
    network: Network
    indicators: Ints
    flows: Ints
    stayers: Ints
    rho: int = -1
    refuted: bool = False
    shared: bool = False
    level: int = 0
    steps: Ints = field(default_factory=lambda: np.empty(0, dtype=np.int64))
    groups: tuple[Ints, ...] = ()
    families: tuple[tuple[SiteColumns, Family], ...] = field(default=())


def prepare(
    mission: Mission,
    constraints: Sequence[Constraint] = (),
    ideas: frozenset[Idea] = ALL_IDEAS,
    goal: Formula | None = None,
    *,
    clock: Clock | None = None,
) -> Setting:
    """Sort the team into classes and reduce their graphs.

    `goal` is a positive formula in place of the mission's own goal. Raises Halted when the clock is
    over before that is done.
    """
    clock = clock or Clock()
    system = mission.system
    arrays = map_arrays(system)
    goal = mission.goal if goal is None else goal
    named = {*capabilities(goal), *(term.capability for term in terms_of(constraints))}
    classes = agent_classes(
        system,
        mission.team,
        {name for name in named if name is not None},
        priced="cost" in mission.objective,
    )
    interests = [
        _interest(mission, goal, item.graph.capabilities, arrays, constraints) for item in classes
    ]
    reduced = None
    if Idea.REDUCTION in ideas and _paid_by_duration(mission, classes):
        reduced = _reduced(classes, interests, mission.horizon, clock)
    return Setting(
        mission=mission,
        goal=goal,
        horizon=mission.horizon,
        classes=classes,
        reduced=reduced or tuple(whole(item.graph) for item in classes),
        arrays=arrays,
        constraints=tuple(constraints),
        ideas=ideas,
        clock=clock,
        monotone=reduced is not None
        and not any(interest.limited.any() for interest in interests)
        and not arrays.group_capacity,
    )


def _reduced(
    classes: Sequence[AgentClass], interests: Sequence[Interest], horizon: int, clock: Clock
) -> tuple[Reduced, ...] | None:
    """Reductions of all classes, or None where that of one would not be exact."""
    found = []
    for item, interest in zip(classes, interests, strict=True):
        reduction = reduce(item.graph, interest, horizon, clock)
        if reduction is None:
            return None
        found.append(reduction)
    return tuple(found)


def _paid_by_duration(mission: Mission, classes: Sequence[AgentClass]) -> bool:
    if "cost" not in mission.objective:
        return True
    unit = mission.system.cost_unit
    return all(
        np.array_equal(
            item.graph.cost * unit.numerator,
            np.where(item.graph.wait, 0, item.graph.duration) * unit.denominator,
        )
        for item in classes
    )


def _interest(
    mission: Mission,
    goal: Formula,
    able: frozenset[str],
    arrays: MapArrays,
    constraints: Sequence[Constraint],
) -> Interest:
    """Which states the problem counts agents with these capabilities at, and which it limits."""
    relevant = np.zeros(len(arrays.names), dtype=np.bool_)
    limited = np.zeros(len(arrays.names), dtype=np.bool_)
    for node in walk(goal):
        if isinstance(node, Count) and (node.capability is None or node.capability in able):
            states = arrays.states_with(mission.system, node.label)
            relevant[states] = True
            limited[states] |= node.relation == "<="
    for state, _ in arrays.capacity:
        relevant[state] = limited[state] = True
    for term in terms_of(constraints):
        if term.capability is None or term.capability in able:
            states = states_of(term, mission.system, arrays)
            relevant[states] = limited[states] = True
    return Interest(relevant, limited)


def tight(setting: Setting, level: int = 0, *, chain: bool = False) -> Encoded:
    """The tight model of plans with availability at least `level`.

    With `chain` eventualities under an always get as few witnesses as possible: a restriction,
    whose flow columns are the same, for finding a first plan.
    """
    ways = Ways(chain=chain, visits=Idea.VISITS in setting.ideas)
    return assembled(setting, lambda encoder, *_: encoder.encode(setting.goal), level, ways)


_WAYS = Ways()

Asking = Callable[[WitnessEncoder, Draft, Network], Witnesses]
"""Asks an encoder for what is to hold; it may add columns and rows of its own to the draft."""


def assembled(setting: Setting, ask: Asking, level: int = 0, ways: Ways = _WAYS) -> Encoded:
    """The tight model of what `ask` requires; its formulas are parts of the setting's goal."""
    draft = Draft(Watch(setting.clock))
    graphs = [item.graph for item in setting.reduced]
    finish = [~graph.wait for graph in graphs] if setting.monotone else None
    network = unroll(graphs, setting.horizon, draft, finish=finish)
    flows = np.arange(draft.column_count)
    capacity_rows(network, setting.arrays, draft)
    constraint_rows(setting.constraints, setting.mission.system, setting.arrays, network, draft)
    read = setting.requirement(level)
    outlook = Outlook(setting.goal, network, read, trusting=Idea.OUTLOOK not in setting.ideas)
    ways = replace(ways, share=Idea.SHARING in setting.ideas)
    encoder = WitnessEncoder(draft, outlook, read, ways)
    witnesses = ask(encoder, draft, network)
    if Idea.TOGETHER in setting.ideas:
        legs = legs_of(witnesses, network)
        if "travel" in setting.mission.objective:
            route_rows(legs, network, draft)
    joint, lazy = Idea.FAMILIES in setting.ideas, Idea.LAZY in setting.ideas
    staffing = Staffing(network, draft, joint=joint, lazy=lazy)
    staffing.write(
        witnesses, cuts=Idea.VISITS in setting.ideas, together=Idea.TOGETHER in setting.ideas
    )
    stay = _stayers(setting, network, draft)
    return Encoded(
        model=draft.build(),
        network=network,
        indicators=np.array(witnesses.choices.columns, dtype=np.int64),
        flows=flows,
        stayers=stay,
        refuted=witnesses.choices.refuted,
        steps=np.array(witnesses.choices.steps, dtype=np.int64),
        groups=tuple(witnesses.choices.groups),
        shared=bool(witnesses.covers),
        families=tuple(staffing.families),
    )


def reference(setting: Setting, levels: tuple[int, int]) -> Encoded:
    """The reference model, with one column `rho` for the availability between `levels`."""
    draft = Draft(Watch(setting.clock))
    network = unroll([item.graph for item in setting.classes], setting.horizon, draft)
    flows = np.arange(draft.column_count)
    capacity_rows(network, setting.arrays, draft)
    constraint_rows(setting.constraints, setting.mission.system, setting.arrays, network, draft)
    rho = int(draft.columns(1, lower=levels[0], upper=levels[1], integer=True)[0])
    encoder = ReferenceEncoder(draft, network, setting.requirement(0), (rho, *levels))
    encoder.encode(setting.goal)
    stay = _stayers(setting, network, draft)
    model = draft.build()
    others = np.setdiff1d(np.flatnonzero(model.integer), flows)
    return Encoded(model, network, others, flows, stay, rho=rho)


def _stayers(setting: Setting, network: Network, draft: Draft) -> Ints:
    if "agents" not in setting.mission.objective:
        return np.empty(0, dtype=np.int64)
    return objectives.stayers(network, draft)
