"""What must be moved whatever the steps: a relaxation that forgets when anything happens.

How many agents take an edge at all, and how much of each resource is carried along it at all, obey
the same balances as at every single step: from a state no more agents leave than begin there or
come, what is used up lies there or comes, and robots carry no more than they can. What a formula
asks for in any case says what must come where. The program is as small as the map, so it bounds
missions whose whole linear program takes too long; and it is one of whole agents.

A flow over time whose steps are added up is a static flow: Ford and Fulkerson, "Constructing
maximal dynamic flows from static flows", Operations Research 6, 1958.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import singledispatch

import numpy as np

from tsplan.encode.atom_encoders import Bound, Executed
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.encoded import Encoded
from tsplan.encode.lanes import LaneTable, lane_table
from tsplan.encode.stocks import PART, Loads, Stocks
from tsplan.logic import (
    Always,
    And,
    Constant,
    Count,
    Eventually,
    Execution,
    Formula,
    Known,
    Or,
    Release,
    Until,
)
from tsplan.milp.model import Draft, Floats, Ints, Model
from tsplan.mission import Resource

Needed = Mapping[Formula, int]
"""Atoms, and at how many steps each must hold at least."""


def still_model(encoded: Encoded, prices: Floats) -> Model | None:
    """A program whose least value is at most that of `prices @ x` at every point x of a model.

    None where there are no resources, or where some price or column may be negative.
    """
    stocks: Stocks | None = encoded.own_columns.get(PART)
    if stocks is None or (prices < 0).any() or (encoded.model.lower < 0).any():
        return None
    return _Still(encoded, stocks, prices).model


@singledispatch
def needed(node: Formula) -> Needed:
    """The atoms that hold somewhere wherever a positive formula holds, and at how many steps."""
    raise TypeError(f"what is needed in any case is not known of {type(node).__name__}")


@needed.register
def _(node: Count | Execution) -> Needed:
    return {node: 1}


@needed.register
def _(_node: Constant | Known | Release) -> Needed:
    return {}  # what is released need not hold for long, and nothing is said of it


@needed.register
def _(node: And) -> Needed:
    parts = [needed(child) for child in node.children]
    return {atom: max(p.get(atom, 0) for p in parts) for part in parts for atom in part}


@needed.register
def _(node: Or) -> Needed:
    first, *others = (needed(child) for child in node.children)
    found = {atom: min([many, *(o.get(atom, 0) for o in others)]) for atom, many in first.items()}
    return {atom: many for atom, many in found.items() if many}


@needed.register
def _(node: Eventually) -> Needed:
    return needed(node.child)


@needed.register
def _(node: Always) -> Needed:
    now = node.child.children if isinstance(node.child, And) else (node.child,)
    steps = node.high - node.low + 1
    return {a: max(many, steps) if a in now else many for a, many in needed(node.child).items()}


@needed.register
def _(node: Until) -> Needed:
    return needed(node.children[1])


@dataclass(frozen=True, eq=False)
class _Moves:
    """How many agents of a class take each of its edges."""

    item: ClassColumns
    edge: Ints
    column: Ints

    def ending(self, states: Sequence[int]) -> Ints:
        """The columns of those that come to some states from others."""
        graph = self.item.graph
        comes = np.isin(graph.head[self.edge], states) & ~np.isin(graph.tail[self.edge], states)
        return self.column[comes]


@dataclass(frozen=True, eq=False)
class _Carried:
    """How much of a resource is carried along each lane: its tail, head and duration."""

    load: Loads
    lane: Ints
    column: Ints


class _Still:
    """Makes the program of one model."""

    def __init__(self, encoded: Encoded, stocks: Stocks, prices: Floats) -> None:
        self._encoded = encoded
        self._draft = Draft()
        self._own: list[Floats] = []
        self._moves = [self._moved(item, prices) for item in encoded.network.classes]
        carried = [self._carried(load, prices) for load in stocks.loads]
        self._bounds = self._needed()
        self._staff()
        for stock in stocks.stocks:
            mine = [item for item in carried if item.load.resource is stock.resource]
            self._balance(stock.resource, mine)
        for held in (False, True):
            table = lane_table(encoded.network, held=held)
            self._room(table, [item for item in carried if item.load.lanes.held is held])
        made = self._draft.build()
        self.model = made.with_objective(np.concatenate([*self._own, np.empty(0)]))

    # --- columns -----------------------------------------------------------------------------

    def _columns(self, prices: Floats, *, integer: bool) -> Ints:
        self._own.append(prices)
        return self._draft.columns(len(prices), integer=integer)

    def _moved(self, item: ClassColumns, prices: Floats) -> _Moves:
        """A column for every edge that may be entered, at its least price, and the balances."""
        graph, (edge, _, column) = item.graph, item.unrolled()
        least = np.full(len(graph.tail), np.inf)
        np.minimum.at(least, edge, prices[column])
        used = np.flatnonzero(~graph.wait & np.isfinite(least))
        made = self._columns(least[used], integer=True)
        leaving, coming = (graph.tail[used], made, 1.0), (graph.head[used], made, -1.0)
        begun = graph.start.astype(np.float64)
        self._draft.sums(
            leaving, coming, lower=np.full(len(begun), -np.inf), upper=begun, kind="flow"
        )
        return _Moves(item, used, made)

    def _carried(self, load: Loads, prices: Floats) -> _Carried:
        lanes = load.lanes
        keys = np.stack([lanes.tail, lanes.head, lanes.duration])
        lane, place = np.unique(keys, axis=1, return_inverse=True)
        least = np.full(lane.shape[1], np.inf)
        np.minimum.at(least, place.reshape(-1), prices[load.columns])
        return _Carried(load, lane, self._columns(least, integer=load.resource.indivisible))

    # --- rows --------------------------------------------------------------------------------

    def _needed(self) -> list[tuple[Bound | Executed, int]]:
        """The bounds that must hold, and at how many steps."""
        setting = self._encoded.setting
        atoms = setting.atoms(self._encoded.network)
        found = []
        for atom, steps in needed(setting.goal).items():
            requirement = atoms.of(atom)[1] if atom in atoms else None
            if requirement is not None and (requirement.every or len(requirement.bounds) == 1):
                found += [(bound, steps) for bound in requirement.bounds]
        return found

    def _staff(self) -> None:
        """Who is asked for at a state begins there or comes."""
        network = self._encoded.network
        for bound, _ in self._bounds:
            if not isinstance(bound, Bound) or bound.upper:
                continue
            able = network.having(bound.capability)
            moves = [item for item in self._moves if item.item in able]
            states = list(bound.states)
            begun = sum(int(item.item.graph.start[states].sum()) for item in moves)
            coming = [(0, item.ending(states), 1.0) for item in moves]
            self._draft.sums(*coming, lower=float(bound.amount - begun), kind="staff")

    def _balance(self, resource: Resource, carried: Sequence[_Carried]) -> None:
        """What leaves a state or is used up there has been there or comes."""
        arrays = self._encoded.setting.arrays
        count = len(arrays.names)
        lying, used, lent = np.zeros((3, count))
        for name, _, amount in resource.sources:
            lying[arrays.number[name]] += amount
        for bound, steps in self._bounds:
            if isinstance(bound, Executed):
                amount = dict(bound.task.resources).get(resource.name, 0.0)
                used[bound.state] += amount * steps if resource.consumed else 0.0
                lent[bound.state] = max(lent[bound.state], amount)
        leaving = [(item.lane[0], item.column, 1.0) for item in carried]
        coming = [(item.lane[1], item.column, -1.0) for item in carried]
        none = np.full(count, -np.inf)
        self._draft.sums(*leaving, *coming, lower=none, upper=lying - used, kind="stock")
        if not resource.consumed:
            self._draft.sums(*coming, lower=none, upper=lying - lent, kind="tool")

    def _room(self, table: LaneTable, carried: Sequence[_Carried]) -> None:
        """What is carried along a lane is no more than those who take it can carry."""
        if not table.lanes.held:
            for item in carried:
                self._rows(table, [item], item.load.resource)
            return
        self._rows(table, carried, None)
        pieces = [item for item in carried if item.load.resource.indivisible]
        if table.parted:
            self._rows(table, pieces, None)

    def _rows(
        self, table: LaneTable, carried: Sequence[_Carried], resource: Resource | None
    ) -> None:
        if not carried:
            return
        pieces = all(item.load.resource.indivisible for item in carried)
        most = table.rooms_of(resource, pieces=pieces)
        row: dict[tuple[int, ...], int] = defaultdict(lambda: len(row))
        loads = [([row[key] for key in _keys(i.lane)], i.column, -1.0) for i in carried]
        robots = []
        for item, room in zip(self._moves, most.tolist(), strict=True):
            graph = item.item.graph
            edges = np.stack([graph.tail, graph.head, graph.duration])[:, item.edge]
            place = np.array([row.get(key, -1) for key in _keys(edges)], dtype=np.int64)
            if room and isinstance(graph.carries, tuple) is not table.lanes.held:
                robots.append((place[place >= 0], item.column[place >= 0], room))
        self._draft.sums(*loads, *robots, count=len(row), kind="cargo")


def _keys(lanes: Ints) -> list[tuple[int, ...]]:
    return [tuple(lane) for lane in lanes.T.tolist()]
