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

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.count_atoms import watched_states
from tsplan.encode.encoded import Setting
from tsplan.encode.flow_network import Network, balance, laid_out
from tsplan.encode.groups.group_demands import (
    group_network,
    most_groups,
    only_of,
    presence_rows,
    split_rows,
)
from tsplan.encode.map_reduction import Interest, Reduced, reduce, whole
from tsplan.encode.memory import Watch
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.witness import WitnessEncoder
from tsplan.milp.model import INFINITY, Draft, Floats, Ints, Model

_SOME = 1e-6


@dataclass(frozen=True, eq=False)
class Tokens:
    """The model of tokens; it minimises how many are added to the starts.

    `indicators` and `choices` are the columns of the logic, as in `Encoded`.
    """

    model: Model
    indicators: Ints
    choices: tuple[Ints, ...]
    refuted: bool
    _entered: tuple[ClassColumns, ...]
    _reduced: tuple[Reduced, ...]
    _graphs: tuple[ClassGraph, ...]

    def moving(self) -> Floats:
        """How many steps each column moves; waits cost nothing."""
        price = np.zeros(self.model.size.columns)
        for columns in self._entered:
            columns.price(price, columns.graph.duration * ~columns.graph.wait)
        return price

    def tracks(self, values: Floats) -> list[Track]:
        """The edges of each swarm's map that its tokens take, and when."""
        tracks = []
        for columns, reduced, graph in zip(self._entered, self._reduced, self._graphs, strict=True):
            edge, step, column = columns.unrolled()
            taken = np.flatnonzero(values[column] > _SOME)
            tracks.append(track_of(reduced, graph, edge[taken], step[taken]))
        return tracks


class Track(NamedTuple):
    """Edges and the steps at which they are entered."""

    edge: Ints
    step: Ints


def track_of(reduced: Reduced, graph: ClassGraph, edge: Ints, step: Ints) -> Track:
    """The edges of a map that edges of its reduction stand for, entered at some steps."""
    paths = [reduced.paths[short] for short in edge.tolist()]
    lasting = [graph.duration[path] for path in paths]
    after = [np.cumsum(each) - each for each in lasting]
    begun = [when + each for when, each in zip(step.tolist(), after, strict=True)]
    empty = np.empty(0, dtype=np.int64)
    return Track(np.concatenate([*paths, empty]), np.concatenate([*begun, empty]))


def tokens(setting: Setting) -> Tokens:
    """The model of tokens of the swarms of a setting; raises Halted when its clock is over."""
    draft = Draft(Watch(setting.clock))
    swarms = [item for item in setting.classes if item.bounds is not None]
    graphs = tuple(item.graph for item in swarms)
    reduced = tuple(_shortened(setting, item) for item in swarms)
    entered, added = [], []
    for short in reduced:
        columns = laid_out(short.graph, setting.horizon, draft, upper=INFINITY)
        added.append(_flow(columns, setting.horizon, draft))
        entered.append(columns)
    robots = _robots(setting)
    network = Network((*entered, *robots.classes), setting.horizon)
    encoder = WitnessEncoder(draft, OptimisticBound(setting.goal, setting.atoms(network)))
    witnesses = only_of(encoder.encode(setting.goal), robots)
    most = [
        most_groups(item.graph.agents, item.bounds, setting.together)
        for item in swarms
        if item.bounds is not None
    ]
    presence_rows(group_network(entered, most, Network((), setting.horizon)), witnesses, draft)
    births = np.concatenate(added)
    starts = sum(int((graph.start > 0).sum()) for graph in graphs)
    split_rows((births, np.ones(len(births))), starts, witnesses, draft)
    model = draft.build()
    price = np.zeros(model.size.columns)
    price[births] = 1.0
    choices = witnesses.choices
    return Tokens(
        model.with_objective(price),
        np.array(choices.columns, dtype=np.int64),
        tuple(choices.groups),
        choices.refuted,
        tuple(entered),
        reduced,
        graphs,
    )


def _robots(setting: Setting) -> Network:
    """Where those that move one by one can be when; no columns of the model of tokens."""
    scratch = Draft(Watch(setting.clock))
    laid: Sequence[ClassColumns] = [
        laid_out(short.graph, setting.horizon, scratch, upper=1.0)
        for item, short in zip(setting.classes, setting.reduced, strict=True)
        if item.bounds is None
    ]
    return Network(tuple(laid), setting.horizon)


def _shortened(setting: Setting, item: AgentClass) -> Reduced:
    """The quickest ways between the states at which the formula wants agents of a swarm.

    Upper bounds on counts are not looked at.
    """
    system, able = setting.mission.system, item.graph.capabilities
    wanted, _ = watched_states(setting.goal, able, system, setting.arrays)
    none = np.zeros_like(wanted)
    unwatched = np.zeros(len(item.graph.tail), dtype=np.bool_)
    interest = Interest(wanted, limited=none, narrow=none, watched=unwatched)
    return reduce(item.graph, interest, setting.horizon, setting.clock) or whole(item.graph)


def _flow(columns: ClassColumns, horizon: int, draft: Draft) -> Ints:
    """Tokens that leave a state have come or begin there; columns of those added to the starts."""
    starts = np.flatnonzero(columns.graph.start)
    added = draft.columns(len(starts), upper=INFINITY, integer=True)
    if horizon == 0:
        return added
    kept = balance(columns, horizon)
    begun = np.zeros(kept.total)
    begun[kept.row_of[starts]] = 1.0
    born = kept.row_of[starts], added, -1.0
    moved = kept.rows, kept.columns, kept.values
    draft.sums(moved, born, lower=-INFINITY, upper=begun, kind="tokens")
    return added
