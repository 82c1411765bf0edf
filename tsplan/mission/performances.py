"""How well structures of modules do the tasks that a formula asks for.

A task is served at a state by structures that are there as long as it lasts, each of which serves
one of its needs: of each capability no more than the task needs. It is done as well as those do it
that do it best, and at every state with its label.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import numpy.typing as npt

from tsplan.exact import common_unit, exact
from tsplan.logic import Execution, Formula
from tsplan.logic.evaluation import holds
from tsplan.logic.performance import tree_of_tasks, worth

if TYPE_CHECKING:
    from tsplan.logic.traces import CountTrace
    from tsplan.mission.configurations import ModuleRules
    from tsplan.mission.mission_parts import MissionParts

Floats = npt.NDArray[np.float64]


class Kind(NamedTuple):
    """Structures of one configuration with the same capabilities."""

    configuration: str
    capabilities: frozenset[str]


class Serving(NamedTuple):
    """What one structure of a kind is worth that serves a task, and which needs it can serve."""

    kind: Kind
    worth: int  # in whole units
    needs: frozenset[str]


@dataclass(frozen=True)
class Performances:
    """What configurations are worth by label, in whole units."""

    rules: ModuleRules

    @cached_property
    def unit(self) -> Fraction:
        """The largest number of which every worth is a whole multiple."""
        every = (exact(amount) for _, worth in self.rules.performance for _, amount in worth)
        return common_unit(every)

    def serving(self, task: Execution, kinds: Sequence[Kind]) -> list[Serving]:
        """Who of some kinds is worth anything where it serves a task, the best first."""
        worth = dict(dict(self.rules.performance).get(task.label, ()))
        named = frozenset(name for name, _ in task.needs)
        found = [
            Serving(kind, int(exact(amount) / self.unit), kind.capabilities & named)
            for kind in kinds
            if (amount := worth.get(kind.configuration))
        ]
        return sorted((s for s in found if s.needs), key=lambda s: -s.worth)

    def done(self, task: Execution, there: Mapping[Kind, Floats]) -> Floats:
        """How well a task is done at a state by those that are there at every step, in units.

        The value at a step is that of the task when it begins then; as many values as the task fits
        in.
        """
        steps = len(next(iter(there.values()))) - task.last if there else 0
        able = self.serving(task, tuple(there))
        staying = [
            np.min([there[s.kind][late : late + steps] for late in range(task.last + 1)], axis=0)
            for s in able
        ]
        total = np.zeros(max(steps, 0))
        used: dict[frozenset[str], Floats] = {}
        for serving, most in zip(able, staying, strict=True):
            serve = most
            for some, room in rooms(task):
                if serving.needs <= some:
                    taken = (count for needs, count in used.items() if needs <= some)
                    serve = np.minimum(serve, room - sum(taken, np.zeros_like(most)))
            used[serving.needs] = used.get(serving.needs, np.zeros_like(most)) + serve
            total += serving.worth * serve
        return total


def performance_of(
    mission: MissionParts, trace: CountTrace, present: Mapping[Kind, Floats]
) -> float:
    """What the best way to meet the mission's formula is worth in units; -infinite without any.

    `present` has structures at the states of the map, in their order, and steps.
    """
    rules = Performances(mission.modular)
    tree = tree_of_tasks(mission.formula, mission.task_interval)
    row = {state: number for number, state in enumerate(mission.system.states)}

    def leaf(node: Formula) -> Floats:
        if not isinstance(node, Execution):
            return np.where(holds(node, trace), 0.0, -np.inf)
        steps = max(trace.steps - node.last, 0)
        total = np.zeros(steps)
        for state in mission.system.labels[node.label]:
            here = {kind: table[row[state]] for kind, table in present.items()}
            total += rules.done(node, here) if here else 0.0
        if node.resources or mission.books:
            total = np.where(trace.executed(node.task, node.label)[:steps], total, -np.inf)
        return total

    return float(worth(tree, leaf)[0])


def rooms(task: Execution) -> list[tuple[frozenset[str], int]]:
    """How many can serve needs for capabilities out of each set of those that a task names.

    By Hall's theorem structures can serve together wherever no set has more of them.
    """
    names = [name for name, _ in task.needs]
    return [
        (frozenset(some), sum(number for name, number in task.needs if name in some))
        for count in range(1, len(names) + 1)
        for some in combinations(names, count)
    ]
