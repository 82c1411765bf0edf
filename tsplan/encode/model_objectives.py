"""Objectives in a model: what is minimised, what is kept of it, and what a point is worth in it.

Most are linear in the columns and minimised as they stand. `availability` and `makespan` are
settled level by level, since each of their levels is a model of its own. An objective is put here
by `register`, under the name that missions use; how its value is measured on a plan is said in the
check, which does not believe what is said here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil
from types import MappingProxyType

import numpy as np

from tsplan.encode.amount_objectives import Haulage, Reserve
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.executions import Executions, beyond
from tsplan.encode.expressions import Own
from tsplan.encode.flow_network import Network
from tsplan.encode.groups.group_sizes import sizes, smallest, with_smallest
from tsplan.encode.groups.occupancy import split_terms
from tsplan.encode.objective_kinds import (
    Grouping,
    LevelObjective,
    ModelObjective,
    RealObjective,
    StageObjective,
    TargetObjective,
)
from tsplan.encode.own_constraints import PART as VARIABLES
from tsplan.encode.own_constraints import Quantities
from tsplan.encode.performance_objective import Performance
from tsplan.encode.priced_objectives import Cost, Energy, Risk, Travel
from tsplan.encode.read_back import availability, begun_until, last_arrival, moving
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.stability_objective import Deviation, Stability
from tsplan.logic import Execution, walk
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.milp.target import Target
from tsplan.mission import Mission


class MovingAgents(TargetObjective):
    """How many agents ever move: all but those that wait at their start to the end."""

    name = "agents"

    def columns(
        self, setting: Setting, network: Network, executed: Executions, draft: Draft
    ) -> list[Ints]:
        """Columns that count the agents of each class and start that wait there to the end."""
        return [stayers(item, network.horizon, draft) for item in network.classes]

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """All agents but those that stay."""
        vector = np.zeros(encoded.model.size.columns)
        staying = encoded.own_columns[self.name]
        for item, columns in zip(encoded.network.classes, staying, strict=True):
            vector[columns] = -float(item.graph.modules)
        return Target(vector, constant=Fraction(setting.mission.size))

    def worth(self, setting: Setting, point: Point) -> float:
        """Told by the moves: more may stay than the columns say."""
        return float(moving(setting, point))


class Availability(LevelObjective, TargetObjective):
    """How many agents with any one capability may be missing anywhere, and the formula holds."""

    name = "availability"
    built = True

    def by_levels(self, *, tight: bool) -> bool:
        """The reference encoding has a column for it."""
        return tight

    def ideal(self, setting: Setting) -> float:
        """Every atom on its own, by team and travel times; infinite if nothing is asked for."""
        bound = OptimisticBound(setting.judged, setting.atoms(setting.unrolled()))
        best = bound.best(setting.judged, 0)
        if best == np.inf and any(isinstance(node, Execution) for node in walk(setting.judged)):
            return float(beyond(setting.judged, setting.mission.size))  # not with every plan
        return best

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """The column of the reference encoding."""
        vector = np.zeros(encoded.model.size.columns)
        vector[encoded.rho] = -1.0
        return Target(vector, Fraction(-1))

    def minimised(self, setting: Setting, point: Point) -> float:
        """The column where there is one, else the value itself."""
        if point.tight:
            return self.worth(setting, point)
        return self.target(setting, point.encoded).value(point.values)

    def worth(self, setting: Setting, point: Point) -> float:
        """Robustness of the goal under the counts of the moves."""
        return availability(setting, point)


class Delay(LevelObjective):
    """How many steps late every agent may be at any time, and the formula holds."""

    name = "delay"
    built = True

    def ideal(self, setting: Setting) -> float:
        """Every atom on its own, by team and travel times and the steps that agents may be late."""
        network, low, high = setting.unrolled(), setting.delay, setting.horizon
        while low < high:
            later = (low + high + 1) // 2
            atoms = setting.atoms(network, later - setting.delay)
            possible = OptimisticBound(setting.goal, atoms).best(setting.goal, 0) >= 0
            low, high = (later, high) if possible else (low, later - 1)
        return float(low)

    def worth(self, setting: Setting, point: Point) -> float:
        """What the model of the point was made for."""
        return float(point.encoded.setting.delay)

    def kept(self, setting: Setting, encoded: Encoded, value: float) -> Encoded:
        """As it is: a model is made for that."""
        return encoded


class Makespan(LevelObjective):
    """The last step at which an agent arrives by a move that is not a wait; 0 without any."""

    name = "makespan"
    grouping = Grouping.PLACES

    def ideal(self, setting: Setting) -> float:
        """Nobody moves but those who are under way."""
        return float(begun_until(setting))

    def worth(self, setting: Setting, point: Point) -> float:
        """Told by the moves."""
        return float(max(begun_until(setting), last_arrival(setting, point)))

    def kept(self, setting: Setting, encoded: Encoded, value: float) -> Encoded:
        """Without the moves that end later."""
        upper = encoded.model.upper.copy()
        groups = [swarm.places.entered for swarm in encoded.swarms]
        for item in (*encoded.network.classes, *groups):
            upper[item.late(int(value))] = 0.0
        return replace(encoded, model=encoded.model.with_bounds(encoded.model.lower, upper))


class Splits(ModelObjective):
    """How often groups split: whoever leaves by j edges at once splits j - 1 times."""

    name = "splits"
    grouping = Grouping.TOKENS

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """Edges entered beyond one for every occupied state."""
        vector = np.zeros(encoded.model.size.columns)
        columns, values = split_terms([swarm.places for swarm in encoded.swarms])
        vector[columns] = values
        return vector


class GroupMoves(ModelObjective):
    """Edges entered by a group, waits aside."""

    name = "moves"
    grouping = Grouping.PLACES

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """One for every edge that is no wait."""
        vector = np.zeros(encoded.model.size.columns)
        for swarm in encoded.swarms:
            graph = swarm.places.entered.graph
            swarm.places.entered.price(vector, ~graph.wait & ~graph.begun)
        return vector


class Balance(TargetObjective):
    """The size of the smallest sub-swarm at any step."""

    name = "balance"
    opens = False

    def extended(self, encoded: Encoded) -> Encoded:
        """With one more column, the last: at most the size of every sub-swarm."""
        found = sizes(encoded.swarms)
        model = with_smallest(encoded.model, found, float(found.most.max(initial=0.0)))
        flows = np.append(encoded.flows, model.size.columns - 1)
        return replace(encoded, model=model, flows=flows)

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """The last column of an extended model."""
        vector = np.zeros(encoded.model.size.columns)
        vector[-1] = -1.0
        return Target(vector, Fraction(-1))

    def minimised(self, setting: Setting, point: Point) -> float:
        """Told by the flows; less is better as it is minimised."""
        return -smallest(point.encoded.swarms, point.values)

    def kept(self, setting: Setting, encoded: Encoded, value: float) -> Encoded:
        """Every sub-swarm has at least so many agents, by a fixed column."""
        wide = with_smallest(encoded.model, sizes(encoded.swarms), -value)
        lower = wide.lower.copy()
        lower[-1] = -value
        return replace(encoded, model=wide.with_bounds(lower, wide.upper))


@dataclass(frozen=True)
class OwnSum(TargetObjective):
    """A user's own sum of quantities, in whole units where they and its coefficients allow it."""

    own: Own

    name = "own"

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """The sum over the columns of the counts."""
        variables = encoded.own_columns[VARIABLES]
        quantities = Quantities(encoded.setting, encoded.network, variables)
        terms: dict[int, Fraction] = {}
        constant, most = self.own.expression.constant, setting.mission.size
        for term, factor in self.own.expression.terms:
            columns, fixed = quantities.columns(term)
            constant += factor * fixed
            most = max(most, ceil(quantities.most(term)))
            for column in columns.tolist():
                terms[column] = terms.get(column, Fraction(0)) + factor
        whole = all(term.whole for term, _ in self.own.expression.terms)
        made = Target.of(
            terms,
            encoded.model.size.columns,
            constant,
            most=most,
            maximise=self.own.maximised,
            unit=None if whole else Fraction(1),
        )
        return made if whole else replace(made, step=0.0)


