"""Searches that begin with a plan: what they find is what they would find without it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

import tsplan
from tests.command_line import here
from tests.narrow_missions import sliding
from tests.seeds import long, seed_blocks
from tsplan.errors import InputError, PlanError
from tsplan.run.events import Incumbent
from tsplan.search import capacity_relaxation
from tsplan.testing.random_missions import random_mission, random_task_mission

HARVEST = Path("environments/farm_harvest.yaml")
BOOKED = Path("environments/site_booked.yaml")
LATE = Path("environments/office_late.yaml")


@cache
def planned(path: Path) -> tsplan.Plan:
    return tsplan.plan(tsplan.load_mission(path))


def first_plan(mission: tsplan.Mission, **options) -> tuple[tsplan.Plan, tsplan.Plan]:
    """The plan that is told of first, and the one at the end."""
    told: list[tsplan.Plan] = []

    def hear(event: tsplan.Event) -> None:
        if isinstance(event, Incumbent) and not told and event.plan is not None:
            told.append(event.plan())

    made = tsplan.plan(mission, on_event=hear, **options)
    return told[0], made


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize("draw", [random_mission, random_task_mission])
@pytest.mark.parametrize("block", seed_blocks(range(3), range(406), 20))
def test_the_plan_itself_is_the_first_found(draw, encoding: str, block) -> None:
    for seed in block:
        mission = draw(seed)
        made = tsplan.plan(mission)
        if not made.has_paths or mission.objective[:1] == ("delay",) or mission.delay:
            continue
        first, again = first_plan(mission, start=made, encoding=encoding)
        values = [(item.name, item.value) for item in made.objective]
        assert [(item.name, item.value) for item in again.objective] == values, seed
        assert first.value(mission.objective[0]) == made.objective[0].value if values else True, (
            seed
        )


def test_capacities_are_looked_at_with_the_plan_in_hand(monkeypatch) -> None:
    monkeypatch.setattr(capacity_relaxation, "SMALL", 0)
    mission = sliding(5)
    made = tsplan.plan(mission)
    first, again = first_plan(mission, start=made)
    assert first.value("travel") == again.value("travel") == made.value("travel")


@pytest.mark.parametrize(
    ("path", "formula", "elsewhere"),
    [(BOOKED, "F[0,9] sum(wall) >= 1", LATE), long(HARVEST, "F[0,30] sum(wheat) >= 1", BOOKED)],
)
def test_a_plan_of_another_mission_does_no_harm(path: Path, formula: str, elsewhere: Path) -> None:
    mission = tsplan.load_mission(path)
    fewer = replace(mission, formula=tsplan.parse(formula), text="", objective=("travel",))
    easy, hard = tsplan.plan(fewer), planned(path)
    assert easy.objective != hard.objective
    assert tsplan.plan(mission, start=easy).objective == hard.objective
    assert tsplan.plan(fewer, start=hard).objective == easy.objective
    other = tsplan.load_mission(elsewhere)
    assert tsplan.plan(other, start=hard).objective == planned(elsewhere).objective


def test_what_is_no_start_is_said() -> None:
    booked = tsplan.load_mission(BOOKED)
    none = tsplan.plan(replace(booked, formula=tsplan.parse("false"), text=""))
    with pytest.raises(PlanError, match="no paths"):
        tsplan.plan(booked, start=none)
    with pytest.raises(InputError, match="over signals"):
        tsplan.plan("environments/signals/reach_avoid.yaml", start=planned(BOOKED))


def test_the_command_line_starts_from_a_file(tmp_path) -> None:
    old, new = tmp_path / "old.json", tmp_path / "new.json"
    assert here("plan", str(BOOKED), "-o", str(old)).code == 0
    assert here("plan", str(BOOKED), "--start", str(old), "-o", str(new)).code == 0
    values = [tsplan.load_plan(path).objective for path in (old, new)]
    assert values[0] == values[1]
    over = here("plan", str(BOOKED), "--start", str(old), "-o", str(old))
    assert over.code == 2
    assert "read by the same command" in over.err
