"""Both encodings, with each idea on and off, agree on random missions with all operators."""

from __future__ import annotations

import pytest

import tsplan
from tsplan.encode.options import Idea
from tsplan.plans.plan import Plan
from tsplan.testing import random_mission

SHORT = range(60)
LONG = range(60, 2060)


def answer(plan: Plan) -> tuple[str, tuple[tuple[str, float | None], ...]]:
    """What must not depend on the encoding."""
    assert plan.status in ("optimal", "infeasible"), plan.status
    assert plan.verified == (plan.status == "optimal")
    for item in plan.objective:
        assert item.value == item.bound or item.value == pytest.approx(item.bound, abs=1e-4)
    rounded = tuple(
        (item.name, None if item.value is None else round(item.value, 4)) for item in plan.objective
    )
    return str(plan.status), rounded


def agree(seed: int) -> None:
    mission = random_mission(seed)
    expected = answer(tsplan.plan(mission, encoding="reference"))
    assert answer(tsplan.plan(mission)) == expected


@pytest.mark.parametrize("seed", SHORT)
def test_tight_and_reference_agree(seed: int) -> None:
    agree(seed)


@pytest.mark.long
@pytest.mark.parametrize("seed", LONG)
def test_tight_and_reference_agree_on_many(seed: int) -> None:
    agree(seed)


@pytest.mark.parametrize("idea", list(Idea))
def test_switching_an_idea_off_changes_no_answer(idea: Idea) -> None:
    for seed in range(100, 112):
        mission = random_mission(seed)
        assert answer(tsplan.plan(mission, without=(idea.value,))) == answer(tsplan.plan(mission))


@pytest.mark.long
@pytest.mark.parametrize("idea", list(Idea))
def test_switching_an_idea_off_changes_no_answer_on_many(idea: Idea) -> None:
    for seed in range(3000, 3200):
        mission = random_mission(seed)
        assert answer(tsplan.plan(mission, without=(idea.value,))) == answer(tsplan.plan(mission))


def test_without_any_idea() -> None:
    names = tuple(idea.value for idea in Idea)
    for seed in range(120, 140):
        mission = random_mission(seed)
        assert answer(tsplan.plan(mission, without=names)) == answer(tsplan.plan(mission))
