"""What is carried, brought in order once it is settled who goes where.

Points of a search carry things to and fro without need, and objectives that were kept within what
solvers tell apart lose that little. With all moves and executions fixed, each objective that is
about amounts is brought to its best again, in the mission's order, and then nothing is carried
without need.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.amount_objectives import Haulage, OfAmounts
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.model_objectives import objectives_of
from tsplan.encode.stocks import PART, Stocks
from tsplan.milp.confirmation import tried
from tsplan.search.effort import Effort

_SECONDS = 2.0  # for one objective


def tidied(setting: Setting, point: Point, effort: Effort, clock: Clock) -> Point:
    """The point with the same moves and executions, and no needless cargo."""
    made: Stocks | None = point.encoded.own_columns.get(PART)
    if made is None or not made.loads:
        return point
    model, values = point.encoded.model, point.values
    free = np.concatenate([made.pieces, [made.reserve]])
    fixed = np.setdiff1d(np.flatnonzero(model.integer), free)
    model = model.with_fixed(fixed, values[fixed])
    about = [o for o in objectives_of(setting.mission) if isinstance(o, OfAmounts)]
    for objective in [*about, Haulage()]:
        vector = objective.vector(setting, point.encoded)
        options = effort.options(clock.within(_SECONDS), objective.target(setting, point.encoded))
        better = tried(effort.solver, model.with_objective(vector), options)
        if better is None:
            break
        values = better
        model = model.with_row(vector, -np.inf, float(vector @ values), "kept")
    return replace(point, values=values)
