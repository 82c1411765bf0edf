"""Needs of one witness at several places: ruled out, or asked of the region as a whole."""

from __future__ import annotations

from tsplan import Mission, plan
from tsplan.encode.assemble import tight
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.encode.switches import ALL_SWITCHES, Switch
from tsplan.milp.lp import WarmLP
from tsplan.mission import Group
from tsplan.ts import Edge, State, TransitionSystem

TWO_PLACES = "F[0,12] (T(1,A,{(c,2)}) && T(1,B,{(c,2)}))"


def line() -> TransitionSystem:
    """s - a - b, two steps from each to the next."""
    states = [State("s"), State("a", labels=frozenset("A")), State("b", labels=frozenset("B"))]
    names = ["s", "a", "b"]
    edges = [Edge(name, name, 1) for name in names]
    for near, far in (("s", "a"), ("a", "b")):
        edges += [Edge(near, far, 2), Edge(far, near, 2)]
    return TransitionSystem.build(states, edges)


def two_places(agents: int, formula: str = TWO_PLACES) -> Mission:
    return Mission.of(map=line(), team=[Group.of("c", {"s": agents}, {"c"})], formula=formula)


def lp_bound(mission: Mission, *without: Switch) -> float:
    setting = prepare(mission, switches=ALL_SWITCHES - set(without))
    encoded = tight(setting)
    objective = Travel().vector(setting, encoded)
    return WarmLP(encoded.model.with_objective(objective)).solve().objective


def test_a_witness_that_needs_more_agents_than_there_are_is_ruled_out_before_any_lp() -> None:
    def refuted(mission: Mission) -> bool:
        return tight(prepare(mission, switches=ALL_SWITCHES - {Switch.RIVALS})).refuted

    assert refuted(two_places(3))
    assert not refuted(two_places(4))
    assert plan(two_places(3)).status == "infeasible"
    assert plan(two_places(4)).status == "optimal"


def test_choices_of_impossible_witnesses_are_impossible_themselves() -> None:
    """Neither part of the alternative can be had, at no step; a third one can."""
    both = "(T(1,A,{(c,2)}) && T(1,B,{(c,2)}))"
    formula = f"F[0,9] ({both} || F[1,3] {both})"
    assert tight(prepare(two_places(3, formula))).refuted
    assert plan(two_places(3, formula), encoding="reference").status == "infeasible"
    formula = f"F[0,9] ({both} || F[1,3] {both} || T(1,A,{{(c,3)}}))"
    assert not tight(prepare(two_places(3, formula))).refuted
    assert plan(two_places(3, formula)).has_paths


def test_needs_that_hold_in_any_case_refute_the_whole_problem() -> None:
    formula = "G[6,9] (T(1,A,{(c,2)}) && T(1,B,{(c,2)}))"
    assert tight(prepare(two_places(3, formula))).refuted
    assert not tight(prepare(two_places(4, formula))).refuted


def test_two_agents_must_come_to_each_of_two_places_at_once() -> None:
    mission = two_places(4)
    optimum = plan(mission).objective[0].value
    assert optimum == 2 * 2 + 2 * 4
    assert lp_bound(mission, Switch.TOGETHER) < lp_bound(mission) <= optimum + 1e-6


def test_going_from_one_place_of_a_region_to_another_is_not_coming() -> None:
    """Starting inside the region, even on the way between its places, nobody has to come."""
    system = line()
    team = [Group.of("c", {"a": 4}, {"c"})]
    mission = Mission.of(map=system, team=team, formula=TWO_PLACES)
    assert plan(mission).objective[0].value == 2 * 2
    assert plan(mission, without=("together",)).objective[0].value == 2 * 2
