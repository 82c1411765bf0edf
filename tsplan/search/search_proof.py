"""What a search has proven, to be written down: its tree, its cuts, and why choices are choices.

At most one column of a choice is 1: a row says so, or what rows say together.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.milp.exact_rows import Multipliers
from tsplan.milp.model import Model
from tsplan.milp.proof_tree import Leaf, ProofTree, choices_in
from tsplan.milp.proven_lp import ProvenLP
from tsplan.search.standing import Standing

COUNTING = "demands judged one by one"
"""What refutes a mission without any program: no agents can be there in time."""

_CUTS = {"arrival": "arrival cuts", "visitors": "visitor cuts", "clique": "clique cuts"}


def rests_on(encoded: Encoded, model: Model) -> frozenset[str]:
    """What of the encoding a bound rests on beside the rows that the model had at first."""
    if encoded.refuted:
        return frozenset({COUNTING})
    added = model.tags[len(encoded.model.tags) :]
    return frozenset(_CUTS.get(tag.kind, f"{tag.kind} cuts") for tag in added)


def search_proof(
    encoded: Encoded, model: Model, known: Standing, leaves: tuple[Leaf, ...], clock: Clock
) -> ProofTree:
    """What proves the exact bound of a search, or that there is no point."""
    return ProofTree(
        model,
        bound=None if known.refuted else known.exact,
        whole=bool(known.target.step),
        leaves=leaves,
        choices=choice_proofs(encoded.model, choices_in(leaves), clock),
        added=encoded.model.matrix.shape[0],
        values=known.values,
        refuted=encoded.refuted,
    )


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
