"""Whatever solvers say: nothing that is called certified is wrong."""

from __future__ import annotations

import pytest

import tsplan
from tests.joint_plans import SENSE, best, small_enough
from tests.lying import lie
from tests.seeds import seed_blocks
from tests.test_brute_force import small_mixed, small_swarms, small_team
from tsplan.errors import SolverError
from tsplan.plans.outcomes import CERTIFIED, Status

KINDS = (small_team, small_team, small_swarms, small_mixed)


def judge(seed: int, monkeypatch: pytest.MonkeyPatch) -> bool:
    """Whether an answer was certified; one that is has to be what all joint plans say."""
    mission = KINDS[seed % len(KINDS)](seed)
    if not small_enough(mission):
        return False
    truth = best(mission)
    with monkeypatch.context() as patched:
        lie(patched, seed)
        try:
            plan = tsplan.plan(mission, solver="lying", time_limit=2, certified=seed % 3 > 0)
        except SolverError:
            return False  # contradictions stop a run with a report
    if plan.status is Status.INFEASIBLE:
        if plan.proof == CERTIFIED:
            assert truth is None
        return plan.proof == CERTIFIED
    assert not plan.has_paths or truth is not None
    sure = bool(plan.objective)
    for item, value in zip(plan.objective, truth or (), strict=False):
        if item.proof != CERTIFIED or item.value is None or item.bound is None:
            return False
        # what is certified is a bound, and where it is the value there is nothing better
        assert SENSE[item.name] * item.bound <= value + 1e-6
        if item.value != item.bound:
            return False  # later objectives are of plans that keep less
        assert SENSE[item.name] * item.value == pytest.approx(value, abs=1e-6)
    return sure


@pytest.mark.parametrize("seeds", seed_blocks(range(8), range(8, 1000), 8))
def test_no_lie_is_certified(seeds, monkeypatch):
    certified = [judge(seed, monkeypatch) for seed in seeds]
    assert any(certified)
