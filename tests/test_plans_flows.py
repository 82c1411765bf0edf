"""Flow decomposition: nothing lost, nothing made up, the same every time."""

from __future__ import annotations

from collections import Counter
from itertools import chain

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan.errors import TsplanError
from tsplan.mission import Rank
from tsplan.name_runs import Run
from tsplan.plans.bundles import Agents
from tsplan.plans.decomposition import decompose
from tsplan.plans.moves import Move

ABLE = frozenset({"see"})


def ranks_of(starts):
    """The robots that start at each state, numbered one after the other."""
    ranks, before = [], 0
    for state, count in starts.items():
        if count:
            ranks.append(Rank(Run("a-", before + 1, before + count), "a", ABLE, state, 0))
        before += count
    return ranks


def flow_of(starts, edges, entries):
    """Ranks, moves and durations from `{(edge number, step): agents}`."""
    moves = [Move(step, *edges[edge][:2], count) for (edge, step), count in entries.items()]
    return ranks_of(starts), moves, {(u, v): duration for u, v, duration in edges}


def walked(*flow):
    """The agents of a flow with their paths, in the order of the ranks."""
    return Agents.along(chain.from_iterable(decompose(*flow)))


def entered(agents, edges, horizon):
    """The flow that paths add up to, read from the stays alone."""
    number = {(source, target): place for place, (source, target, _) in enumerate(edges)}
    total = Counter()
    for agent in agents:
        for place, (first, last, state) in enumerate(agent.stays):
            for step in range(first, last):
                total[number[state, state], step] += 1
            if place + 1 < len(agent.stays):
                total[number[state, agent.stays[place + 1][2]], last] += 1
            elif last < horizon:
                total[number[state, agent.heading], last] += 1
    return total


@st.composite
def walks(draw):
    """A random map, starts, and the flow of random walks on it."""
    states = [f"s{n}" for n in range(draw(st.integers(1, 4)))]
    pairs = [(u, v) for u in states for v in states if u == v or draw(st.booleans())]
    edges = [(u, v, draw(st.integers(1, 3))) for u, v in pairs]
    horizon = draw(st.integers(0, 7))
    starts = {state: draw(st.integers(0, 5)) for state in states}
    starts[states[0]] += 1
    entries = Counter()
    for state, count in starts.items():
        for _ in range(count):
            here, step = state, 0
            while step < horizon:
                edge = draw(st.sampled_from([n for n, e in enumerate(edges) if e[0] == here]))
                entries[edge, step] += 1
                here, step = edges[edge][1], step + edges[edge][2]
    return starts, edges, dict(entries), horizon


@quick
@given(walks(), st.integers(0, 3) | st.none())
def test_paths_add_up_to_the_flow(walk, seed):
    starts, edges, entries, horizon = walk
    flow = flow_of(starts, edges, entries)
    agents = walked(*flow, horizon, seed)
    assert [(a.id, a.stays[0][0], a.stays[0][2]) for a in agents] == [
        (agent.id, 0, agent.start) for rank in flow[0] for agent in rank.agents
    ]
    assert entered(agents, edges, horizon) == entries
    for agent in agents:
        assert (agent.heading is None) == (agent.stays[-1][1] == horizon)
    assert agents == walked(*flow, horizon, seed)


@quick
@given(walks())
def test_as_many_as_possible_stay_at_home(walk):
    starts, edges, entries, horizon = walk
    agents = walked(*flow_of(starts, edges, entries), horizon)
    wait = {source: n for n, (source, target, _) in enumerate(edges) if source == target}
    for state, count in starts.items():
        steps = range(0, horizon, edges[wait[state]][2])
        most = min([count, *(entries.get((wait[state], step), 0) for step in steps)])
        home = [a for a in agents if {s for *_, s in a.stays} | {a.heading} <= {state, None}]
        assert len(home) >= most


def test_visitors_do_not_take_the_waits_of_those_at_home():
    edges = [("p", "p", 1), ("q", "q", 1), ("p", "q", 1)]
    entries = {(2, 0): 1, (1, 0): 1, (1, 1): 2, (1, 2): 2}
    agents = walked(*flow_of({"p": 1, "q": 1}, edges, entries), 3)
    assert agents[1].stays == ((0, 3, "q"),)


def test_another_seed_gives_the_paths_to_others():
    edges = [("p", "p", 1), ("p", "q", 1)]
    flow = flow_of({"p": 20}, edges, {(0, 0): 10, (1, 0): 10})
    first, second = walked(*flow, 1, 0), walked(*flow, 1, 1)
    assert first != second
    assert Counter(a.stays for a in first) == Counter(a.stays for a in second)


def test_a_wait_of_two_steps_is_no_stay():
    agents = walked(*flow_of({"p": 1}, [("p", "p", 2)], {(0, 0): 1, (0, 2): 1}), 3)
    assert agents[0].stays == ((0, 0, "p"), (2, 2, "p"))
    assert agents[0].heading == "p"


@pytest.mark.parametrize(
    "entries",
    [
        {(0, 0): 1},  # one of two agents leaves nowhere
        {(0, 0): 3, (0, 1): 3},  # three leave where two are
        {(0, 0): 2, (0, 1): 1},  # lost on the way
        {(0, 0): 2, (0, 1): 2, (0, 2): 2},  # beyond the horizon
        {(0, 0): 2, (0, 1): 2, (1, 1): -1},
    ],
)
def test_a_flow_that_is_not_conserved_is_refused(entries):
    with pytest.raises(TsplanError):
        decompose(*flow_of({"p": 2}, [("p", "p", 1), ("p", "q", 1)], entries), 2)


def test_a_hundred_thousand_agents_are_split_into_paths():
    states = [f"s{n}" for n in range(30)]
    edges = [(s, t, 1) for n, s in enumerate(states) for t in (s, states[(n + 1) % 30])]
    share = 100_000 // 30 // 2 * 2
    entries = {(e, step): share // 2 for e in range(len(edges)) for step in range(60)}
    flow = flow_of(dict.fromkeys(states, share), edges, entries)
    agents = walked(*flow, 60)
    assert len(agents) == share * 30
