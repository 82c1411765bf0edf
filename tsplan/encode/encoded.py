"""What a problem is encoded from, what its model means, and a point of that model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.agent_classes import AgentClass, MapArrays
from tsplan.encode.atom_encoders import Atoms
from tsplan.encode.class_shares import Served
from tsplan.encode.count_atoms import atoms_over
from tsplan.encode.demand_rows import SiteColumns
from tsplan.encode.demand_runs import Family
from tsplan.encode.expressions import Constraint
from tsplan.encode.flow_network import Network, unroll
from tsplan.encode.groups.group_rows import Swarm
from tsplan.encode.map_reduction import Reduced
from tsplan.encode.memory import Watch
from tsplan.encode.stocks import PART as STOCKS
from tsplan.encode.stocks import Stocks
from tsplan.encode.structure_flows import Change
from tsplan.encode.switches import ALL_SWITCHES, Switch
from tsplan.encode.visitor_cuts import Visits
from tsplan.logic import Formula, conjunction, simplify, tighten
from tsplan.logic.margin import shifted
from tsplan.milp.model import Draft, Floats, Ints, Model
from tsplan.mission import Mission

_NO_INTS = np.empty(0, dtype=np.int64)


@dataclass(frozen=True, eq=False)
class Setting:
    """What every encoding starts from; the classes' graphs are reduced where that is exact."""

    mission: Mission
    goal: Formula  # positive normal form of counting atoms
    horizon: int
    classes: tuple[AgentClass, ...]
    reduced: tuple[Reduced, ...]
    arrays: MapArrays
    constraints: tuple[Constraint, ...] = ()
    switches: frozenset[Switch] = ALL_SWITCHES
    monotone: bool = False  # nothing bounds a count from above
    clock: Clock = field(default_factory=Clock)  # heard while models are made
    plain: Formula | None = None  # what of the goal a margin tightens, without that
    beside: Formula | None = None  # what is in the goal beside that, as it is written
    level: int = 0  # the availability that is asked for beside that
    delay: int = 0  # how many steps late agents may be
    changes: tuple[Change, ...] = ()  # by which structures of modules become others
    slack: float = np.inf  # what agents may travel in detours, all of them together
    straight: bool = False  # resources lie only where they began and where they are wanted

    def atoms(self, network: Network, later: int = 0) -> Atoms:
        """How atoms are encoded over a network; with `later`, what can hold if agents are so."""
        mission = self.mission
        given = self.arrays, self.level, mission.resources
        return atoms_over(network, mission.system, *given, later=later)

    @cached_property
    def judged(self) -> Formula:
        """What availability is told of: the goal without a margin."""
        parts = [part for part in (self.plain, self.beside) if part is not None]
        return simplify(conjunction(parts)) if parts else self.goal

    @property
    def formula_alone(self) -> bool:
        """Whether robots that go one by one have nothing to keep but the formula and the map.

        There are no swarms, structures, resources, margins, delays, expected numbers or
        constraints of the user's own.
        """
        mission = self.mission
        return not (
            mission.swarm is not None
            or mission.expected is not None
            or mission.resources
            or self.changes
            or self.constraints
            or self.delay
            or self.plain is not None
        )

    @property
    def untimed(self) -> bool:
        """Whether the map is the same at all steps, and everybody starts at a state."""
        under_way = any(len(item.graph.coming) for item in self.classes)
        return not (under_way or self.mission.system.timed)

    def at(self, level: int) -> Setting:
        """The setting of plans with availability at least `level`."""
        rules = self.mission.swarm
        if self.plain is None or rules is None or not level:
            return replace(self, level=level)
        goal = [tighten(self.plain, self.mission.having, rules.spare, level)]
        goal += [] if self.beside is None else [shifted(self.beside, level)]
        return replace(self, goal=simplify(conjunction(goal)))

    @property
    def together(self) -> int | None:
        """The most sub-swarms of all swarms at a step."""
        return None if self.mission.swarm is None else self.mission.swarm.together

    def unrolled(self) -> Network:
        """The flow network of all classes, of which no model is made."""
        graphs = [item.graph for item in self.reduced]
        return unroll(graphs, self.horizon, Draft(Watch(self.clock)))


@dataclass(frozen=True, eq=False)
class Encoded:
    """A model and what its columns mean.

    It is of the plans of a `setting`. `flows` are the columns of agents that enter edges,
    `indicators` the 0/1 columns of what is decided besides, and `steps` when what they stand for
    begins (tight encoding only); `choices` are those of them of which at most one is 1, in the
    order of their steps. `swarms` has the columns of the classes that move in groups; `occupied` is
    the relaxation in which only the places of groups are known, whose columns are the first of this
    model. `shared` says that some eventuality lies under an always, `level` which availability was
    asked for. `rho` is the availability's column in the reference encoding; `own_columns` are those
    that an objective needs for itself, by its name, and what the columns of other parts mean by
    theirs. `loads` are the columns of whole pieces that are carried, which are repaired as flows
    are; so are the columns `rebuilt` of structures that become others, which solvers decide.
    `served` are the tasks that classes may share.
    """

    setting: Setting
    model: Model
    network: Network
    indicators: Ints
    flows: Ints
    swarms: tuple[Swarm, ...] = ()
    occupied: Encoded | None = None
    own_columns: Mapping[str, Any] = field(default_factory=dict)
    loads: Ints = field(default_factory=lambda: _NO_INTS)
    rebuilt: Ints = field(default_factory=lambda: _NO_INTS)
    rho: int = -1
    refuted: bool = False
    shared: bool = False
    level: int = 0
    steps: Ints = field(default_factory=lambda: _NO_INTS)
    choices: tuple[Ints, ...] = ()
    families: tuple[tuple[SiteColumns, Family], ...] = ()
    visits: tuple[Visits, ...] = ()
    served: tuple[Served, ...] = ()

    @property
    def repaired(self) -> Ints:
        """The columns that may be fractions at first and are made whole afterwards."""
        return np.concatenate([self.loosened, self.rebuilt])

    @property
    def loosened(self) -> Ints:
        """Those of them that are nearly always whole once all others are."""
        return np.concatenate([self.flows, self.loads])

    @property
    def carrying(self) -> bool:
        """Whether some agents can carry something that is of use."""
        made: Stocks | None = self.own_columns.get(STOCKS)
        return made is not None and bool(made.loads)

    @cached_property
    def moves(self) -> Ints:
        """The columns of agents that enter edges which are no waits."""
        unrolled = [(item.graph, *item.unrolled()) for item in self.network.classes]
        moving = [column[graph.travel[edge] > 0] for graph, edge, _, column in unrolled]
        return np.concatenate([*moving, _NO_INTS])


@dataclass(frozen=True, eq=False)
class Point:
    """A point of a model: enough to read the agents' moves off it."""

    encoded: Encoded
    values: Floats
    tight: bool
