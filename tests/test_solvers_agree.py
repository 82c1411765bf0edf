"""Every installed solver gives the same answers, with both encodings."""

from __future__ import annotations

import pytest

import tsplan
from tests.seeds import seed_blocks
from tsplan.errors import SolverUnavailableError
from tsplan.milp.solver import solver
from tsplan.testing import random_mission

NAMES = ["highs", "gurobi", "pulp:PULP_CBC_CMD"]


def usable(name: str) -> bool:
    try:
        solver(name)
    except SolverUnavailableError:
        return False
    return True


def answers(seed: int, name: str) -> list[object]:
    mission = random_mission(seed, states=3, most_agents=2, steps=4)
    found: list[object] = []
    # without its own searches the tight encoding leaves everything to the solver
    for encoding, without in (("tight", ("dive", "tree")), ("reference", ())):
        plan = tsplan.plan(mission, solver=name, encoding=encoding, without=without)
        values = [(item.name, item.value) for item in plan.objective]
        found.append((plan.status, values))
    return found


@pytest.mark.parametrize("name", NAMES[1:])
@pytest.mark.parametrize(
    "seeds", seed_blocks(range(500, 502), [*range(500, 512), *range(600, 900)], 12)
)
def test_solvers_agree_with_highs(name: str, seeds: list[int]) -> None:
    if not usable(name):
        pytest.skip(f"{name} cannot be used here")
    for seed in seeds:
        assert answers(seed, name) == answers(seed, "highs")
