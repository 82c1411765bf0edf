"""Exported plans, read by readers of their formats: everybody is where the plan says, when it says.

The plans are random walks on random maps, with names that files have to escape, moves and waits of
several steps, and agents that are on their way when the plan ends.
"""

from __future__ import annotations

import csv
import io
import json
import math
from collections import defaultdict
from itertools import pairwise

import networkx as nx
import pytest

from tests.exporting import STEP, arrival, random_plan, text_of, visits
from tsplan.errors import InputError, MapError, PlanError
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem

SEEDS = range(12)


@pytest.fixture(params=SEEDS)
def made(request):
    return random_plan(request.param)


def on_the_way(mission, agent, step):
    """Where an agent is that is at no state at a step."""
    system = mission.system
    here = next(stay for stay in reversed(agent.stays) if stay[1] < step)
    there = next(((s[0], s[2]) for s in agent.stays if s[0] > step), None)
    end, target = there or (arrival(system, agent), agent.heading)
    share = (step - here[1]) / (end - here[1])
    both = zip(system.states[here[2]].at, system.states[target].at, strict=True)
    return tuple(one * (1 - share) + two * share for one, two in both)


def test_a_table_has_every_step(made, tmp_path):
    mission, plan = made
    states = mission.system.states
    rows = list(csv.DictReader(io.StringIO(text_of(plan, "csv", mission, tmp_path))))
    assert list(rows[0]) == ["agent", "step", "state", "x", "y", "seconds", "origin"]
    steps = range(plan.horizon + 1)
    expected = [(agent, step) for agent in plan.agents for step in steps]
    assert [(row["agent"], int(row["step"])) for row in rows] == [(a.id, s) for a, s in expected]
    for (agent, step), row in zip(expected, rows, strict=True):
        state = agent.state_at(step)
        assert (row["state"] or None, float(row["seconds"])) == (state, step * STEP)
        at = states[state].at if state else on_the_way(mission, agent, step)
        assert (float(row["x"]), float(row["y"])) == pytest.approx(at)
        assert row["origin"] == (str(states[state].origin) if state else "")


def test_lines_are_geojson_with_the_steps_of_their_points(made, tmp_path):
    mission, plan = made
    data = json.loads(text_of(plan, "geojson", mission, tmp_path))
    assert (data["type"], data["name"]) == ("FeatureCollection", mission.name)
    place = {name: list(state.at) for name, state in mission.system.states.items()}
    for agent, feature in zip(plan.agents, data["features"], strict=True):
        assert set(feature) == {"type", "geometry", "properties"}
        geometry, told = feature["geometry"], feature["properties"]
        line = geometry["coordinates"]
        if geometry["type"] == "Point":
            line = [line]
        else:
            assert geometry["type"] == "LineString"
            assert len(line) >= 2
        assert (told["agent"], told["class"]) == (agent.id, agent.class_name)
        assert line == [place[state] for state in told["states"]]
        assert told["seconds"] == [STEP * step for step in told["steps"]]
        assert all(one < two for one, two in pairwise(told["steps"]))
        seen = dict(zip(told["steps"], told["states"], strict=True))
        ends = {step: state for first, last, state in agent.stays for step in (first, last)}
        assert seen == ends
        assert told.get("heading") == agent.heading


