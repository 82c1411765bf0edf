"""How many agents each group has, once it is known where the groups are.

With occupancy and witnesses fixed, a swarm is a flow between given bounds. Chosen are the counts
that keep the objectives' values and make the smallest sub-swarm as large as possible; then those
whose splits are most even: the least sum, over all splits, of the largest part minus the smallest.
Counts are whole numbers throughout.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace

import numpy as np
from scipy import sparse

from tsplan.encode.groups.group_rows import Swarm, agents_at_states
from tsplan.milp.model import INFINITY, Floats, Ints, Model, Tag, Terms, joined_terms

Solve = Callable[[Model], "Floats | None"]

_SLACK = 1e-6
_HALF = 0.5


@dataclass(frozen=True, eq=False)
class Sizes:
    """Counts of agents that are sub-swarms where their group column is 1, one a row.

    The count of row i is `base[i]` and the sum of the columns `flow` whose `index` is i.
    """

    index: Ints
    flow: Ints
    group: Ints
    base: Floats
    most: Floats


def sizes(swarms: Sequence[Swarm]) -> Sizes:
    """All counts of sub-swarms: at states, and inside edges that take more than a step."""
    parts: list[Sizes] = []
    rows = 0
    for swarm in swarms:
        part = _sizes(swarm)
        parts.append(replace(part, index=part.index + rows))
        rows += len(part.group)
    return Sizes(
        *(np.concatenate([getattr(part, f.name) for part in parts]) for f in fields(Sizes))
    )


def _sizes(swarm: Swarm) -> Sizes:
    at, columns = agents_at_states(swarm)
    state, _, own = swarm.places.reached()
    edge, _, mine = swarm.flows.unrolled()
    long = swarm.flows.graph.duration[edge] > 1  # entered before the horizon: inside at some step
    count = len(own) + int(long.sum())
    base = np.zeros(count)
    if swarm.places.horizon == 0:
        base[: len(own)] = swarm.flows.graph.start[state]
    return Sizes(
        index=np.concatenate([at, np.arange(len(own), count)]),
        flow=np.concatenate([columns, mine[long]]),
        group=np.concatenate([own, swarm.places.entered.unrolled()[2][long]]),
        base=base,
        most=np.full(count, float(swarm.size)),
    )


def smallest(swarms: Sequence[Swarm], point: Floats) -> float:
    """The size of the smallest sub-swarm in a point."""
    found = sizes(swarms)
    size = found.base.copy()
    np.add.at(size, found.index, np.round(point[found.flow]))
    held = np.round(point[found.group]) > 0
    return float(size[held].min(initial=INFINITY))


def with_smallest(model: Model, found: Sizes, largest: float) -> Model:
    """The model with one more column, the last: at most the size of every sub-swarm.

    `size >= smallest - most * (1 - group)`.
    """
    rows, column = np.arange(len(found.group)), model.size.columns
    terms: list[Terms] = [(found.index, found.flow, 1.0), (rows, column, -1.0)]
    terms.append((rows, found.group, -found.most))
    return _extended(model, np.array([largest]), terms, -found.most - found.base)


def _extended(model: Model, most: Floats, terms: Sequence[Terms], least: Floats) -> Model:
    """The model with more columns (whole numbers up to `most`) and rows of terms `>= least`."""
    more, (index, columns, values) = len(most), joined_terms(terms)
    shape = len(least), model.size.columns + more
    block = sparse.csr_array(sparse.coo_array((values, (index, columns)), shape=shape))
    wide = sparse.csr_array(
        sparse.hstack([model.matrix, sparse.csr_array((model.matrix.shape[0], more))])
    )
    begin = wide.shape[0]
    return replace(
        model,
        objective=np.concatenate([model.objective, np.zeros(more)]),
        lower=np.concatenate([model.lower, np.zeros(more)]),
        upper=np.concatenate([model.upper, most]),
        integer=np.concatenate([model.integer, np.ones(more, dtype=np.bool_)]),
        matrix=sparse.csr_array(sparse.vstack([wide, block], format="csr")),
        row_lower=np.concatenate([model.row_lower, least]),
        row_upper=np.concatenate([model.row_upper, np.full(len(least), INFINITY)]),
        tags=(*model.tags, Tag("size", begin, begin + len(least))),
    )


def settled(model: Model, fixed: Ints, values: Floats) -> tuple[Model, Ints]:
    """The model of the columns that are not `fixed` to their values, and which these are.

    Columns whose bounds meet are gone too.
    """
    lower, upper = model.lower.copy(), model.upper.copy()
    lower[fixed] = upper[fixed] = np.round(values[fixed])
    free = np.flatnonzero(lower < upper)
    done = np.setdiff1d(np.arange(len(lower)), free)
    shift = model.matrix[:, done] @ lower[done]
    left = sparse.csr_array(model.matrix[:, free])
    used = np.diff(left.indptr) > 0
    broken = (shift < model.row_lower - _SLACK) | (shift > model.row_upper + _SLACK)
    kept = np.flatnonzero(used | broken)
    small = replace(
        model,
        objective=model.objective[free],
        lower=lower[free],
        upper=upper[free],
        integer=model.integer[free],
        matrix=sparse.csr_array(left[kept]),
        row_lower=(model.row_lower - shift)[kept],
        row_upper=(model.row_upper - shift)[kept],
        tags=(Tag("settled", 0, len(kept)),),
        offset=float(model.offset + model.objective[done] @ lower[done]),
    )
    return small, free


def spread(model: Model, place: Ints, swarms: Sequence[Swarm]) -> Model | None:
    """The model whose objective is how uneven the splits are; None where nothing splits.

    `place` gives the position of every column of the whole model in this one, or -1.
    """
    parts: dict[tuple[int, int, int], list[int]] = {}
    for number, swarm in enumerate(swarms):
        edge, step, column = swarm.flows.unrolled()
        here = place[column]
        for state, when, at in zip(
            swarm.flows.graph.tail[edge][here >= 0].tolist(),
            step[here >= 0].tolist(),
            here[here >= 0].tolist(),
            strict=True,
        ):
            parts.setdefault((number, state, when), []).append(at)
    split = [members for members in parts.values() if len(members) > 1]
    if not split:
        return None
    columns, more, member = model.size.columns, 2 * len(split), np.concatenate(split)
    high = columns + 2 * np.repeat(np.arange(len(split)), list(map(len, split)))
    above, below = np.arange(2 * len(member)).reshape(-1, 2).T
    terms = [
        (above, high, 1.0),
        (above, member, -1.0),
        (below, member, 1.0),
        (below, high + 1, -1.0),
    ]
    wide = _extended(model, np.full(more, INFINITY), terms, np.zeros(2 * len(member)))
    objective = np.zeros(columns + more)
    objective[columns::2] = 1.0
    objective[columns + 1 :: 2] = -1.0
    return wide.with_objective(objective)


def even_shares(
    swarms: Sequence[Swarm], whole: Model, values: Floats, fixed: Ints, solve: Solve
) -> Floats:
    """`values` with the counts of this module's rule, or unchanged where time runs out.

    `whole` is the model with the rows of all that must be kept.
    """
    found = sizes(swarms)
    largest = float(found.most.max(initial=0.0))
    wide = with_smallest(_placeless(swarms, whole, values), found, largest)
    small, free = settled(wide, fixed, np.append(values, 0.0))
    goal = np.zeros(small.size.columns)
    least = int(np.flatnonzero(free == whole.size.columns)[0])
    goal[least] = -1.0
    best = solve(small.with_objective(goal))
    if best is None:
        return values
    values = _placed(values, free, best)
    lower = small.lower.copy()
    lower[least] = np.floor(best[least] + _SLACK)
    place = np.full(whole.size.columns + 1, -1)
    place[free] = np.arange(len(free))
    uneven = spread(small.with_bounds(lower, small.upper), place, swarms)
    if uneven is None:
        return values
    evened = solve(uneven)
    if evened is None:
        return values
    return _placed(values, free, evened[: len(free)])


def _placeless(swarms: Sequence[Swarm], whole: Model, values: Floats) -> Model:
    """The model without flows on edges that no group enters."""
    upper = whole.upper.copy()
    for swarm in swarms:
        flow, group = swarm.flows.unrolled()[2], swarm.places.entered.unrolled()[2]
        upper[flow[values[group] < _HALF]] = 0.0
    return whole.with_bounds(whole.lower, upper)


def _placed(values: Floats, free: Ints, found: Floats) -> Floats:
    placed = np.append(values, 0.0)
    placed[free] = found
    return placed[:-1]
