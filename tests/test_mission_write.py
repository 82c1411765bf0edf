"""Missions written to files: what is read back is the same mission, and everything works on it."""

from __future__ import annotations

import re
import stat
from dataclasses import replace
from fractions import Fraction
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan import check, load_mission, load_plan
from tsplan.cli import main
from tsplan.errors import FormulaError, InputError, MissionError
from tsplan.logic import limit, parse, simplify
from tsplan.mission import (
    Group,
    Mission,
    Preference,
    SolverChoice,
    SwarmBounds,
    SwarmRules,
    mission_from_text,
)
from tsplan.testing.random_missions import (
    CAPABILITIES,
    random_formula,
    random_map,
    random_mission,
    random_swarm_mission,
    random_task_mission,
)
from tsplan.ts import Edge, State, TransitionSystem

YARD = TransitionSystem.build(
    [
        State("dock", frozenset({"home"}), at=(0.5, 2), capacity=30),
        State("12", frozenset({"no", "Ä b"}), needs=frozenset({"fly"})),
        State("q: 1", color="red", shape=((0, 0), (1, 0.25), (1, 1))),
    ],
    [
        Edge("dock", "dock"),
        Edge("dock", "q: 1", {"cart": 2, "default": 1}, both_ways=True, capacity=4),
        Edge("q: 1", "dock", {"cart": 2, "default": 1}, both_ways=True, capacity=4),
        Edge("dock", "12", 2, cost=0.125, needs=frozenset({"fly"})),
    ],
    name="yard #1",
)
CART, DRONE = Group.of("cart", {"dock": 2, "q: 1": 1}), Group.of("drone", {"12": 3}, ["fly"])


def alike(mission):
    text = mission.to_yaml()
    read = mission_from_text(text)
    assert read == mission
    assert read.formula is mission.formula
    assert [soft.formula for soft in read.prefer] == [soft.formula for soft in mission.prefer]
    assert read.to_yaml() == text
    return text


def random_prefer(random):
    return [
        Preference(
            parse(random_formula(random, 1)),
            weight=Fraction(random.randint(1, 40), 8),
            name=f"soft {number}",
            level=random.randint(0, 2),
            partial=random.random() < 0.5,
        )
        for number in range(random.randint(0, 2))
    ]


def random_kind(seed):
    """A mission with robots, swarms or both, with every field that a mission has."""
    random = Random(f"written {seed}")
    while True:
        system = random_map(random, 4, strange=random.random() < 0.5)
        names = list(system.states)
        teams, swarms = random.choice([(2, 0), (0, 1), (0, 2), (1, 1), (2, 2)])
        prefer = random_prefer(random)
        aims = random.choice([["travel"], ["makespan", "travel"], []])
        if not prefer and random.random() < 0.3:
            aims = [{"satisfaction": random.choice(["weighted", "depth"])}, *aims]
        values = {
            "team": [
                Group.of(f"k{n}", {random.choice(names): 1, names[n]: 2}, CAPABILITIES[:n])
                for n in range(teams)
            ],
            "swarms": [
                {
                    "name": f"w{n}",
                    "size": 5,
                    "at": {names[0]: 3, names[1]: 2},
                    "min_subswarm": random.randint(1, 2),
                    **random.choice([{}, {"max_subswarms": 4}, {"capabilities": ["u"]}]),
                }
                for n in range(swarms)
            ],
        }
        more = {"margin": random.choice(["12.5%", 1, None])} if swarms and aims[:1] else {}
        if swarms == 1 and random.random() < 0.5:
            (swarm,) = values.pop("swarms")
            swarm.pop("name")
            values["swarm"] = swarm
        elif swarms:
            more["max_subswarms"] = random.choice([None, 6])
        try:
            return Mission.of(
                map=system,
                **{key: value for key, value in values.items() if value},
                **more,
                must=random_formula(random, 2) if random.random() < 0.9 else True,
                prefer=prefer,
                language=random.choice(["mtl", "catl"]),
                objective=aims,
                task_interval=random.choice(["closed", "half-open"]),
                horizon=random.choice([None, 40]),
                solver=random.choice([None, {"gap": 0.25, "seed": 3}, {"time_limit": 60}]),
                name=random.choice(["", "no", "12", "ä: 'b' \"c\" #d", "a\nb"]),
            )
        except MissionError:
            continue


@quick
@given(st.integers(0, 10**6))
def test_random_missions_are_read_as_they_were(seed):
    alike(random_mission(seed))
    alike(random_task_mission(seed))
    alike(random_swarm_mission(seed))
    alike(random_kind(seed))


@pytest.mark.parametrize(
    "text",
    [
        'F[0,3] home && G[0,3] sum("Ä b") <= 2 /\\ true',
        "F[0,3] home\n   &&  \n\nG[0,3] sum(home, cart) <= 3",
        "  F[0,3] home",
        "!home # 1".removesuffix(" # 1"),
        "[][0,2] (home\t||\tsum(dock) >= 1)",
    ],
)
def test_a_formula_keeps_its_text(text):
    written = alike(Mission.of(map=YARD, team=[CART, DRONE], formula=text))
    assert mission_from_text(written).text == text


