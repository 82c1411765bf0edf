"""What the package gives to test planners with: strategies, random missions, plain errors."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import tsplan
from tests.command_line import printed
from tests.joint_plans import best, how_many
from tsplan import testing
from tsplan.checking.plan_check import check
from tsplan.logic import horizon
from tsplan.testing import maps, missions, random_mission, swarms, teams
from tsplan.testing.random_missions import random_swarm_mission, random_task_mission

few = settings(max_examples=10, deadline=None, suppress_health_check=list(HealthCheck))


def test_every_name_is_there():
    for name in testing.__all__:
        assert getattr(testing, name) is not None
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        testing.nothing  # noqa: B018


def test_without_hypothesis_the_remedy_is_named_and_random_missions_are_made():
    code = """
import sys
sys.modules["hypothesis"] = None
from tsplan.errors import TsplanError
from tsplan.testing import random_mission, run_corpus
print(random_mission(1).name)
try:
    from tsplan.testing import missions
except TsplanError as error:
    print(error)
"""
    assert printed(code).splitlines() == [
        "random 1",
        "'missions' needs hypothesis, which is not installed; pip install 'tsplan[test]'",
    ]


@few
@given(st.data())
def test_maps_carry_teams_and_swarms(data):
    system = data.draw(maps(most_states=3))
    assert len(system.states) <= 3
    assert {"a", "b"} <= set(system.labels)
    assert sum(group.count for group in data.draw(teams(system, most_agents=2))) <= 2
    swarm = data.draw(swarms(system))
    assert sum(swarm["at"].values()) == swarm["size"] <= 4


@few
@given(missions(most_steps=4), missions(swarm=True, most_steps=4))
def test_missions_are_planned_and_checked(team, swarm):
    assert (team.swarm, swarm.swarm is None) == (None, False)
    for mission in (team, swarm):
        assert horizon(mission.formula) <= 4
        plan = tsplan.plan(mission, time_limit=60)
        assert plan.status in ("optimal", "infeasible")
        if plan.has_paths:
            assert check(mission, plan).ok
        if how_many(mission) <= 300:
            assert (best(mission) is None) == (not plan.has_paths)


@pytest.mark.parametrize("make", [random_mission, random_task_mission, random_swarm_mission])
def test_a_seed_gives_the_same_mission_and_some_have_no_plan(make):
    made = [make(seed) for seed in range(12)]
    for seed, mission in enumerate(made):
        again = make(seed)
        assert (again.text, again.team, again.swarm) == (mission.text, mission.team, mission.swarm)
    assert len({mission.text for mission in made}) > 6
    seen = Counter(tsplan.plan(mission, time_limit=60).status for mission in made)
    assert min(seen["optimal"], seen["infeasible"]) >= 1


def test_what_never_fits_ends_in_an_error(monkeypatch):
    monkeypatch.setattr("tsplan.testing.random_missions._MOST_TRIES", 20)
    with pytest.raises(tsplan.MissionError, match="none of 20 missions that were drawn fits"):
        random_swarm_mission(1, fits=lambda _: False)


def test_the_job_with_rtamt_finds_all_it_imports():
    code = """
import sys
for name in ("antlr4", "highspy", "matplotlib", "networkx", "pydantic", "rich", "scipy", "yaml"):
    sys.modules[name] = None
import tests.conftest, tests.test_logic_rtamt
print("found")
"""
    assert printed(code) == "found\n"
