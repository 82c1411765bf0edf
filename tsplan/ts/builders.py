"""Building maps in Python: grids, and networkx graphs."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from numbers import Integral, Real
from typing import TYPE_CHECKING, Any, TypeAlias

from tsplan.errors import Finding, MapError
from tsplan.limits import clipped
from tsplan.ts.edges import NOTHING, Edge, State, missing_waits, words
from tsplan.ts.system import TransitionSystem
from tsplan.ts.validity import Fault, problems

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
    reading = _Reading({"labels": labels, "at": at, "duration": duration})
    states = [
        State(str(node), **reading.fields(f"node '{node}'", _OF_STATES, data))
        for node, data in graph.nodes(data=True)
    ]
    edges = []
    for source, target, data in graph.edges(data=True):
        pair = str(source), str(target)
        both_ways = not graph.is_directed() and pair[0] != pair[1]
        fields = reading.fields(_way(*pair), _OF_EDGES, data)
        edge = Edge(*pair, **fields, both_ways=both_ways)
        edges += [edge, edge.reverse()] if both_ways else [edge]
    if waits:
        edges += missing_waits(states, edges)
    reading.judge(states, edges)
    return TransitionSystem.build(states, edges, name or str(graph.graph.get("name", "")))


class _Reading:
    """Attributes of nodes and edges as fields of states and edges; what is wrong is kept.

    `names` has what the attribute of a field is called where it is not called as the field.
    """

    def __init__(self, names: Mapping[str, str]) -> None:
        self._names = names
        self._findings: list[Finding] = []

    def fields(
        self, where: str, converters: _Converters, data: Mapping[str, Any]
    ) -> dict[str, Any]:
        """The fields that a node or edge gives."""
        fields = {}
        for field, converted in converters.items():
            name = self._names.get(field, field)
            value = converted(data[name]) if name in data else None
            if isinstance(value, Fault):
                self._note(where, field, f"{clipped(data[name])} is {value.what}", value.remedy)
            elif name in data:
                fields[field] = value
        return fields

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

    def _note(self, where: str, field: str | None, message: str, remedy: str) -> None:
        if field is not None and (field in _OF_STATES or field in _OF_EDGES):
            where = f"{where}, attribute '{self._names.get(field, field)}'"
        self._findings.append(Finding(message, remedy, where))


def _way(source: str, target: str) -> str:
    return f"edge from '{source}' to '{target}'"


def _words(value: Any) -> frozenset[str] | Fault:
    """One word, or a collection of words; none of None."""
    if value is None or isinstance(value, str):
        return NOTHING if value is None else frozenset((value,))
    if isinstance(value, Iterable) and not isinstance(value, bytes | Mapping):
        words = tuple(value)
        if all(isinstance(word, str) for word in words):
            return frozenset(words)
    remedy = "write it as 'door' or ['door', 'exit']"
    return Fault("neither a text nor a collection of texts", remedy)


def _text(value: Any) -> str | Fault | None:
    if value is None or isinstance(value, str):
        return value
    return Fault("not a text", "write it as 'tan' or '#d2b48c'")


def _steps(value: Any) -> Any:
    """A number, or one for each class."""
    if isinstance(value, Mapping):
        return {name: _number(steps) for name, steps in value.items()}
    return _number(value)


def _numbers(value: Any) -> Any:
    """Collections of collections of numbers as tuples; what is none is left for the checks."""
    if isinstance(value, str | Mapping) or not isinstance(value, Iterable):
        return value
    return tuple(_numbers(_number(member)) for member in value)


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


_Converters: TypeAlias = Mapping[str, Callable[[Any], Any]]
_OF_STATES: _Converters = {
    "labels": _words,
    "at": _numbers,
    "shape": _numbers,
    "color": _text,
    "capacity": _number,
    "needs": _words,
}
_OF_EDGES: _Converters = {
    "duration": _steps,
    "cost": _number,
    "success": _number,
    "capacity": _number,
    "needs": _words,
}
"""The fields that attributes give, each with what makes it of a value."""
