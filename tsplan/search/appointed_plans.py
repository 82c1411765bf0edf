"""Plans of agents that keep appointments: tours first, then ways with room for everybody.

Where a goal asks for agents at places and no more, who goes where is planned by tours, as if nobody
were in anybody's way, and single agents are led around each other then. Other tours may leave more
time for that, or need less, so they are begun with again and again. A bound comes from the routes
that single agents could have (`route_bound`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Setting
from tsplan.encode.priced_objectives import Priced
from tsplan.routing.appointments import Agenda
from tsplan.routing.calls import calls_of
from tsplan.routing.crowd import Room
from tsplan.routing.distances import Distances
from tsplan.routing.engagements import Engagements
from tsplan.routing.rerouting import CLEAR, Rerouting
from tsplan.routing.tours import TourPlanner, Tours
from tsplan.routing.walks import Walk, point_of
from tsplan.search.best_plan import BestPlan
from tsplan.search.effort import Effort
from tsplan.search.met_routes import Meeting, MetRoutes
from tsplan.search.route_bound import RouteBound, Windows, boundable
from tsplan.search.route_tree import RouteTree, highest

_SPARES = 0.3, 0.1, 0.0, 0.05, 0.2, 0.02  # how much longer ways are taken to be, by turns
_PATIENCE = 200  # tours in a row that are no shorter
_REPAIRS, _CHANGES = 400, 100  # changes of ways in a row that do not help
_STARTS = 6  # tours in a row that lead to no better plan, after which it ends
_SHORT = 0.1, 0.05, 0.02, 0.0  # the same where routes are just in time
_ABOUT = 6, 12, 24, 48  # steps about the times of the best plan in which better ones are looked for
_SLICE = 1.0  # seconds of changes, after which it is the turn of bounds
_CLOSE = 1e-6  # what is told apart
_LEAST, _TAKING = 10.0, 0.5  # seconds, or of the time so far, that ways for tours may take


@dataclass(eq=False)
class AppointedPlans:
    """Looks for plans of a problem whose goal is an agenda."""

    setting: Setting
    agenda: Agenda
    known: BestPlan
    effort: Effort
    seed: int = 0
    _number: int = field(default=0, init=False)
    _best: Rerouting | None = field(default=None, init=False)
    _owed: float = field(default=0.0, init=False)  # seconds of plans beyond those of bounds
    _since: float = field(default=0.0, init=False)

    def __post_init__(self) -> None:
        """Measure the map."""
        self._prices = self.known.prices()
        self._distances = Distances.of(self.setting, self.agenda, self._prices)
        self._room = dict(self.setting.arrays.capacity)
        self._routes: RouteBound | None = None
        self._bounds: Iterator[float] | None = None
        self._tree: RouteTree | None = None
        self._met: Windows | None = None  # in which routes have been chosen
        self._drawn = 0  # times that they have been, with other prices

    @property
    def bounding(self) -> bool:
        """Whether there is a plan, and a bound by routes."""
        return self._best is not None and self._routes is not None

    def search(self, clock: Clock, *, patient: bool = False) -> None:
        """Look for better plans and bounds until that leads nowhere, or else as long as it may."""
        idle = 0
        while not clock.over and not self.known.settled and (patient or idle < _STARTS):
            before = self.known.point
            if self._fresh:
                self._meet(clock)
            elif self._number % 2 and self._best is not None:
                self._improve(self._best, clock)
            elif self._number % 4 and self._tree is not None and self._best is not None:
                self._meet(clock)
            elif not self._begin(clock) or (self._best is None and self._number >= _STARTS):
                return
            self._number += 1
            idle = idle + 1 if self.known.point is before else 0

    # --- plans -----------------------------------------------------------------------------------

    def _begin(self, clock: Clock) -> bool:
        """Ways for other tours; False where nobody has time for any."""
        turn = self._number // 4 if self._best is not None else self._number
        spare, seed = _SPARES[turn % len(_SPARES)], self.seed + self._number
        planner = TourPlanner(self.agenda, self._distances, self._room, spare, seed)
        tours = planner.best(clock, _PATIENCE)
        times = None if tours is None else planner.times(tours)
        if tours is None or times is None:
            return spare > 0 or self._best is not None
        if self._routes is None and boundable(self.known.objectives, self._prices, self.agenda):
            self._bound_by(tours, clock)
        if self._best is None or tours.length < self._best.price:
            serving = (tours.serving[number] for number in range(len(times)))
            agents = (tuple(tuple(a for a, _ in group) for group in each) for each in serving)
            began = tuple(times[number] for number in range(len(times)))
            self._lead(Meeting(began, tuple(agents)), clock, seed)
        return True

    def _bound_by(self, tours: Tours, clock: Clock) -> None:
        """Begin with bounds by routes, some of which are those of tours."""
        self._routes = RouteBound(self.agenda, self._distances, self._room, self._unit)
        self._routes.begin_with(tours)
        self._tree = RouteTree(self._routes, Windows.of(self.agenda))
        near = RouteBound(self.agenda, self._distances, self._room, self._unit)
        near.begin_with(tours)
        self._near = MetRoutes(near, self.effort)
        trees = [self._tree]
        if calls_of(self.agenda, ends=False) != self._routes.calls:
            quick = RouteBound(self.agenda, self._distances, self._room, self._unit, ends=False)
            quick.begin_with(tours)
            trees.append(RouteTree(quick, self._tree.windows))
        self._bounds = highest([tree.raised(clock, self._enough) for tree in trees])

    @property
    def _fresh(self) -> bool:
        """Whether routes can meet in windows of which no use has been made."""
        return self._tree is not None and self._tree.met is not self._met

    def _meet(self, clock: Clock) -> None:
        """Ways along routes that a program of all of them knows, if they can meet."""
        assert self._tree is not None
        assert self._best is not None
        tree, fresh, engaged = self._tree, self._fresh, self._best.engaged
        self._drawn = 0 if fresh else self._drawn + 1
        self._met = tree.met
        if engaged is not None and not fresh and (self._drawn % 2 or tree.met is None):
            routes = self._near
            apart = _ABOUT[self._drawn // 2 % len(_ABOUT)]
            windows = routes.about(engaged.times, apart, clock, self._enough())
        else:
            routes = MetRoutes(tree.routes, self.effort)
            windows = tree.met or tree.windows
        chosen = routes.chosen(windows, clock, self._drawn)
        if chosen is None or routes.price(chosen) >= self._best.price:
            return
        for spare in _SHORT:
            meeting = routes.meeting(chosen, spare)
            if meeting is not None:
                self._lead(meeting, clock, self.seed + self._number)
                return

    def _lead(self, meeting: Meeting, clock: Clock, seed: int) -> None:
        """Lead agents around each other to where they are to meet."""
        ways = self._ways(meeting, seed)
        within = clock.within(max(_LEAST, _TAKING * clock.elapsed))
        if ways is not None and ways.repair(CLEAR, within, _REPAIRS):
            self._improve(ways, clock)

    def _improve(self, ways: Rerouting, clock: Clock) -> None:
        """Make ways without conflicts cheaper, and keep them if they are the best.

        It ends where that leads no further, or where there are routes to begin with.
        """
        better = True
        while better:
            began = clock.elapsed
            if self._best is None or ways.price < self._best.price:
                self._best = ways
            self.known.take(point_of(self.setting, ways.walks, 0))
            self._raise(clock, began - self._since)
            self._since = clock.elapsed
            better = not (self.known.settled or self._fresh or clock.over)
            better = better and ways.improve(clock.within(_SLICE), _CHANGES)

    def _ways(self, meeting: Meeting, seed: int) -> Rerouting | None:
        """A way for every agent to where it meets others; None where one is too late."""
        setting = self.setting
        engaged = Engagements(
            self.agenda, len(setting.arrays.names), meeting.times, meeting.serving
        )
        walks = []
        for kind, start in zip(self._kinds, self._starts, strict=True):
            waits = setting.classes[kind].graph.waits(start, setting.horizon)
            if waits is None:
                return None
            walks.append(Walk(kind, start, *waits))
        ways = Rerouting(
            setting,
            walks,
            [engaged.duties(agent) for agent in range(len(walks))],
            self._prices,
            Room.of(setting, self.agenda.quotas),
            seed=seed,
            engaged=engaged,
        )
        return ways if ways.begin() else None

    @property
    def _kinds(self) -> list[int]:
        return [int(kind) for kind in self._distances.kind]

    @property
    def _starts(self) -> list[int]:
        states = list(self._distances.place)
        return [states[place] for place in self._distances.begin.tolist()]

    # --- bounds ----------------------------------------------------------------------------------

    def _raise(self, clock: Clock, seconds: float) -> None:
        """Better bounds, in as many seconds as plans have taken, with those before."""
        self._owed += seconds
        while self._bounds is not None and self._owed > 0 and not self.known.settled:
            began = clock.elapsed
            bound = next(self._bounds, None)
            self._owed -= clock.elapsed - began
            if bound is None:
                self._bounds = None
            else:
                self._hear(bound)

    def _enough(self) -> float:
        """Up to what a bound is of interest."""
        objective, point = self.known.objectives[0], self.known.point
        if point is None or not isinstance(objective, Priced):
            return float("inf")
        value = float(objective.minimised(self.setting, point))
        return value - self._unit + (_CLOSE if self._unit else 0.0)

    @property
    def _unit(self) -> float:
        """What all prices of plans are multiples of, or 0."""
        return float(all((price == np.rint(price)).all() for price in self._prices))

    def _hear(self, bound: float) -> None:
        """Tell of a bound, as far as it can be believed."""
        objective, point = self.known.objectives[0], self.known.point
        assert isinstance(objective, Priced)
        assert point is not None
        target = objective.target(self.setting, point.encoded)
        proven = target.proven(bound)
        if not target.refutes(objective.minimised(self.setting, point), proven):
            self.known.hear(objective.name, target.own(proven))
