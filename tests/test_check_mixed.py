"""Plans of robots and swarms together: judged as one, by paths and by moves."""

from __future__ import annotations

import io
from collections import Counter
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console
from scipy.stats import binom

from tests.refusing import refused
from tests.seeds import quick
from tests.swarm_lane import SYSTEM
from tests.test_check_swarms_random import SYSTEM as WALKED
from tests.test_check_swarms_random import duration, places, walks
from tsplan.checking import measures
from tsplan.checking.assignment import assign
from tsplan.checking.plan_check import certify, check, objective_values
from tsplan.errors import InputError, MissionError
from tsplan.mission import Mission, Objective, objectives, register
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.moves import Move
from tsplan.plans.outcomes import MissionRef, ObjectiveValue
from tsplan.plans.plan import Plan
from tsplan.plans.summary import print_summary
from tsplan.protocol.margin_size import margin_for
from tsplan.protocol.simulation import simulate

VALUES = {
    "availability": 0,
    "travel": 14,
    "cost": 14,
    "makespan": 3,
    "risk": 0,
    "agents": 7,
    "splits": 0,
    "moves": 2,
    "balance": 6,
}
CART = frozenset({"cart"})
CARTS = (
    AgentPlan("cart-1", "cart", CART, ((0, 0, "p"), (1, 1, "r"), (2, 5, "q"))),
    AgentPlan("cart-2", "cart", CART, ((0, 5, "p"),)),
)
MOVES = (
    Move(0, "p", "p", 6),
    Move(1, "p", "r", 6),
    Move(2, "r", "q", 6),
    Move(3, "q", "q", 6),
    Move(4, "q", "q", 6),
)


def mission(formula="F[0,5] (sum(goal) >= 7 && sum(goal, cart) >= 1)", **options):
    swarm = {"size": 6, "at": "p", "max_subswarms": 1, "min_subswarm": 6} | options.pop("swarm", {})
    team = [{"class": "cart", "count": 2, "at": "p", "capabilities": ["cart"]}]
    given = {"language": "mtl", "objective": list(VALUES), "horizon": 5} | options
    return Mission.of(map=SYSTEM, team=team, swarm=swarm, formula=formula, **given)


def plan(agents=CARTS, moves=MOVES, **changes):
    made = Plan(
        "feasible",
        MissionRef("m", ""),
        5,
        "time_limit",
        objective=tuple(ObjectiveValue(name, None) for name in VALUES),
        agents=agents,
        moves=moves if isinstance(moves, dict) else {"swarm": tuple(moves)},
    )
    return replace(made, **changes)


def test_a_right_plan_is_completed_and_accepted():
    made = certify(mission(), plan())
    assert made.verified
    assert {item.name: item.value for item in made.objective} == VALUES
    assert objective_values(mission(), made) == VALUES
    report = check(mission(), made)
    assert report.ok
    assert report.facts[:6] == (
        "the team is the mission's: 2 agents, each with one path from its start",
        "swarm keeps its 6 agents from its start on",
        "every path and every move follow the map's edges at their durations up to step 5",
        "every capacity is kept",
        "the bounds on sub-swarms are kept at every step; the smallest one has 6 agents",
        "the formula holds, with availability 0",
    )
    assert [group.swarm for group in made.groups] == ["swarm"] * 3


def test_who_is_where_is_told_of_both():
    made = certify(mission(), plan())
    assert made.states == ("p", "q", "r")
    assert made.counts(states=["p", "q"]).tolist() == [[8, 7, 1, 1, 1, 1], [0, 0, 1, 7, 7, 7]]
    assert made.counts("cart", states=["q"]).tolist() == [[0, 0, 1, 1, 1, 1]]
    assert made.counts("swarm", states=["q"]).tolist() == [[0, 0, 0, 6, 6, 6]]
    with pytest.raises(InputError, match="no capability 'nobody'"):
        made.counts("nobody")
    assert made.state_at(1) == {"cart-1": "r", "cart-2": "p", "swarm:1": "p"}
    assert Plan.from_json(made.to_json()) == made


def test_the_summary_tells_of_both():
    text = io.StringIO()
    print_summary(certify(mission(), plan()), Console(file=text, width=100))
    lines = [" ".join(line.split()) for line in text.getvalue().splitlines()]
    for line in (
        "agents 7",
        "cart-1 cart p:0, r:1, q:2-5",
        "step 0: 6 at p",
        "step 5: 6 at q",
        "horizon 5, 8 agents",
    ):
        assert line in lines


