"""Zones: states and edges of a map that share a capacity."""

from __future__ import annotations

import random
from dataclasses import replace

import networkx as nx
import pytest

import tsplan
from tests.joint_plans import best, small_enough
from tests.seeds import seed_blocks
from tests.test_brute_force import PLAIN, REFERENCE, TIGHT, compare
from tsplan import MapError, Mission, MissionError
from tsplan.mission.read import mission_from_text
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import from_networkx
from tsplan.ts.product import product, unit_steps

NARROW = """\
format: tsplan-mission/1
map:
  waiting: true
  zones: {narrow: 1}
  states: {a: {labels: [A]}, m: {zone: narrow}, b: {labels: [B]}}
  edges:
    - {from: a, to: m, duration: 2, both_ways: true, zone: narrow}
    - {from: m, to: b, duration: 2, both_ways: true, zone: narrow}
team: [{class: cart, count: 2, at: a}]
spec: {language: mtl, formula: "F[0,LAST] sum(B) >= 2"}
objective: [makespan]
"""


def narrow(last: int) -> Mission:
    return mission_from_text(NARROW.replace("LAST", str(last)), "m.yaml")


def test_one_after_the_other_goes_through_a_zone():
    for way in (TIGHT, REFERENCE, PLAIN):
        plan = tsplan.plan(narrow(8), **way)
        assert plan.status == "optimal"
        assert [item.value for item in plan.objective] == [8]
        assert tsplan.plan(narrow(7), **way).status == "infeasible"


def test_the_check_refuses_two_in_a_zone_for_one():
    plan = tsplan.plan(narrow(8))
    free = replace(plan.agents[0], stays=((0, 3, "a"), (5, 5, "m"), (7, 8, "b")))
    other = replace(plan.agents[1], stays=((0, 0, "a"), (2, 2, "m"), (4, 8, "b")))
    report = tsplan.check(narrow(8), replace(plan, agents=(free, other)))
    said = [finding.message for finding in report.findings]
    assert "2 agents are in the zone narrow at step 3, which holds 1" in said
    assert not any("at step 4" in words for words in said)


def zoned(seed: int, *, swarms: bool = False) -> Mission | None:
    """A tiny random mission with a zone of some of its states and edges."""
    draw = random.Random(seed)
    mission = (
        random_swarm_mission(seed, fits=small_enough)
        if swarms
        else random_mission(seed, states=4, most_agents=3, steps=5)
    )
    system = mission.system
    starts = {name for group in mission.team for name, _ in group.starts}
    states = [
        replace(state, zone="z") if draw.random() < (0.1 if name in starts else 0.7) else state
        for name, state in system.states.items()
    ]
    edges = [
        replace(edge, zone="z", both_ways=False, capacity=None)
        if not edge.both_ways and draw.random() < 0.7
        else edge
        for edge in system.edges.values()
    ]
    made = replace(system, zones={"z": draw.choice([1, 1, 2])}).rebuilt(states, edges)
    try:
        return replace(mission, system=made)
    except MissionError:
        return None  # more start in the zone than it holds


@pytest.mark.parametrize("seeds", seed_blocks(range(5), range(400), 10))
def test_zones_of_swarms_do_as_well_as_the_best_of_all_joint_plans(seeds: list[int]) -> None:
    for seed in seeds:
        mission = zoned(seed, swarms=True)
        if mission is not None and small_enough(mission):
            compare(mission, TIGHT, REFERENCE)


def zones_matter(mission: Mission) -> bool:
    without = replace(mission.system, zones={"z": 9})
    return best(mission) != best(replace(mission, system=without))


@pytest.mark.parametrize("seeds", seed_blocks(range(8), range(1500), 15))
def test_zones_do_as_well_as_the_best_of_all_joint_plans(seeds: list[int]) -> None:
    for mission in map(zoned, seeds):
        if mission is not None and small_enough(mission):
            compare(mission, TIGHT, REFERENCE)


def crossing(seed: int) -> Mission:
    """Robots that change sides through a middle that is a zone, or partly one."""
    draw = random.Random(seed)
    states = [State("a", frozenset("A")), State("b", frozenset("B"))]
    states += [State(name, zone=draw.choice(["z", "z", None])) for name in "mn"]
    edges = [Edge(state.name, state.name) for state in states]
    for one, two in ("am", "mb", "an", "nb", "mn"):
        if draw.random() < 0.8:
            zone = draw.choice(["z", None])
            edges += [
                Edge(*ends, draw.choice([1, 1, 2]), zone=zone) for ends in ((one, two), (two, one))
            ]
    return Mission.of(
        map=TransitionSystem.build(states, edges, zones={"z": draw.choice([1, 1, 2])}),
        team=[
            {"class": "right", "count": draw.choice([1, 2]), "at": "a"},
            {"class": "left", "count": 1, "at": "b"},
        ],
        language="mtl",
        formula=f"F[0,{draw.choice([3, 4])}] (sum(B, right) >= 1 && sum(A, left) >= 1)",
        objective=draw.choice([["makespan"], ["travel"], ["availability", "travel"]]),
    )


