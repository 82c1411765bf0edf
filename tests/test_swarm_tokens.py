"""Tokens bound the number of splits from below; what is found along their ways are real plans."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest

import tsplan
from tests.joint_plans import best
from tests.seeds import sampled, seed_blocks
from tsplan import Mission
from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.groups.token_flow import tokens
from tsplan.encode.model_objectives import Splits
from tsplan.encode.preparation import prepare
from tsplan.milp.model import Floats, Model
from tsplan.milp.solution import Options
from tsplan.milp.solver import solver
from tsplan.search.guided_restriction import fewest, guided
from tsplan.ts import Edge, State, TransitionSystem


def ring() -> TransitionSystem:
    """Four states in a ring, each with a label of its own; one may wait everywhere."""
    names = ["a", "b", "c", "d"]
    states = [State(name, labels=frozenset({name.upper()})) for name in names]
    edges = [Edge(name, name) for name in names]
    for number, name in enumerate(names):
        other = names[(number + 1) % 4]
        edges += [Edge(name, other), Edge(other, name)]
    return TransitionSystem.build(states, edges, name="ring")


def splitting(seed: int) -> Mission:
    """Three agents at one place of a ring, wanted at several places at once."""
    random = Random(seed)
    parts = []
    for _ in range(2):
        low = random.randint(0, 2)
        wanted = random.sample(["A", "B", "C", "D"], random.randint(1, 3))
        parts.append(f"F[{low},{random.randint(low, 3)}] ({' && '.join(wanted)})")
    return Mission.of(
        map=ring(),
        swarm={
            "size": 3,
            "at": {random.choice("abcd"): 3},
            "max_subswarms": random.choice([None, 2, 3]),
            "min_subswarm": random.choice([1, 1, 2]),
        },
        formula=" && ".join(parts),
        objective=["splits"],
        horizon=3,
    )


def solve(model: Model) -> Floats | None:
    return solver("highs").solve(model, Options(time_limit=20.0)).values


@pytest.mark.parametrize("block", sampled(range(2), []))
def test_no_plan_has_fewer_splits_than_tokens_say(block: int) -> None:
    for seed in range(40_000 + 6 * block, 40_006 + 6 * block):
        mission = splitting(seed)
        expected = best(mission)
        bound = fewest(tokens(prepare(mission)), Clock(20.0)).bound
        assert bound - 1e-6 <= (np.inf if expected is None else expected[0])


@pytest.mark.parametrize("seeds", seed_blocks(range(40_000, 40_008), range(40_000, 40_050), 50))
def test_bounds_are_met_and_infinite_often(seeds: list[int]) -> None:
    met = infinite = 0
    for seed in seeds:
        mission = splitting(seed)
        bound = fewest(tokens(prepare(mission)), Clock(20.0)).bound
        plan = tsplan.plan(mission)
        if plan.status == "infeasible":
            infinite += np.isinf(bound)
        else:
            value = plan.objective[0].value
            assert value is not None
            met += bound > value - 1 + 1e-6 and value >= 1
    assert met >= len(seeds) // 5
    assert infinite >= len(seeds) // 5


def test_where_merging_costs_a_split_the_whole_problem_decides() -> None:
    mission = Mission.of(
        map=ring(),
        swarm={"size": 3, "at": {"a": 3}},
        formula="F[1,1] (A && B) && G[2,2] sum(A) >= 100% && F[3,3] (A && B)",
        objective=["splits"],
    )
    assert fewest(tokens(prepare(mission)), Clock(20.0)).bound == pytest.approx(1)
    assert tsplan.plan(mission).objective[0].value == 2
    assert best(mission) == (2.0,)


@pytest.mark.parametrize("seeds", seed_blocks(range(40_000, 40_009), range(40_000, 40_060), 60))
def test_what_is_found_along_their_ways_is_a_point_of_the_whole_problem(seeds: list[int]) -> None:
    seen = 0
    for seed in seeds:
        mission = splitting(seed)
        setting = prepare(mission)
        encoded = tight(setting)
        vector = Splits().vector(setting, encoded)
        for splits, point in guided(tokens(setting), encoded, vector, Clock(20.0), solve):
            if point is not None:
                seen += 1
                assert encoded.model.violation(point) < 1e-6
                assert vector @ point == pytest.approx(splits)
    assert seen >= len(seeds) // 3
