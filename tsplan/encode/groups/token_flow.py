"""The fewest splits that a mission of swarms can do with: tokens on a reduced map.

Give every group at step 0 as many tokens as it will have parts. Where a group splits each part
takes some of its tokens, one at least; where groups merge one token is kept and the others vanish.
Wherever a group is there is a token then, and there are no more tokens than groups at step 0 and
splits together. Followed only between the states that matter, by the quickest way, tokens obey the
rows written here, so the fewest of them are a bound on the number of splits, and where no tokens
will do there is no plan. Nothing is known here of the limits on sub-swarms, of upper bounds on
counts, of sizes.

It is a flow with few rows, whose LPs take milliseconds where those of `groups` take half a second,
and a plan of as few splits is often found near the ways that the tokens take.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from tsplan.encode.agent_classes import map_arrays
from tsplan.encode.flow_network import ClassColumns, ClassGraph, laid_out
from tsplan.encode.groups.group_demands import (
    group_network,
    most_groups,
    presence_rows,
    split_rows,
    swarm_graphs,
    witnesses_of,
)
from tsplan.encode.map_reduction import Interest, Reduced, reduce, whole
from tsplan.encode.memory import Watch
from tsplan.logic import Count, walk
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import INFINITY, Bools, Draft, Floats, Ints, Model
from tsplan.mission import Mission
from tsplan.search.branch_and_bound import Grown, Tree, Witnessing
from tsplan.search.clock import Clock
from tsplan.search.target import Target

_SOME = 1e-6
_SPLIT = 1e4  # steps of moving that are worth a split


@dataclass(frozen=True, eq=False)
class Tokens:
    """The model of tokens; it minimises how many are added."""

    model: Model
    witnessing: Witnessing
    refuted: bool
    _entered: tuple[ClassColumns, ...]
    _reduced: tuple[Reduced, ...]
    _graphs: tuple[ClassGraph, ...]

    def fewest(self, clock: Clock) -> Grown:
        """The fewest tokens added to the starts, or a bound on them; infinite if none will do."""
        if self.refuted:
            return Grown(None, np.inf, done=True)
        lp = WarmLP(self.model, stop=clock.stop)
        root = lp.solve(time_limit=clock.left)
        if root.status != "optimal":
            impossible = root.status == "infeasible"
            return Grown(None, np.inf if impossible else 0.0, done=impossible)
        target = Target(self.model.objective)
        grown = Tree(lp, self.witnessing, target, root).grow(clock)
        return replace(grown, bound=target.proven(grown.bound))

    def whole(self, values: Floats, solve: Callable[[Model], Floats | None]) -> Floats | None:
        """Whole tokens with the witnesses of a point, that move as little as they can."""
        model, fixed = self.model, self.witnessing.indicators
        lower, upper = model.lower.copy(), model.upper.copy()
        lower[fixed] = upper[fixed] = np.round(values[fixed])
        price = _SPLIT * model.objective
        for columns in self._entered:
            edge, _, column = columns.unrolled()
            price[column] = (columns.graph.duration * ~columns.graph.wait)[edge]
        return solve(model.with_bounds(lower, upper).with_objective(price))

    def tracks(self, values: Floats) -> list[Track]:
        """The edges of each swarm's map that its tokens take, and when."""
        tracks = []
        for columns, reduced, graph in zip(self._entered, self._reduced, self._graphs, strict=True):
            edge, step, column = columns.unrolled()
            taken = np.flatnonzero(values[column] > _SOME)
            paths = [reduced.paths[short] for short in edge[taken].tolist()]
            lasting = [graph.duration[path] for path in paths]
            after = [np.cumsum(each) - each for each in lasting]
            begun = [when + each for when, each in zip(step[taken].tolist(), after, strict=True)]
            empty = np.empty(0, dtype=np.int64)
            tracks.append(Track(np.concatenate([*paths, empty]), np.concatenate([*begun, empty])))
        return tracks


class Track(NamedTuple):
    """Edges and the steps at which they are entered."""

    edge: Ints
    step: Ints


def tokens(mission: Mission, clock: Clock | None = None) -> Tokens:
    """The model of tokens of a mission of swarms; raises Halted when the clock is over."""
    clock = clock or Clock()
    draft = Draft(Watch(clock))
    most = most_groups(mission)
    graphs = swarm_graphs(mission)
    entered, reduced, added = [], [], []
    for number, graph in enumerate(graphs):
        short = _shortened(graph, _relevant(mission, number), mission.horizon, clock)
        columns = laid_out(short.graph, mission.horizon, draft, upper=INFINITY)
        added.append(_flow(columns, mission.horizon, draft))
        entered.append(columns)
        reduced.append(short)
    witnesses = witnesses_of(mission, entered, draft)
    presence_rows(group_network(entered, most, mission.horizon), witnesses, draft)
    births = np.concatenate(added)
    starts = sum(int((graph.start > 0).sum()) for graph in graphs)
    split_rows((births, np.ones(len(births))), starts, witnesses, draft)
    model = draft.build()
    price = np.zeros(model.size.columns)
    price[births] = 1.0
    choices = witnesses.choices
    return Tokens(
        model.with_objective(price),
        Witnessing(np.array(choices.columns, dtype=np.int64), tuple(choices.groups)),
        choices.refuted,
        tuple(entered),
        tuple(reduced),
        tuple(graphs),
    )


def _shortened(graph: ClassGraph, relevant: Bools, horizon: int, clock: Clock) -> Reduced:
    """The quickest ways between some states; upper bounds on counts are not looked at."""
    interest = Interest(relevant, np.zeros_like(relevant))
    return reduce(graph, interest, horizon, clock) or whole(graph)


def _relevant(mission: Mission, number: int) -> Bools:
    """The states at which the formula wants agents of a swarm."""
    arrays = map_arrays(mission.system)
    able = mission.team[number].capabilities
    relevant = np.zeros(len(arrays.names), dtype=np.bool_)
    for node in walk(mission.goal):
        if not isinstance(node, Count) or node.relation == "<=":
            continue
        if node.capability is None or node.capability in able:
            relevant[arrays.states_with(mission.system, node.label)] = True
    return relevant


def _flow(columns: ClassColumns, horizon: int, draft: Draft) -> Ints:
    """Tokens that leave a state have come or begin there; columns of those added to the starts."""
    graph = columns.graph
    spans = np.maximum(horizon - columns.arrival, 0)
    row_of = np.cumsum(spans) - spans - columns.arrival
    edge, step, column = columns.unrolled()
    end = step + graph.duration[edge]
    inside = end < horizon
    starts = np.flatnonzero(graph.start)
    added = draft.columns(len(starts), upper=INFINITY, integer=True)
    if horizon == 0:
        return added
    begun = np.zeros(int(spans.sum()))
    begun[row_of[starts]] = 1.0
    leaving, coming = row_of[graph.tail[edge]] + step, (row_of[graph.head[edge]] + end)[inside]
    draft.rows(
        np.concatenate([leaving, coming, row_of[starts]]),
        np.concatenate([column, column[inside], added]),
        np.concatenate([np.ones(len(column)), -np.ones(len(coming) + len(starts))]),
        lower=-INFINITY,
        upper=begun,
        kind="tokens",
    )
    return added