def test_networkx_reads_every_path_out_of_graphml(made, tmp_path):
    mission, plan = made
    graph = nx.read_graphml(io.BytesIO(text_of(plan, "graphml", mission, tmp_path).encode()))
    assert graph.is_directed()
    assert list(graph) == list(mission.system.states)
    for name, state in mission.system.states.items():
        node = graph.nodes[name]
        assert (node["x"], node["y"], node["origin"]) == (*state.at, str(state.origin))
        assert node.get("labels", "") == ", ".join(state.labels)
    done = defaultdict(list)
    for source, target, told in graph.edges(data=True):
        assert told["from_seconds"] == STEP * told["from"]
        assert told["to_seconds"] == STEP * told["to"]
        done[told["agent"]].append((told["from"], told["kind"] != "stay", source, target, told))
    assert set(done) == {agent.id for agent in plan.agents}
    for agent in plan.agents:
        edges = sorted(done[agent.id], key=lambda edge: edge[:2])
        assert {told["class"] for *_, told in edges} == {agent.class_name}
        stays = [(first, e["to"], one) for first, move, one, _, e in edges if not move]
        assert tuple(stays) == agent.stays
        moves = [(one, first, two, e["to"]) for first, move, one, two, e in edges if move]
        ways = [(a[2], a[1], b[2], b[0]) for a, b in pairwise(agent.stays)]
        if agent.heading is not None:
            last = agent.stays[-1]
            ways.append((last[2], last[1], agent.heading, arrival(mission.system, agent)))
        assert moves == ways


def test_nav2_has_the_ids_of_nodes_and_when_they_are_visited(made, tmp_path):
    mission, plan = made
    data = json.loads(text_of(plan, "nav2", mission, tmp_path))
    assert (data["horizon"], data["step_seconds"]) == (plan.horizon, STEP)
    name = {state.origin: state.name for state in mission.system.states.values()}
    for agent, robot in zip(plan.agents, data["robots"], strict=True):
        assert (robot["robot"], robot["class"]) == (agent.id, agent.class_name)
        told = robot["visits"]
        assert robot["nodes"] == [visit["node"] for visit in told]
        for visit in told:
            state = mission.system.states[name[visit["node"]]]
            assert (visit["state"], visit["x"], visit["y"]) == (state.name, *state.at)
            for key in ("arrive", "leave"):
                step = visit[f"{key}_step"]
                assert visit[key] == (None if step is None else STEP * step)
        expected = list(visits(agent))
        end = arrival(mission.system, agent)
        if agent.heading == expected[-1][0]:
            expected[-1] = (*expected[-1][:2], end)
        elif agent.heading is not None:
            expected.append((agent.heading, end, math.inf))
        assert [(v["state"], v["arrive_step"], v["leave_step"]) for v in told] == [
            (state, first, None if last >= plan.horizon else last)
            for state, first, last in expected
        ]
        legs = [(goal["start_id"], goal["goal_id"]) for goal in robot["goals"]]
        assert legs == list(pairwise(robot["nodes"]))
        asked = [{key: goal[key] for key in ("use_start", "use_poses")} for goal in robot["goals"]]
        assert asked == [{"use_start": False, "use_poses": False}] * len(legs)


def still(system, *agents, horizon=2):
    """A plan in which everybody stays where it is."""
    paths = tuple(
        AgentPlan(name, "cart", frozenset(), ((0, horizon, state),)) for name, state in agents
    )
    return Plan("feasible", MissionRef("still", "0" * 64), horizon, "gap", agents=paths)


def halls(*states):
    return TransitionSystem.build(states, [Edge(state.name, state.name) for state in states])


def refused(plan, to, system, folder, **given):
    """What a plan is refused for, when nothing is written."""
    with pytest.raises(InputError) as caught:
        text_of(plan, to, system, folder, **given)
    assert list(folder.iterdir()) == []
    return caught.value


def test_without_coordinates_seconds_and_ids_columns_are_empty_or_away(tmp_path):
    system = halls(State("hall"), State("room", shape=((0, 0), (2, 0), (2, 2), (0, 2))))
    plan = still(system, ("a", "hall"), ("b", "room"), horizon=0)
    text = text_of(plan, "csv", system, tmp_path)
    assert text == "agent,step,state,x,y\na,0,hall,,\nb,0,room,1.0,1.0\n"
    [feature] = json.loads(text_of(plan, "geojson", system, tmp_path, agents="b"))["features"]
    assert feature["geometry"] == {"type": "Point", "coordinates": [1, 1]}
    assert feature["properties"] == {
        "agent": "b",
        "class": "cart",
        "steps": [0],
        "states": ["room"],
    }


