"""Long missions in pieces."""

from __future__ import annotations

import pytest

import tsplan
from tests.command_line import here
from tests.seeds import seed_blocks
from tsplan.errors import InputError
from tsplan.testing import random_mission
from tsplan.ts.builders import grid

ROUNDS = " && ".join(f"F[{first},{first + 9}] corner" for first in range(5, 100, 15))


def rounds(steps: int = 110, text: str = ROUNDS) -> tsplan.Mission:
    return tsplan.Mission.of(
        map=grid(3, 3, labels={(2, 2): "corner", (0, 0): "home"}),
        team={"cart": {"r0c0": 2}},
        formula=f"{text} && G[0,{steps - 10}] F[0,8] home",
        language="mtl",
        horizon=steps,
    )


def test_a_long_mission_is_planned_as_well_as_at_once() -> None:
    mission, windows = rounds(), []
    made = tsplan.plan_in_pieces(mission, 30, 10, on_piece=lambda *ends: windows.append(ends))
    assert (made.status, made.stopped_by, made.verified) == ("feasible", "window", True)
    assert tsplan.check(mission, made).ok
    assert made.value("travel") == tsplan.plan(mission).value("travel")
    assert windows[0] == (0, 30)
    assert [first for first, _ in windows] == list(range(0, 81, 10))


def test_one_window_is_enough_for_a_short_mission() -> None:
    mission = rounds()
    assert tsplan.plan_in_pieces(mission, 200, 50).objective == tsplan.plan(mission).objective


def test_a_window_without_a_plan_becomes_longer() -> None:
    # the carts are needed at once at both ends of a corridor that is longer than the window
    corridor = grid(1, 12, labels={(0, 11): "far"})
    mission = tsplan.Mission.of(
        map=corridor,
        team={"cart": {"r0c0": 1}},
        formula="F[0,30] far && G[20,20] far",
        language="mtl",
        horizon=30,
    )
    windows: list[tuple[int, int]] = []
    made = tsplan.plan_in_pieces(mission, 8, 4, on_piece=lambda *ends: windows.append(ends))
    assert made.has_paths == (made.status == "feasible")
    assert max(last - first for first, last in windows) > 8


def test_what_the_first_window_refutes_is_infeasible() -> None:
    mission = rounds(text="G[0,3] corner")
    made = tsplan.plan_in_pieces(mission, 20, 10)
    assert made.status == "infeasible"


@pytest.mark.parametrize("seeds", seed_blocks(range(15), range(1000), 30))
def test_plans_in_pieces_stand_and_refutations_are_true(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_mission(seed, states=4, most_agents=3, steps=6)
        if mission.delay or "delay" in mission.objective or mission.partial or mission.prefer:
            continue
        made = tsplan.plan_in_pieces(mission, 3, 1)
        if made.has_paths:
            assert tsplan.check(mission, made).ok, seed
        elif made.status == "infeasible":
            assert tsplan.plan(mission).status == "infeasible", seed
        else:
            assert made.status == "no_plan_found", seed


def test_numbers_that_are_none_are_told() -> None:
    with pytest.raises(InputError, match="window: "):
        tsplan.plan_in_pieces(rounds(), 0, 1)
    with pytest.raises(InputError, match="12 steps are kept of a window of 10"):
        tsplan.plan_in_pieces(rounds(), 10, 12)


def test_the_command_line_plans_in_pieces(tmp_path) -> None:
    mission, plan = tmp_path / "rounds.yaml", tmp_path / "plan.json"
    rounds(60, "F[5,14] corner && F[35,44] corner").save(mission)
    done = here("plan", str(mission), "--window", "20", "--commit", "10", "-o", str(plan))
    assert done.code == 0
    assert "search ended with the last window" in done.out
    assert here("check", str(mission), str(plan)).code == 0
    alone = here("plan", str(mission), "--commit", "10")
    assert (alone.code, "--window" in alone.err) == (2, True)
