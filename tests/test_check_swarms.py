"""Moves, sub-swarms, splits and the check of swarm plans, on cases that can be followed by hand."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from tests.refusing import refused
from tests.swarm_lane import DURATIONS, MOVES, SYSTEM, VALUES, mission, plan
from tsplan.checking.assignment import assign
from tsplan.checking.plan_check import certify, check, objective_values
from tsplan.errors import InputError, PlanError
from tsplan.mission import Mission
from tsplan.plans.moves import Move, shares, splits
from tsplan.plans.subswarms import SubSwarm, subswarms
from tsplan.ts import Edge, State, TransitionSystem


def without(step, source, target, count=None):
    """The moves with one of them changed to another count, or left out."""
    kept = [move for move in MOVES if move[:3] != (step, source, target)]
    assert len(kept) == len(MOVES) - 1
    return sorted([*kept, *([] if count is None else [Move(step, source, target, count)])])


def test_what_moves_say():
    assert splits(MOVES) == 2
    assert shares(MOVES)["p", 1] == (
        ("p", Fraction(1, 6)),
        ("q", Fraction(1, 3)),
        ("r", Fraction(1, 2)),
    )
    assert shares(MOVES)["q", 4] == (("q", Fraction(1)),)


def test_the_sub_swarms_of_moves():
    first, *others, last = subswarms("swarm", {"p": 12}, MOVES, DURATIONS, 5)
    assert first == SubSwarm(
        "swarm:1", "swarm", 0, 1, 12, "p", None, (), ("swarm:2", "swarm:4", "swarm:3")
    )
    by_place = {(group.place, group.first): group for group in others}
    assert {key: (g.last, g.size) for key, g in by_place.items()} == {
        ("at p", 2): (2, 2),
        ("at r", 2): (2, 6),
        ("on the way from p to q", 2): (3, 4),
        ("at r", 3): (3, 2),
        ("at q", 3): (3, 6),
    }
    assert last.first, last.last == (4, 5)
    assert (last.size, last.state) == (12, "q")
    assert {by_place[key].id for key in by_place if by_place[key].last == 3} == set(last.parents)
    assert by_place["at p", 2].children == (by_place["at r", 3].id,)


def test_waiting_by_a_long_loop_and_travelling_at_the_end():
    moves = [Move(0, "a", "a", 3), Move(2, "a", "b", 3)]
    made = subswarms("s", {"a": 3}, moves, {("a", "a"): 2, ("a", "b"): 9}, 4)
    assert [(g.place, g.first, g.last, g.children) for g in made] == [
        ("at a", 0, 0, ("s:2",)),
        ("on the way from a to a", 1, 1, ("s:3",)),
        ("at a", 2, 2, ("s:4",)),
        ("on the way from a to b", 3, 4, ()),
    ]
    assert subswarms("s", {"a": 3}, (), {}, 0) == (SubSwarm("s:1", "s", 0, 0, 3, "a"),)


def test_a_right_plan_is_completed_and_accepted():
    made = certify(mission(), plan())
    assert made.verified
    assert {item.name: item.value for item in made.objective} == VALUES
    assert made.availability == 0
    assert len(made.groups) == 7
    assert made.states == ("p", "q", "r")
    assert made.counts(states=["q", "p"]).tolist() == [[0, 0, 0, 6, 12, 12], [12, 12, 2, 0, 0, 0]]
    with pytest.raises(InputError, match="no swarm 'nobody'"):
        made.counts("nobody")
    assert sorted(group.size for group in made.groups_at(3)) == [2, 4, 6]
    assert made.state_at(0) == {"swarm:1": "p"}
    assert None in made.state_at(2).values()
    report = check(mission(), made)
    assert report.ok
    assert any("smallest one has 2 agents" in fact for fact in report.facts)
    assert objective_values(mission(), made) == report.values


def test_agents_make_the_same_plan():
    made = assign(mission(), plan())
    assert made.verified
    assert len(made.agents) == 12
    assert assign(mission(), plan()) == made
    assert assign(mission(), plan(), seed=3).agents != made.agents
    assert check(mission(), made).ok
    # judged by the paths alone, the answer is the same
    alone = certify(mission(), replace(made, moves={}, groups=(), verified=False))
    assert alone.moves == {"swarm": MOVES}
    assert alone == made
    # and each must agree with the other
    other = tuple(without(1, "p", "p"))
    refused(
        mission(),
        replace(made, moves={"swarm": other}),
        "at step 1, 0 agents of swarm wait at p by the",
    )
    fewer = replace(made, agents=made.agents[1:])
    refused(mission(), fewer, f"agent {made.agents[0].id} has no path")
    with pytest.raises(PlanError, match="no moves of swarms"):
        assign(mission(), replace(made, moves={}))


@pytest.mark.parametrize(
    ("moves", "words"),
    [
        (without(1, "p", "r"), ["swarm has 12 agents at p at step 1 and 6 leave", "6 lost"]),
        (without(1, "p", "r", 5), ["1 lost", "1 come from nowhere"]),
        (without(4, "q", "q", 13), ["12 agents at q at step 4 and 13", "1 come from nowhere"]),
        (without(4, "q", "q", 0), ["waits at q at step 4 with 0 agents"]),
        ([*MOVES, Move(5, "q", "q", 12)], ["moves at step 5, and the plan ends at 5"]),
        ([*MOVES, Move(4, "q", "q", 12)], ["from q to q at step 4 twice"]),
        ([*without(4, "q", "q"), Move(4, "q", "r", 12)], ["q to r at step 4", "no such edge"]),
        ([*without(0, "p", "p"), Move(0, "q", "q", 12)], ["12 agents at p at step 0 and 0 leave"]),
    ],
)
def test_impossible_moves_are_refused(moves, words):
    refused(mission(), plan(moves), *words)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"most": 2}, ["swarm is in 3 sub-swarms at step 2, and max_subswarms is 2: ", "2 at p"]),
        ({"least": 3}, ["swarm at p has 2 agents at step 2, and min_subswarm is 3"]),
        ({"least": 5}, ["from p to q since step 1 has 4 agents at step 3, and min_subswarm is 5"]),
        ({"formula": "F[0,3] sum(goal) >= 60%", "horizon": 5}, ["the formula does not hold", "-2"]),
        (
            {"formula": "F[0,3] sum(goal) >= 50%", "margin": 1, "horizon": 5},
            ["some demand falls 1 short of the mission's margin"],
        ),
        ({"horizon": 7}, ["ends at step 5 and the mission at step 7"]),
    ],
)
def test_what_the_mission_asks_is_counted(given, words):
    assert check(mission(), certify(mission(), plan())).ok
    refused(mission(**given), plan(), *words)


@pytest.mark.parametrize(
    ("name", "claimed"), [("splits", 1), ("travel", 27), ("balance", 3), ("makespan", 3)]
)
def test_claimed_objectives_are_counted_again(name, claimed):
    made = certify(mission(), plan())
    wrong = tuple(
        replace(item, value=claimed) if item.name == name else item for item in made.objective
    )
    refused(mission(), replace(made, objective=wrong), f"the plan claims {name} {claimed} and has")


def test_capacities_are_counted():
    crowd = [Move(0, "p", "q", 12), Move(3, "q", "q", 12), Move(4, "q", "q", 12)]
    words = "12 agents are on the edge from p to q at step 0, which holds 5"
    refused(mission("true", horizon=5), plan(crowd), words)


def test_claimed_sub_swarms_are_counted_again():
    made = certify(mission(), plan())
    first, second, *others = made.groups
    larger = replace(made, groups=(first, replace(second, size=3), *others))
    refused(
        mission(),
        larger,
        "names a sub-swarm of 3 agents of swarm at p at step 2, which its moves do not",
    )
    refused(mission(), larger, "names no sub-swarm of 2 agents of swarm at p at step 2")
    orphan = replace(made, groups=(first, replace(second, parents=()), *others))
    refused(mission(), orphan, "sub-swarm swarm:2 at p from step 2 to 2 has other")


def test_plans_and_missions_of_another_kind():
    refused(mission(), plan(moves={"other": MOVES}), "moves 'other'", "has no moves of swarm")
    team = Mission.of(map=SYSTEM, team=[{"class": "a", "at": "p"}], formula="true", horizon=5)
    report = check(team, plan())
    assert any("the mission has a team" in finding.message for finding in report.findings)


def test_several_swarms_are_bounded_each_and_together():
    def of(**options):
        swarms = [
            {"name": "a", "size": 4, "at": "p", "max_subswarms": 2},
            {"name": "b", "size": 6, "at": "p", "min_subswarm": 2},
        ]
        return Mission.of(
            map=SYSTEM,
            swarms=swarms,
            formula="F[0,3] (sum(goal, a) >= 50% && sum(home, b) >= 1)",
            objective=["splits", "moves", "balance"],
            **options,
        )

    moves = {
        "a": (
            Move(0, "p", "p", 2),
            Move(0, "p", "r", 2),
            Move(1, "p", "p", 2),
            Move(1, "r", "q", 2),
            Move(2, "p", "p", 2),
            Move(2, "q", "q", 2),
        ),
        "b": (Move(0, "p", "p", 6), Move(1, "p", "p", 6), Move(2, "p", "p", 6)),
    }
    made = plan(moves=moves, horizon=3, objective=())
    done = certify(of(max_subswarms=3), made)
    assert [item.value for item in done.objective] == [1, 2, 2]
    # two swarms at one state are two sub-swarms, and agents are told apart by their swarm
    assert [group.swarm for group in done.groups_at(0)] == ["a", "b"]
    assert done.counts("a", states=["p"]).tolist() == [[4, 2, 2, 2]]
    assert done.counts(states=["p"]).tolist() == [[10, 8, 8, 8]]
    refused(of(max_subswarms=2), made, "together are in 3 sub-swarms at step 1")


def test_a_million_agents_cost_nothing():
    huge = tuple(move._replace(count=move.count * 100_000) for move in MOVES)
    roomy = TransitionSystem.build(
        [State(name, state.labels) for name, state in SYSTEM.states.items()],
        [Edge(*pair, edge.duration) for pair, edge in SYSTEM.edges.items()],
    )
    given = Mission.of(
        map=roomy, swarm={"size": 1_200_000, "at": "p"}, formula="F[0,5] sum(goal) >= 90%"
    )
    made = certify(given, plan(huge, objective=()))
    assert made.verified
    assert "agents" not in vars(given)
    assert made.counts(states=["q"]).max() == 1_200_000
