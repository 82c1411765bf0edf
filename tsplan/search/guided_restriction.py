"""A first plan of few splits: along the ways that the fewest tokens take.

Tokens (see `encode.groups.token_flow`) bound the number of splits from below, and say which ways
lead to so few. The whole problem is small where swarms may only move along these ways at about
these steps, or wait by them. What it then knows of sizes and limits may cost more splits than the
tokens, or leave no plan: more slack is tried, and in the end the search that leaves nothing out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.encode.groups.group_rows import Swarm
from tsplan.encode.groups.token_flow import Tokens, Track
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Floats, Model
from tsplan.milp.target import Target
from tsplan.search.branch_and_bound import BranchAndBound, Explored

_SECONDS = 10.0  # for the tokens
SLACKS = (0, 2, 6)
"""Steps that a plan may differ from the tokens it follows."""

_SPLIT = 1e4  # steps of moving that are worth a split


def guided(
    tokens: Tokens,
    encoded: Encoded,
    splits: Floats,
    clock: Clock,
    solve: Callable[[Model], Floats | None],
) -> Iterator[tuple[float, Floats | None]]:
    """A bound on the number of splits, infinite if there is no plan; then points of a whole model.

    `splits` are the coefficients of their number. Each point comes with it; the last ones are the
    better ones.
    """
    found = fewest(tokens, clock.within(_SECONDS))
    bound = found.bound
    yield bound, None
    whole = None if found.values is None else solve(_least_moving(tokens, found.values))
    if whole is None:
        return
    best = np.inf
    for slack in SLACKS:
        narrow = near(encoded.model, encoded.swarms, tokens.tracks(whole), slack)
        values = solve(narrow.with_objective(splits))
        value = np.inf if values is None else float(np.round(splits @ values))
        if value < best:
            best = value
            yield best, values
        if best <= bound or clock.over:
            return


def fewest(tokens: Tokens, clock: Clock) -> Explored:
    """The fewest tokens added to the starts, or a bound on them; infinite if none will do."""
    if tokens.refuted:
        return Explored(None, np.inf, done=True)
    lp = WarmLP(tokens.model, stop=clock.stop)
    root = lp.solve(time_limit=clock.left)
    if root.status != "optimal":
        impossible = root.status == "infeasible"
        return Explored(None, np.inf if impossible else 0.0, done=impossible)
    target = Target(tokens.model.objective)
    search = BranchAndBound(lp, tokens.indicators, tokens.choices, target, root)
    explored = search.run(clock)
    return replace(explored, bound=target.proven(explored.bound))


def _least_moving(tokens: Tokens, values: Floats) -> Model:
    """The model of whole tokens with the witnesses of a point, that move as little as they can."""
    model, fixed = tokens.model, tokens.indicators
    price = _SPLIT * model.objective + tokens.moving()
    return model.with_fixed(fixed, values[fixed]).with_objective(price)


def near(model: Model, swarms: Sequence[Swarm], tracks: Sequence[Track], slack: int) -> Model:
    """The model in which swarms move along tracks, so many steps sooner or later, or wait there."""
    upper = model.upper.copy()
    for swarm, track in zip(swarms, tracks, strict=True):
        columns = swarm.places.entered
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
