"""Why at most one column of a choice is 1: by a row that says so, or by what rows say together."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.exact_rows import Multipliers
from tsplan.milp.model import Model
from tsplan.milp.proven_lp import ProvenLP


def choice_proofs(
    model: Model, choices: Iterable[tuple[int, ...]], clock: Clock
) -> dict[tuple[int, ...], Multipliers]:
    """Multipliers by which the sum of each choice is less than 2; those without any are left out.

    A choice below another is worth no more than the one above, so the program knows it.
    """
    found: dict[tuple[int, ...], Multipliers] = {}
    lp: ProvenLP | None = None
    for choice in sorted(choices):
        row = _row(model, choice)
        if row is not None:
            found[choice] = Multipliers(np.array([row]), np.array([-1]), 0)
            continue
        lp = lp or ProvenLP(model.with_objective(np.zeros(model.size.columns)), clock.stop)
        columns = np.array(choice, dtype=np.int64)
        lp.costs(columns, -1.0)
        result = lp.solve(time_limit=clock.left)
        lp.costs(columns, 0.0)
        if result.status == "optimal":
            found[choice] = result.proof
    return found


def _row(model: Model, choice: tuple[int, ...]) -> int | None:
    """A row that says that the sum of the columns is 1, or at most that."""
    matrix, columns = model.matrix, np.array(choice)
    entries = np.flatnonzero(matrix.indices == columns[0])
    for row in np.searchsorted(matrix.indptr, entries, side="right") - 1:
        part = slice(int(matrix.indptr[row]), int(matrix.indptr[row + 1]))
        same = np.array_equal(np.sort(matrix.indices[part]), columns)
        if same and (matrix.data[part] == 1).all() and model.row_upper[row] == 1:
            return int(row)
    return None
