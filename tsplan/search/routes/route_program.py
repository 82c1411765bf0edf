"""A bound by routes: the least cost of any agents who run all errands, each by a route of its own.

The program has a column for every route of one agent, and a row for every errand: who runs it
counts, and it needs so many. Its dual has a price for each errand, and routes are found when they
are needed: those that cost less than they are credited with (column generation, as for vehicles
with time windows: Desrochers, Desrosiers and Solomon, 1992). At any prices the needs at these,
less what all agents could be credited with beyond their cost, are a true bound (Lagrange): it is
counted in whole numbers. Prices are asked for between the best ones so far and the program's, which
steadies them (Wentges, 1997).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from scipy import sparse

from tsplan.clock import Clock
from tsplan.encode.flow_network import Network
from tsplan.milp.lp import LPResult, WarmLP
from tsplan.milp.model import INFINITY, Draft, Floats, Ints
from tsplan.search.routes.cheapest_routes import CheapestRoutes, Route
from tsplan.search.routes.errands import Errand
from tsplan.search.routes.rewards import Prices, Rewards
from tsplan.search.routes.route_graph import RouteGraph

SCALE = 2**12
"""Parts of one that prices are counted in."""

_WAYS = 3
_DEAR = 4  # times what any route costs: nobody pays more for one agent
_CALM = 0.7  # share of the best prices so far in those that are asked about
_USED = 1e-6  # routes used less than this are tolerance
_ROUNDS = 300  # of prices, for one set of memories


@dataclass(frozen=True, eq=False)
class Routed:
    """What a program has come to: a true `bound`, and how often each of its routes is used.

    `value` is that of the routes; the two differ by less than was asked for, if there was time.
    `prices` are what one agent more for each errand would cost.
    """

    bound: int
    value: float
    routes: tuple[Route, ...]
    used: Floats
    prices: Floats


@dataclass(eq=False)
class RouteProgram:
    """The program of the routes of a network past some errands, whose columns cost `vector`.

    What is kept from one call to the next makes it quicker: routes, prices, and what is remembered
    where.
    """

    network: Network
    vector: Floats
    errands: tuple[Errand, ...]
    clock: Clock
    parts: bool = True
    remembered: list[dict[int, list[int]]] = field(default_factory=list)
    pool: tuple[Route, ...] = ()
    _prices: Floats | None = field(default=None, init=False)
    _graphs: dict[int, RouteGraph] = field(default_factory=dict, init=False)

    def __post_init__(self) -> None:
        if not self.remembered:
            self.remembered = [{} for _ in self.network.classes]

    # --- the parts of it -------------------------------------------------------------------------

    @property
    def size(self) -> int:
        """How many values the routes of all classes have, over all steps."""
        steps = self.network.horizon + 1
        return sum(int(self._graph(g).base[-1]) * steps for g in range(len(self.network.classes)))

    @property
    def widest(self) -> int:
        """The most errands that are remembered at a place for themselves."""
        graphs = (self._graph(group) for group in range(len(self.network.classes)))
        return max((len(own) for graph in graphs for own in graph.own), default=0)

    def flows(self, routed: Routed) -> Floats | None:
        """The columns of the network with all agents on routes; None where some are fractions."""
        found = np.zeros(len(self.vector))
        idle = [list(starts) for starts in self._starts()]
        for place in np.flatnonzero(routed.used > _USED).tolist():
            route, used = routed.routes[place], float(routed.used[place])
            found[route.columns] += used
            idle[route.group][route.start] -= used
        for group, starts in enumerate(idle):
            for start, agents in enumerate(starts):
                waits = self._graph(group).waiting(start)
                if waits is None:
                    return None
                found[waits] += agents
        whole = np.round(found)
        return whole if np.abs(found - whole).max(initial=0.0) < _USED * 10 else None

    def _graph(self, group: int) -> RouteGraph:
        if group not in self._graphs:
            item = self.network.classes[group]
            own = {k: errand for k, errand in enumerate(self.errands) if group in errand.classes}
            self._graphs[group] = RouteGraph.of(
                item, self.network.horizon, own, self.remembered[group]
            )
        return self._graphs[group]

    def _cheapest(self) -> list[CheapestRoutes]:
        found = []
        for group in range(len(self.network.classes)):
            own = {k: errand for k, errand in enumerate(self.errands) if group in errand.classes}
            graph = self._graph(group)
            rewards = Rewards(graph, own, len(self.errands), parts=self.parts)
            found.append(CheapestRoutes(group, graph, rewards, self.vector, SCALE))
        return found

    def narrowed(
        self,
        errands: tuple[Errand, ...],
        routes: Sequence[Route],
        before: Sequence[Errand] = (),
    ) -> None:
        """The same errands in other windows; only routes that run them whole are credited.

        Routes keep what they are credited with for errands that are the same as `before`.
        """
        same = {
            k for k, pair in enumerate(zip(errands, before, strict=False)) if pair[0] is pair[1]
        }
        self.errands = errands
        self.pool = tuple(self._credited(route, same) for route in routes)

    def _credited(self, route: Route, same: Collection[int]) -> Route:
        given = {key: part for key, part in route.credits.items() if key[1] in same}
        for number, errand in enumerate(self.errands):
            if number not in same and route.group in errand.classes and self._runs(route, errand):
                given |= {(way, number): 1.0 for way in range(_WAYS)}
        return replace(route, credits=given)

    def _runs(self, route: Route, errand: Errand) -> bool:
        """Whether a route stands at an errand's states for its whole stay."""
        return any(
            node in errand.states and _overlap(errand, since, until) >= errand.stay
            for node, since, until in route.stays
        )

    # --- column generation -----------------------------------------------------------------------

    def solve(self, near: float, enough: float = np.inf) -> Routed:
        """The program's value and bound, which are less than `near` apart if there is time.

        Routes may run errands again that are forgotten on the way. A bound that is `enough` need
        not become better.
        """
        cheapest = self._cheapest()
        lp, routes = self._dual(), list(self.pool)
        self._add(lp, routes)
        best, value, rounds = -np.inf, np.inf, 0
        while not self.clock.over and rounds < _ROUNDS:
            result = lp.solve(time_limit=self.clock.left)
            if result.status != "optimal" or result.values is None:
                break
            value = -result.objective
            if value - best < near or best >= enough:
                break
            found, bound = self._priced(cheapest, result, best)
            best = max(best, bound)
            if not found:
                break
            self._add(lp, found)
            routes += found
            rounds += 1
        result = lp.solve(time_limit=self.clock.left)
        duals = result.row_duals
        used = np.zeros(len(routes)) if duals is None else np.abs(duals[: len(routes)])
        count = len(self.errands)
        prices = np.zeros(_WAYS * count) if result.values is None else result.values
        paid = prices[: _WAYS * count].reshape(_WAYS, count).sum(axis=0)
        return Routed(int(max(best, 0)), value, tuple(routes), used, paid)

    def _priced(
        self, cheapest: Sequence[CheapestRoutes], result: LPResult, best: float
    ) -> tuple[list[Route], float]:
        """Routes that are worth more than they cost at the program's prices, and the best bound."""
        values = result.values
        assert values is not None
        highest = best
        calm = (0.0,) if self._prices is None else (_CALM, 0.0)
        for share in calm:
            prices = values if self._prices is None else share * self._prices + (1 - share) * values
            found, bound = self._asked(cheapest, prices, values)
            if bound > highest or self._prices is None:
                highest, self._prices = max(bound, highest), prices
            if found:
                return found, highest
        return [], highest

    def _asked(
        self, cheapest: Sequence[CheapestRoutes], wanted: Floats, values: Floats
    ) -> tuple[list[Route], float]:
        """The cheapest routes at some prices, as far as the program lacks them, and a bound."""
        prices, fees = self._whole(wanted)
        need = np.array([errand.amount for errand in self.errands])
        bound = sum(int(need @ price) for price in prices)
        found = []
        begin = 0
        for routes in cheapest:
            starts = routes.graph.starts
            own = fees[begin : begin + len(starts)]
            begin += len(starts)
            solved = routes.solve(prices, own)
            agents = np.array([agents for _, agents in starts], dtype=np.int64)
            bound += int(agents.sum()) * solved.least - int(agents @ own)
            found += [route for route in solved.below(0) if self._lacking(route, values)]
        return found, float(-(-bound // SCALE))

    def _whole(self, prices: Floats) -> tuple[Prices, Ints]:
        """Prices in whole parts, those of all steps multiples of the stay, and the starts' fees."""
        count = len(self.errands)
        stay = np.array([errand.stay for errand in self.errands], dtype=np.int64)
        first, last, each = np.floor(prices[: _WAYS * count] * SCALE).reshape(_WAYS, count)
        whole = each.astype(np.int64) // stay * stay
        fees = np.ceil(prices[_WAYS * count :] * SCALE).astype(np.int64)
        return Prices(first.astype(np.int64), last.astype(np.int64), whole), fees

    def _lacking(self, route: Route, values: Floats) -> bool:
        """Whether the program's prices are too high for a route."""
        columns, factors = self._terms(route)
        return float(factors @ values[columns]) > route.cost + _USED

    # --- the dual program ------------------------------------------------------------------------

    def _dual(self) -> WarmLP:
        """Prices of errands and fees of starts, without any routes."""
        need = np.array([errand.amount for errand in self.errands], dtype=np.float64)
        # who is there for the only step of a stay is there for all of it
        several = np.array([self.parts and errand.stay > 1 for errand in self.errands])
        agents = np.array([a for item in self._starts() for a in item], dtype=np.float64)
        draft = Draft()
        dear = self._dear
        upper = dear * several, dear * several, np.full(len(need), dear)
        prices = draft.columns(_WAYS * len(need), upper=np.concatenate(upper))
        fees = draft.columns(len(agents), upper=_DEAR * dear * max(len(need), 1))
        vector = np.zeros(draft.column_count)
        vector[prices], vector[fees] = -np.tile(need, _WAYS), agents
        return WarmLP(draft.build().with_objective(vector), self.clock.stop)

    def _starts(self) -> list[list[float]]:
        """How many agents of each class begin at each of its starts."""
        graphs = [item.graph for item in self.network.classes]
        return [graph.start[graph.start > 0].tolist() for graph in graphs]

    @property
    def _dear(self) -> float:
        """More than one agent costs for anything that has a way at all."""
        most = 1.0
        for item in self.network.classes:
            edge, _, column = item.unrolled()
            if len(column):
                most = max(most, float((self.vector[column] / item.graph.duration[edge]).max()))
        return _DEAR * most * max(self.network.horizon, 1)

    def _add(self, lp: WarmLP, routes: Sequence[Route]) -> None:
        """What routes are credited with is at most what they cost."""
        if not routes:
            return
        terms = [self._terms(route) for route in routes]
        begin = np.cumsum([0, *(len(columns) for columns, _ in terms)])
        count = _WAYS * len(self.errands) + sum(map(len, self._starts()))
        rows = sparse.csr_array(
            (
                np.concatenate([factors for _, factors in terms]),
                np.concatenate([columns for columns, _ in terms]),
                begin,
            ),
            shape=(len(routes), count),
        )
        cost = np.array([float(route.cost) for route in routes])
        lp.add_rows(rows, np.full(len(routes), -INFINITY), cost)

    def _terms(self, route: Route) -> tuple[Ints, Floats]:
        count = len(self.errands)
        before = sum(len(starts) for starts in self._starts()[: route.group])
        earned = [way * count + number for way, number in route.credits]
        columns = np.array([*earned, _WAYS * count + before + route.start], dtype=np.int64)
        return columns, np.array([*route.credits.values(), -1.0])

    # --- memories --------------------------------------------------------------------------------

    def remember(self, routed: Routed, most: int) -> bool:
        """Remember more where routes that are used run errands again; whether there are any.

        There are no more than `most` values afterwards, or nothing more is remembered.
        """
        before = [{node: list(own) for node, own in kept.items()} for kept in self.remembered]
        grown = False
        for route, used in zip(routed.routes, routed.used.tolist(), strict=True):
            for number in route.repeats if used > _USED else ():
                grown = self._between(route, number) or grown
        if grown:
            self._graphs.clear()
            if self.size > most:
                self.remembered, grown = before, False
                self._graphs.clear()
        self.pool = tuple(route for route in routed.routes if not route.repeats)
        return grown

    def _between(self, route: Route, number: int) -> bool:
        """Remember an errand wherever a route goes between two times it runs it."""
        errand, kept = self.errands[number], self.remembered[route.group]
        at = [
            place
            for place, (node, since, until) in enumerate(route.stays)
            if node in errand.states and _overlap(errand, since, until) > 0
        ]
        grown = False
        for node, _, _ in route.stays[at[0] : at[-1]]:
            own = kept.setdefault(node, [])
            if node not in errand.states and number not in own:
                own.append(number)
                grown = True
        return grown


def _overlap(errand: Errand, since: int, until: int) -> int:
    """For how many steps of an errand's window somebody stands there."""
    return min(until, errand.last) - max(since, errand.first) + 1
