"""Robots that go on as they were to, taken out of the moves of their class before the others."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tsplan.encode.planned_ways import Following
from tsplan.encode.stability_objective import Stability, intended_of, path_of, rank_of
from tsplan.plans.bundles import Stretch

if TYPE_CHECKING:
    from tsplan.encode.agent_classes import AgentClass
    from tsplan.encode.encoded import Point, Setting
    from tsplan.encode.read_back import Moves
    from tsplan.mission import Rank


def kept_paths(
    setting: Setting, point: Point, item: AgentClass, moves: Moves
) -> tuple[list[tuple[Rank, Stretch]], Moves]:
    """Robots of a class that keep their intended paths, and the moves of the others.

    As many keep each path as the point says, and then as many more as its moves allow.
    """
    mine = intended_of(setting, item)
    if not mine or item.bounds is not None or item.graph.modes is not None:
        return [], moves
    entered = zip(*(part.tolist() for part in moves), strict=True)
    left = {(edge, step): count for edge, step, count in entered}
    said = {
        each.intended: round(float(point.values[each.column]))
        for each in point.encoded.own_columns.get(Stability.name, ())
    }
    follow = Following(item.graph, setting.horizon, setting.arrays.number)
    found: list[tuple[Rank, Stretch]] = []
    taken = dict.fromkeys(mine, 0)
    for most in (said, {each: each.names.size for each in mine}):
        for each in mine:
            rank = rank_of(setting, each)
            entries = follow.whole(setting.arrays.number[rank.place], path_of(rank, each))
            if entries is None:
                continue
            wanted = most.get(each, 0) - taken[each]
            count = min([wanted, *(left.get(entry, 0) for entry in entries)])
            if count <= 0:
                continue
            for entry in entries:
                left[entry] -= count
            names = each.names.part(taken[each], taken[each] + count)
            taken[each] += count
            found.append((rank, Stretch(names, path_of(rank, each))))
    rest = [(edge, step, count) for (edge, step), count in left.items() if count]
    edges, steps, counts = np.array(rest, dtype=np.int64).reshape(-1, 3).T
    return found, (edges, steps, counts)