class ExpectedTravel(RealObjective, Travel):
    """Agent-steps that are expected to be spent in actions that are no waits."""

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """Expected numbers are not whole."""
        return replace(super().target(setting, encoded), step=0.0)


class ExpectedCost(RealObjective, Cost):
    """Expected costs of all actions."""

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """Expected costs are told apart as floats are."""
        return replace(super().target(setting, encoded), step=0.0)


class ExpectedAvailability(RealObjective):
    """By how much expected numbers of agents exceed what the formula asks for."""

    name = "availability"

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """The column of the availability, a real number."""
        return replace(Availability().target(setting, encoded), step=0.0)


EXPECTED: Mapping[str, StageObjective] = MappingProxyType(
    {each.name: each for each in (ExpectedTravel(), ExpectedCost(), ExpectedAvailability())}
)
"""The objectives of expected numbers, by their names."""

_OBJECTIVES: dict[str, StageObjective] = {}


def register(objective: StageObjective) -> None:
    """Let missions name an objective; one of the same name is replaced."""
    _OBJECTIVES[objective.name] = objective


for _each in (
    Travel(),
    Cost(),
    Risk(),
    MovingAgents(),
    Availability(),
    Delay(),
    Haulage(),
    Reserve(),
    Energy(),
    Performance(),
    Makespan(),
    Splits(),
    GroupMoves(),
    Balance(),
    Stability(),
    Deviation(),
):
    register(_each)


def model_objective(name: str) -> StageObjective | None:
    """The objective of a name; None for those that say what is to hold."""
    return _OBJECTIVES.get(name)


def objectives_of(mission: Mission) -> tuple[StageObjective, ...]:
    """The objectives of a mission in their order, but for those that say what is to hold."""
    named = model_objective if mission.expected is None else EXPECTED.get
    found = map(named, mission.objective)
    return tuple(objective for objective in found if objective is not None)


def stayers(item: ClassColumns, horizon: int, draft: Draft) -> Ints:
    """Columns that count the agents of a class, by start, that wait there to the end.

    An agent stays by taking its start's self-loop again and again, so as many can stay as every
    one of those waits is taken by. Minimising the agents that move is maximising these columns.
    """
    made = []
    for state in np.flatnonzero(item.graph.start).tolist():
        stays = item.graph.waits(state, horizon)
        if stays is None:
            continue
        edge, step = stays
        waits = item.offset[edge] + step - item.first[edge]  # of edges that are open then
        staying = draft.columns(1, upper=float(item.graph.start[state]), integer=True)
        every = np.arange(len(waits))
        draft.sums((every, waits, 1.0), (every, staying[0], -1.0), count=len(every), kind="stay")
        made.append(staying)
    return np.concatenate([*made, np.empty(0, dtype=np.int64)])
