"""A transition system: the map that agents move on, as one frozen value."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

from tsplan import display
from tsplan.errors import Finding, MapError, Spot, in_order
from tsplan.exact import common_unit, exact
from tsplan.ts.actions import Action, ActionFlaw, ActionKey, action_flaws, edges_of
from tsplan.ts.closures import shifted
from tsplan.ts.edges import Edge, Pair, State
from tsplan.ts.validity import Problem, problems
from tsplan.words import nfc

if TYPE_CHECKING:
    import networkx as nx


@dataclass(frozen=True, slots=True)
class Extras:
    """What a file of another format says that this package does not use, kept for writing it back.

    `format` names the format it belongs to; `system`, `states` and `edges` hold what that format
    knows about the whole, each state and each edge.
    """

    format: str
    system: Mapping[str, Any] = field(default_factory=dict)
    states: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    edges: Mapping[Pair, Any] = field(default_factory=dict)


class ZoneParts(NamedTuple):
    """What shares the capacity of a zone."""

    states: tuple[str, ...]
    edges: tuple[Pair, ...]


@dataclass(frozen=True)
class TransitionSystem(display.Displayed):
    """States and directed edges, at most one edge for each ordered pair of states.

    Build one with `TransitionSystem.build`, which checks it. States and edges keep the order in
    which they were given. `places` says where a file gives the costs of edges. Where outcomes are
    uncertain there are `actions`, by state and name, and the edges say what these may lead to.
    `zones` bound how many agents are at their states and on their edges at once, by their names.
    Of a map that was converted, `step_seconds` says how long a step is, `frame` what its
    coordinates refer to, and `notes` what was dropped or chosen; of those with a remedy missions
    warn.

    >>> town = TransitionSystem.build(
    ...     [State("home"), State("shop", frozenset({"open"}))],
    ...     [Edge("home", "shop", 2), Edge("shop", "shop")],
    ... )
    >>> town.labels["open"], town.edges["home", "shop"].duration
    (('shop',), 2)
    """

    name: str
    states: Mapping[str, State]
    edges: Mapping[Pair, Edge]
    extras: Extras | None = field(default=None, repr=False, compare=False)
    places: Mapping[Pair, Spot] = field(default_factory=dict, repr=False, compare=False)
    actions: Mapping[ActionKey, Action] = field(default_factory=dict)
    zones: Mapping[str, int] = field(default_factory=dict)
    step_seconds: float | None = None
    frame: str | None = None
    notes: tuple[Finding, ...] = field(default=(), repr=False, compare=False)

    def __post_init__(self) -> None:
        """Freeze the mappings."""
        zones = {nfc(name): capacity for name, capacity in self.zones.items()}
        object.__setattr__(self, "zones", MappingProxyType(zones))
        object.__setattr__(self, "actions", MappingProxyType(dict(self.actions)))
        object.__setattr__(self, "states", MappingProxyType(dict(self.states)))
        object.__setattr__(self, "edges", MappingProxyType(dict(self.edges)))

    def __hash__(self) -> int:
        return hash((self.name, len(self.states), len(self.edges), next(iter(self.states), "")))

    def __repr__(self) -> str:
        counts = f"{len(self.states)} states, {len(self.edges)} edges"
        return f"<TransitionSystem {self.name!r}: {counts}>"

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle as plain dicts, so that a system can be sent to another process."""
        parts = (self.name, dict(self.states), dict(self.edges), self.extras, dict(self.places))
        whole = (self.step_seconds, self.frame, self.notes)
        return TransitionSystem, (*parts, dict(self.actions), dict(self.zones), *whole)

    @classmethod
    def build(
        cls,
        states: Iterable[State],
        edges: Iterable[Edge],
        name: str = "",
        *,
        extras: Extras | None = None,
        actions: Iterable[Action] = (),
        zones: Mapping[str, int] | None = None,
        step_seconds: float | None = None,
        frame: str | None = None,
        notes: Iterable[Finding] = (),
        locate: Callable[[Problem], Finding] = Problem.finding,
        locate_action: Callable[[ActionFlaw], Finding] = ActionFlaw.finding,
    ) -> TransitionSystem:
        """A transition system from its parts, in the order given.

        With `actions` there are no edges beside those that follow from them. `locate` and
        `locate_action` turn what is wrong into a finding with its place, for parts that come from
        a file.

        Raises
        ------
        MapError
            No states, names that repeat, edges with unknown ends or that repeat, durations that
            are not whole numbers from 1 on, wrong capacities and costs, unknown zones,
            probabilities that do not add up to 1; all of them at once.

        """
        states, edges, actions = tuple(states), tuple(edges), tuple(actions)
        zones = {nfc(name): capacity for name, capacity in (zones or {}).items()}
        faults = [locate(problem) for problem in problems(states, edges, zones)]
        faults += [locate_action(flaw) for flaw in action_flaws(states, actions)]
        if actions and edges:
            what = "the map has edges beside its actions, and edges follow from these"
            remedy = "write an edge as an action that is sure, such as go: {q2: 1}"
            faults.append(locate(Problem("system", 0, "edges", what, remedy)))
        for index, state in enumerate(states if actions else ()):
            if state.closed:
                what = f"the state '{state.name}' is closed for a time, and moves are uncertain"
                remedy = "nobody can be kept out for sure; remove 'closed'"
                faults.append(locate(Problem("state", index, "closed", what, remedy)))
        if faults:
            raise MapError(in_order(faults))
        return cls(
            nfc(name),
            {state.name: state for state in states},
            {edge.pair: edge for edge in edges or edges_of(actions)},
            extras,
            {} if locate is Problem.finding else _cost_places(edges, locate),
            {action.key: action for action in actions},
            zones,
            step_seconds,
            frame,
            tuple(notes),
        )

    def rebuilt(self, states: Iterable[State], edges: Iterable[Edge]) -> TransitionSystem:
        """A system of other states and edges, with the zones, the step and the name of this one.

        Raises MapError as `build` does.
        """
        return TransitionSystem.build(
            states,
            edges,
            self.name,
            zones=self.zones,
            extras=self.extras,
            step_seconds=self.step_seconds,
            frame=self.frame,
            notes=self.notes,
        )

    @cached_property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """The states that carry each label, in the order of the states."""
        carriers: dict[str, list[str]] = {}
        for state in self.states.values():
            for label in sorted(state.labels):
                carriers.setdefault(label, []).append(state.name)
        return MappingProxyType({label: tuple(names) for label, names in carriers.items()})

    @cached_property
    def capacity_groups(self) -> tuple[tuple[int, tuple[Pair, ...]], ...]:
        """Edge capacities with the edges that share each: one edge, or one in both directions.

        Those of zones are among the `zone_parts`.
        """
        groups: dict[Pair, tuple[int, tuple[Pair, ...]]] = {}
        for pair, edge in self.edges.items():
            back = (edge.target, edge.source)
            # the direction that comes first stands for both
            if edge.capacity is not None and not (edge.both_ways and back in groups):
                pairs = (pair, back) if edge.both_ways else (pair,)
                groups[pair] = edge.capacity, pairs
        return tuple(groups.values())

    @cached_property
    def zone_parts(self) -> Mapping[str, ZoneParts]:
        """The states and edges of every zone.

        An agent is in the zone at every step at which it is at one of the states, or has left for
        one of the edges and not yet arrived; while it is at a state it is not on an edge as well.
        """
        states: dict[str, list[str]] = {name: [] for name in self.zones}
        edges: dict[str, list[Pair]] = {name: [] for name in self.zones}
        for state in self.states.values():
            if state.zone is not None:
                states[state.zone].append(state.name)
        for pair, edge in self.edges.items():
            if edge.zone is not None:
                edges[edge.zone].append(pair)
        return MappingProxyType(
            {name: ZoneParts(tuple(states[name]), tuple(edges[name])) for name in self.zones}
        )

    @cached_property
    def timed(self) -> bool:
        """Whether some state or edge is closed for a time."""
        parts: tuple[State | Edge, ...] = (*self.states.values(), *self.edges.values())
        return any(part.closed for part in parts)

    def later(self, steps: int) -> TransitionSystem:
        """The map where all that is closed for a time is so some steps later, or earlier below 0.

        >>> door = State("door", closed=((4, 9),))
        >>> TransitionSystem.build([door], []).later(-6).states["door"].closed
        ((0, 3),)
        """
        if not self.timed:
            return self
        states = (replace(s, closed=shifted(s.closed, steps)) for s in self.states.values())
        edges = (replace(e, closed=shifted(e.closed, steps)) for e in self.edges.values())
        return self.rebuilt(states, edges)

    @cached_property
    def cost_unit(self) -> Fraction:
        """The largest number of which every edge's cost is a whole multiple."""
        costs = {edge.cost for edge in self.edges.values() if edge.cost is not None}
        durations = any(e.cost is None and not e.is_wait for e in self.edges.values())
        return common_unit([*map(exact, costs), *([Fraction(1)] if durations else [])])

    @cached_property
    def graph(self) -> nx.DiGraph[str]:
        """A frozen networkx graph: nodes hold `state`; edges hold `edge` and `weight`.

        `weight` is the duration, for classes that differ the shortest one.
        """
        import networkx as nx  # noqa: PLC0415 - slow to import, and needed for graph work only

        graph: nx.DiGraph[str] = nx.DiGraph(name=self.name)
        graph.add_nodes_from((name, {"state": state}) for name, state in self.states.items())
        graph.add_edges_from(
            (source, target, {"edge": edge, "weight": edge.shortest()})
            for (source, target), edge in self.edges.items()
        )
        nx.freeze(graph)
        return graph

    def leaving(self, state: str) -> tuple[Edge, ...]:
        """The edges that leave a state, waits included."""
        return self._leaving.get(state, ())

    def plot(self, ax: Any = None) -> display.Picture:
        """The map: its matplotlib figure and axes.

        Raises PlotUnavailableError without matplotlib.
        """
        return display.draw_map(self, ax)

    def _repr_svg_(self) -> str:
        """The map as notebooks show it."""
        return display.map_svg(self)

    @cached_property
    def _leaving(self) -> Mapping[str, tuple[Edge, ...]]:
        leaving: dict[str, list[Edge]] = {}
        for edge in self.edges.values():
            leaving.setdefault(edge.source, []).append(edge)
        return {name: tuple(edges) for name, edges in leaving.items()}


def _cost_places(edges: Iterable[Edge], locate: Callable[[Problem], Finding]) -> dict[Pair, Spot]:
    """Where the costs of edges stand."""
    places = {}
    for index, edge in enumerate(edges):
        if edge.cost is not None:
            finding = locate(Problem("edge", index, "cost", "", ""))
            places[edge.pair] = (finding.source, finding.line, finding.column)
    return places
