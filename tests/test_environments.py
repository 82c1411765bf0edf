"""The project's own maps and missions: they are what they say, and plans for them are right."""

import json
from pathlib import Path

import pytest

import tsplan
from tests.command_line import here
from tsplan.mission import load_mission
from tsplan.signals.signal_files import load_signal_mission, signal_mission_from_text
from tsplan.ts.io.map_files import load_map
from tsplan.ts.map_lint import lint
from tsplan.ts.reachability import reachable

FOLDER = Path(__file__).parents[1] / "environments"
MAPS = sorted(path.stem for path in FOLDER.glob("*.yaml") if "_" not in path.stem)
MISSIONS = sorted(path.stem for path in FOLDER.glob("*_*.yaml"))
SIGNALS = sorted(f"signals/{path.stem}" for path in FOLDER.glob("signals/*.yaml"))


def test_there_are_enough():
    assert len(MAPS) >= 4
    assert len(MISSIONS) >= 8
    assert {name.split("_")[0] for name in MISSIONS} == set(MAPS)


@pytest.mark.parametrize("name", [*MAPS, *MISSIONS, *SIGNALS])
def test_each_says_what_it_shows(name):
    text = (FOLDER / f"{name}.yaml").read_text(encoding="utf-8")
    assert len(text.split("\n", maxsplit=1)[0]) > 20
    assert text.startswith("# ")


@pytest.mark.parametrize("name", MAPS)
def test_maps_can_be_drawn_and_hold_no_surprises(name):
    system = load_map(FOLDER / f"{name}.yaml")
    assert lint(system) == []
    assert all(state.at is not None and state.shape is not None for state in system.states.values())


def test_sizes():
    assert len(load_map(FOLDER / "warehouse.yaml").states) >= 60
    rescue = load_map(FOLDER / "rescue.yaml")
    assert 100 < len(rescue.states) < 144
    walking = reachable(rescue, "r0c0", "rover", ())
    assert 90 < len(walking) < len(rescue.states)
    assert len(reachable(rescue, "r0c0", "drone", {"fly"})) == len(rescue.states)


def test_both_languages_are_shown():
    languages = [load_mission(FOLDER / f"{name}.yaml").language for name in MISSIONS]
    assert languages.count("catl") >= 3
    assert languages.count("mtl") >= 3


@pytest.mark.parametrize("name", MISSIONS)
def test_missions_are_modest_and_raise_no_warnings(name):
    mission = load_mission(FOLDER / f"{name}.yaml")
    assert mission.warnings == ()
    assert mission.horizon <= 60
    assert mission.size <= (40 if mission.swarm is None else 1000)


@pytest.mark.parametrize("name", SIGNALS)
def test_missions_over_signals_are_modest_and_written_as_they_are_read(name):
    mission = load_signal_mission(FOLDER / f"{name}.yaml")
    assert mission.warnings == ()
    assert mission.horizon <= 60
    assert signal_mission_from_text(mission.to_yaml()) == mission


def test_every_kind_of_mission_over_signals_is_shown():
    missions = [load_signal_mission(FOLDER / f"{name}.yaml") for name in SIGNALS]
    assert {mission.language for mission in missions} == {"stl", "wstl"}
    kinds = {
        "free": any(mission.system.dynamics is None for mission in missions),
        "several": any(mission.copies for mission in missions),
        "in part": any(mission.satisfaction for mission in missions),
        "preferred": any(mission.prefer for mission in missions),
        "sum": any(aim.name == "J" for mission in missions for aim in mission.objective),
    }
    assert [kind for kind, there in kinds.items() if not there] == []


@pytest.mark.parametrize("limit", ["0.6"])
def test_a_short_limit_gives_a_verified_plan_or_none(limit, tmp_path):
    arguments = ["plan", str(FOLDER / "office_wishes.yaml"), "--json", "--time-limit", limit]
    code, out, err = here(*arguments, folder=tmp_path)
    assert code in (0, 4), err
    plan = json.loads(out, parse_constant=pytest.fail)
    assert (plan["status"], plan["verified"]) in (
        ("optimal", True),
        ("feasible", True),
        ("no_plan_found", False),
    )


def test_one_bound_alone_makes_the_thin_survey_infeasible():
    survey, thin = (load_mission(FOLDER / f"reef_{name}.yaml") for name in ("survey", "thin"))
    assert (survey.goal, survey.horizon, survey.team) == (thin.goal, thin.horizon, thin.team)
    assert [m.swarm.each["swarm"].most for m in (survey, thin)] == [3, 2]
    assert survey.swarm.each["swarm"].least == thin.swarm.each["swarm"].least


@pytest.mark.long
def test_one_sub_swarm_more_makes_the_thin_survey_feasible():
    plan = tsplan.plan(load_mission(FOLDER / "reef_survey.yaml"))
    assert max(len(plan.groups_at(step)) for step in range(plan.horizon + 1)) == 3


@pytest.mark.long
def test_the_halves_of_the_swarm_that_regroups_meet_early():
    plan = tsplan.plan(load_mission(FOLDER / "reef_regroup.yaml"))
    met = next(step for step in range(plan.horizon) if len(plan.groups_at(step)) == 1)
    # apart, the halves would only meet at the lagoon, a step before the beacon, by nine moves
    assert met <= 6


@pytest.mark.long
def test_the_drifting_swarm_has_room_enough():
    mission = load_mission(FOLDER / "reef_drift.yaml")
    assert mission.swarm.margin == tsplan.margin_for(mission, 0.99)
    found = tsplan.plan(mission, time_limit=60).simulate(mission, runs=2000)
    assert found.formula.rate >= 0.99
