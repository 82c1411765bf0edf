"""Plans of swarms as files and in words."""

from __future__ import annotations

import io
import json
from dataclasses import replace

import pytest
from rich.console import Console

from tests.swarm_lane import MOVES, SYSTEM, mission, plan
from tsplan.checking.assignment import assign
from tsplan.checking.plan_check import certify, check
from tsplan.errors import PlanError
from tsplan.mission import Mission
from tsplan.plans.moves import Move
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import load_plan, save_plan
from tsplan.plans.split_history import timeline
from tsplan.plans.summary import print_summary


def changed(change, made=None):
    """The plan read from its JSON after a change to the data."""
    data = json.loads((made or certify(mission(), plan())).to_json())
    change(data)
    return Plan.from_json(json.dumps(data))


def refused(change, *words):
    with pytest.raises(PlanError) as caught:
        changed(change)
    text = str(caught.value)
    assert all(word in text for word in words), text


def test_round_trip(tmp_path):
    for made in (certify(mission(), plan()), assign(mission(), plan())):
        text = made.to_json()
        assert Plan.from_json(text) == made
        assert Plan.from_json(text).to_json() == text
        save_plan(made, tmp_path / "plan.json")
        assert load_plan(tmp_path / "plan.json") == made
    data = json.loads(text)
    assert data["moves"]["swarm"][2] == [1, "p", "q", 4]
    assert data["groups"][0] == {
        "id": "swarm:1",
        "swarm": "swarm",
        "from": 0,
        "to": 1,
        "state": "p",
        "size": 12,
        "parents": [],
        "children": ["swarm:2", "swarm:4", "swarm:3"],
    }
    assert data["groups"][3]["edge"] == ["p", "q"]
    assert len(data["agents"]) == 12
    assert "agents" not in json.loads(certify(mission(), plan()).to_json())


def test_a_file_with_moves_or_agents_alone_is_enough():
    bare = changed(lambda data: data.pop("groups"))
    assert check(mission(), bare).ok
    assert certify(mission(), replace(bare, verified=False)) == certify(mission(), plan())
    for read in (bare.counts, lambda: bare.states):
        with pytest.raises(PlanError, match="fill them in with certify"):
            read()

    def only_agents(data):
        del data["groups"], data["moves"]

    paths = changed(only_agents, assign(mission(), plan()))
    assert check(mission(), paths).ok
    assert paths.counts(states=["q"])[0, 5] == 12


def test_moves_are_sorted_when_read():
    assert changed(lambda data: data["moves"]["swarm"].reverse()).moves == {"swarm": MOVES}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d: d["moves"]["swarm"][0].__setitem__(3, 0), ["moves.swarm[0][3]", "greater"]),
        (lambda d: d["moves"]["swarm"][0].__setitem__(0, -1), ["moves.swarm[0][0]", "greater"]),
        (lambda d: d["moves"]["swarm"][0].pop(), ["moves.swarm[0][3]", "required"]),
        (
            lambda d: d["moves"]["swarm"].append([0, "p", "p", 1]),
            ["p to p at step 0 is there twice"],
        ),
        (lambda d: d["moves"]["swarm"].append([5, "p", "p", 1]), ["step 5", "ends at 5"]),
        (lambda d: d["groups"][0].update(to=9), ["after step 5"]),
        (lambda d: d["groups"][2].update({"from": 9}), ["groups[2]", "9 to 2 are out of order"]),
        (lambda d: d["groups"][0].update(edge=["p", "q"]), ["groups[0]", "one of both"]),
        (lambda d: d["groups"][0].update(children=["x"]), ["swarm:1 names x"]),
        (lambda d: d["groups"][0].update(id="swarm:2"), ["same id"]),
        (lambda d: d["groups"][0].update(size=0.5), ["groups[0].size"]),
        (lambda d: d["groups"][0].update(name=3), ["groups[0].name"]),
        (lambda d: d.update(status="infeasible", stopped_by=None), ["infeasible cannot hold"]),
        (lambda d: [d.pop("moves"), d.pop("groups")], ["feasible needs the agents' paths"]),
    ],
)
def test_wrong_files_are_refused(change, words):
    refused(change, *words)


def test_the_timeline_in_words():
    made = certify(mission(), plan())
    assert timeline(made) == [
        "step 0: 12 at p",
        "step 1: 12 at p split: 6 to r, 4 to q, 2 wait",
        "step 4: 6 + 4 + 2 merge at q",
        "step 5: 12 at q",
    ]
    text = io.StringIO()
    print_summary(made, Console(file=text, width=100))
    assert "step 1: 12 at p split" in text.getvalue()
    assert "splits 2" in text.getvalue()
    assert "horizon 5, 12 agents" in text.getvalue()


def test_the_timeline_of_several_swarms_that_travel_at_the_end():
    moves = {
        "a": (Move(0, "p", "p", 1), Move(0, "p", "q", 1)),
        "b": (Move(0, "p", "q", 2000),),
    }
    swarms = [{"name": "a", "size": 2, "at": "p"}, {"name": "b", "size": 2000, "at": "p"}]
    edges = {pair: replace(edge, capacity=None) for pair, edge in SYSTEM.edges.items()}
    roomy = replace(SYSTEM, edges=edges)
    given = Mission.of(map=roomy, swarms=swarms, formula="true", horizon=1)
    made = certify(given, plan(moves, horizon=1, objective=()))
    assert timeline(made) == [
        "step 0: 2 a at p, 2,000 b at p",
        "step 0: 2 a at p split: 1 to q, 1 wait",
        "step 1: 1 a at p, 1 a on the way from p to q, 2,000 b on the way from p to q",
    ]


def test_long_timelines_are_shortened():
    # a swarm of two that splits and merges all the time
    moves, step = [], 0
    for _ in range(30):
        moves += [Move(step, "p", "q", 1), Move(step, "p", "r", 1), Move(step + 1, "r", "q", 1)]
        moves += [Move(step + 3, "q", "p", 1), Move(step + 2, "q", "p", 1)]
        moves += [Move(step + 4, "p", "p", 1)]
        step += 5
    given = Mission.of(map=SYSTEM, swarm={"size": 2, "at": "p"}, formula="true", horizon=step)
    made = certify(given, plan(sorted(moves), horizon=step, objective=()))
    text = io.StringIO()
    print_summary(made, Console(file=text, width=100))
    assert len(timeline(made)) == 62
    assert "and 22 more splits and merges until the end" in text.getvalue()
    assert f"step {step}: 2 at p" in text.getvalue()
