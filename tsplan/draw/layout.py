"""Where every state of a map is drawn: its own coordinates, or places computed from the edges.

Nothing here is random, so the same map always has the same places. Maps without coordinates
are laid out so that distances on paper follow the durations: by networkx's Kamada-Kawai layout, and
above `MOST_SPRINGS` states by pivot MDS, whose cost grows only linearly with the states.

Source: U. Brandes and C. Pich, "Eigensolver methods for progressive multidimensional scaling of
large data", Graph Drawing 2006.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    import networkx as nx

    from tsplan.ts import State, TransitionSystem
    from tsplan.ts.edges import Duration

Point: TypeAlias = tuple[float, float]
Places: TypeAlias = Mapping[str, Point]
Floats: TypeAlias = npt.NDArray[np.float64]

MOST_SPRINGS = 150
"""States up to which a part of a map is laid out by Kamada and Kawai's method."""

_PIVOTS = 50
_ROUNDS = 60  # iterations of the spring layout that places states beside known ones
_FLAT = 1e-9  # of an area: below it a polygon has no centroid
_TALLER = 1.6  # height over width from which a layout is turned to lie on its side


class Link(NamedTuple):
    """Two connected states, drawn as one line; `words` are those of the durations both ways."""

    source: str
    target: str
    one_way: bool
    words: str


def places(system: TransitionSystem) -> Places:
    """Coordinates of every state, in the order of the map.

    A state's own `at`, else the centroid of its `shape`. States with neither are placed beside
    their neighbours, or all by the edges if no state has coordinates.

    >>> from tsplan.ts import Edge, State, TransitionSystem
    >>> square = ((0, 0), (2, 0), (2, 2), (0, 2))
    >>> map = TransitionSystem.build([State("p", at=(5, 1)), State("q", shape=square)], [])
    >>> dict(places(map))
    {'p': (5.0, 1.0), 'q': (1.0, 1.0)}
    """
    known = {name: place for name, state in system.states.items() if (place := own_place(state))}
    if len(known) == len(system.states):
        return known
    graph = _undirected(system)
    found = _filled(graph, known) if known else _arranged(graph)
    return {name: found[name] for name in system.states}


def own_place(state: State) -> Point | None:
    """The coordinates that a state brings along, if any."""
    if state.at is not None:
        return float(state.at[0]), float(state.at[1])
    return centroid(state.shape) if state.shape else None


def centroid(shape: Sequence[Point]) -> Point:
    """The centre of a polygon's area; of a degenerate one, the mean of its corners.

    >>> centroid([(0, 0), (6, 0), (0, 3)])
    (2.0, 1.0)
    """
    area = x = y = 0.0
    for (x0, y0), (x1, y1) in pairwise([*shape, shape[0]]):
        cross = x0 * y1 - x1 * y0
        area += cross
        x += (x0 + x1) * cross
        y += (y0 + y1) * cross
    extent = max(max(p) for p in shape) - min(min(p) for p in shape)
    if abs(area) <= _FLAT * max(extent * extent, 1.0):
        return sum(p[0] for p in shape) / len(shape), sum(p[1] for p in shape) / len(shape)
    return x / (3 * area), y / (3 * area)


def spacing(where: Places) -> float:
    """The typical distance from a state to the nearest other one; 1 for a single state.

    It is the median, so that a few states that are close together do not shrink everything.

    >>> spacing({"p": (0, 0), "q": (3, 0), "r": (6, 0)})
    3.0
    """
    from scipy.spatial import cKDTree  # noqa: PLC0415  (slow to import)

    if len(where) < 2:  # noqa: PLR2004  (a distance needs two)
        return 1.0
    points = np.array(list(where.values()), dtype=np.float64)
    nearest = np.asarray(cKDTree(points).query(points, k=2)[0], dtype=np.float64)[:, 1]
    apart = nearest[nearest > 0]
    return float(np.median(apart)) if apart.size else 1.0


