"""Agents in bundles: the same as agents one by one, in memory, in files and before the check."""

from __future__ import annotations

import json
import pickle
import re
from collections import Counter
from dataclasses import replace
from itertools import chain
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

import tsplan
from tests.seeds import quick, sampled
from tests.walks import walk, walking
from tsplan.checking.plan_check import check
from tsplan.checking.team_check import strangers
from tsplan.errors import PlanError
from tsplan.mission import Mission
from tsplan.name_runs import Names, Run, joined_runs
from tsplan.plans import agent_entries
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import load_plan
from tsplan.testing import random_mission
from tsplan.ts.builders import grid

STEMS = ("a-", "a", "b-0", "-", "", "r2-")
NAMES = st.one_of(
    st.tuples(st.sampled_from(STEMS), st.integers(0, 12)).map(lambda pair: f"{pair[0]}{pair[1]}"),
    st.text(min_size=1, max_size=4),
    st.sampled_from(["a-00", "a-07", "٣", "a-٣", "7" * 16, "a-" + "9" * 15]),
)
PATHS = st.sampled_from([((0, 5, "p"),), ((0, 2, "p"), (4, 5, "q")), ((1, 1, "q"),)])
AGENTS = st.lists(
    st.builds(
        AgentPlan,
        NAMES,
        st.sampled_from(["a", "b"]),
        st.sampled_from([frozenset(), frozenset({"see"})]),
        PATHS,
        st.sampled_from([None, "q"]),
    ),
    max_size=12,
)


@quick
@given(NAMES)
def test_a_name_is_one_run_in_one_way(name):
    run = Run.of(name)
    assert [*run.names()] == [name]
    assert run.size == 1
    assert not run.counted or Run.of(f"{run.stem}{run.first}") == run


@quick
@given(st.lists(NAMES, max_size=12), NAMES)
def test_runs_are_a_sequence_of_names(names, other):
    made = Names.of(names)
    assert [*made] == names
    assert (len(made), made == tuple(names), hash(made)) == (len(names), True, hash(tuple(names)))
    assert [made[place] for place in range(len(names))] == names
    assert [made[place] for place in range(-len(names), 0)] == names
    assert made[1:-1] == tuple(names[1:-1])
    assert all(name in made for name in names)
    assert (other in made) == (other in names)
    assert tuple(joined_runs(made.runs)) == made.runs
    with pytest.raises(IndexError):
        made[len(names)]


def test_long_rows_are_short():
    made = Names.of([f"a-{number}" for number in range(1, 100_000)])
    assert made.runs == (Run("a-", 1, 99_999),)


@quick
@given(AGENTS)
def test_agents_are_a_sequence_of_agents(agents):
    made = Agents.of(agents)
    assert [*made] == agents
    assert (len(made), made == tuple(agents)) == (len(agents), True)
    assert [made[place] for place in range(len(agents))] == agents
    assert made[1:-1] == tuple(agents[1:-1])
    assert made == Agents.of(tuple(replace(agent, stays=(*agent.stays,)) for agent in agents))
    assert hash(made) == hash(tuple(agents))
    assert pickle.loads(pickle.dumps(made)) == made
    groups = Counter(replace(agent, id="") for agent in agents)
    assert {bundle.agent(""): len(bundle.agents) for bundle in made.bundles} == groups
    for bundle in made.bundles:
        own = [agent.id for agent in agents if replace(agent, id="") == bundle.agent("")]
        assert [*bundle.agents] == own


@quick
@given(AGENTS, AGENTS)
def test_other_agents_are_not_equal(agents, others):
    assert (Agents.of(agents) == Agents.of(others)) == (agents == others)


@quick
@given(AGENTS.filter(bool), st.booleans())
def test_plans_are_read_as_they_were_written(agents, each):
    plan = Plan("feasible", MissionRef("m", ""), 5, "gap", agents=tuple(agents))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(agent_entries, "MOST_LISTED", 0)
        text = plan.to_json(each=each)
    entries = json.loads(text)["agents"]
    assert len(entries) == (len(agents) if each else len(plan.bundles))
    listed = (
        (place, stem if first is None else f"{stem}{number}")
        for entry in entries
        for stem, first, last, begin in entry.get("ids", ())
        for place, number in enumerate(range(first or 0, (last or 0) + 1), begin)
    )
    assert each or [name for _, name in sorted(listed)] == [agent.id for agent in agents]
    again = Plan.from_json(text)
    assert again == plan
    assert again.bundles == plan.bundles
    assert dict(again.agent) == {agent.id: agent for agent in agents}
    assert again.state_at(4) == {agent.id: agent.state_at(4) for agent in agents}