def test_agents_of_a_mixed_plan_go_by_chance_or_as_planned():
    parted = [*MOVES[:1], Move(1, "p", "p", 3), Move(1, "p", "r", 3), Move(2, "p", "p", 3)]
    parted += [Move(2, "r", "q", 3), Move(3, "p", "p", 3), Move(3, "q", "q", 3)]
    parted += [Move(4, "p", "p", 3), Move(4, "q", "q", 3)]
    loose = {"swarm": {"max_subswarms": 2, "min_subswarm": 1}}
    sure = mission("F[0,5] sum(goal, cart) >= 1", **loose)
    made = certify(sure, plan(moves=parted))
    assert simulate(sure, made, runs=500, seed=1).formula.rate == 1
    # the cart and three of six, by the binomial with p = 1/2
    half = mission("G[3,5] sum(goal) >= 4", **loose)
    found = simulate(half, certify(half, plan(moves=parted)), runs=20_000, seed=1)
    assert found.formula.rate == pytest.approx(binom.sf(2, 6, 0.5), abs=0.02)
    assert margin_for(half, 0.5) >= 1


def test_a_swarm_may_have_paths_too():
    made = assign(mission(), certify(mission(), plan()))
    assert [agent.class_name for agent in made.agents] == ["cart"] * 2 + ["swarm"] * 6
    assert check(mission(), made).ok
    assert any("paths of 6 agents say the same" in fact for fact in check(mission(), made).facts)
    alone = replace(made, moves={}, groups=(), verified=False)
    assert certify(mission(), alone) == made
    other = replace(made, moves={"swarm": (Move(0, "p", "r", 6), *MOVES[1:])})
    refused(mission(), other, "0 agents of swarm wait at p by the moves and 6 by the agents' paths")
    refused(mission(), replace(made, agents=made.agents[:-1]), "agent swarm-6 has no path")
    assert Plan.from_json(made.to_json()) == made


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"agents": CARTS[:1]}, ["agent cart-2 has no path"]),
        ({"agents": ()}, ["agent cart-1 (and 1 more) has no path"]),
        ({"agents": (CARTS[1], CARTS[1])}, ["cart-2 is there twice", "cart-1 has no path"]),
        (
            {"agents": (replace(CARTS[0], stays=((0, 0, "p"), (1, 5, "q"))), CARTS[1])},
            ["agent cart-1 takes the edge from p to q at step 0 in 1 steps instead of 3"],
        ),
        ({"moves": {}}, ["the plan has no moves of swarm"]),
        ({"moves": {"swarm": MOVES[:-1]}}, ["6 agents at q at step 4 and 0 leave or wait: 6 lost"]),
        (
            {"moves": {"swarm": MOVES, "cart": (Move(0, "p", "r", 1),)}},
            ["the plan moves 'cart', and the mission has no such swarm"],
        ),
        ({"availability": 1}, ["claims availability 1 and has 0"]),
        ({"objective": (ObjectiveValue("travel", 12),)}, ["objectives are travel"]),
    ],
)
def test_forged_plans_are_refused(changes, words):
    refused(mission(), plan(**changes), *words)


@pytest.mark.parametrize(("name", "claimed"), [("travel", 12), ("agents", 6), ("moves", 4)])
def test_claimed_objectives_are_counted_again(name, claimed):
    made = certify(mission(), plan())
    wrong = tuple(
        replace(item, value=claimed) if item.name == name else item for item in made.objective
    )
    refused(mission(), replace(made, objective=wrong), f"the plan claims {name} {claimed} and has")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (
            {"formula": "F[0,5] sum(goal) >= 8"},
            "the formula does not hold (its availability is -1)",
        ),
        ({"formula": "F[0,1] sum(goal, cart) >= 1"}, "the formula does not hold"),
        # the margin is kept at what each atom counts: 7 of 8 agents, 1 of 2 carts
        (
            {"formula": "F[0,5] sum(goal) >= 6", "margin": 2},
            "falls 1 short of the mission's margin",
        ),
        ({"formula": "F[0,5] sum(goal, cart) >= 50%", "margin": "30%"}, "falls 1 short of"),
        ({"swarm": {"min_subswarm": 7}}, "has 6 agents at step 0, and min_subswarm is 7"),
    ],
)
def test_what_the_mission_asks_is_counted_of_both(options, words):
    refused(mission(**options), plan(), words)


def test_bounds_are_about_swarms_alone():
    # the two carts are apart, and the swarm may be in one part
    assert check(mission(), certify(mission(), plan())).ok
    parted = [
        Move(0, "p", "p", 3),
        Move(0, "p", "r", 3),
        Move(1, "p", "r", 3),
        Move(1, "r", "q", 3),
        Move(2, "r", "q", 3),
        *[Move(2, "q", "q", 3), Move(3, "q", "q", 6), Move(4, "q", "q", 6)],
    ]
    words = ["swarm is in 2 sub-swarms at step 1, and max_subswarms is 1", "has 3 agents at step 1"]
    refused(mission(), plan(moves=parted), *words)


def test_capacities_are_shared():
    ten = [move._replace(count=11) for move in MOVES]
    both = (CARTS[0], AgentPlan("cart-2", "cart", CART, CARTS[0].stays))
    of = mission("true", swarm={"size": 11, "min_subswarm": 1})
    refused(of, plan(both, ten), "13 agents are at q at step 3, which holds 12")
    one = certify(of, plan(moves=ten))
    assert one.verified


