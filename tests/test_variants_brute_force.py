"""Starts under way and places closed for a time: against the best of all joint plans."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import tsplan
from tests.joint_plans import best, how_many, small_enough
from tests.module_missions import TooManyError, random_module_mission, worth
from tests.module_missions import best as best_of_modules
from tests.narrow_missions import narrow_mission
from tests.resource_missions import random_resource_mission
from tests.seeds import seed_blocks
from tests.test_brute_force import (
    PLAIN,
    REFERENCE,
    TIGHT,
    compare,
    small_mixed,
    small_swarms,
    small_team,
)
from tests.test_late import compare as compare_late
from tests.test_late import delayed
from tests.test_resources_brute_force import compare as compare_resources
from tsplan import Mission, Plan
from tsplan.search import capacity_relaxation
from tsplan.testing import with_closures, with_starts_under_way

FEW = 100
"""Joint plans of a mission, each with all that can be done with its resources."""


def under_way(mission: Mission, seed: int) -> Mission | None:
    """The mission with starts under way, if it can have some."""
    made = with_starts_under_way(mission, seed)
    return made if any(group.coming for group in made.team) else None


def closed(mission: Mission, seed: int) -> Mission | None:
    """The mission with places closed for a time, now and then with starts under way, too."""
    made = with_closures(mission, seed)
    if seed % 3 == 0 and not made.resources:
        made = with_starts_under_way(made, seed)
    return made if made.system.timed else None


Vary = Callable[[Mission, int], Mission | None]
variants = pytest.mark.parametrize("vary", [under_way, closed])


def varied(mission: Mission, vary: Vary, seed: int) -> Mission | None:
    """A variant of a mission, if it has one that is small enough."""
    made = vary(mission, seed)
    return made if made is not None and small_enough(made) else None


@variants
@pytest.mark.parametrize("seeds", seed_blocks(range(10_000, 10_005), range(10_000, 12_000), 15))
def test_teams(vary: Vary, seeds: list[int]) -> None:
    for seed in seeds:
        mission = varied(small_team(seed), vary, seed)
        if mission is not None:
            compare(mission, TIGHT, REFERENCE, PLAIN)


@variants
@pytest.mark.parametrize("seeds", seed_blocks(range(30_000, 30_003), range(30_000, 32_000), 14))
def test_swarms(vary: Vary, seeds: list[int]) -> None:
    for seed in seeds:
        mission = varied(small_swarms(seed), vary, seed)
        if mission is not None:
            compare(mission, TIGHT, REFERENCE)


@variants
@pytest.mark.parametrize("seeds", seed_blocks(range(40_000, 40_003), range(40_000, 41_000), 12))
def test_robots_beside_swarms(vary: Vary, seeds: list[int]) -> None:
    for seed in seeds:
        mission = varied(small_mixed(seed), vary, seed)
        if mission is not None:
            compare(mission, TIGHT, PLAIN)


@variants
@pytest.mark.parametrize("seeds", seed_blocks(range(6), range(600), 12))
def test_late_agents(vary: Vary, seeds: list[int]) -> None:
    for seed in seeds:
        mission = varied(delayed(seed, states=4, most_agents=3, steps=6), vary, seed)
        if mission is not None:
            compare_late(mission)


@variants
@pytest.mark.parametrize("seeds", seed_blocks(range(1, 4), range(400), 4))
def test_carriers(vary: Vary, seeds: list[int]) -> None:
    for seed in seeds:
        mission = vary(random_resource_mission(seed, most=2), seed)
        if mission is not None and how_many(mission) <= FEW:
            compare_resources(mission, 1.0)


@pytest.mark.parametrize("seeds", seed_blocks(range(5), range(1_000), 10))
def test_structures_under_way_or_being_rebuilt(seeds: list[int]) -> None:
    for seed in seeds:
        mission = under_way(random_module_mission(seed), seed)
        if mission is None:
            continue
        try:
            expected = best_of_modules(mission)
        except TooManyError:
            continue
        for encoding in ("tight", "reference"):
            plan = tsplan.plan(mission, encoding=encoding)
            assert plan.has_paths == (expected is not None), (seed, encoding)
            if expected is not None:
                values = {item.name: item.value for item in plan.objective}
                assert worth(mission, values) == pytest.approx(expected), (seed, encoding)
                assert tsplan.check(mission, Plan.from_json(plan.to_json())).ok, (seed, encoding)


@pytest.mark.parametrize("seeds", seed_blocks(range(15), range(2_000), 30))
def test_teams_under_way_in_narrow_places(
    seeds: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(capacity_relaxation, "SMALL", 0)
    for seed in seeds:
        narrow = narrow_mission(seed, states=4, most_agents=3, steps=5)
        mission = None if narrow is None else varied(narrow, under_way, seed)
        if mission is not None:
            compare(mission, {})


@variants
def test_the_random_missions_are_of_all_kinds(vary: Vary) -> None:
    made = [varied(small_team(seed), vary, seed) for seed in range(10_000, 10_030)]
    small = [mission for mission in made if mission is not None]
    assert len(small) >= 12
    assert 3 <= sum(best(mission) is None for mission in small) <= len(small) - 3
