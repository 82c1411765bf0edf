"""Lanes of sub-swarms: nobody is lost, and each lane is one group that stays together."""

from __future__ import annotations

from collections import Counter, defaultdict

from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan.draw.tracks import lanes

STATES = ("p", "q", "r")


@st.composite
def flows(draw):
    """A start, durations of all edges, and moves that keep every agent, up to a horizon."""
    horizon = draw(st.integers(0, 6))
    starts = {s: n for s in STATES if (n := draw(st.integers(0, 9)))} or {"p": 4}
    durations = {(a, b): 1 if a == b else draw(st.integers(1, 3)) for a in STATES for b in STATES}
    present = defaultdict(int)
    for state, count in starts.items():
        present[0, state] = count
    moves = []
    for step in range(horizon):
        for state in STATES:
            left = present[step, state]
            targets = draw(st.permutations(STATES))
            for place, target in enumerate(targets):
                last = place == len(targets) - 1
                count = left if last else draw(st.integers(0, left))
                if count:
                    moves.append((step, state, target, count))
                    present[step + durations[state, target], target] += count
                left -= count
    return starts, draw(st.permutations(moves)), durations, horizon


def at(lane, step):
    """Where a lane is at a step: a state, or an edge with the step it was entered."""
    for place, (first, last, state, _) in enumerate(lane.stays):
        if first <= step <= last:
            return state
        if last < step and place + 1 < len(lane.stays) and step < lane.stays[place + 1][0]:
            return state, lane.stays[place + 1][2], last
    return None


@quick
@given(flows())
def test_lanes_hold_everybody_at_every_step(flow):
    starts, moves, durations, horizon = flow
    made = lanes(*flow)
    for step in range(horizon + 1):
        wanted = Counter(starts) if step == 0 else Counter()
        for entered, source, target, count in moves:
            arrival = entered + durations[source, target]
            if arrival == step:
                wanted[target] += count
            elif entered < step < arrival:
                wanted[source, target, entered] += count
        found = Counter()
        for lane in made:
            if lane.stays[0][0] <= step < lane.end:
                found[at(lane, step)] += lane.count
        assert found == wanted


@quick
@given(flows())
def test_every_step_of_a_lane_is_one_move(flow):
    _, moves, durations, horizon = flow
    counted = {(step, a, b): count for step, a, b, count in moves}
    for lane in lanes(*flow):
        for place, (first, last, state, _) in enumerate(lane.stays):
            for step in range(first, last):
                assert counted[step, state, state] == lane.count
            if place + 1 < len(lane.stays):
                arrival, _, target, _ = lane.stays[place + 1]
                assert counted[last, state, target] == lane.count
                assert arrival == last + durations[state, target]
        assert lane.end <= horizon + 1


def test_a_group_that_stays_whole_keeps_its_lane():
    there = [(0, "p", "q", 5), (2, "q", "q", 5), (3, "q", "p", 5)]
    (lane,) = lanes({"p": 5}, there, {("p", "q"): 2, ("q", "q"): 1, ("q", "p"): 2}, 5)
    assert [stop[:3] for stop in lane.stays] == [(0, 0, "p"), (2, 3, "q"), (5, 5, "p")]
    assert lane.end == 6
