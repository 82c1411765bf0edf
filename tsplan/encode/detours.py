"""How much longer ways become that visit a state between two others."""

from __future__ import annotations

import numpy as np

from tsplan.encode.class_graph import ClassGraph
from tsplan.milp.model import Bools, Floats
from tsplan.ts.reachability import Lengths

MOST = 300
"""Kept states up to which detours are worth being looked at: work grows with their square."""


def detours(graph: ClassGraph, kept: Bools) -> Floats:
    """The least detour by each state on a way between two kept ones, or from one to stay there.

    It is 0 on quickest ways, and infinite where no way leads.
    """
    places = np.flatnonzero(kept)
    count = len(kept)
    if len(places) > MOST:
        return np.zeros(count)
    there = graph.lengths.distances(places)
    back = Lengths(count, graph.head, graph.tail, graph.duration).distances(places)
    least = there.min(axis=0, initial=np.inf)
    for way in there:
        direct = way[places]
        reached = np.isfinite(direct)
        if reached.any():
            by = way + back[reached] - direct[reached][:, None]
            np.minimum(least, by.min(axis=0), out=least)
    return np.asarray(least)
