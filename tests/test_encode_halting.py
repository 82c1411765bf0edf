"""The clock and the memory's end are heard while maps are reduced and models are made."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from tsplan import Mission, plan
from tsplan.clock import Clock, Halted
from tsplan.encode import memory as ceiling
from tsplan.encode import shortcuts
from tsplan.encode.assemble import reference, tight
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Setting
from tsplan.encode.memory import Watch, free_memory
from tsplan.encode.preparation import prepare
from tsplan.encode.shortcuts import Kept
from tsplan.milp.model import Draft
from tsplan.mission import Group
from tsplan.run.events import Incumbent
from tsplan.stopping import StoppedBy
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import grid


def team(objective: tuple[str, ...] = ("travel",)) -> Mission:
    system = grid(5, 5, labels={(0, 4): "A", (4, 0): "B", (4, 4): "C"})
    return Mission.of(
        map=system,
        team=[Group.of("r", {"r0c0": 3}, {"r"})],
        formula="F[0,20] A && F[0,20] B && F[0,30] (C && F[1,9] A)",
        language="mtl",
        objective=objective,
    )


def swarm() -> Mission:
    return Mission.of(
        map=grid(3, 3, labels={(0, 2): "A", (2, 0): "B"}),
        swarm={"size": 8, "at": "r0c0"},
        formula="F[0,6] (A && B)",
        language="mtl",
    )


class Counting:
    """A wish to stop that comes true at the n-th time it is asked for."""

    def __init__(self, after: int) -> None:
        self.left = after

    def __call__(self) -> bool:
        self.left -= 1
        return self.left < 0


def reason(make: Callable[[Clock], object], after: int) -> StoppedBy | None:
    """Why a making was halted whose clock is over at the n-th question."""
    try:
        make(Clock(stop=Counting(after)))
    except Halted as halted:
        return halted.reason
    return None


@pytest.mark.parametrize(
    "make",
    [
        lambda clock: prepare(team(), clock=clock),
        lambda clock: tight(_with(clock)),
        lambda clock: reference(_with(clock), (0, 0)),
        lambda clock: tight(prepare(swarm(), clock=clock)),
    ],
    ids=["reduction", "tight", "reference", "swarm"],
)
def test_a_wish_to_stop_is_heard_between_all_blocks(make: Callable[[Clock], object]) -> None:
    asked = Counting(10**9)
    make(Clock(stop=asked))
    times = 10**9 - asked.left
    assert times > 2
    assert {reason(make, after) for after in range(times)} == {StoppedBy.INTERRUPT}


def _with(clock: Clock) -> Setting:
    """A setting of less than `team`, as every model is made once for each question."""
    mission = Mission.of(
        map=grid(2, 3, labels={(0, 2): "A", (1, 0): "B"}),
        team=[Group.of("r", {"r0c0": 3}, {"r"})],
        formula="F[0,6] A && F[0,4] (B && F[1,3] A)",
        language="mtl",
        objective=("travel",),
    )
    return replace(prepare(mission), clock=clock)


@pytest.mark.parametrize("mission", [team(), swarm()], ids=["team", "swarm"])
def test_no_time_at_all_is_no_plan_found_by_the_time_limit(mission: Mission) -> None:
    made = plan(mission, time_limit=1e-9)
    assert (made.status, made.stopped_by) == ("no_plan_found", "time_limit")


def test_the_best_plan_is_kept_where_a_later_model_is_not_made(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Room for the first model only: the memory ends when the next one is made."""
    rooms = iter([1 << 40, 1 << 40])
    monkeypatch.setattr(ceiling, "free_memory", lambda: next(rooms, 1))
    made = plan(team(("availability", "travel")))
    assert (made.status, made.stopped_by, made.verified) == ("feasible", "memory", True)
    assert any("GB" in note or "MB" in note for note in made.notes)


def test_an_interrupt_is_no_time_limit() -> None:
    made = plan(team(("availability", "travel")), on_event=lambda e: isinstance(e, Incumbent))
    assert (made.status, made.stopped_by, made.verified) == ("feasible", "interrupt", True)


