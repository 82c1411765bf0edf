"""Plans of swarms in the viewer: groups with counts, and nobody lost."""

from __future__ import annotations

import json

import pytest

from tsplan.checking.plan_check import certify
from tsplan.draw.tracks import tracks
from tsplan.errors import PlanError
from tsplan.mission import Mission
from tsplan.plans.moves import Move
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.viewer.page_data import page_data

SYSTEM = TransitionSystem.build(
    [State("home", frozenset({"home"})), State("reef", frozenset({"reef"}))],
    [Edge("home", "home"), Edge("reef", "reef"), Edge("home", "reef", 2)],
)
MOVES = (
    Move(0, "home", "home", 400),
    Move(0, "home", "reef", 800),
    Move(1, "home", "home", 400),
    Move(2, "home", "home", 100),
    Move(2, "home", "reef", 300),
    Move(2, "reef", "reef", 800),
    Move(3, "home", "home", 100),
    Move(3, "reef", "reef", 800),
)


@pytest.fixture(scope="module")
def mission():
    swarm = {"size": 1200, "at": "home", "max_subswarms": 3}
    formula = "F[0,4] sum(reef) >= 90% && G[0,4] sum(home) >= 5%"
    return Mission.of(
        map=SYSTEM, swarm=swarm, formula=formula, language="mtl", objective=["splits"]
    )


def planned(mission, moves):
    reference = MissionRef(mission.name, mission.digest)
    return Plan("feasible", reference, 4, "time_limit", moves={"swarm": tuple(moves)})


@pytest.fixture(scope="module")
def plan(mission):
    return certify(mission, planned(mission, MOVES))


def test_groups_hold_everybody_where_the_plan_does(mission, plan):
    data = json.loads(json.dumps(page_data(mission, plan)))
    names = [state["name"] for state in data["map"]["states"]]
    groups = [(track["count"], track["end"]) for track in data["tracks"]]
    assert groups == [(400, 2), (800, 5), (100, 5), (300, 5)]
    assert [kind["agents"] for kind in data["classes"]] == [1200]
    for step in range(5):
        found = dict.fromkeys(names, 0)
        for track in tracks(plan, mission, moving=True):
            where = track.at(step)
            if track.present(step) and where.share == 0:
                found[where.source.state] += track.count
        counts = plan.counts(states=names)[:, step].tolist()
        assert list(found.values()) == counts


def test_shares_of_a_swarm_tick_off(mission, plan):
    eventually, always = page_data(mission, plan)["formula"][1:]
    assert eventually["charts"][0]["bound"] == 1080
    assert eventually["settled"] == ((4, 1),)
    assert always["charts"][0]["bound"] == 60
    assert always["duties"] == 5


def test_moves_that_the_map_lacks_are_refused(mission, plan):
    moves = [*MOVES[:-1], Move(3, "reef", "home", 800)]
    with pytest.raises(PlanError, match="goes from reef to home, and the map has no such edge"):
        tracks(planned(mission, moves), mission, moving=True)