def test_lines_need_coordinates(tmp_path):
    system = halls(State("hall"), State("room", at=(0, 1)), State("nook"), State("den"))
    plan = still(system, ("a", "hall"), ("b", "room"), ("c", "nook"))
    error = refused(plan, "geojson", system, tmp_path)
    assert isinstance(error, MapError)
    assert [item.message for item in error.findings] == [
        "the state 'hall' has no coordinates",
        "the state 'nook' has no coordinates",
    ]
    assert text_of(plan, "geojson", system, tmp_path, agents=["b"])


@pytest.mark.parametrize(
    ("state", "number"),
    [
        (State("hall", origin=0), 0),
        (State("hall", origin=65535), 65535),
        (State("hall", origin="17"), 17),
        (State("17"), 17),
        (State("hall", origin=-1), None),
        (State("hall", origin=65536), None),
        (State("hall", origin="seventeen"), None),
        (State("hall", origin="\u0661"), None),  # a digit, but no ASCII one
        (State("hall"), None),
        (State("17", origin="hall"), None),
    ],
)
def test_ids_of_nodes_are_whole_numbers_of_16_bits(state, number, tmp_path):
    system = halls(state)
    plan = still(system, ("a", state.name))
    if number is None:
        words = f"the state '{state.name}' has no id of a node"
        assert words in str(refused(plan, "nav2", system, tmp_path))
    else:
        [robot] = json.loads(text_of(plan, "nav2", system, tmp_path))["robots"]
        assert robot["nodes"] == [number]


def test_no_two_states_are_one_node(tmp_path):
    system = halls(State("hall", origin=3), State("3"))
    plan = still(system, ("a", "hall"), ("b", "3"))
    words = "the states 'hall' and '3' have the same id 3"
    assert words in str(refused(plan, "nav2", system, tmp_path))


@pytest.mark.parametrize("where", ["state", "label", "origin", "agent"])
def test_what_xml_cannot_write_is_refused(where, tmp_path):
    odd = "b\x07ll"
    names = {"state": "s", "label": "l", "origin": "o", "agent": "a"} | {where: odd}
    system = halls(State(names["state"], frozenset({names["label"]}), origin=names["origin"]))
    plan = still(system, (names["agent"], names["state"]))
    [finding] = refused(plan, "graphml", system, tmp_path).findings
    assert finding.message == "the name 'b\\x07ll' has a character that GraphML cannot hold"
    assert text_of(plan, "csv", system, tmp_path)


def test_only_agents_that_are_named_are_written(tmp_path):
    mission, plan = random_plan(3)
    chosen = [plan.agents[3].id, plan.agents[1].id]
    rows = csv.DictReader(io.StringIO(text_of(plan, "csv", mission, tmp_path, agents=chosen)))
    assert list(dict.fromkeys(row["agent"] for row in rows)) == chosen[::-1]
    for file in tmp_path.iterdir():
        file.unlink()
    error = refused(plan, "csv", mission, tmp_path, agents=["cart-1", "card-2", "x"])
    assert [str(item) for item in error.findings] == [
        "the plan has no agent 'card-2'; did you mean 'cart-2'?",
        'the plan has no agent \'x\'; known: cart-1, cart-2, drone, "fast"-1, drone, "fast"-2',
    ]


def test_paths_that_the_map_does_not_allow_are_refused(tmp_path):
    mission, plan = random_plan(1)
    other = halls(*list(mission.system.states.values())[:1])
    for given in (other, halls(State("elsewhere"))):
        assert isinstance(refused(plan, "csv", given, tmp_path), PlanError)


def test_plans_without_paths_are_refused(tmp_path):
    none = Plan("infeasible", MissionRef("none", "0" * 64), 3)
    assert "has no paths" in str(refused(none, "csv", halls(State("a")), tmp_path))
