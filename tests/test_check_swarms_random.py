"""Random walks of a few agents: the check and the sub-swarms against counting agent by agent."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tests.swarm_lane import VALUES
from tsplan.checking.assignment import assign
from tsplan.checking.plan_check import certify, check
from tsplan.mission import Mission
from tsplan.plans.moves import Move
from tsplan.plans.outcomes import MissionRef, ObjectiveValue
from tsplan.plans.plan import Plan
from tsplan.plans.split_history import timeline
from tsplan.ts import Edge, State, TransitionSystem

# waiting at c takes two steps at a time
SYSTEM = TransitionSystem.build(
    [State("a", frozenset({"A"})), State("b", frozenset({"B"})), State("c")],
    [
        Edge("a", "a"),
        Edge("b", "b"),
        Edge("c", "c", 2),
        Edge("a", "b", 1),
        Edge("b", "a", 2),
        Edge("a", "c", 3),
        Edge("c", "b", 1),
        Edge("b", "c", 2),
    ],
)


@st.composite
def walks(draw):
    """For each agent the edges it enters, as (step, source, target), up to a horizon."""
    horizon = draw(st.integers(1, 6))
    agents = []
    for _ in range(draw(st.integers(1, 5))):
        state, step, walk = draw(st.sampled_from("abc")), 0, []
        while step < horizon:
            edge = draw(st.sampled_from(SYSTEM.leaving(state)))
            walk.append((step, state, edge.target))
            state, step = edge.target, step + edge.duration
        agents.append(tuple(walk))
    return horizon, agents


def duration(entry):
    return SYSTEM.edges[entry[1:]].duration


def places(walk, horizon):
    """Where an agent is at every step: at a state, or on an edge it entered at some step."""
    at = {}
    for entry in walk:
        step, source, target = entry
        at[step] = source
        at.update(dict.fromkeys(range(step + 1, step + duration(entry)), entry))
        at[step + duration(entry)] = target
    return [at[step] for step in range(horizon + 1)]


def planned(horizon, agents, **options):
    starts = Counter(walk[0][1] for walk in agents)
    given = Mission.of(
        map=SYSTEM,
        swarm={"size": len(agents), "at": dict(starts)} | options,
        formula="true",
        objective=list(VALUES),
        horizon=horizon,
    )
    entered = Counter(entry for walk in agents for entry in walk)
    moves = tuple(sorted(Move(*entry, count) for entry, count in entered.items()))
    objective = tuple(ObjectiveValue(name, None) for name in VALUES)
    made = Plan("feasible", MissionRef("", ""), horizon, "gap", objective, moves={"swarm": moves})
    return given, made


@quick
@given(walks())
def test_values_are_those_of_the_agents(drawn):
    horizon, agents = drawn
    mission, plan = planned(horizon, agents)
    made = certify(mission, plan)
    together = [Counter(row) for row in zip(*(places(w, horizon) for w in agents), strict=True)]
    exits = {(step, source): set() for walk in agents for step, source, _ in walk}
    entries = {}
    for walk in agents:
        for entry in walk:
            exits[entry[:2]].add(entry[2])
            entries.setdefault((entry[0] + duration(entry), entry[2]), set()).add(entry)
    away = [entry for walk in agents for entry in walk if entry[1] != entry[2]]
    assert {item.name: item.value for item in made.objective} == {
        "splits": sum(len(targets) - 1 for targets in exits.values()),
        "travel": sum(duration(entry) for entry in away),
        "moves": len(set(away)),
        "balance": min(min(row.values()) for row in together),
        "makespan": max((entry[0] + duration(entry) for entry in away), default=0),
    }
    assert sum(line.count(" + ") for line in timeline(made) if "merge" in line) == sum(
        len(came) - 1 for (step, _), came in entries.items() if step <= horizon
    )
    for step, row in enumerate(together):
        named = Counter(
            {group.state or (group.first - 1, *group.edge): group.size
             for group in made.groups_at(step)}
        )  # fmt: skip
        assert named == row


@quick
@given(walks())
def test_sub_swarms_are_linked_as_agents_pass_through_them(drawn):
    horizon, agents = drawn
    made = certify(*planned(horizon, agents))
    seen = {group.id: (set(), set()) for group in made.groups}

    def at(place, step):
        return next(
            group.id
            for group in made.groups_at(step)
            if place == (group.state or (group.first - 1, *group.edge))
        )

    for walk in agents:
        for before, after in pairwise(at(p, k) for k, p in enumerate(places(walk, horizon))):
            if before != after:
                seen[before][1].add(after)
                seen[after][0].add(before)
    for group in made.groups:
        assert (set(group.parents), set(group.children)) == seen[group.id]


@quick
@given(walks(), st.integers(1, 3), st.integers(1, 3))
def test_bounds_are_broken_when_some_step_breaks_them(drawn, most, least):
    horizon, agents = drawn
    mission, plan = planned(horizon, agents, max_subswarms=most, min_subswarm=least)
    together = [Counter(row) for row in zip(*(places(w, horizon) for w in agents), strict=True)]
    broken = any(len(row) > most or min(row.values()) < least for row in together)
    # judged by the moves, and by agents that make them
    values = certify(*planned(horizon, agents))
    given_moves = replace(values, mission=plan.mission)
    assert check(mission, given_moves).ok != broken
    paths = assign(*planned(horizon, agents))
    assert check(mission, replace(paths, moves={}, groups=())).ok != broken


@quick
@given(walks(), st.integers(0, 40), st.sampled_from([-1, 1]))
def test_a_changed_count_is_never_accepted(drawn, place, change):
    horizon, agents = drawn
    mission, plan = planned(horizon, agents)
    moves = list(plan.moves["swarm"])
    move = moves[place % len(moves)]
    moves[place % len(moves)] = move._replace(count=move.count + change)
    wrong = replace(certify(mission, plan), moves={"swarm": tuple(moves)})
    assert not check(mission, wrong).ok
    also = replace(assign(mission, plan), moves={"swarm": tuple(moves)})
    assert not check(mission, also).ok
