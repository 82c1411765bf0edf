"""Cargo in rows: loaded, read and judged as it is agent by agent."""

from __future__ import annotations

import json
from collections import Counter, defaultdict
from dataclasses import replace
from math import floor
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick, sampled
from tests.test_plans_bundles import singly
from tests.walks import walk
from tsplan.checking.ledger_reading import read_ledger
from tsplan.errors import PlanError
from tsplan.mission import Mission, Resource
from tsplan.mission.resources import compartment
from tsplan.plans import cargo_rows
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.bundles import Agents
from tsplan.plans.cargo_rows import CargoRow, CargoRows
from tsplan.plans.loading import LEAST, Carried, loading
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.plans.supplies import Cargo
from tsplan.ts.builders import grid

RESOURCES = (
    Resource("brick", (("r0c0", 500),), indivisible=True),
    Resource("sand", (("r0c0", 90.25),)),
)
CARGO = st.lists(
    st.builds(
        Cargo,
        st.sampled_from(["a-1", "a-2", "a-3", "b-1", "a-07", "odd"]),
        st.integers(0, 2),
        st.sampled_from(["brick", "sand"]),
        st.sampled_from([1.0, 2.0, 0.1]),
    ),
    max_size=12,
)


@quick
@given(CARGO, st.booleans())
def test_rows_are_the_same_cargo_in_memory_and_in_files(cargo, each):
    rows = CargoRows.of(cargo)
    assert [*rows] == cargo
    assert (len(rows), rows == tuple(cargo), hash(rows)) == (len(cargo), True, hash(tuple(cargo)))
    stay = AgentPlan("a-1", "a", frozenset(), ((0, 5, "p"),))
    plan = Plan("feasible", MissionRef("m", ""), 5, "gap", agents=[stay], cargo=cargo)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cargo_rows, "MOST_LISTED", 0)
        text = plan.to_json(each=each)
    entries = json.loads(text).get("cargo", [])
    assert len(entries) == (len(cargo) if each else len(rows.order))
    assert Plan.from_json(text) == plan


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        ({"agent": "a-1", "agents": ["a-", 1, 2]}, "cargo has an agent or agents"),
        ({}, "cargo has an agent or agents"),
        ({"agents": ["a-", 2, 1]}, "cargo[0].agents: the numbers 2 to 1 are out of order"),
        ({"agents": ["a-", 0, 10**7]}, "more than the 10,000,000 agents of any team"),
        ({"agents": ["a-0", 1, 2]}, "does not begin behind 'a-0'"),
        ({"agents": ["a-", 1]}, "cargo[0].agents[2]"),
    ],
)
def test_what_is_carried_by_nobody_is_refused_in_words(entry, words):
    data = json.loads(Plan("error", MissionRef("m", ""), 5).to_json())
    data["cargo"] = [{"step": 0, "resource": "brick", "amount": 1, **entry}]
    with pytest.raises(PlanError) as caught:
        Plan.from_json(json.dumps(data))
    assert words in str(caught.value)


def building(seed):
    """A mission whose robots carry things in every way, and a plan of random walks."""
    random = Random(f"cargo {seed}")
    carries = [{"brick": 2, "sand": 0.5}, 2.5, {}, {"brick": 3}, 1, {"sand": 0.7}]
    names = random.choices(["a", "b"], k=4)
    mission = Mission.of(
        map=grid(1, 3),
        team=[
            {"class": name, "at": {"r0c0": random.randint(1, 6)}, "carries": random.choice(carries)}
            for name in names
        ],
        resources=RESOURCES,
        formula=True,
        horizon=8,
    )
    agents = []
    for rank in mission.ranks:
        robots = [*rank.agents]
        ways = [walk(mission, robots[0], random) for _ in range(2)]
        agents += (AgentPlan(*robot[:3], *random.choice(ways)) for robot in robots)
    ref = MissionRef(mission.name, mission.digest)
    return random, mission, Plan("feasible", ref, mission.horizon, "gap", agents=agents)