def test_sub_swarms_are_those_of_swarms():
    made = certify(mission(), plan())
    carts = replace(made.groups[0], swarm="cart", id="x", size=2)
    refused(
        mission(),
        replace(made, groups=(*made.groups, carts)),
        "a sub-swarm of 2 agents of cart at p",
    )


@quick
@given(walks(), st.data())
def test_values_are_those_of_all_agents(drawn, data):
    horizon, agents = drawn
    robots = data.draw(st.integers(0, len(agents) - 1))
    team, swarm = agents[:robots], agents[robots:]
    starts = Counter(walk[0][1] for walk in swarm)
    of = Mission.of(
        map=WALKED,
        team=[{"class": "robot", "at": {state: n}} for state, n in _starts(team).items()] or None,
        swarm={"size": len(swarm), "at": dict(starts)},
        formula="true",
        language="mtl",
        objective=list(VALUES),
        horizon=horizon,
    )
    entered = Counter(entry for walk in swarm for entry in walk)
    made = Plan(
        "feasible",
        MissionRef("", ""),
        horizon,
        "gap",
        agents=tuple(
            _path(agent, walk, horizon)
            for agent, walk in zip(of.members({"robot"}), sorted(team, key=_begin), strict=True)
        ),
        moves={"swarm": tuple(sorted(Move(*entry, n) for entry, n in entered.items()))},
    )
    values = {item.name: item.value for item in certify(of, made).objective}
    away = [entry for walk in agents for entry in walk if entry[1] != entry[2]]
    together = [Counter(row) for row in zip(*(places(w, horizon) for w in swarm), strict=True)]
    assert values["availability"] is None
    assert values["travel"] == values["cost"] == sum(duration(entry) for entry in away)
    assert values["makespan"] == max((entry[0] + duration(entry) for entry in away), default=0)
    assert values["moves"] == len({e for walk in swarm for e in walk if e[1] != e[2]})
    assert values["balance"] == min(min(row.values()) for row in together)
    # robots as they went; of a swarm as few as its moves allow
    moved = sum(any(entry[1] != entry[2] for entry in walk) for walk in team)
    some = sum(any(entry[1] != entry[2] for entry in walk) for walk in swarm)
    assert moved <= values["agents"] <= moved + some
    paths = assign(of, certify(of, made))
    again = {item.name: item.value for item in certify(of, replace(paths, objective=())).objective}
    assert again == values


def _begin(walk):
    return walk[0][1]


def _starts(team):
    return dict(sorted(Counter(map(_begin, team)).items()))


def _path(agent, walk, horizon):
    """The stays of a walk; a wait of several steps begins a stay anew."""
    stays, heading = [(0, 0, walk[0][1])], None
    for step, source, target in walk:
        arrival = step + duration((step, source, target))
        if arrival > horizon:
            heading = target
        elif source == target and arrival == step + 1:
            stays[-1] = (stays[-1][0], arrival, source)
        else:
            stays.append((arrival, arrival, target))
    return AgentPlan(agent.id, "robot", agent.capabilities, tuple(stays), heading)


@pytest.fixture
def registers():
    """The registers of objectives and measures are as before afterwards."""
    kept = [(known, dict(known)) for known in (objectives._REGISTER, measures._REGISTER)]
    yield
    for known, before in kept:
        known.clear()
        known.update(before)


def test_an_objective_from_outside_is_measured(registers):
    register(Objective("waiting", "minimise", "steps that agents wait"))
    with pytest.raises(ValueError, match="already"):
        register(Objective("waiting", "maximise"))

    def waiting(traffic):
        return sum(item.agents * item.times for item in traffic.segments if item.edge.is_wait)

    measures.register_measure("waiting", waiting)
    for name, words in (("waiting", "already"), ("wait", "no objective 'wait'")):
        with pytest.raises(ValueError, match=words):
            measures.register_measure(name, waiting)
    of = mission(objective=["waiting", "balance"])
    made = certify(of, plan(objective=()))
    # 3 steps of the one cart, 5 of the other, and 3 of the swarm's six
    assert [item.value for item in made.objective] == [26, 6]
    bounded = (ObjectiveValue("waiting", 26, 27), ObjectiveValue("balance", 6))
    refused(of, replace(made, objective=bounded), "waiting 26 is better than its bound 27")
    with pytest.raises(MissionError, match=r"unknown objective 'wating'.*'waiting'"):
        mission(objective=["wating"])


def test_objectives_of_groups_need_a_swarm():
    with pytest.raises(MissionError, match="objective 'splits' is for swarms"):
        Mission.of(
            map=SYSTEM,
            team=[{"class": "cart", "at": "p"}],
            formula="true",
            horizon=3,
            objective=["splits"],
        )