def test_few_agents_are_listed_and_many_in_bundles():
    def written(agents, **form):
        made = [AgentPlan(f"a-{n}", "a", frozenset(), ((0, 5, "p"),)) for n in range(agents)]
        plan = Plan("feasible", MissionRef("m", ""), 5, "gap", agents=made)
        return json.loads(plan.to_json(**form))["agents"]

    assert len(written(1000)) == len(written(1000, each=True)) == 1000
    assert len(written(1001, each=True)) == 1001
    assert written(1001) == [
        {"ids": [["a-", 0, 1000, 0]], "class": "a", "capabilities": [], "stays": [[0, 5, "p"]]}
    ]


@pytest.mark.parametrize(
    ("ids", "words"),
    [
        ([["a-", 1, 3, 1]], "agent a-1 has place 1, and 0 come before it"),
        ([["a-", 1, 3, 0], ["a-", 4, 4, 2]], "agent a-4 has place 2, and 3 come before it"),
        ([["a-", 3, 1, 0]], "agents[0].ids[0]: the numbers 3 to 1 are out of order"),
        ([["a-", 1, None, 0]], "the numbers 1 to None are out of order"),
        ([["a-1", 1, 3, 0]], "the number 1 does not begin behind 'a-1'"),
        ([["", None, None, 0]], "'' is no name without a number"),
        ([["a-1", None, None, 0]], "'a-1' is no name without a number"),
        ([["a-", 0, 10**15 - 1, 0]], "'a-' has more than the 10,000,000 agents of any team"),
        (
            [["a-", 0, 10**7 - 1, 0], ["b-", 0, 0, 10**7]],
            "there are 10,000,001 agents, more than the 10,000,000 of any team",
        ),
        ([["a-", -1, 3, 0]], "agents[0].ids[0][1]"),
        ([["a-", 1, 3]], "agents[0].ids[0][3]"),
        ([], "a bundle of agents has ids"),
        ("a-1", "agents[0].ids"),
    ],
)
def test_what_names_nobody_is_refused_in_words(ids, words):
    agents = [{"ids": ids, "class": "a", "stays": [[0, 5, "p"]]}]
    data = json.loads(Plan("error", MissionRef("m", ""), 5).to_json())
    data |= {"status": "feasible", "stopped_by": "gap", "agents": agents}
    with pytest.raises(PlanError) as caught:
        Plan.from_json(json.dumps(data), "plan.json")
    assert words in str(caught.value)


def test_an_entry_has_an_id_or_ids():
    both = {"id": "a-1", "ids": [["a-", 2, 3, 1]], "class": "a", "stays": [[0, 5, "p"]]}
    data = json.loads(Plan("error", MissionRef("m", ""), 5).to_json())
    data |= {"status": "feasible", "stopped_by": "gap", "agents": [both]}
    with pytest.raises(PlanError, match="an agent has an id, and a bundle"):
        Plan.from_json(json.dumps(data))


def teams(seed):
    """A random mission of a team, some groups of which are of one class."""
    random = Random(f"teams {seed}")
    mission = random_mission(random.randrange(10**6))
    roomy = [name for name, state in mission.system.states.items() if state.capacity is None]
    groups = [
        replace(group, starts=((s, (3 if s in roomy else 1) * n) for s, n in group.starts))
        for group in mission.team
    ]
    if roomy and random.random() < 0.5:
        groups.append(replace(random.choice(groups), starts=((random.choice(roomy), 2),)))
    return replace(mission, team=tuple(groups))


def few_ways(mission, random):
    """A plan of random walks, in which those of one rank share three of them."""
    agents = []
    for rank in mission.ranks:
        robots = [*rank.agents]
        ways = [walk(mission, robots[0], random) for _ in range(3)]
        agents += (AgentPlan(*robot[:3], *random.choice(ways)) for robot in robots)
    ref = MissionRef(mission.name, mission.digest)
    return Plan("feasible", ref, mission.horizon, "gap", agents=agents)


def spoilt(plan, random):
    """A plan with a few agents left out, repeated, exchanged or changed."""
    agents = [*plan.agents]
    for _ in range(random.choice((0, 0, 1, 1, 2, 4))):
        place = random.randrange(len(agents))
        chosen = agents[place]
        other = random.choice(agents)
        change = random.choice(
            (
                {"id": other.id},
                {"id": random.choice(("x-1", "a", f"{other.class_name}-0", f"{other.id}0"))},
                {"class_name": other.class_name},
                {"capabilities": other.capabilities | {"x"}},
                {"stays": other.stays, "heading": other.heading},
                {"stays": (*chosen.stays[:-1], (*chosen.stays[-1][:2], other.stays[0][2]))},
                {"heading": other.stays[0][2]},
                None,
            )
        )
        agents[place : place + 1] = [] if change is None else [replace(chosen, **change)]
        if not agents:
            return plan
    if random.random() < 0.3:
        random.shuffle(agents)
    return replace(plan, agents=agents)


