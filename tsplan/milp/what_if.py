"""A small linear program that is asked again and again what it would cost to close some columns.

Most answers of a local search are turned down. So every question goes on from the basis of the last
answer that was kept, and ends as soon as it is known to cost too much.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tsplan.milp.highs import checked, load, set_option
from tsplan.milp.model import INFINITY, Bools, Floats, Model
from tsplan.process.quiet_output import hushed

with hushed():
    from highspy import HighsModelStatus as Ended

_MARGIN = 1e-6  # by which a value may be more than what is asked for


@dataclass(frozen=True, eq=False)
class Answer:
    """The least `value` of a program, with the values and reduced costs of its columns."""

    value: float
    values: Floats
    reduced: Floats


class WhatIf:
    """The relaxation of a model, in which the first columns are open or closed.

    Those that are closed are zero, the others may be anything from zero on. All are open at first.
    """

    def __init__(self, model: Model) -> None:
        self._highs = load(model, relaxed=True)
        set_option(self._highs, "solver", "simplex")
        set_option(self._highs, "presolve", "off")
        # what is changed is small: perturbed costs would take more iterations to be taken back
        set_option(self._highs, "dual_simplex_cost_perturbation_multiplier", 0.0)
        self.open: Bools = np.ones(model.size.columns, dtype=np.bool_)
        self._asked = self.open
        self._basis = self._highs.getBasis()

    def ask(self, wanted: Bools, most: float = INFINITY) -> float | None:
        """The least value where other columns are open; None where it is more than `most`."""
        self._turn(self.open, wanted)
        self._asked = wanted
        set_option(self._highs, "objective_bound", most + _MARGIN)
        self._highs.run()
        if self._highs.getModelStatus() != Ended.kOptimal:
            return None
        value = float(self._highs.getObjectiveValue())
        return value if value <= most + _MARGIN else None

    def keep(self) -> Answer:
        """Go on from the last question, which had an answer."""
        self.open = self._asked
        self._basis = self._highs.getBasis()
        found = self._highs.getSolution()
        columns = len(self.open)
        return Answer(
            float(self._highs.getObjectiveValue()),
            np.fromiter(found.col_value, np.float64, columns),
            np.fromiter(found.col_dual, np.float64, columns),
        )

    def drop(self) -> None:
        """Forget the last question, and go on from the one before."""
        self._turn(self._asked, self.open)
        self._asked = self.open
        self._highs.setBasis(self._basis)

    def change(self, wanted: Bools) -> None:
        """Open and close columns where that makes no difference to the answer that was kept."""
        self._turn(self.open, wanted)
        self.open = self._asked = wanted

    def _turn(self, before: Bools, after: Bools) -> None:
        columns = np.flatnonzero(before != after)
        if len(columns):
            high = np.where(after[columns], INFINITY, 0.0)
            status = self._highs.changeColsBounds(
                len(columns), columns.astype(np.int32), np.zeros(len(columns)), high
            )
            checked(status, "column bounds")
