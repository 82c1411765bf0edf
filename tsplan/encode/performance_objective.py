"""How well structures do what the formula asks for, as an objective."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.executions import Executions
from tsplan.encode.flow_network import Network
from tsplan.encode.objective_kinds import ModelObjective
from tsplan.encode.performance_rows import Performed, kinds_of, performed
from tsplan.encode.read_back import counts_of, present_of
from tsplan.logic.performance import tree_of_tasks
from tsplan.milp.model import Draft, Floats
from tsplan.milp.target import Target
from tsplan.mission.performances import Kind, Performances, performance_of


class Performance(ModelObjective):
    """What the best way to meet the formula is worth, by how well structures do it."""

    name = "performance"
    opens = False

    def columns(
        self, setting: Setting, network: Network, executed: Executions, draft: Draft
    ) -> Performed:
        """Columns that add up to no more than that."""
        return performed(setting, network, executed, draft)

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """What every column counts, in whole units."""
        made: Performed = encoded.own_columns[self.name]
        vector = np.zeros(encoded.model.size.columns)
        vector[made.columns] = -made.worth
        return vector

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """In the unit of which all worths are multiples."""
        unit = Performances(setting.mission.modular).unit
        return Target(self.vector(setting, encoded), -unit)

    def minimised(self, setting: Setting, point: Point) -> float:
        """Told by where structures are: the columns may say less."""
        return -_value(setting, point)

    def worth(self, setting: Setting, point: Point) -> float:
        """The same in the objective's own unit."""
        unit = Performances(setting.mission.modular).unit
        return float(unit * Fraction(_value(setting, point)))


def _value(setting: Setting, point: Point) -> float:
    """What a point is worth by its moves, in whole units."""
    mission = setting.mission
    tree = tree_of_tasks(mission.formula, mission.task_interval)
    present = present_of(setting, point)
    there: dict[Kind, Floats] = {}
    for number, kind in kinds_of(setting):
        there[kind] = present[number] + there.get(kind, 0.0)
    return performance_of(mission, counts_of(setting, tree, point), there)
