"""Clique cuts: rows of a conflict graph that the linear program violates, added round by round."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.encode.partial.conflict_graph import ConflictGraph
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Floats

_ROUNDS = 12
_GAIN = 1e-4  # relative rise of the bound that another round has to bring


def with_clique_cuts(
    encoded: Encoded, objective: Floats, conflicts: ConflictGraph, clock: Clock
) -> Encoded:
    """The model with the cliques that its LP violates, round after round while that pays."""
    if encoded.refuted or not conflicts.rows.shape[0]:
        return encoded
    model = encoded.model
    lp = WarmLP(model.with_objective(objective), clock.stop)
    former = -np.inf
    for _ in range(_ROUNDS):
        result = lp.solve(time_limit=clock.left)
        if result.status != "optimal" or result.values is None or clock.over:
            break
        if result.objective < former + _GAIN * max(abs(former), 1.0):
            break
        cliques = conflicts.violated(result.values)
        if cliques is None:
            break
        former = result.objective
        count = cliques.shape[0]
        lp.add_rows(cliques, np.full(count, -np.inf), np.ones(count))
        model = model.with_rows(cliques, -np.inf, 1.0, "clique")
    return replace(encoded, model=model)
