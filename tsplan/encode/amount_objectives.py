"""Objectives about the amounts of resources that are moved or left."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.objective_kinds import ModelObjective, RealObjective
from tsplan.encode.stocks import PART, Stocks
from tsplan.milp.model import Floats
from tsplan.milp.target import Target


class OfAmounts(RealObjective, ModelObjective):
    """An objective about amounts: whole where all comes in whole pieces, else as solvers tell it.

    What an earlier one reached is kept to the last digit.
    """

    lost = 1e-9  # the rounding of doubles, far below what solvers forgive
    digits = 9  # of which solvers tell about six

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """In its own unit, perhaps turned round."""
        unit = Fraction(-1 if self.rises else 1)
        return Target(self.vector(setting, encoded), unit, step=float(_stocks(encoded).whole))


class Haulage(OfAmounts):
    """Amounts times the steps they are moved."""

    name = "haulage"

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """The duration of what every amount is carried along."""
        vector = np.zeros(encoded.model.size.columns)
        for load in _stocks(encoded).loads:
            vector[load.columns] = load.lanes.duration
        return vector


class Reserve(OfAmounts):
    """The least amount left at any execution beside what is needed there."""

    name = "reserve"
    opens = False

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """The column that is at most what is left."""
        vector = np.zeros(encoded.model.size.columns)
        vector[_stocks(encoded).reserve] = -1.0
        return vector

    def minimised(self, setting: Setting, point: Point) -> float:
        """Told by the stocks, but no more than the column can be."""
        most = float(point.encoded.model.upper[_stocks(point.encoded).reserve])
        return -min(self.worth(setting, point), most)

    def worth(self, setting: Setting, point: Point) -> float:
        """What is left at the executions, infinite without any."""
        return _stocks(point.encoded).least_left(point.values)


def _stocks(encoded: Encoded) -> Stocks:
    made: Stocks = encoded.own_columns[PART]
    return made