def test_a_whole_file():
    mission = Mission.of(
        map=YARD,
        team=[DRONE, CART],
        swarms=[{"name": "bees", "size": 8, "at": "dock", "max_subswarms": 3}],
        margin="2.5%",
        must="F[0,6] (sum(home) >= 50% && sum(home, bees) >= 1)",
        prefer=[{"formula": "F[0,4] sum(home, cart) >= 1", "weight": 1.5, "partial": True}],
        objective=["splits", "agents"],
        solver=SolverChoice("highs", 60, seed=1),
        name="mixed",
    )
    text = alike(mission)
    assert text.startswith('format: tsplan-mission/1\nname: mixed\nmap:\n  name: "yard #1"\n')
    assert text.endswith(
        """\
team:
  - {class: drone, count: 3, at: "12", capabilities: [fly]}
  - {class: cart, at: {dock: 2, "q: 1": 1}, capabilities: [cart]}
swarms:
  - {name: bees, size: 8, at: {dock: 8}, max_subswarms: 3}
margin: 2.5%
spec:
  language: catl
  must: "F[0,6] (sum(home) >= 50% && sum(home, bees) >= 1)"
  prefer:
    - {formula: "F[0,4] sum(home, cart) >= 1", name: "F[0,4] sum(home, cart) >= 1", """
        """weight: 1.5, level: 0, partial: true}
objective: [preferences, splits, agents]
horizon: 6
solver: {name: highs, time_limit: 60.0, seed: 1}
"""
    )


def test_what_the_constructor_takes_is_written_too():
    bees = Group("bees", frozenset({"fly"}), (("dock", 1), ("12", 2), ("dock", 4)))
    rules = SwarmRules({"bees": SwarmBounds(least=2)}, margin=Fraction(1, 8))
    mission = Mission("", YARD, (bees, CART), "mtl", "", parse("F[0,3] home"), 9, (), swarm=rules)
    assert mission.text == "F[0,3] home"
    assert [group.class_name for group in mission.team] == ["cart", "bees"]
    assert mission.team[1].starts == (("dock", 5), ("12", 2))
    assert mission.team[1].capabilities == {"fly", "bees"}
    alike(mission)
    one = Group.of("swarm", {"dock": 4})
    rules = SwarmRules({"swarm": SwarmBounds()}, together=2)
    single = Mission("", YARD, (one,), "mtl", "", parse("F[0,3] home"), 9, (), swarm=rules)
    assert "max_subswarms: 2" in single.to_yaml()
    mission_from_text(single.to_yaml())
    changed = replace(mission, formula=simplify(mission.formula.always(0, 2)))
    assert mission_from_text(changed.to_yaml()).formula is changed.formula


def test_what_no_file_can_say_is_refused():
    formula = parse("F[0,3] home")
    rules = SwarmRules({"bees": SwarmBounds()}, margin=Fraction(1, 3))
    bees = Group.of("bees", {"dock": 4})
    with pytest.raises(MissionError, match="the margin 1/3 is no percentage"):
        Mission("", YARD, (bees,), "mtl", "", formula, 9, (), swarm=rules).to_yaml()
    fine = replace(rules, margin=Fraction(1, 10**18))
    with pytest.raises(MissionError, match="no percentage of 15 digits"):
        Mission("", YARD, (bees,), "mtl", "", formula, 9, (), swarm=fine).to_yaml()
    soft = Preference(formula, weight=Fraction(1, 3))
    with pytest.raises(MissionError, match=r"1/3 of 'F.*' has no end"):
        Mission("", YARD, (CART,), "mtl", "", formula, 9, (), prefer=(soft,)).to_yaml()
    with pytest.raises(FormulaError):
        Mission("", YARD, (CART,), "mtl", "", limit("home"), 9, ()).to_yaml()


def test_a_saved_mission_is_planned_explained_and_checked(tmp_path, capsys):
    mission = Mission.of(
        map=YARD,
        team=[CART],
        formula="F[0,4] sum(home, cart) >= 3",
        name="made in Python",
    )
    place, plan = tmp_path / "mission.yaml", tmp_path / "plan.json"
    mission.save(place)
    assert load_mission(place) == mission
    assert main(["plan", str(place), "-o", str(plan)]) == 0
    assert main(["check", str(place), str(plan)]) == 0
    assert check(mission, load_plan(plan)).ok
    assert load_plan(plan).mission.sha256 == load_mission(place).digest
    assert main(["explain", str(place)]) in (0, 1)
    capsys.readouterr()


def test_the_map_may_stand_beside_it_and_files_are_whole(tmp_path):
    mission = Mission.of(map=YARD, team=[CART], formula="F[0,4] home")
    place = tmp_path / "mission.yaml"
    place.write_text("before")
    place.chmod(0o640)
    mission.save(place, map_file="the map.yaml")
    assert re.search('^map: "the map.yaml"$', place.read_text(), re.MULTILINE)
    assert load_mission(place) == mission
    assert stat.S_IMODE(place.stat().st_mode) == 0o640
    assert sorted(item.name for item in tmp_path.iterdir()) == ["mission.yaml", "the map.yaml"]
    with pytest.raises(InputError, match="cannot write"):
        mission.save(tmp_path / "none" / "mission.yaml")
