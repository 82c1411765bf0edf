"""Cuts of visitors: so many different agents must come, not a few of them again and again.

An arrival cut counts arrivals at one place, and in a fractional solution a fifth of the agents may
come five times, going to and fro between two tasks. Yet whoever serves a demand is one agent with
one way from its start, and that way crosses into any set Q of places at steps around the demand at
least once. So for every such set

    agents that begin in Q + agents that enter Q  >=  what exclusive demands inside Q ask for.

The sets are those of the network unrolled over time, so there are far too many to write down. The
one that is violated most is a minimum cut between the starts and the demands, with what a linear
program sends along each edge as capacities (Ford and Fulkerson, 1956).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse.csgraph import breadth_first_order, maximum_flow

from tsplan.encode.atom_encoders import Site
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.flow_network import Network
from tsplan.milp.model import Bools, Floats, Ints, Terms, joined_terms

_ENOUGH = 1e-3  # violations below this, in agents, are left to the solver's tolerance
_NOTHING = 1e-9  # less than this along an edge is no flow
_FINE, _MOST = 1e6, 1e9  # parts of an agent that flows are counted in; the greatest sum of them


class Visits(NamedTuple):
    """Demands of agents with a capability at some states, of which at most one is made.

    Part p asks for agents who are all there at one step of `first[p] .. last[p]`: for
    `constant[p]` and the sum of its `terms`. From that step on as many are asked for at `stay`
    steps, the first of them counted, though not the same ones at each.
    """

    states: Site
    capability: str | None
    first: Ints
    last: Ints
    terms: Terms
    constant: Floats
    stay: int = 1

    @property
    def together(self) -> Visits:
        """One part for all of them: who serves any is there at some step of the whole window."""
        _, members, amount = self.terms
        ends = self.first.min(keepdims=True), self.last.max(keepdims=True)
        constant = self.constant.sum(keepdims=True)
        return self._replace(
            first=ends[0], last=ends[1], terms=(0, members, amount), constant=constant
        )


class Separated(NamedTuple):
    """Violated rows, `rows @ x >= lower`."""

    rows: sparse.csr_array
    lower: Floats


class _Found(NamedTuple):
    """One violated cut: columns, factors and lower bound."""

    columns: Ints
    factors: Floats
    lower: float


@dataclass(frozen=True, eq=False)
class _Unrolled:
    """The flows of the classes with one capability: edges between states at steps.

    `starts` are where agents begin, and `supply` how many of them.
    """

    classes: Sequence[ClassColumns]
    width: int  # steps of one state
    offsets: Ints  # of the states of each class
    nodes: Ints
    tail: Ints
    head: Ints
    column: Ints
    starts: Ints
    supply: Ints

    def at(self, states: Ints, first: int, last: int) -> Ints:
        """The nodes of states at some steps, as far as agents can be there."""
        steps = np.arange(first, last + 1)
        places = [
            (offset + item.graph.nodes(states))[:, None] * self.width + steps
            for offset, item in zip(self.offsets.tolist(), self.classes, strict=True)
        ]
        wanted = np.concatenate([part.ravel() for part in places])
        place = np.searchsorted(self.nodes, wanted)
        place = np.minimum(place, len(self.nodes) - 1)
        return np.asarray(place[self.nodes[place] == wanted])


def _unrolled(classes: Sequence[ClassColumns], horizon: int) -> _Unrolled:
    width = horizon + 2  # what ends after the horizon ends at one step more
    sizes = [len(item.graph.start) for item in classes]
    offsets = np.cumsum([0, *sizes])[:-1]
    tails, heads, columns, starts, supplies = [], [], [], [], []
    for offset, item in zip(offsets.tolist(), classes, strict=True):
        graph = item.graph
        edge, step, column = item.unrolled()
        end = np.minimum(step + graph.duration[edge], horizon + 1)
        begun = np.flatnonzero(graph.start)
        tails.append((offset + graph.tail[edge]) * width + step)
        heads.append((offset + graph.head[edge]) * width + end)
        columns.append(column)
        starts.append((offset + begun) * width)
        supplies.append(graph.start[begun])
    tail, head, start = (np.concatenate(parts) for parts in (tails, heads, starts))
    nodes, place = np.unique(np.concatenate([tail, head, start]), return_inverse=True)
    tail, head, start = np.split(place, np.cumsum([len(tail), len(head)]))
    supply = np.concatenate(supplies)
    return _Unrolled(
        classes, width, offsets, nodes, tail, head, np.concatenate(columns), start, supply
    )


@dataclass(frozen=True, eq=False)
class VisitorCuts:
    """Finds violated cuts of the demands of one model."""

    network: Network
    demands: Sequence[Visits]

    def violated(self, values: Floats, columns: int) -> Separated | None:
        """Rows over so many columns that `values` violates, at most one for each of the demands."""
        flows = {name: _Flows.of(net, values) for name, net in self._unrolled.items()}
        found = []
        for one in self.demands:
            made = flows[one.capability]
            # what all parts ask for together gives the stronger cuts, if it is violated at all
            cut = _cut(made, one.together, values)
            if cut is None and len(one.first) > 1:
                cut = _cut(made, one, values)
            found += [] if cut is None else [cut]
        if not found:
            return None
        begin = np.cumsum([0, *(len(cut.columns) for cut in found)])
        entries = np.concatenate([cut.factors for cut in found])
        places = np.concatenate([cut.columns for cut in found])
        rows = sparse.csr_array((entries, places, begin), shape=(len(found), columns))
        return Separated(rows, np.array([cut.lower for cut in found]))

    @cached_property
    def windows(self) -> bool:
        """Whether some are asked for at any step of a window, not at that of a witness."""
        return any(bool((one.first < one.last).any()) for one in self.demands)

    @cached_property
    def _unrolled(self) -> dict[str | None, _Unrolled]:
        names = dict.fromkeys(one.capability for one in self.demands)
        horizon = self.network.horizon
        return {name: _unrolled(self.network.having(name), horizon) for name in names}


@dataclass(frozen=True, eq=False)
class _Flows:
    """What a solution sends along the edges, in whole small parts of an agent."""

    net: _Unrolled
    scale: float
    used: Ints
    along: Ints

    @classmethod
    def of(cls, net: _Unrolled, values: Floats) -> _Flows:
        along = values[net.column]
        scale = min(_FINE, _MOST / max(float(net.supply.sum()), 1.0))
        used = np.flatnonzero(along > _NOTHING)
        return cls(net, scale, used, np.ceil(along[used] * scale).astype(np.int64))


def _cut(flows: _Flows, demand: Visits, values: Floats) -> _Found | None:
    """The minimum cut of one demand, if what crosses it is less than what is asked for."""
    net, scale = flows.net, flows.scale
    part, members, amount = np.broadcast_arrays(*demand.terms)
    asked = demand.constant + np.bincount(part, amount * values[members], len(demand.first))
    asked = np.maximum(asked, 0.0)
    need = np.floor(asked * scale).astype(np.int64)
    count = len(net.nodes)
    states = np.array(demand.states)
    spans = zip(demand.first.tolist(), demand.last.tolist(), strict=True)
    inside = [net.at(states, *span) for span in spans]
    begin, end = count + len(need), count + len(need) + 1
    parts = count + np.arange(len(need))
    at = np.concatenate(inside)
    most = max(int(flows.along.sum() + net.supply.sum() * scale), 1)
    most = min(most, np.iinfo(np.int32).max)
    arcs = [
        (net.tail[flows.used], net.head[flows.used], flows.along),
        (np.full(len(net.starts), begin), net.starts, (net.supply * scale).astype(np.int64)),
        (at, np.repeat(parts, [len(nodes) for nodes in inside]), np.full(len(at), most)),
        (parts, np.full(len(parts), end), need),
    ]
    tail, head, capacity = (np.concatenate(each) for each in zip(*arcs, strict=True))
    graph = sparse.csr_array(
        (np.minimum(capacity, most).astype(np.int32), (tail, head)), shape=(end + 1, end + 1)
    )
    flow = maximum_flow(graph, begin, end)
    lack = need.sum() - flow.flow_value
    if lack <= _ENOUGH * scale:
        return None
    left = graph - flow.flow
    left.data = np.maximum(left.data, 0)
    left.eliminate_zeros()
    reaching = breadth_first_order(left.T.tocsr(), end, return_predecessors=False)
    within = np.zeros(end + 1, dtype=np.bool_)
    within[reaching] = True
    return _row(net, demand, within)


def _row(net: _Unrolled, demand: Visits, within: Bools) -> _Found:
    """The cut of a set of nodes, which holds all nodes of the parts that are in it."""
    count = len(net.nodes)
    asked = within[count : count + len(demand.first)]
    entering = net.column[within[net.head] & ~within[net.tail]]
    begun = float(net.supply[within[net.starts]].sum())
    part, members, amount = np.broadcast_arrays(*demand.terms)
    some = asked[part]
    zeros = np.zeros(len(entering), dtype=np.int64)
    terms = (zeros, entering, 1.0), (0, members[some], -amount[some])
    _, columns, factors = joined_terms(terms)
    return _Found(columns, factors, float(demand.constant[asked].sum()) - begun)
