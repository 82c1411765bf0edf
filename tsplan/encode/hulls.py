"""The surroundings of a place at which agents are wanted: nodes where they only make room.

Where a place is limited the states next to it are kept, so agents of a fractional solution can come
to the place again and again by one short step. Who is around the place was there before or came to
its surroundings from afar; so arrival cuts of the place and all that lies around it count no such
step.
"""

from __future__ import annotations

import numpy as np

from tsplan.encode.atom_encoders import Site
from tsplan.encode.flow_network import Network


def hull_of(states: Site, wanted: frozenset[int], network: Network) -> Site:
    """The states of a place and those next to it that lie nearer to it than to any other.

    Others are those at which agents are `wanted` or begin. Any set of states around the place gives
    true cuts.
    """
    found = set(states)
    for item in network.classes:
        graph = item.graph
        if graph.modes is not None or graph.layer is not None:
            return states
        begin = np.flatnonzero(graph.start).tolist()
        others = np.array(sorted(wanted.union(begin).difference(states)), dtype=np.int64)
        next_to = np.setdiff1d(graph.tail[np.isin(graph.head, states)], [*others, *states])
        if len(next_to):
            near = graph.lengths.nearest(states)
            far = graph.lengths.nearest(others)
            found.update(next_to[near[next_to] <= far[next_to]].tolist())
    return tuple(sorted(found))
