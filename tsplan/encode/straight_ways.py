"""A restriction for first plans of missions with resources: straight ways, begun now and then.

Where robots carry things the whole map matters, since things may be handed over anywhere, and a
model of it has a column for every resource on every edge at every step. A plan seldom needs that.
Here robots go from one state that matters to another at a stretch, by a quickest way, and begin
only every so many steps; things are laid down where they began and where they are wanted, and
nowhere else. All plans of it are plans of the mission, so what it finds is a plan; what it leaves
out may be better, so it proves nothing. Structures of modules are rebuilt where some of them begin
or are needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.map_reduction import Interest, Reduced
from tsplan.encode.preparation import interest
from tsplan.encode.read_back import moves_of
from tsplan.encode.shortcuts import Kept, shortcuts
from tsplan.logic import Execution, walk
from tsplan.milp.model import Bools, Floats, Ints


def straightened(setting: Setting, every: int) -> Setting | None:
    """The setting of straight ways, begun every so many steps; None where robots cannot wait.

    Nor where places are closed for a time.

    Its classes are those of the setting on their reduced maps, so that its moves are edges of them.
    """
    graphs = [base.graph for base in setting.reduced]
    if any(graph.timed.any() for graph in graphs):
        return None  # ways are not open whenever they are begun
    matter = [interest(setting, graph, rebuilt=False) for graph in graphs]
    matter = [replace(each, limited=each.limited | each.narrow) for each in matter]
    ends, meeting = _ends_of_loads(setting), _meeting(graphs, matter)
    classes, ways = [], []
    for item, base, matters in zip(setting.classes, setting.reduced, matter, strict=True):
        goals = ends | (matters.relevant if base.graph.layer is None else meeting)
        if base.graph.layer is None:
            found = _straight(setting, base.graph, replace(matters, relevant=goals), every)
        else:
            found = _rebuilt(setting, base.graph, replace(matters, relevant=goals), every)
        if found is None:
            return None
        classes.append(replace(item, graph=base.graph))
        ways.append(found)
    return replace(setting, classes=tuple(classes), reduced=tuple(ways), straight=True)


def flows_in(encoded: Encoded, point: Point) -> Floats | None:
    """The flows of a straight point in the model that it restricts; None if one has no column."""
    values = np.zeros(encoded.model.size.columns)
    for (_, (edge, step, count)), columns in zip(
        moves_of(point), encoded.network.classes, strict=True
    ):
        if ((step < columns.first[edge]) | (step > columns.last[edge])).any():
            return None
        np.add.at(values, columns.offset[edge] + step - columns.first[edge], count)
    return np.asarray(values[encoded.flows])


def _ends_of_loads(setting: Setting) -> Bools:
    """The states where resources lie at the beginning, and those where they are wanted."""
    mission, arrays = setting.mission, setting.arrays
    ends = np.zeros(len(arrays.names), dtype=np.bool_)
    ends[
        [
            arrays.number[name]
            for item in mission.resources
            for name, _, there in item.sources
            if there
        ]
    ] = True
    for node in walk(setting.goal):
        if isinstance(node, Execution):
            ends[arrays.states_with(mission.system, node.label)] = True
    return ends


def _meeting(graphs: Sequence[ClassGraph], matter: Sequence[Interest]) -> Bools:
    """The states where structures may be rebuilt: where some of them begin or matter."""
    found = np.zeros_like(matter[0].relevant)
    for graph, matters in zip(graphs, matter, strict=True):
        if graph.layer is not None:
            found |= matters.relevant | (graph.start[:-1] > 0)
    return found


def _rebuilt(setting: Setting, graph: ClassGraph, matters: Interest, every: int) -> Reduced | None:
    """Straight ways of structures, which are rebuilt where it matters and nowhere else."""
    assert graph.layer is not None
    nowhere = np.zeros(1, dtype=np.bool_)
    able = graph.layer.reach[:-1] <= setting.horizon
    matters = replace(matters, relevant=matters.relevant & able)
    parts = matters.relevant, matters.limited, matters.narrow
    relevant, limited, narrow = (np.append(part, nowhere) for part in parts)
    wide = Interest(relevant, limited, narrow, matters.watched)
    rides = replace(graph.among(graph.rides), start=graph.start)
    short = _straight(setting, rides, wide, every)
    if short is None:
        return None
    half = np.arange(graph.layer.rides, len(graph.tail))
    made = short.graph.with_edges_of(graph, half)
    place = np.minimum(graph.tail[half], graph.head[half])  # nowhere comes after all states
    begins = graph.layer.begins[half]
    last = np.where(matters.relevant[place], setting.horizon - 1, -1)
    assert short.graph.entries is not None
    first, until = short.graph.entries
    entries = np.append(first, begins), np.append(until, last)
    return Reduced(replace(made, entries=entries), (*short.paths, *half.reshape(-1, 1)))


def _straight(setting: Setting, graph: ClassGraph, matters: Interest, every: int) -> Reduced | None:
    """Unit waits where it matters, and an edge for every step at which a way may begin."""
    relevant = matters.relevant
    kept = np.flatnonzero(relevant | (graph.start > 0))
    waits = np.flatnonzero(graph.wait & (graph.duration == 1) & np.isin(graph.tail, kept))
    if len(np.unique(graph.tail[waits])) < len(kept):
        return None
    tail, ways = _quickest(setting, graph, matters.limited, kept, np.flatnonzero(relevant))
    lasting = np.array([graph.duration[way].sum() for way in ways], dtype=np.int64)
    arrival = graph.earliest(setting.horizon)[tail]
    spans = np.maximum((setting.horizon - lasting - arrival) // every + 1, 0)
    chosen = np.repeat(np.arange(len(ways)), spans)
    turn = np.arange(len(chosen)) - np.repeat(np.cumsum(spans) - spans, spans)
    step = arrival[chosen] + every * turn
    paths = (*waits.reshape(-1, 1), *(ways[place] for place in chosen.tolist()))
    entries = np.append(np.zeros_like(waits), step), np.append(waits * 0 + setting.horizon, step)
    return Reduced(_along(graph, paths, entries), paths)


def _quickest(
    setting: Setting, graph: ClassGraph, limited: Bools, kept: Ints, goals: Ints
) -> tuple[Ints, list[Ints]]:
    """Tails and edges of the quickest ways between kept states that pass no limited one."""
    tails: list[Ints] = []
    ways: list[Ints] = []
    nowhere = np.zeros_like(limited)
    for goal in goals.tolist():
        closed = limited.copy()
        closed[goal] = True
        ends = Kept(kept, closed, nowhere, graph.group >= 0)
        found = shortcuts(graph, ends, float(setting.horizon), setting.clock)
        mine = np.flatnonzero(found[1] == goal)
        tails.append(found[0][mine])
        ways += [found[2][place] for place in mine.tolist()]
    return np.concatenate([*tails, kept[:0]]), ways


def _along(graph: ClassGraph, paths: tuple[Ints, ...], entries: tuple[Ints, Ints]) -> ClassGraph:
    """A graph whose edges are paths of another one."""
    first = np.array([path[0] for path in paths], dtype=np.int64)
    last = np.array([path[-1] for path in paths], dtype=np.int64)
    place = np.repeat(np.arange(len(paths)), [len(path) for path in paths])
    edges = np.concatenate([*paths, first[:0]])

    def total(values: Ints | Floats) -> Floats:
        return np.asarray(np.bincount(place, values[edges], len(paths)), dtype=np.float64)

    return replace(
        graph,
        tail=graph.tail[first],
        head=graph.head[last],
        duration=total(graph.duration).astype(np.int64),
        cost=total(graph.cost),
        risk=total(graph.risk),
        group=np.full(len(paths), -1),
        entries=entries,
    )