def loaded_one_by_one(mission, agents, carried):
    """What each agent is loaded with where one is filled after the other."""
    limits = {
        agent.id: mission.team[mission.roster.get(agent.id).group].carries for agent in agents
    }
    lanes = defaultdict(list)
    for item in carried:
        lanes[item[:5]].append(item)
    latest = {}
    for (source, target, step, duration, held), items in sorted(
        lanes.items(), key=lambda lane: lane[0][2]
    ):
        robots = [
            agent.id
            for agent in agents
            for before, after in zip(agent.stays, agent.stays[1:], strict=False)
            if (before[1:], after[::2]) == ((step, source), (step + duration, target))
            if limits[agent.id] != () and isinstance(limits[agent.id], tuple) is not held
        ]
        loads = {name: {} for name in robots}
        for item in sorted(items, key=lambda item: not item.resource.indivisible):
            kind, left = item.resource, item.amount
            for name in sorted(robots, key=lambda name: -latest.get(name, {}).get(kind.name, 0)):
                limit = limits[name]
                if isinstance(limit, tuple):
                    room = (compartment(limit, kind) or 0) - loads[name].get(kind.name, 0)
                else:
                    room = limit - sum(loads[name].values())
                    room = floor(room + LEAST) if kind.indivisible else room
                load = round(min(left, room), 9)
                if load > LEAST:
                    loads[name][kind.name] = load
                    left = round(left - load, 9)
        for name, load in loads.items():
            latest[name] = load
            yield from ((name, step, what, amount) for what, amount in load.items())


@pytest.mark.parametrize("seed", sampled(range(400), range(20)))
def test_many_robots_are_loaded_as_one_after_the_other(seed):
    random, mission, plan = building(seed)
    ways = {
        (before[2], after[2], before[1], after[0] - before[1])
        for agent in plan.agents
        for before, after in zip(agent.stays, agent.stays[1:], strict=False)
    }
    carried = [
        Carried(*way, held, kind, random.randint(1, 9) if kind.indivisible else random.random() * 4)
        for way in sorted(ways)
        for held in (False, True)
        for kind in RESOURCES
        if random.random() < 0.7
    ]
    made = loading(mission, Agents.of(plan.agents), (), carried)
    told = sorted((item.agent, item.step, item.resource, item.amount) for item in made)
    alone = sorted(loaded_one_by_one(mission, plan.agents, carried))
    assert [item[:3] for item in told] == [item[:3] for item in alone]
    assert [item[3] for item in told] == pytest.approx([item[3] for item in alone], abs=2e-9)


@pytest.mark.parametrize("seed", sampled(range(400), range(20)))
def test_rows_are_judged_as_their_agents_one_by_one(seed):
    random, mission, plan = building(seed)
    ids = [agent.id for agent in plan.agents]
    cargo = [
        Cargo(
            random.choice([*ids, "a-0", "nobody"]) if random.random() < 0.2 else name,
            stays[0][1] if random.random() < 0.9 else random.randint(0, 8),
            random.choice(["brick", "brick", "sand", "gold"][: random.choice((2, 4))]),
            random.choice([1.0, 2.0, 0.5]),
        )
        for name, stays in ((agent.id, agent.stays) for agent in plan.agents)
        for _ in range(random.choice((1, 1, 2)))
    ]
    rows = CargoRows.of(sorted(cargo, key=lambda item: (item.step, item.resource, item.agent)))
    alone = tuple(
        CargoRow(row.names.part(n, n + 1), *row[1:])
        for row in rows.order
        for n in range(row.names.size)
    )
    together = read_ledger(mission, replace(plan, cargo=rows))
    apart = read_ledger(mission, replace(plan, cargo=CargoRows(alone)))
    single = read_ledger(mission, replace(plan, agents=[*plan.agents][::-1], cargo=rows))
    assert singles(together[1]) == singles(apart[1]) == singles(single[1])
    assert together[0].lying == apart[0].lying
    assert together[0].haulage == apart[0].haulage
    hauled = Counter()
    for haul in apart[0].hauls:
        hauled[haul.left, haul.come, haul.source, haul.target, haul.resource] += haul.amount
    for haul in together[0].hauls:
        hauled[haul.left, haul.come, haul.source, haul.target, haul.resource] -= haul.amount
    assert not any(hauled.values())


def singles(problems):
    """Findings about agents in a row as one about each."""
    return sorted(item for problem in problems for item in singly(problem))
