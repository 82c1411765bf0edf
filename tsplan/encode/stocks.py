"""Stocks, what is carried between them, and what executions take from them.

For every resource: a column for what stays at a state from a step to the next, and one for what is
carried along an edge entered at a step. What comes to a state, what is carried away, what is used
up and what stays balance at every step. Robots that enter an edge at one step share what is carried
along it, so there is one column for all classes that take the edge in the same time: those with a
compartment for each resource, and those with one hold, apart. Of whole pieces a robot carries a
whole number, so their sum is at most the sum of what each robot carries of them; any amounts of
others fill what room is left.

Columns begin when some of a resource can be at a state, and end when it can be of use no more.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.atom_encoders import Executed
from tsplan.encode.executions import (
    Executions,
    earliest,
    executed_at,
    latest,
)
from tsplan.encode.flow_network import Network
from tsplan.encode.lanes import Lanes, LaneTable, joined, lane_table
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.mission import Mission, Resource

PART = "stocks"
"""The name of this part among those of a model."""


@dataclass(frozen=True, eq=False)
class Loads:
    """What is carried of a resource: a column for each of some lanes."""

    resource: Resource
    lanes: Lanes
    columns: Ints


@dataclass(frozen=True, eq=False)
class Stock:
    """What stays of a resource at states: `columns[place[state] + step - first[state]]`."""

    resource: Resource
    first: Ints
    last: Ints
    place: Ints
    columns: Ints

    def at(self, states: Ints | int, steps: Ints | int) -> Ints:
        """The columns of states at steps."""
        return np.asarray(self.columns[self.place[states] + steps - self.first[states]])

    def has(self, state: int, step: int) -> bool:
        """Whether there is a column."""
        return bool(self.first[state] <= step <= self.last[state])


@dataclass(frozen=True, eq=False)
class Stocks:
    """The columns of executions, stocks and what is carried, and what they mean."""

    executions: Executions
    stocks: tuple[Stock, ...]
    loads: tuple[Loads, ...]
    reserve: int = -1

    @property
    def pieces(self) -> Ints:
        """The columns of what is carried in whole pieces."""
        return joined(load.columns for load in self.loads if load.resource.indivisible)

    def least_left(self, values: Floats) -> float:
        """What is left at the executions of a point beside what they need; infinite without any."""
        done = executed_at(self.executions, values)
        left = [np.inf]
        for stock in self.stocks:
            name, consumed = stock.resource.name, stock.resource.consumed
            needed = [
                (state, step, task.last, dict(task.resources)[name])
                for task, state, step in done
                if dict(task.resources).get(name)
            ]
            for state, step, *_ in needed:
                here = float(values[stock.at(state, step)].sum())
                for load in self.loads:
                    lanes = load.lanes
                    if load.resource is stock.resource:
                        going = (lanes.tail == state) & (lanes.step == step)
                        here += float(values[load.columns[going]].sum())
                busy = (
                    amount
                    for other, begun, last, amount in needed
                    if other == state and begun <= step <= begun + last
                )
                left.append(here - (0.0 if consumed else sum(busy)))
        least = float(min(left))
        return float(round(least)) if self.whole and np.isfinite(least) else least

    @property
    def whole(self) -> bool:
        """Whether all that is used comes in whole pieces."""
        return all(stock.resource.indivisible for stock in self.stocks)


def stocks(
    mission: Mission,
    executions: Executions,
    network: Network,
    arrays: MapArrays,
    draft: Draft,
    *,
    straight: bool = False,
) -> Stocks:
    """The columns and rows of stocks for the executions that a model has.

    With `straight` nothing is laid down but where it began or where it is wanted, a restriction.
    """
    return _StockRows(mission, executions, network, arrays, draft, straight=straight).stocks


class _StockRows:
    """Writes the rows of one model."""

    def __init__(
        self,
        mission: Mission,
        executions: Executions,
        network: Network,
        arrays: MapArrays,
        draft: Draft,
        *,
        straight: bool,
    ) -> None:
        self._straight = straight
        self._executions = executions
        self._network = network
        self._arrays = arrays
        self._draft = draft
        self._rooms: list[tuple[Lanes, Ints, Ints, Ints]] = []
        lanes = [lane_table(network, held=held) for held in (False, True)]
        used = [item for item in mission.resources if self._needs(item)]
        self._stocks = {item.name: stock for item in used if (stock := self._stock(item))}
        self._loads: dict[tuple[str, bool], tuple[Loads, Ints]] = {}
        for item in used:
            for table in lanes:
                self._load(item, table)
        self._capacities(lanes)
        for stock in self._stocks.values():
            self._balance(stock)
        for item in used:
            self._tools(item)
        reserve = self._reserve() if "reserve" in mission.objective else -1
        loads = tuple(load for load, _ in self._loads.values())
        self.stocks = Stocks(executions, tuple(self._stocks.values()), loads, reserve)

    def _needs(self, resource: Resource) -> dict[Executed, float]:
        """How much of a resource every execution needs, of those that need any."""
        amounts = ((bound, dict(bound.task.resources)) for bound in self._executions)
        return {bound: found[resource.name] for bound, found in amounts if found.get(resource.name)}

    # --- columns ---------------------------------------------------------------------------------

    def _stock(self, resource: Resource) -> Stock:
        """Columns of what stays, from when some can be there to when it is of no more use."""
        wanted: dict[int, int] = {}
        for bound in self._needs(resource):
            done = self._executions[bound].last
            done += 0 if resource.consumed else bound.task.last
            wanted[bound.state] = max(wanted.get(bound.state, 0), done)
        first = earliest(resource, self._network, self._arrays)
        last = latest(wanted, resource, self._network, self._arrays)
        if self._straight:
            begun = [self._arrays.number[state] for state, _, amount in resource.sources if amount]
            last[np.setdiff1d(np.arange(len(last)), [*wanted, *begun])] = -1
        spans = np.maximum(last - first + 1, 0)
        columns = self._draft.columns(int(spans.sum()), upper=float(resource.total))
        return Stock(resource, first, last, np.cumsum(spans) - spans, columns)

    def _load(self, resource: Resource, table: LaneTable) -> None:
        """Columns of what is carried along the lanes that lead to where it is of use."""
        stock, lanes = self._stocks[resource.name], table.lanes
        room = table.room(resource)
        useful = (stock.first[lanes.tail] <= lanes.step) & (lanes.step <= stock.last[lanes.tail])
        useful &= (lanes.end <= stock.last[lanes.head]) & (stock.first[lanes.head] <= lanes.end)
        places = np.flatnonzero(useful & (room > 0))
        columns = self._draft.columns(
            len(places), upper=float(resource.total), integer=resource.indivisible
        )
        made = Loads(resource, lanes.at(places), columns)
        self._loads[resource.name, lanes.held] = made, places

    # --- rows ------------------------------------------------------------------------------------

    def _capacities(self, tables: Sequence[LaneTable]) -> None:
        """What is carried is no more than the robots there can carry."""
        for table in tables:
            mine = [found for (_, held), found in self._loads.items() if held is table.lanes.held]
            if not table.lanes.held:
                for load, places in mine:
                    self._room(table, [(load, places)], [load.resource])
                continue
            self._room(table, mine, [load.resource for load, _ in mine])
            pieces = [found for found in mine if found[0].resource.indivisible]
            if table.parted and pieces:
                self._room(table, pieces, [load.resource for load, _ in pieces])

    def _room(
        self,
        table: LaneTable,
        loads: Sequence[tuple[Loads, Ints]],
        resources: Sequence[Resource],
    ) -> None:
        """Rows: what is carried of some resources along each lane, less the room there."""
        lanes = np.unique(joined(places for _, places in loads))
        if not len(lanes):
            return
        row = np.full(len(table.lanes.step), -1)
        row[lanes] = np.arange(len(lanes))
        pieces = all(resource.indivisible for resource in resources)
        most = table.rooms_of(resources[0] if not table.lanes.held else None, pieces=pieces)
        here = row[table.lane] >= 0
        terms = [(row[places], load.columns, -1.0) for load, places in loads]
        robots = (row[table.lane[here]], table.column[here], most[table.group[here]])
        self._draft.sums(robots, *terms, count=len(lanes), kind="cargo")

    def _balance(self, stock: Stock) -> None:
        """What stays, less what stayed and came, and all that goes: nothing but the beginning."""
        resource = stock.resource
        spans = np.maximum(stock.last - stock.first + 1, 0)
        total = int(spans.sum())
        every = np.arange(total)
        later = np.ones(total, dtype=np.bool_)
        later[stock.place[spans > 0]] = False
        terms: list[tuple[Ints, Ints, float]] = [
            (every, stock.columns, 1.0),
            (every[later], stock.columns[every[later] - 1], -1.0),
        ]
        row = stock.place - stock.first
        for load in self._loads_of(resource):
            lanes = load.lanes
            terms.append((row[lanes.tail] + lanes.step, load.columns, 1.0))
            terms.append((row[lanes.head] + lanes.end, load.columns, -1.0))
        if resource.consumed:
            for bound, amount in self._needs(resource).items():
                steps, columns = self._able(bound, stock)
                terms.append((row[bound.state] + steps, columns, amount))
        begun = np.zeros(total)
        for name, step, amount in resource.sources:
            state = self._arrays.number[name]
            if amount and stock.has(state, step):
                begun[row[state] + step] += amount
        self._draft.sums(*terms, lower=begun, upper=begun, kind="stock")

    def _able(self, bound: Executed, stock: Stock) -> tuple[Ints, Ints]:
        """The steps at which a task may find some of a resource; at others it is not executed."""
        timed = self._executions[bound]
        steps = np.arange(timed.first, timed.last + 1)
        able = steps >= stock.first[bound.state]
        if not able.all():
            never = timed.columns[~able]
            self._draft.sums((0, never, 1.0), lower=0.0, upper=0.0, kind="executed")
        return steps[able], timed.columns[able]

    def _loads_of(self, resource: Resource) -> list[Loads]:
        return [load for (name, _), (load, _) in self._loads.items() if name == resource.name]

    def _tools(self, resource: Resource) -> None:
        """At every step as many tools lie at a state as the executions there use."""
        if resource.consumed:
            return
        stock = self._stocks[resource.name]
        for bound in self._needs(resource):
            self._able(bound, stock)
        for state, step in self._busy(resource):
            self._draft.sums(
                *self._lying(stock, state, step), *self._used(resource, state, step), kind="tool"
            )

    def _busy(self, resource: Resource) -> list[tuple[int, int]]:
        """The states and steps at which a tool may be in use and lie."""
        stock = self._stocks[resource.name]
        found = {
            (bound.state, step)
            for bound in self._needs(resource)
            for timed in [self._executions[bound]]
            for step in range(timed.first, timed.last + bound.task.last + 1)
        }
        return sorted(node for node in found if stock.has(*node))

    def _used(self, resource: Resource, state: int, step: int) -> list[tuple[int, Ints, float]]:
        """Terms, taken off, of the tools in use at a state and step."""
        found = []
        for bound, amount in self._needs(resource).items():
            timed = self._executions[bound]
            if bound.state == state:
                begun = max(step - bound.task.last - timed.first, 0)
                found.append((0, timed.columns[begun : max(step - timed.first + 1, 0)], -amount))
        return found

    def _lying(self, stock: Stock, state: int, step: int) -> list[tuple[int, Ints, float]]:
        """Terms of what lies at a state and step when everything used up there is gone."""
        terms = [(0, np.atleast_1d(stock.at(state, step)), 1.0)]
        for load in self._loads_of(stock.resource):
            going = (load.lanes.tail == state) & (load.lanes.step == step)
            terms.append((0, load.columns[going], 1.0))
        return terms

    def _reserve(self) -> int:
        """A column that is at most what is left beside the needs of every execution."""
        used = [stock.resource for stock in self._stocks.values()]
        most = float(max((item.total for item in used), default=0)) + 1.0
        whole = all(item.indivisible for item in used)
        column = int(self._draft.columns(1, upper=most, integer=whole)[0])
        for item in used:
            stock = self._stocks[item.name]
            for bound in self._needs(item):
                for step, executed in zip(*self._able(bound, stock), strict=True):
                    terms = self._lying(stock, bound.state, int(step))
                    if not item.consumed:
                        terms += self._used(item, bound.state, int(step))
                    less = (0, [column, int(executed)], [-1.0, -most])
                    self._draft.sums(*terms, less, lower=-most, kind="reserve")
        return column
