"""A first plan of few splits: along the ways that the fewest tokens take.

Tokens (see `tokens`) bound the number of splits from below, and say which ways lead to so few. The
whole problem is small where swarms may only move along these ways at about these steps, or wait by
them. What it then knows of sizes and limits may cost more splits than the tokens, or leave no plan:
more slack is tried, and in the end the search that leaves nothing out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from tsplan.encode.groups.group_objectives import VECTORS
from tsplan.encode.groups.occupancy import Occupancy
from tsplan.encode.groups.swarm_model import SwarmModel
from tsplan.encode.groups.token_flow import Track, tokens
from tsplan.milp.model import Floats, Model
from tsplan.mission import Mission
from tsplan.search.clock import Clock

_SECONDS = 10.0  # for the tokens
_SLACKS = (0, 2, 6)  # steps that a plan may differ from the tokens it follows


def scout(
    mission: Mission, model: SwarmModel, clock: Clock, solve: Callable[[Model], Floats | None]
) -> Iterator[tuple[float, Floats | None]]:
    """A bound on the number of splits, infinite if there is no plan; then points of `counted`.

    Each point comes with its number of splits; the last ones are the better ones.
    """
    few = tokens(mission, clock)
    fewest = few.fewest(clock.within(_SECONDS))
    bound = fewest.bound
    yield bound, None
    whole = None if fewest.values is None else few.whole(fewest.values, solve)
    if whole is None:
        return
    counted = model.counted.model
    vector = VECTORS["splits"](model, counted.size.columns)
    best = np.inf
    for slack in _SLACKS:
        narrow = _near(counted, model.swarms, few.tracks(whole), slack)
        values = solve(narrow.with_objective(vector))
        splits = np.inf if values is None else float(np.round(vector @ values))
        if splits < best:
            best = splits
            yield best, values
        if best <= bound or clock.over:
            return


def _near(model: Model, swarms: Sequence[Occupancy], tracks: Sequence[Track], slack: int) -> Model:
    """The model in which swarms move along tracks, so many steps sooner or later, or wait there."""
    upper = model.upper.copy()
    for swarm, track in zip(swarms, tracks, strict=True):
        columns = swarm.entered
        graph = columns.graph
        edge, _, column = columns.unrolled()
        met = graph.start > 0
        met[graph.tail[track.edge]] = met[graph.head[track.edge]] = True
        allowed = (graph.wait & met[graph.tail])[edge]
        for shift in range(-slack, slack + 1):
            when = track.step + shift
            inside = (when >= columns.first[track.edge]) & (when <= columns.last[track.edge])
            near = track.edge[inside]
            own = columns.offset[near] + when[inside] - columns.first[near]
            allowed[np.searchsorted(column, own)] = True
        upper[column[~allowed]] = 0.0
    return model.with_bounds(model.lower, upper)
