"""Building maps in Python: grids, and networkx graphs."""

from __future__ import annotations

import operator
import random
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

from tsplan.ts.parts import NOTHING, Edge, State
from tsplan.ts.system import TransitionSystem

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

    Raises
    ------
    MapError
        As `TransitionSystem.build` says; so also for parallel edges.

    """
    states = [_node(node, dict(data), labels, at) for node, data in graph.nodes(data=True)]
    edges = []
    for source, target, data in graph.edges(data=True):
        edge = _link(str(source), str(target), dict(data), duration)
        if graph.is_directed() or edge.is_wait:
            edges.append(edge)
        else:
            edges += [both := _both_ways(edge), both.reverse()]
    if waits:
        looping = {edge.source for edge in edges if edge.is_wait}
        edges += [Edge(s.name, s.name) for s in states if s.name not in looping]
    return TransitionSystem.build(states, edges, name or str(graph.graph.get("name", "")))


def _node(node: Any, data: dict[str, Any], labels: str, at: str) -> State:
    place = data.get(at)
    shape = data.get("shape")
    return State(
        str(node),
        _labels(data.get(labels)),
        None if place is None else tuple(map(float, place)),  # type: ignore[arg-type]  # checked later
        None if shape is None else tuple((float(x), float(y)) for x, y in shape),
        data.get("color"),
        data.get("capacity"),
        _labels(data.get("needs")),
    )


def _link(source: str, target: str, data: dict[str, Any], duration: str) -> Edge:
    given = data.get(duration, 1)
    steps = (
        {key: _steps(value) for key, value in given.items()}
        if isinstance(given, Mapping)
        else _steps(given)
    )
    return Edge(
        source, target, steps, data.get("cost"), data.get("capacity"), _labels(data.get("needs"))
    )


def _both_ways(edge: Edge) -> Edge:
    return Edge(*edge.pair, edge.duration, edge.cost, edge.capacity, edge.needs, both_ways=True)


def _steps(value: Any) -> int:
    """A whole number as Python's own int; anything else is left for the checks to refuse."""
    if isinstance(value, float) and value.is_integer():
        return int(value)
    try:
        return value if isinstance(value, bool) else operator.index(value)
    except TypeError:
        return value  # type: ignore[no-any-return]  # not a whole number, as the checks will say