@pytest.mark.parametrize("seeds", seed_blocks(range(4), range(800), 15))
def test_robots_that_cross_a_zone_do_as_well_as_can_be(seeds: list[int]) -> None:
    for mission in map(crossing, seeds):
        if small_enough(mission):
            compare(mission, TIGHT, REFERENCE)


def test_zones_of_the_tests_matter():
    assert all(zones_matter(crossing(seed)) for seed in (4, 5))


def test_what_is_wrong_about_zones_is_said_where_it_stands():
    text = NARROW.replace("zones: {narrow: 1}", "zones: {narow: 1, wide: -2}").replace(
        "duration: 2, both_ways: true, zone: narrow}\n    - {from: m",
        "duration: 2, capacity: 1, both_ways: true, zone: narow}\n    - {from: m",
    )
    with pytest.raises(MissionError) as caught:
        mission_from_text(text, "m.yaml")
    said = [str(finding) for finding in caught.value.findings]
    assert any(words.startswith("m.yaml:4:27: wide: '-2' should be") for words in said)
    assert "m.yaml:5:30: the map has no zone 'narrow'; did you mean 'narow'?" in said
    assert any("7:47: an edge in a zone has a capacity of its own" in words for words in said)


def test_more_robots_than_a_zone_holds_cannot_start_there():
    with pytest.raises(MissionError, match="2 robots start in the zone 'narrow', which holds 1"):
        mission_from_text(NARROW.replace("LAST", "8").replace("at: a", "at: m"), "m.yaml")


def test_a_map_with_zones_is_written_and_read_as_the_same():
    mission = narrow(8)
    assert mission_from_text(mission.to_yaml()).system == mission.system
    assert mission.system.zone_parts["narrow"].states == ("m",)
    assert len(mission.system.zone_parts["narrow"].edges) == 4


def test_a_zone_that_forbids_every_plan_is_named_and_widened():
    explanation = tsplan.explain(narrow(7))
    told = str(explanation)
    assert "the zone 'narrow' holds at most 1" in told
    assert "raise the capacity of the zone 'narrow' from 1 to 2" in told


def test_edges_of_a_zone_in_single_steps_stay_in_it():
    split = unit_steps(narrow(8).system)
    assert split.states["a->m@1"].zone == split.edges["a", "a->m@1"].zone == "narrow"
    with pytest.raises(MapError, match="not defined for capacities"):
        product(split, split)


def test_zones_of_graphs():
    graph = nx.DiGraph(zones={"door": 1})
    graph.add_node("a", zone="door")
    graph.add_edge("a", "b", zone="door")
    assert from_networkx(graph).zone_parts["door"] == (("a",), (("a", "b"),))
    graph.add_edge("b", "a", zone="dor")
    with pytest.raises(MapError, match="edge from 'b' to 'a', attribute 'zone': the map has no"):
        from_networkx(graph)


def test_uncertain_moves_keep_no_zone():
    text = """\
format: tsplan-mission/1
map:
  zones: {z: 1}
  states: {a: {zone: z}, b: {}}
  actions: {a: {go: {b: 0.5, a: 0.5}}, b: {stay: {b: 1}}}
team: [{class: cart, count: 1, at: a}]
dynamics: expected
spec: {language: mtl, formula: "F[0,3] sum(b) >= 0"}
"""
    with pytest.raises(MissionError, match="the zone 'z' has a capacity, which uncertain moves"):
        mission_from_text(text)


def test_a_wait_in_a_zone_counts_once():
    states = [State("a", zone="z"), State("b", frozenset({"B"}))]
    edges = [Edge("a", "a", zone="z"), Edge("a", "b", 2, zone="z"), Edge("b", "b")]
    system = TransitionSystem.build(states, edges, zones={"z": 1})
    mission = Mission.of(
        map=system,
        team=[{"class": "cart", "count": 1, "at": "a"}],
        language="mtl",
        formula="F[0,4] B",
    )
    for way in (TIGHT, REFERENCE):
        assert tsplan.plan(mission, **way).status == "optimal"