def one_by_one(plan):
    """The same plan with a bundle for every agent."""
    agents = tuple(plan.agents)
    bundles = tuple(
        Bundle(each.class_name, each.capabilities, each.stays, each.heading, (each.id,))
        for each in agents
    )
    order = tuple((Run.of(each.id), place) for place, each in enumerate(agents))
    alone = Agents(bundles, order)
    made = replace(plan)
    object.__setattr__(made, "agents", alone)
    assert made.bundles == bundles
    return made


def strange(mission, plan):
    """Who is wrong about the team and how, agent by agent, by plain sets of names."""
    team = {agent.id: agent for agent in mission.agents}
    for agent in plan.agents:
        own = team.get(agent.id)
        if own is None:
            yield agent.id, "is not in the team"
            continue
        if agent.class_name != own.class_name:
            yield agent.id, f"is of class {own.class_name}, not {agent.class_name}"
        if agent.capabilities != own.capabilities:
            yield agent.id, "has other capabilities in the mission"
        if agent.stays[0][2] != own.start:
            yield agent.id, f"starts at {own.start}, not at {agent.stays[0][2]}"
    times = Counter(agent.id for agent in plan.agents)
    for name in team:
        if not times[name]:
            yield name, "has no path"
        for _ in range(times[name] - 1):
            yield name, "is there twice"


def singly(message):
    """A finding about agents in a row as one about each."""
    first, more, words = re.fullmatch(r"agent (\S+)(?: \(and (\d+) more\))? (.*)", message).groups()
    names = Run.of(first)
    last = names.last + int(more or 0)
    return [(name, words) for name in Run(names.stem, names.first, last).names()]


@pytest.mark.parametrize("seed", sampled(range(600), range(15)))
def test_bundles_are_judged_as_their_agents_one_by_one(seed):
    random = Random(f"judged {seed}")
    mission = teams(seed)
    made = few_ways(mission, random) if seed % 3 else walking(mission, seed, still=0.5)
    for _ in range(4):
        plan = spoilt(made, random)
        alone = one_by_one(plan)
        together, apart = check(mission, plan), check(mission, alone)
        assert together.ok == apart.ok
        assert (together.availability, together.values) == (apart.availability, apart.values)
        assert together.facts == apart.facts
        wrong = Counter(strange(mission, plan))
        for form in (plan, alone):
            told = Counter(chain.from_iterable(map(singly, strangers(mission, form))))
            assert told == wrong
        assert plan.counts(states=mission.system.states).tolist() == (
            alone.counts(states=mission.system.states).tolist()
        )


@quick
@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), max_size=4), st.integers(0, 12))
def test_a_roster_knows_every_name(spans, last):
    mission = Mission.of(
        map=grid(1, 2),
        team=[
            {"class": "ab"[number % 2], "at": {"r0c0": first + 1, "r0c1": second + 1}}
            for number, (first, second) in enumerate([*spans, (0, 0)])
        ],
        formula=True,
    )
    team = {agent.id: agent for agent in mission.agents}
    roster = mission.roster
    parts = [*roster.parts(Run("a-", 0, last + 20))]
    assert [*chain.from_iterable(part.names() for part, _ in parts)] == [
        *Run("a-", 0, last + 20).names()
    ]
    for part, rank in parts:
        for name in part.names():
            assert (roster.get(name) is not None) == (name in team) == (rank is not None)
            assert rank is None or rank.start == team[name].start


def test_a_million_agents_stay_few_bundles(tmp_path):
    mission = Mission.of(
        map=grid(3, 3, labels={(2, 2): "far", (0, 2): "near"}),
        team=[{"class": "a", "count": 1_000_000, "at": "r0c0"}],
        formula="F[0,9] sum(far) >= 30 && F[0,9] sum(near) >= 7",
        language="mtl",
    )
    plan = tsplan.plan(mission)
    assert plan.verified
    assert (len(plan.agents), len(plan.bundles) <= 4) == (1_000_000, True)
    assert plan.agents[-1].id == plan.agent["a-1000000"].id == "a-1000000"
    plan_file = tmp_path / "plan.json"
    plan_file.write_text(plan.to_json())
    assert plan_file.stat().st_size < 5000
    again = load_plan(plan_file)
    assert again == plan
    assert check(mission, again).ok
    fewer = json.loads(plan.to_json())
    fewer["agents"][0]["ids"][0][2] -= 1
    plan_file.write_text(json.dumps(fewer))
    with pytest.raises(PlanError, match="come before it"):
        load_plan(plan_file)
