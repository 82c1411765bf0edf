"""Building maps in Python: grids, and networkx graphs."""

from __future__ import annotations

import random
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from numbers import Integral, Real
from reprlib import repr as clipped
from typing import TYPE_CHECKING, Any, TypeAlias

from tsplan.errors import Finding, MapError
from tsplan.ts.edges import NOTHING, Edge, State
from tsplan.ts.system import TransitionSystem
from tsplan.ts.validity import problems

if TYPE_CHECKING:
    import networkx as nx

Cell: TypeAlias = tuple[int, int]

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?")
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
    free = _free(rows, columns, blocked)
    given = labels or {}
    states = [
        State(free[cell], _labels(given.get(cell)), _middle(cell), _square(cell)) for cell in free
    ]
    return TransitionSystem.build(states, _moves(free, duration, seed, waits=waits), name)


def _free(rows: int, columns: int, blocked: Collection[Cell]) -> dict[Cell, str]:
    closed = frozenset(blocked)
    cells = ((row, column) for row in range(rows) for column in range(columns))
    return {cell: cell_name(*cell) for cell in cells if cell not in closed}


def _labels(given: str | Iterable[str] | None) -> frozenset[str]:
    if given is None:
        return NOTHING
    return frozenset((given,) if isinstance(given, str) else given)


def _middle(cell: Cell) -> tuple[float, float]:
    return cell[1] + 0.5, cell[0] + 0.5


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

    Parameters
    ----------
    graph
        Nodes become states, under the text of the node.
    labels, at, duration
        Names of the attributes that hold a node's labels (one, or a collection), its coordinates,
        and an edge's duration (1 where absent; for example `weight` for other sources).
        Attributes called `shape`, `color`, `capacity`, `needs` and `cost` are used as they are.
    waits
        Whether to add a wait of one step to every state that has none.
    name
        Name of the map; the graph's own by default.

    Numbers may be of any type, of numpy too, or texts such as "3" and "2.5", as DOT and GraphML
    give them.

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
    names = {"labels": labels, "at": at, "duration": duration}
    reading = _Reading(names)
    states = [reading.state(node, data) for node, data in graph.nodes(data=True)]
    edges = []
    for source, target, data in graph.edges(data=True):
        edge = reading.edge(str(source), str(target), data)
        if graph.is_directed() or edge.is_wait:
            edges.append(edge)
        else:
            edges += [both := _both_ways(edge), both.reverse()]
    if waits:
        looping = {edge.source for edge in edges if edge.is_wait}
        edges += [Edge(s.name, s.name) for s in states if s.name not in looping]
    reading.judge(states, edges)
    return TransitionSystem.build(states, edges, name or str(graph.graph.get("name", "")))


class _Reading:
    """Attributes of nodes and edges as parts of a map; what is wrong is kept, with its place."""

    def __init__(self, names: Mapping[str, str]) -> None:
        self._names = names
        self._findings: list[Finding] = []

    def state(self, node: object, data: Mapping[str, Any]) -> State:
        """The state of a node."""
        where = f"node '{node}'"
        return State(
            str(node),
            self._words(where, "labels", data),
            _numbers(self._given("at", data)),
            _numbers(self._given("shape", data)),
            self._text(where, "color", data),
            _number(data.get("capacity")),
            self._words(where, "needs", data),
        )

    def edge(self, source: str, target: str, data: Mapping[str, Any]) -> Edge:
        """The edge of an edge, in the direction in which it is listed."""
        steps = data.get(self._names["duration"], 1)
        if isinstance(steps, Mapping):
            steps = {key: _number(value) for key, value in steps.items()}
        return Edge(
            source,
            target,
            _number(steps),
            _number(data.get("cost")),
            _number(data.get("capacity")),
            self._words(_way(source, target), "needs", data),
        )

    def judge(self, states: Sequence[State], edges: Sequence[Edge]) -> None:
        """Raise MapError with all that is wrong about what was read."""
        for problem in problems(states, edges):
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

    def _note(self, where: str, part: str | None, message: str, remedy: str) -> None:
        if part in _ATTRIBUTES:
            where = f"{where}, attribute '{self._names.get(part, part)}'"
        self._findings.append(Finding(message, remedy, where))

    def _given(self, part: str, data: Mapping[str, Any]) -> Any:
        return data.get(self._names.get(part, part))

    def _words(self, where: str, part: str, data: Mapping[str, Any]) -> frozenset[str]:
        """One word, or a collection of words."""
        given = self._given(part, data)
        some = given is None or isinstance(given, str | Iterable)
        found = (
            ()
            if given is None or not some
            else (given,)
            if isinstance(given, str)
            else tuple(given)
        )
        if some and not isinstance(given, bytes | Mapping) and all(map(_is_word, found)):
            return frozenset(found)
        what = f"{clipped(given)} is neither a text nor a collection of texts"
        self._note(where, part, what, "write it as 'door' or ['door', 'exit']")
        return NOTHING

    def _text(self, where: str, part: str, data: Mapping[str, Any]) -> str | None:
        given = self._given(part, data)
        if given is None or isinstance(given, str):
            return given
        self._note(where, part, f"{clipped(given)} is not a text", "write it as 'tan' or '#d2b48c'")
        return None


_ATTRIBUTES = frozenset({"labels", "at", "shape", "color", "capacity", "needs", "duration", "cost"})


def _way(source: str, target: str) -> str:
    return f"edge from '{source}' to '{target}'"


def _is_word(item: object) -> bool:
    return isinstance(item, str)


def _both_ways(edge: Edge) -> Edge:
    return Edge(*edge.pair, edge.duration, edge.cost, edge.capacity, edge.needs, both_ways=True)


def _numbers(value: Any) -> Any:
    """Collections of collections of numbers as tuples; what is none is left for the checks."""
    if value is None or isinstance(value, str | Mapping) or not isinstance(value, Iterable):
        return value
    return tuple(_numbers(item) if _is_list(item) else _number(item) for item in value)


def _is_list(value: object) -> bool:
    return isinstance(value, Iterable) and not isinstance(value, str | Mapping)


def _number(value: Any) -> Any:
    """A number of any type, or the text of one, as Python's own; whole ones as int.

    Anything else is left for the checks to refuse.
    """
    if isinstance(value, str):
        written = value.strip()
        value = float(written) if _NUMBER.fullmatch(written) else value
    if isinstance(value, bool) or not isinstance(value, Real):
        return value
    if isinstance(value, Integral):
        return int(value)
    number = float(value)
    return int(number) if number.is_integer() else number