def bounds(system: TransitionSystem, where: Places) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of all states and their shapes."""
    corners = [point for state in system.states.values() for point in state.shape or ()]
    xs, ys = zip(*where.values(), *corners, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def links(system: TransitionSystem) -> tuple[Link, ...]:
    """Every pair of connected states once, in the order of the map; waits are none."""
    found = []
    for (source, target), edge in system.edges.items():
        back = system.edges.get((target, source))
        if source != target and (back is None or source < target):
            words = duration_words(edge.duration, (back or edge).duration)
            found.append(Link(source, target, back is None, words))
    return tuple(found)


def duration_words(there: Duration, back: Duration) -> str:
    """A duration as it is written on an edge: one number, or a range where classes or ways differ.

    >>> duration_words(2, 2), duration_words(1, 3), duration_words({"a": 1, "default": 2}, 2)
    ('2', '1-3', '1-2')
    """
    every = [n for d in (there, back) for n in (d.values() if isinstance(d, Mapping) else (d,))]
    least, most = min(every), max(every)
    return str(least) if least == most else f"{least}-{most}"


def _undirected(system: TransitionSystem) -> nx.Graph[str]:
    """The map without waits and directions; an edge is as long as its quicker direction."""
    import networkx as nx  # noqa: PLC0415  (slow to import)

    graph: nx.Graph[str] = nx.Graph()
    graph.add_nodes_from(system.states)
    for (source, target), edge in system.edges.items():
        if source == target:
            continue
        length = float(edge.shortest() or 1)
        before = graph.get_edge_data(source, target, {"weight": math.inf})["weight"]
        graph.add_edge(source, target, weight=min(length, before))
    return graph


def _filled(graph: nx.Graph[str], known: dict[str, Point]) -> Places:
    """All states, those without coordinates moved by springs to where their neighbours are."""
    import networkx as nx  # noqa: PLC0415  (slow to import)

    begin = _begin(graph, known)
    step = spacing(known)
    found = nx.spring_layout(
        graph, k=step, pos=begin, fixed=list(known), iterations=_ROUNDS, weight=None, seed=0
    )
    spread = {name: (float(x), float(y)) for name, (x, y) in found.items()}
    return spread | known


def _begin(graph: nx.Graph[str], known: dict[str, Point]) -> dict[str, Point]:
    """A first place for each state: near the middle of its placed neighbours, else to the right.

    States are moved around a spiral a little, so that no two of them begin at one point.
    """
    step = spacing(known)
    right = max(x for x, _ in known.values()) + step
    top = max(y for _, y in known.values())
    begin = dict(known)
    for number, name in enumerate(name for name in graph if name not in known):
        beside = [begin[other] for other in graph[name] if other in begin]
        x = sum(p[0] for p in beside) / len(beside) if beside else right
        y = sum(p[1] for p in beside) / len(beside) if beside else top
        turn = 2.4 * number  # the golden angle: directions never repeat
        begin[name] = x + 0.6 * step * math.cos(turn), y + 0.6 * step * math.sin(turn)
    return begin


def _arranged(graph: nx.Graph[str]) -> Places:
    """Places from the edges alone: each connected part by itself, side by side, largest first."""
    import networkx as nx  # noqa: PLC0415  (slow to import)

    order = {name: number for number, name in enumerate(graph)}
    parts = sorted(
        nx.connected_components(graph),
        key=lambda part: (-len(part), min(map(order.__getitem__, part))),
    )
    where: dict[str, Point] = {}
    left = base = shelf = 0.0
    room = 1.5 * math.sqrt(len(graph)) + 1
    for part in parts:
        names = sorted(part, key=order.__getitem__)
        points = _laid(graph, names)
        width, height = points.max(axis=0)
        if left and left + width > room:
            left, base, shelf = 0.0, base - shelf - 1.0, 0.0
        for name, (x, y) in zip(names, points, strict=True):
            where[name] = (float(left + x), float(base - height + y))
        left, shelf = left + width + 1.0, max(shelf, float(height))
    return where


def _laid(graph: nx.Graph[str], names: list[str]) -> Floats:
    """One connected part: nearest states about 1 apart, lying rather than standing, from (0,0)."""
    if len(names) == 1:
        return np.zeros((1, 2))
    part = graph.subgraph(names)
    points = _springs(part, names) if len(names) <= MOST_SPRINGS else _scaled(part, names)
    points = _turned(points)
    points = points - points.min(axis=0)
    distance = spacing(
        {name: (float(x), float(y)) for name, (x, y) in zip(names, points, strict=True)}
    )
    return np.asarray(points / distance, dtype=np.float64)


def _springs(part: nx.Graph[str], names: list[str]) -> Floats:
    import networkx as nx  # noqa: PLC0415  (slow to import)

    found = nx.kamada_kawai_layout(part, weight="weight")
    return np.array([found[name] for name in names], dtype=np.float64)


def _scaled(part: nx.Graph[str], names: list[str]) -> Floats:
    """Pivot MDS: the two main directions of the squared distances to a few far-apart states."""
    import networkx as nx  # noqa: PLC0415  (slow to import)
    from scipy.sparse import csgraph  # noqa: PLC0415

    matrix = nx.to_scipy_sparse_array(part, nodelist=names, weight="weight", format="csr")
    nearest = np.full(len(names), np.inf)
    rows: list[Floats] = []
    pivot = 0
    for _ in range(min(_PIVOTS, len(names))):
        distances = csgraph.dijkstra(matrix, directed=False, indices=np.array([pivot]))
        row = np.asarray(distances, dtype=np.float64)[0]
        rows.append(row)
        nearest = np.minimum(nearest, row)
        pivot = int(np.argmax(nearest))
    squared = np.array(rows).T ** 2
    centred = (
        squared
        - squared.mean(axis=0, keepdims=True)
        - squared.mean(axis=1, keepdims=True)
        + squared.mean()
    )
    _, _, directions = np.linalg.svd(centred, full_matrices=False)
    first = directions[:2]
    # the sign of a direction is the library's whim; make it a rule
    signs = np.sign(first[np.arange(2), np.abs(first).argmax(axis=1)])
    return np.asarray(centred @ (first * signs[:, None]).T, dtype=np.float64)


def _turned(points: Floats) -> Floats:
    """The points with their longer side across the page."""
    width, height = np.ptp(points, axis=0)
    return points[:, ::-1] if height > _TALLER * width else points
