"""The distributed protocol: frequencies as the binomial predicts, and margins that suffice."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import binom

import tsplan
from tests.seeds import quick
from tsplan.checking.plan_check import certify
from tsplan.errors import MissionError, PlanError
from tsplan.mission import Mission
from tsplan.plans.moves import Move
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.protocol.margin_size import margin_for, shortfall
from tsplan.protocol.simulation import Frequency, simulate
from tsplan.ts import Edge, State, TransitionSystem

# from p one way leads over one edge to q, another takes two steps to r
SYSTEM = TransitionSystem.build(
    [State("p", frozenset({"P"})), State("q", frozenset({"Q"})), State("r", frozenset({"R"}))],
    [Edge("p", "p"), Edge("q", "q"), Edge("r", "r"), Edge("p", "q"), Edge("p", "r", 2)],
)


def mission(formula, size=100, **options):
    swarm = {"size": size, "at": "p"} | options.pop("swarm", {})
    return Mission.of(map=SYSTEM, swarm=swarm, formula=formula, horizon=4, **options)


def plan(given, going, around=0):
    """At step 1 some agents go to q and some to r; the others stay."""
    size = given.size
    moves = [Move(0, "p", "p", size), Move(1, "p", "q", going)]
    moves += [Move(step, "q", "q", going) for step in (2, 3)]
    moves += [Move(step, "p", "p", size - going - around) for step in (1, 2, 3)]
    moves += [Move(1, "p", "r", around), Move(3, "r", "r", around)]
    moves = tuple(sorted(move for move in moves if move.count))
    made = Plan("feasible", MissionRef("", ""), 4, "time_limit", moves={"swarm": moves})
    return certify(given, made)


@pytest.mark.parametrize("going", [55, 60, 64])
def test_the_formula_holds_as_often_as_the_binomial_says(going):
    given = mission("F[0,4] Q && G[2,4] sum(Q) >= 55%")
    found = simulate(given, plan(given, going), runs=20_000, seed=1)
    predicted = binom.sf(54, 100, going / 100)
    # four standard deviations: wrong once in 16,000 seeds
    assert abs(found.formula.rate - predicted) < 4 * np.sqrt(predicted * (1 - predicted) / 20_000)
    assert found.formula.low < found.formula.rate < found.formula.high
    assert found.bounds.rate == 1


def test_the_spread_is_that_of_the_binomial():
    given = mission("true")
    found = simulate(given, plan(given, 30), runs=20_000, seed=5)
    # of 8 numbers two are fixed (all at p), six stray alike: 3 at q, 3 at p
    strays = np.abs(np.arange(101) - 30) @ binom.pmf(np.arange(101), 100, 0.3)
    assert found.stray_mean == pytest.approx(6 / 8 * strays, rel=0.02)
    assert 13 <= found.stray_max <= 30


def test_shares_are_of_those_who_are_there():
    # a third each, by edges of different durations
    given = mission("true", size=90)
    made = plan(given, 30, 30)
    found = simulate(given, made, runs=5000, seed=2)
    assert found.formula.rate == 1
    third = np.abs(np.arange(91) - 30) @ binom.pmf(np.arange(91), 90, 1 / 3)
    assert found.stray_mean == pytest.approx(8 / 10 * third, rel=0.05)


def test_small_sub_swarms_break_their_bound_as_predicted():
    given = mission("true", swarm={"min_subswarm": 25})
    found = simulate(given, plan(given, 30), runs=20_000, seed=3)
    # 30 at q fall below 25 but not to 0; the 70 at p do so practically never
    predicted = binom.sf(24, 100, 0.3)
    assert found.bounds.rate == pytest.approx(predicted, abs=0.012)
    assert found.formula.rate == 1


def test_travelling_sub_swarms_have_their_bound_too():
    given = mission("true", size=40, swarm={"min_subswarm": 10})
    one = simulate(given, plan(given, 0, 12), runs=5000, seed=3)
    assert one.bounds.rate == pytest.approx(binom.sf(9, 40, 0.3) - binom.sf(30, 40, 0.3), abs=0.02)


def test_equal_seeds_give_equal_answers_and_sizes_do_not_matter():
    given = mission("F[0,4] sum(Q) >= 50%", size=10**6)
    made = plan(given, 500_500)
    first = simulate(given, made, runs=300, seed=7)
    assert first == made.simulate(given, runs=300, seed=7)
    assert first == tsplan.simulate(given, made, runs=300, seed=7)
    assert simulate(given, made, runs=300, seed=8) != first
    assert first.formula.rate == pytest.approx(binom.sf(499_999, 10**6, 0.5005), abs=0.12)


def test_batches_are_independent(monkeypatch):
    given = mission("F[0,4] sum(Q) >= 55%")
    made = plan(given, 55)
    monkeypatch.setattr("tsplan.protocol.simulation._ENTRIES", 3 * 5 * 2 * 700)
    found = simulate(given, made, runs=10_000, seed=7)
    assert found.formula.runs == 10_000
    assert found.formula.rate == pytest.approx(binom.sf(54, 100, 0.55), abs=0.02)


def test_several_swarms_go_apart():
    given = Mission.of(
        map=SYSTEM,
        swarms=[{"name": "a", "size": 40, "at": "p"}, {"name": "b", "size": 60, "at": "p"}],
        formula="F[0,1] (sum(Q, a) >= 50% && sum(Q, b) >= 50%)",
    )
    moves = {
        "a": (Move(0, "p", "p", 18), Move(0, "p", "q", 22)),
        "b": (Move(0, "p", "p", 28), Move(0, "p", "q", 32)),
    }
    made = certify(given, Plan("feasible", MissionRef("", ""), 1, "gap", moves=moves))
    found = simulate(given, made, runs=20_000, seed=3)
    predicted = binom.sf(19, 40, 22 / 40) * binom.sf(29, 60, 32 / 60)
    assert found.formula.rate == pytest.approx(predicted, abs=0.015)


def test_what_cannot_be_simulated():
    given = mission("F[0,4] sum(Q) >= 50%")
    made = plan(given, 50)
    with pytest.raises(PlanError, match="only plans of swarms"):
        simulate(given, replace(made, moves={}, groups=(), status="infeasible", verified=False,
                                stopped_by=None))  # fmt: skip
    with pytest.raises(PlanError, match="formula does not hold"):
        simulate(mission("F[0,4] sum(Q) >= 51%"), made)
    with pytest.raises(ValueError, match="at least one run"):
        simulate(given, made, runs=0)


def test_wilsons_interval():
    # the values of the closed formula for 0, half and all of 10
    low, high = Frequency(0, 10).low, Frequency(0, 10).high
    assert (low, round(high, 4)) == (0, 0.2775)
    assert (round(Frequency(5, 10).low, 4), round(Frequency(5, 10).high, 4)) == (0.2366, 0.7634)
    assert (round(Frequency(10, 10).low, 4), Frequency(10, 10).high) == (0.7225, 1)


def test_a_margin_that_suffices():
    asked = "G[2,4] sum(Q) >= 55% && G[2,4] sum(P) >= 20% && F[0,4] Q"
    bare = mission(asked, size=1000)
    spare = margin_for(bare, 0.9)
    assert 20 < spare < 60
    given = mission(asked, size=1000, margin=spare)
    made = plan(given, 550 + spare)
    found = simulate(given, made, runs=4000, seed=1)
    assert found.formula.rate >= 0.9
    # a plan on the edge succeeds every other time, and with less to spare the promise is broken
    assert simulate(bare, plan(bare, 550), runs=4000, seed=1).formula.rate < 0.6
    assert margin_for(bare, 0.99) > spare
    assert margin_for(mission("F[0,4] sum(Q) >= 100% && G[0,1] !Q"), 0.999) == 0
    assert margin_for(mission("true"), 0.999) == 0


def test_margins_of_every_operator():
    sure = margin_for(mission("F[0,4] sum(Q) >= 50%"), 0.9)
    assert margin_for(mission("sum(Q) >= 50% || F[0,3] sum(P) >= 30%"), 0.9) == sure
    assert margin_for(mission("G[0,3] sum(Q) <= 50%"), 0.9) > sure
    until = margin_for(mission("sum(P) >= 50% U[0,3] sum(Q) >= 50%"), 0.9)
    release = margin_for(mission("sum(P) >= 50% R[1,3] sum(Q) >= 50%"), 0.9)
    # three or four demands that count, against one
    assert until == release == margin_for(mission("G[0,3] sum(Q) >= 50%"), 0.9) > sure
    every = margin_for(mission("F[0,4] min(Q) >= 50%"), 0.9)
    assert every == sure
    with pytest.raises(ValueError, match="between 0 and 1"):
        margin_for(mission("true"), 1)
    team = Mission.of(map=SYSTEM, team=[{"class": "a", "at": "p"}], formula="true")
    with pytest.raises(MissionError, match="has a team"):
        margin_for(team)


@quick
@given(data=st.data())
def test_no_mixture_of_agents_falls_short_more_often_than_said(data):
    """Hoeffding's theorem on small sums, counted out exactly."""
    chances = data.draw(st.lists(st.floats(0, 1), min_size=2, max_size=9))
    agents = len(chances)
    distribution = np.array([1.0])
    for chance in chances:
        distribution = np.convolve(distribution, [1 - chance, chance])
    needed = data.draw(st.integers(1, agents - 1))
    spare = int(np.floor(sum(chances) - needed + 1e-12))
    if spare >= 0 and needed + spare < agents:
        assert distribution[:needed].sum() <= shortfall(agents, needed, spare) + 1e-9