# --- memory -----------------------------------------------------------------------------------


@pytest.mark.parametrize("mission", [team(), swarm()], ids=["team", "swarm"])
def test_a_model_that_does_not_fit_is_refused_in_words(
    mission: Mission, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ceiling, "free_memory", lambda: 10_000)
    made = plan(mission)
    assert (made.status, made.stopped_by) == ("no_plan_found", "memory")
    (words,) = made.notes
    assert "columns" in words
    assert "free" in words
    assert "shorten the horizon" in words


def test_the_reference_encoding_is_refused_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ceiling, "free_memory", lambda: 100_000)
    made = plan(team(), encoding="reference")
    assert (made.status, made.stopped_by) == ("no_plan_found", "memory")


def test_a_draft_is_refused_before_its_columns_are_made() -> None:
    draft = Draft(Watch(Clock(), lambda: 10**9))
    draft.columns(1000)
    with pytest.raises(Halted, match="2,000,001,000 columns") as halted:
        draft.columns(2 * 10**9)  # 16 GB for their bounds alone
    assert halted.value.reason is StoppedBy.MEMORY


def test_what_cannot_be_known_refuses_nothing() -> None:
    Draft(Watch(Clock(), lambda: None)).columns(1000)
    found = free_memory()
    assert found is None or found > 0


# --- shortcuts --------------------------------------------------------------------------------


def line(states: int) -> ClassGraph:
    tail = np.concatenate([np.arange(states), np.arange(states - 1), np.arange(1, states)])
    head = np.concatenate([np.arange(states), np.arange(1, states), np.arange(states - 1)])
    ones = np.ones(len(tail), dtype=np.int64)
    start = np.zeros(states, dtype=np.int64)
    start[0] = 1
    return ClassGraph(
        frozenset(), start, tail, head, ones, ones.astype(np.float64), 0.0 * ones, -ones
    )


@pytest.mark.parametrize("crowded", [0, 10**9], ids=["whole map", "nearby"])
def test_both_searches_find_the_ways_between_neighbours(
    crowded: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shortcuts, "_CROWDED", crowded)
    graph = line(31)
    relevant = np.zeros(31, dtype=np.bool_)
    relevant[[10, 20, 30]] = True
    free = relevant.copy()
    free[20] = False
    kept = Kept(np.array([0, 10, 20, 30]), relevant, free, graph.wait)
    tail, head, paths = shortcuts.shortcuts(graph, kept, np.inf, Clock())
    # nobody may pass 20, and passing 10 is as good as going by
    expected = [(0, 10), (10, 20), (20, 10), (20, 30), (30, 20)]
    assert list(zip(tail.tolist(), head.tolist(), strict=True)) == expected
    assert [len(path) for path in paths] == [10] * 5


def test_searches_nearby_look_no_further_than_the_next_goals(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """With goals all over the map the work grows with the map, not with its square."""
    pops = 0

    def counted(heap: list[tuple[int, int]]) -> tuple[int, int]:
        nonlocal pops
        pops += 1
        return pop(heap)

    pop = shortcuts.heappop
    monkeypatch.setattr(shortcuts, "heappop", counted)
    relevant = np.arange(4000) % 10 == 0
    kept = Kept(np.flatnonzero(relevant), relevant, relevant, line(4000).wait)
    tail, _, _ = shortcuts.shortcuts(line(4000), kept, np.inf, Clock())
    assert len(tail) == 2 * 399
    assert pops < 4000 * 10


def test_a_hub_is_not_turned_into_all_its_pairs() -> None:
    states = [State("hub"), *(State(f"s{n}", labels=frozenset([f"L{n}"])) for n in range(30))]
    edges = [Edge(state.name, state.name, 1) for state in states]
    for state in states[1:]:
        edges += [Edge("hub", state.name, 1), Edge(state.name, "hub", 1)]
    mission = Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("r", {"s0": 1}, {"r"})],
        formula=" && ".join(f"F[0,50] L{n}" for n in range(30)),
        language="mtl",
    )
    (reduced,) = prepare(mission).reduced
    assert len(reduced.graph.tail) == len(edges)
