"""Plans on grids for PlanViz: its moves lead from the start through the cells of the plan."""

from __future__ import annotations

import json
from random import Random

import pytest

from tests.exporting import random_walk, text_of
from tests.viewing import mission_on, plan_of
from tsplan import Group
from tsplan.errors import PlanError
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import cell_name, grid
from tsplan.writers.grid_cells import grid_cells

# rows and columns that a move adds, for the action model MAPF
SHIFTS = {"R": (0, 1), "L": (0, -1), "U": (1, 0), "D": (-1, 0), "W": (0, 0), "T": (0, 0)}
ROWS, COLUMNS = 4, 5


def board(*, long_wait=False):
    """A grid with walls; at some cells waits may take two steps."""
    made = grid(ROWS, COLUMNS, blocked={(1, 1), (2, 3)}, labels={(0, 0): "home"})
    edges = list(made.edges.values())
    if long_wait:
        edges = [Edge(e.source, e.target, 2) if e.is_wait else e for e in edges]
    return TransitionSystem.build(made.states.values(), edges, "board")


def plan_on(system, seed=0, horizon=15, agents=3):
    random = Random(seed)
    start = next(iter(system.states))
    team = [Group.of("cart", {start: agents})]
    mission = mission_on(system, team, "F[0,1] sum(home) >= 0", horizon)
    paths = [random_walk(system, "cart", start, horizon, random) for _ in range(agents)]
    return plan_of(mission, paths)


def played(data, number):
    """The cells of an agent at every step, as PlanViz goes through its moves."""
    row, column, heading = data["start"][number]
    assert heading == "N/A"
    cells = [(row, column)]
    for move in data["actualPaths"][number].split(","):
        cells.append(tuple(a + b for a, b in zip(cells[-1], SHIFTS[move], strict=True)))
    return cells


@pytest.mark.parametrize("long_wait", [False, True])
@pytest.mark.parametrize("seed", range(5))
def test_moves_lead_through_the_cells_of_the_plan(seed, long_wait, tmp_path):
    system = board(long_wait=long_wait)
    plan = plan_on(system, seed)
    data = json.loads(text_of(plan, "planviz", system, tmp_path))
    assert (data["actionModel"], data["version"], data["AllValid"]) == ("MAPF", "2023 LoRR", "No")
    assert (data["teamSize"], data["makespan"], data["errors"]) == (3, plan.horizon, [])
    assert data["agents"] == [agent.id for agent in plan.agents]
    assert data["plannerPaths"] == data["actualPaths"]
    costs = 0
    for number, agent in enumerate(plan.agents):
        cells = played(data, number)
        assert len(cells) == plan.horizon + 1
        for first, last, state in agent.stays:
            for step in range(first, last + 1):
                assert cell_name(*cells[step]) == state
        [[task, begin, assigned], [same, end, finished]] = data["events"][number]
        assert (task, same, begin, assigned, finished) == (
            number,
            number,
            0,
            "assigned",
            "finished",
        )
        assert data["tasks"][number] == [number, *cells[-1]]
        assert set(cells[end:]) == {cells[-1]}
        assert end == 0 or cells[end - 1] != cells[-1]
        costs += end
    assert (data["numTaskFinished"], data["sumOfCost"]) == (3, costs)


def test_the_grid_is_written_as_planviz_reads_it(tmp_path):
    system = board()
    lines = text_of(plan_on(system), "movingai", system, tmp_path).splitlines()
    assert lines[:4] == ["type octile", f"height {ROWS}", f"width {COLUMNS}", "map"]
    assert {len(line) for line in lines[4:]} == {COLUMNS}
    free = {
        (r, c) for r, line in enumerate(lines[4:]) for c, mark in enumerate(line) if mark == "."
    }
    assert free == set(grid_cells(system).values())
    assert "".join(lines[4:]).count("@") == 2


def test_a_huge_grid_is_refused(tmp_path):
    states = [State("r0c0", frozenset({"home"})), State("r99999999c9")]
    edges = [Edge(state.name, state.name) for state in states]
    system = TransitionSystem.build(states, edges)
    with pytest.raises(PlanError, match="100,000,000 rows and 10 columns"):
        text_of(plan_on(system), "movingai", system, tmp_path)


