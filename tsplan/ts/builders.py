"""Building maps in Python: grids, and networkx graphs."""

from __future__ import annotations

import random
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from tsplan.errors import Finding, MapError
from tsplan.ts.edges import Edge, State, missing_waits, words
from tsplan.ts.graph_attributes import (
    LENGTHS,
    OF_EDGES,
    OF_STATES,
    USUAL,
    Converters,
    Names,
    attribute_of,
    fields_of,
    length_of,
)
from tsplan.ts.parallel_edges import choices, chosen
from tsplan.ts.ride_durations import Ride, steps_of
from tsplan.ts.system import TransitionSystem
from tsplan.ts.validity import problems

if TYPE_CHECKING:
    import networkx as nx

Cell: TypeAlias = tuple[int, int]

_STEPS = ((0, 1), (1, 0), (0, -1), (-1, 0))


def cell_name(row: int, column: int) -> str:
    """The name of the state at a cell of a grid.

    >>> cell_name(2, 10)
    'r2c10'
    """
    return f"r{row}c{column}"


def grid(
    rows: int,
    columns: int,
    *,
    blocked: Collection[Cell] = (),
    labels: Mapping[Cell, str | Iterable[str]] | None = None,
    duration: int | tuple[int, int] = 1,
    seed: int = 0,
    waits: bool = True,
    name: str = "grid",
) -> TransitionSystem:
    """A grid of unit cells; neighbours in the four directions are connected there and back.

    Cell (row, column), counted from 0, is the state `cell_name(row, column)`, drawn as the unit
    square around (column + 0.5, row + 0.5).

    Parameters
    ----------
    rows, columns
        Size of the grid.
    blocked
        Cells that are left out.
    labels
        Labels of cells.
    duration
        Steps of every move; or the least and the most, between which each direction of each move
        draws its own, uniformly.
    seed
        Seed of those draws.
    waits
        Whether an agent can wait at each cell for one step.
    name
        Name of the map.

    Raises
    ------
    MapError
        No cell is left, or a duration is below 1.

    >>> grid(2, 2, blocked={(0, 1)}, labels={(1, 1): "goal"}).labels
    mappingproxy({'goal': ('r1c1',)})

    """
    closed, labels = frozenset(blocked), labels or {}
    cells = ((row, column) for row in range(rows) for column in range(columns))
    free = {cell: cell_name(*cell) for cell in cells if cell not in closed}
    states = [
        State(state, words(labels.get(cell, ())), (cell[1] + 0.5, cell[0] + 0.5), _square(cell))
        for cell, state in free.items()
    ]
    return TransitionSystem.build(states, _moves(free, duration, seed, waits=waits), name)


def _square(cell: Cell) -> tuple[tuple[float, float], ...]:
    bottom, left = float(cell[0]), float(cell[1])
    return (left, bottom), (left + 1, bottom), (left + 1, bottom + 1), (left, bottom + 1)


def _moves(
    free: Mapping[Cell, str], duration: int | tuple[int, int], seed: int, *, waits: bool
) -> Iterator[Edge]:
    draw = random.Random(seed)  # noqa: S311 - a reproducible map, no secret
    drawn = isinstance(duration, tuple)
    least, most = duration if isinstance(duration, tuple) else (duration, duration)
    for (row, column), here in free.items():
        if waits:
            yield Edge(here, here)
        for down, right in _STEPS:
            there = free.get((row + down, column + right))
            if there is not None:
                yield Edge(here, there, draw.randint(least, most) if drawn else least)


def from_networkx(
    graph: nx.Graph[Any],
    *,
    labels: str = "labels",
    at: str = "at",
    duration: str = "duration",
    waits: bool = False,
    name: str = "",
) -> TransitionSystem:
    """A transition system from a networkx graph; an undirected edge goes both ways.

    Numbers may be of any type, of numpy too, or texts such as "3" and "2.5", as DOT and GraphML
    give them.

    Parameters
    ----------
    graph
        Nodes become states, under the text of the node.
    labels, at, duration
        Names of the attributes that hold a node's labels (one, or a collection), its coordinates,
        and an edge's duration (1 where absent; for example `weight` for other sources).
        Attributes called `shape`, `color`, `capacity`, `needs`, `cost` and `success` are used as
        they are.
    waits
        Whether to add a wait of one step to every state that has none.
    name
        Name of the map; the graph's own by default.

    Raises
    ------
    MapError
        Everything that is wrong, each with its node or edge and its attribute: of the wrong type,
        or as `TransitionSystem.build` says; so also for parallel edges.

    >>> import networkx as nx
    >>> graph = nx.DiGraph()
    >>> graph.add_node("dock", labels=["goal"], at=("1", "2.5"))
    >>> graph.add_edge("door", "dock", weight="4")
    >>> from_networkx(graph, duration="weight").edges["door", "dock"].duration
    4

    """
    reading = _Reading({"labels": (labels,), "at": (at,), "duration": (duration,)})
    states, edges = reading.states(graph), reading.edges(graph, ())
    return reading.made(states, edges, graph, name=name, waits=waits)


