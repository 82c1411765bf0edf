"""Places computed from the edges of a map, for states that bring no coordinates along.

Distances on paper follow the durations: by networkx's Kamada-Kawai layout, and above `MOST_SPRINGS`
states by pivot MDS, whose cost grows only linearly with the states.

Source: U. Brandes and C. Pich, "Eigensolver methods for progressive multidimensional scaling of
large data", Graph Drawing 2006.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.ts import TransitionSystem

if TYPE_CHECKING:
    import networkx as nx

Point: TypeAlias = tuple[float, float]
Places: TypeAlias = Mapping[str, Point]

Floats: TypeAlias = npt.NDArray[np.float64]

MOST_SPRINGS = 150
"""States up to which a part of a map is laid out by Kamada and Kawai's method."""

_PIVOTS = 50
_ROUNDS = 60  # iterations of the spring layout that places states beside known ones
_TALLER = 1.6  # height over width from which a layout is turned to lie on its side


def computed(system: TransitionSystem, known: Mapping[str, Point]) -> Places:
    """The places of all states, in the order of the map; those `known` stay where they are."""
    graph = _undirected(system)
    found = _filled(graph, known) if known else _arranged(graph)
    return {name: found[name] for name in system.states}


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


def _networkx() -> Any:
    """The library of graphs, which is slow to import."""
    import networkx as nx  # noqa: PLC0415  (as it says)

    return nx


def _undirected(system: TransitionSystem) -> nx.Graph[str]:
    """The map without waits and directions; an edge is as long as its quicker direction."""
    graph: nx.Graph[str] = _networkx().Graph()
    graph.add_nodes_from(system.states)
    for (source, target), edge in system.edges.items():
        if source == target:
            continue
        length = float(edge.shortest() or 1)
        before = graph.get_edge_data(source, target, {"weight": math.inf})["weight"]
        graph.add_edge(source, target, weight=min(length, before))
    return graph


def _filled(graph: nx.Graph[str], known: Mapping[str, Point]) -> Places:
    """All states, those without coordinates moved by springs to where their neighbours are."""
    how: dict[str, Any] = {"pos": _begin(graph, known), "fixed": list(known), "iterations": _ROUNDS}
    found = _networkx().spring_layout(graph, k=spacing(known), weight=None, seed=0, **how)
    return {name: (float(x), float(y)) for name, (x, y) in found.items()} | dict(known)


def _begin(graph: nx.Graph[str], known: Mapping[str, Point]) -> dict[str, Point]:
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
    order = {name: number for number, name in enumerate(graph)}
    parts = sorted(
        _networkx().connected_components(graph),
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
    if len(names) <= MOST_SPRINGS:
        found = _networkx().kamada_kawai_layout(part, weight="weight")
        points = np.array([found[name] for name in names], dtype=np.float64)
    else:
        points = _scaled(part, names)
    width, height = np.ptp(points, axis=0)
    points = points[:, ::-1] if height > _TALLER * width else points
    points = points - points.min(axis=0)
    where = {name: (float(x), float(y)) for name, (x, y) in zip(names, points, strict=True)}
    return np.asarray(points / spacing(where), dtype=np.float64)


def _scaled(part: nx.Graph[str], names: list[str]) -> Floats:
    """Pivot MDS: the two main directions of the squared distances to a few far-apart states."""
    from scipy.sparse import csgraph  # noqa: PLC0415  (slow to import)

    matrix = _networkx().to_scipy_sparse_array(part, nodelist=names, weight="weight", format="csr")
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