def renamed(system, name, place):
    """The same map with other names and coordinates."""
    names = {old: name(number) for number, old in enumerate(system.states)}
    states = [
        State(names[old], state.labels, None if place is None else place(*grid_cells(system)[old]))
        for old, state in system.states.items()
    ]
    edges = [Edge(names[e.source], names[e.target], e.duration) for e in system.edges.values()]
    return TransitionSystem.build(states, edges), names


@pytest.mark.parametrize(
    "place",
    [
        lambda row, column: (column, -row),
        lambda row, column: (0.1 + 0.7 * column, 3.3 - 0.7 * row),
        lambda row, column: (1e6 + 0.05 * column, 0.05 * (7 - row)),
    ],
)
def test_coordinates_tell_rows_from_the_top(place, tmp_path):
    system = board()
    other, names = renamed(system, lambda n: f"s{n}", place)
    assert {names[old]: cell for old, cell in grid_cells(system).items()} == grid_cells(other)
    plan = plan_on(other, 2)
    data = json.loads(text_of(plan, "planviz", other, tmp_path))
    old = {new: name for name, new in names.items()}
    for number, agent in enumerate(plan.agents):
        cells = played(data, number)
        assert all(cell_name(*cells[first]) == old[state] for first, _, state in agent.stays)


@pytest.mark.parametrize(
    ("name", "place"),
    [
        (lambda n: f"s{n}", None),
        (lambda n: f"s{n}", lambda row, column: (column + 0.3 * (row == 2), row)),
        (lambda n: f"s{n}", lambda row, column: (column // 9, row // 9)),
        (lambda n: f"r{n}c0" if n else "hall", None),
        (lambda n: f"r{n}c0" if n else "r01c0", None),
    ],
)
def test_maps_that_are_no_grid_are_refused(name, place, tmp_path):
    system, _ = renamed(board(), name, place)
    assert grid_cells(system) is None
    for to in ("planviz", "movingai"):
        with pytest.raises(PlanError, match="the map is no grid"):
            text_of(plan_on(system), to, system, tmp_path)
    assert list(tmp_path.iterdir()) == []


def line(*edges):
    """A row of five cells with some edges."""
    states = [State(cell_name(0, n), frozenset({"home"})) for n in range(5)]
    waits = [Edge(state.name, state.name) for state in states]
    return TransitionSystem.build(states, [*waits, *edges])


@pytest.mark.parametrize(
    ("edge", "horizon", "words"),
    [
        (Edge("r0c0", "r0c2"), 4, "which is no neighbouring cell of its row or column"),
        (Edge("r0c0", "r0c1", 2), 4, "which takes 2 steps, and PlanViz knows one"),
        (Edge("r0c0", "r0c1", 9), 4, "which takes 9 steps, and PlanViz knows one"),
    ],
)
def test_moves_that_it_cannot_show_are_refused_with_who_makes_them(edge, horizon, words, tmp_path):
    system = line(edge)
    mission = mission_on(system, [Group.of("cart", {"r0c0": 3})], "home", horizon)
    arrives = 1 + edge.duration
    way = ((0, 1, "r0c0"), (arrives, horizon, edge.target))
    moved = (way, None) if arrives <= horizon else (way[:1], edge.target)
    still = (((0, horizon, "r0c0"),), None)
    plan = plan_of(mission, [still, moved, moved])
    with pytest.raises(PlanError) as caught:
        text_of(plan, "planviz", system, tmp_path)
    [finding] = caught.value.findings
    assert finding.message == f"agent cart-2 goes from r0c0 to {edge.target} at step 1, {words}"
    assert finding.remedy == "export as csv, geojson or graphml"
    assert text_of(plan, "planviz", system, tmp_path, agents=["cart-1"])


def test_a_plan_without_moves_is_refused(tmp_path):
    system = line()
    mission = mission_on(system, [Group.of("cart", {"r0c0": 1})], "home", 0)
    with pytest.raises(PlanError, match="ends at step 0"):
        text_of(plan_of(mission, [(((0, 0, "r0c0"),), None)]), "planviz", system, tmp_path)