def map_of_graph(graph: nx.Graph[Any]) -> TransitionSystem:
    """The map of a networkx graph that is given for one, by attributes as tools call them.

    The `duration` of an edge is in steps; else its `length`, `distance`, `dist` or `weight` is in
    metres, at one metre a step and rounded up; else it takes one step. Labels may be called
    `labels`, `label` or `prop`, coordinates `at`, `pos`, `position`, `location`, or `x` and `y`.
    Agents can wait everywhere. Of parallel edges one is kept; the map's `notes` say so.

    Raises MapError as `from_networkx` does.

    >>> import networkx as nx
    >>> graph = nx.MultiDiGraph()
    >>> graph.add_weighted_edges_from([("a", "b", 1.5), ("a", "b", 4)])
    >>> system = map_of_graph(graph)
    >>> system.edges["a", "b"].duration, [note.message for note in system.notes]
    (2, ["1 more edge from 'a' to 'b' can do nothing better than the one that is kept"])

    """
    reading = _Reading(USUAL)
    states, edges = reading.states(graph), reading.edges(graph, LENGTHS)
    made = list(choices(edges))
    notes = [Finding(*choice.words(edges)) for choice in made]
    kept = list(chosen(edges, made).values())
    return reading.made(states, kept, graph, notes=notes)


class _Reading:
    """Attributes of nodes and edges as fields of states and edges; what is wrong is kept."""

    def __init__(self, names: Names) -> None:
        self._names = names
        self._findings: list[Finding] = []
        self._data: dict[str, Mapping[str, Any]] = {}  # by where they are said

    def states(self, graph: nx.Graph[Any]) -> list[State]:
        """A state for every node."""
        return [
            State(str(node), **self._fields(f"node '{node}'", OF_STATES, data), origin=_id(node))
            for node, data in graph.nodes(data=True)
        ]

    def edges(self, graph: nx.Graph[Any], lengths: Sequence[str]) -> list[Edge]:
        """An edge for every edge, or one in each direction; attributes that may hold lengths."""
        edges = []
        for source, target, data in graph.edges(data=True):
            pair = str(source), str(target)
            both_ways = not graph.is_directed() and pair[0] != pair[1]
            fields = self._fields(_way(*pair), OF_EDGES, data)
            if "duration" not in fields:
                length, misfits = length_of(data, lengths)
                self._findings += (
                    Finding(each.message, each.remedy, _part(_way(*pair), each.attribute))
                    for each in misfits
                )
                if length is not None:
                    fields["duration"] = steps_of(Ride(length), 1.0, 1.0)
            edge = Edge(*pair, **fields, both_ways=both_ways)
            edges += [edge, edge.reverse()] if both_ways else [edge]
        return edges

    def _fields(
        self, where: str, converters: Converters, data: Mapping[str, Any]
    ) -> dict[str, Any]:
        """The fields that a node or edge gives."""
        fields, misfits = fields_of(data, converters, self._names)
        self._data.setdefault(where, data)
        self._findings += (
            Finding(each.message, each.remedy, _part(where, each.attribute)) for each in misfits
        )
        return fields

    def made(
        self,
        states: Sequence[State],
        edges: list[Edge],
        graph: nx.Graph[Any],
        *,
        name: str = "",
        waits: bool = True,
        notes: Iterable[Finding] = (),
    ) -> TransitionSystem:
        """The system, with waits if asked for; MapError with all that is wrong."""
        if waits:
            edges = [*edges, *missing_waits(states, edges)]
        zones = graph.graph.get("zones") or {}
        self._judge(states, edges, zones)
        title = name or str(graph.graph.get("name", ""))
        return TransitionSystem.build(states, edges, title, zones=zones, notes=notes)

    def _judge(
        self, states: Sequence[State], edges: Sequence[Edge], zones: Mapping[str, int]
    ) -> None:
        """Raise MapError with all that is wrong about what was read."""
        for problem in problems(states, edges, zones):
            where = "the graph"
            if problem.kind == "state":
                where = f"node '{states[problem.index].name}'"
            elif problem.kind == "edge":
                edge = edges[problem.index]
                if edge.both_ways and edge.pair > edge.reverse().pair:
                    continue  # said of the other direction already
                where = _way(*edge.pair)
            self._note(where, problem.part, problem.message, problem.remedy)
        if self._findings:
            raise MapError(self._findings)

    def _note(self, where: str, field: str | None, message: str, remedy: str) -> None:
        if field is not None and (field in OF_STATES or field in OF_EDGES):
            where = _part(where, attribute_of(field, self._data.get(where, {}), self._names))
        self._findings.append(Finding(message, remedy, where))


def _id(node: Any) -> str | int | None:
    """A node as its own id, where it is text or a whole number."""
    return node if isinstance(node, str | int) and not isinstance(node, bool) else None


def _part(where: str, attribute: str) -> str:
    return f"{where}, attribute '{attribute}'"


def _way(source: str, target: str) -> str:
    return f"edge from '{source}' to '{target}'"
