"""A bound of large missions with resources that takes seconds: what must be moved at all.

See `encode.still_flows`. Its linear program says most of it; whole agents say a little more, so the
solver may take a while.
"""

from __future__ import annotations

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.encode.still_flows import still_model
from tsplan.errors import SolverError
from tsplan.milp.lp import WarmLP
from tsplan.milp.target import Target
from tsplan.search.effort import Effort

_SECONDS = 5.0
_SHARE = 1 / 4  # of the time that is left


def still_bound(encoded: Encoded, target: Target, effort: Effort, clock: Clock) -> float:
    """A true bound of a target, minus infinity where none is found soon."""
    least = -np.inf
    model = still_model(encoded, target.vector)
    if model is None:
        return least
    left = clock.left
    within = clock.within(_SECONDS if left is None else min(_SECONDS, _SHARE * left))
    try:
        first = WarmLP(model, clock.stop).solve(time_limit=within.left)
        if first.status != "optimal":
            return least
        least = target.proven(first.objective)
        further = effort.solver.solve(model, effort.options(within, target)).bound
    except SolverError:
        return least
    return least if further is None else max(least, target.proven(further))
