"""Agents that are on an edge when the mission begins: files, plans, and what the check refuses."""

from __future__ import annotations

from dataclasses import replace

import pytest

import tsplan
from tsplan import Group, Mission, Plan
from tsplan.checking.plan_check import check
from tsplan.draw.tracks import tracks
from tsplan.errors import MissionError
from tsplan.mission import UnderWay
from tsplan.mission.read import mission_from_text
from tsplan.viewer.page_data import page_data
from tsplan.writers.handover import handover

MAP = """
format: tsplan-mission/1
map:
  waiting: true
  states: {q1: {}, q2: {labels: [b]}, q3: {labels: [c]}}
  edges: [[q1, q2, 4], [q2, q3, 1], [q3, q2, 1]]
"""
TEAM = (
    MAP
    + """
team:
  - {class: scout, count: 2, at: {from: q1, to: q2, arrives: 3}}
  - {class: heavy, at: [q3, {q1: 2}, {from: q1, to: q2, arrives: 2, count: 2}]}
spec: "F[0,8] (sum(b, heavy) >= 2 && sum(c, scout) >= 2)"
"""
)


# --- files --------------------------------------------------------------------------------------


def test_all_forms_of_starts_are_read_and_written() -> None:
    mission = mission_from_text(TEAM)
    scouts, heavies = mission.team
    assert scouts.coming == ((UnderWay("q1", "q2", 3), 2),)
    assert (scouts.starts, scouts.count) == ((), 2)
    assert heavies.starts == (("q3", 1), ("q1", 2))
    assert heavies.coming == ((UnderWay("q1", "q2", 2), 2),)
    assert [agent.start for agent in mission.agents[-2:]] == [UnderWay("q1", "q2", 2)] * 2
    again = mission_from_text(mission.to_yaml())
    assert again.team == mission.team
    assert "at: {from: q1, to: q2, arrives: 3, count: 2}" in mission.to_yaml()


def test_python_has_the_same_forms() -> None:
    given = {"q3": 1, "q1": 2, UnderWay("q1", "q2", 2): 2}
    heavy = Group.of("heavy", given, ["heavy"])
    assert heavy == mission_from_text(TEAM).team[1]
    system = mission_from_text(TEAM).system
    for team in ([heavy], [("heavy", given, ["heavy"])], {"heavy": given}):
        made = Mission.of(map=system, team=team, formula="F[0,2] sum(b) >= 2", language="mtl")
        assert made.team[0].coming == heavy.coming
    entry = {"at": [{"q1": 2}, {"from": "q1", "to": "q2", "arrives": 2, "count": 2}]}
    made = Mission.of(map=system, team={"heavy": entry}, formula="F[0,2] b", language="mtl")
    assert made.team[0].coming == heavy.coming


def test_states_may_be_called_as_the_keys_are() -> None:
    text = TEAM.replace("q3", "from").replace("[from, {q1: 2}", "[{from: 1}, {q1: 2}")
    mission = mission_from_text(text)
    assert mission.team[1].starts == (("from", 1), ("q1", 2))
    assert mission_from_text(mission.to_yaml()).team == mission.team


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("arrives: 3", "arrives: 0", "9:62", "at least 1"),
        ("arrives: 3", "arives: 3", "9:34", "'arrives' is missing"),
        ("arrives: 3", "arrives: 3, by: 2", "9:65", "unknown key 'by'; known: "),
        ("to: q2, arrives: 2", "to: q9, arrives: 2", "10:38", "no state 'q9'"),
        ("{q1: 2}", "{q7: 2}", "10:34", "no state 'q7'"),
        ("at: [q3,", "at: [q8,", "10:25", "no state 'q8'"),
        ("at: [q3,", "at: [true,", "10:25", "'true' is no start"),
        ("{q1: 2}", "{q1: -1}", "10:34", "at least 1"),
        ("arrives: 3", "arrives: 3, count: 3", "9:27", "count is 2 and the start states hold 3"),
    ],
)
def test_what_is_wrong_is_told_at_its_place(old: str, new: str, place: str, words: str) -> None:
    assert old in TEAM
    with pytest.raises(MissionError) as told:
        mission_from_text(TEAM.replace(old, new, 1))
    assert any(f":{place}:" in str(finding) for finding in told.value.findings), str(told.value)
    assert words in str(told.value)


def test_more_than_an_edge_or_a_zone_holds_cannot_start_there() -> None:
    narrow = TEAM.replace("[q1, q2, 4]", "{from: q1, to: q2, duration: 4, capacity: 3}")
    with pytest.raises(MissionError, match="4 robots start on the edge from 'q1' to 'q2'"):
        mission_from_text(narrow)
    zoned = TEAM.replace("[q1, q2, 4]", "{from: q1, to: q2, duration: 4, zone: z}")
    zoned = zoned.replace("  states:", "  zones: {z: 3}\n  states:")
    with pytest.raises(MissionError, match="4 robots start in the zone 'z', which holds 3"):
        mission_from_text(zoned)


def test_structures_start_under_way_whole() -> None:
    text = TEAM.replace("team:", "configurations: {pair: {modules: 2}}\nteam:")
    text = text.replace("arrives: 3}", "arrives: 3, count: 3}, configuration: pair")
    with pytest.raises(MissionError, match="3 modules start on the way from 'q1' to 'q2', and a"):
        mission_from_text(text)


# --- plans --------------------------------------------------------------------------------------


def test_begun_moves_are_paid_for_and_told() -> None:
    mission = mission_from_text(TEAM)
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(mission, encoding=encoding)
        assert (plan.status, plan.verified, plan.value("travel")) == ("optimal", True, 2)
        scout = plan.agent["scout-1"]
        assert (scout.coming, scout.stays[0][::2]) == ("q1", (3, "q2"))
        assert scout.state_at(2) is None
        assert Plan.from_json(plan.to_json()) == plan
    assert plan.value("makespan") >= 3
    assert plan.value("agents") == 4
    assert "on the way from q1, q2:3-" in str(plan)


def test_whoever_never_arrives_has_no_stay() -> None:
    mission = mission_from_text(TEAM.replace("{q1: 2}", "{from: q1, to: q2, arrives: 9}"))
    plan = tsplan.plan(mission)
    agent = next(agent for agent in plan.agents if not agent.stays)
    assert (agent.coming, agent.heading) == ("q1", "q2")
    assert Plan.from_json(plan.to_json()) == plan
    assert "on the way from q1 to q2" in str(plan)


def test_an_edge_may_be_gone_or_admit_nobody_any_more() -> None:
    for edge in ("[q2, q1, 1]", "{from: q1, to: q2, duration: {heavy: 1}}"):
        mission = mission_from_text(TEAM.replace("[q1, q2, 4]", edge))
        for encoding in ("tight", "reference"):
            plan = tsplan.plan(mission, encoding=encoding)
            assert (plan.status, plan.verified) == ("optimal", True)


def test_those_under_way_use_the_room_of_the_edge() -> None:
    text = TEAM.replace("[q1, q2, 4]", "{from: q1, to: q2, duration: 1, capacity: 4}")
    text = text.replace("sum(b, heavy) >= 2", "sum(b, heavy) >= 4")
    early = mission_from_text(text.replace("F[0,8]", "F[0,4]"))
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(early, encoding=encoding)
        assert (plan.status, plan.verified) == ("optimal", True)
        left = {agent.stays[0][1] for agent in plan.agents if agent.stays[0][2] == "q1"}
        assert min(left) >= 2  # two of four come off the edge then


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"coming": "q3"}, "starts on the way from q1 to q2 until step 3, and not on the way"),
        ({"coming": None}, "not on the way from anywhere"),
        ({"stays": ((2, 8, "q2"),)}, "is first at q2 at step 2"),
        ({"stays": ((3, 8, "q3"),)}, "is first at q3 at step 3"),
        ({"stays": (), "heading": "q2"}, "is never by the plan"),
    ],
)
def test_forged_arrivals_are_refused(change: dict[str, object], words: str) -> None:
    mission = mission_from_text(TEAM)
    plan = tsplan.plan(mission)
    first, *others = plan.agents
    forged = replace(plan, agents=(replace(first, **change), *others))
    assert any(words in finding.message for finding in check(mission, forged).findings)


def test_groups_of_swarms_may_be_under_way() -> None:
    text = MAP + (
        "swarm: {size: 6, at: [{q1: 3}, {from: q1, to: q2, arrives: 2, count: 3}]}\n"
        'spec: "F[0,8] sum(c) >= 2"'
    )
    mission = mission_from_text(text)
    assert mission_from_text(mission.to_yaml()).team == mission.team
    plan = tsplan.plan(mission)
    assert (plan.status, plan.value("splits"), plan.value("travel")) == ("optimal", 0, 3)
    first = next(group for group in plan.groups if group.edge is not None)
    assert (first.edge, first.first, first.last, first.size) == (("q1", "q2"), 0, 1, 3)
    assert len(first.children) == 1
    paths = tsplan.assign(mission, replace(plan, agents=()))
    assert sum(agent.coming is not None for agent in paths.agents) == 3
    assert plan.simulate(mission, runs=20).formula.times == 20


def test_what_they_bring_is_there_when_they_arrive() -> None:
    team = "[{class: hauler, at: {from: q1, to: q2, arrives: 3, carrying: {brick: 2}}}]"
    text = f"{MAP}\nresources: [{{name: brick, at: {{q1: 1}}}}]\nteam: {team}\nhorizon: 6\n"
    for last, status in ((2, "infeasible"), (3, "optimal")):
        mission = mission_from_text(f"{text}spec: 'F[0,{last}] T(0, b, {{}}, {{(brick, 2)}})'")
        for encoding in ("tight", "reference"):
            plan = tsplan.plan(mission, encoding=encoding)
            assert plan.status == status
    assert plan.verified
    assert plan.executions[0].step >= 3
    assert mission_from_text(mission.to_yaml()).resources == mission.resources
    with pytest.raises(MissionError, match="no resource 'stone'"):
        mission_from_text(mission.to_yaml().replace("carrying: {brick", "carrying: {stone"))


def test_reasons_know_when_they_arrive() -> None:
    mission = mission_from_text(TEAM.replace("F[0,8]", "F[0,2]"))
    told = str(tsplan.explain(mission))
    assert "one of class scout from 'q2', at step 4 by q2 > q3" in told
    assert "on the way from 'q1' to 'q2'" in told


def test_the_page_shows_them_on_their_edge() -> None:
    mission = mission_from_text(TEAM)
    data = page_data(mission, tsplan.plan(mission))
    number = {state["name"]: place for place, state in enumerate(data["map"]["states"])}
    begun = [track["stops"][:4] for track in data["tracks"] if track["stops"][0] < 0]
    assert begun == [[-1, -1, number["q1"], 0]] * 2


def test_tracks_are_on_their_way_until_they_arrive() -> None:
    mission = mission_from_text(TEAM)
    (track,) = (t for t in tracks(tsplan.plan(mission), mission) if t.class_name == "scout")
    assert next(iter(track.journeys(8))) == (0, 3)
    assert track.present(0)
    here, there, share = track.at(1.0)
    assert (here.state, there.state, share) == ("q1", "q2", 0.5)


def test_exports_say_where_they_are() -> None:
    mission = mission_from_text(TEAM)
    plan = tsplan.plan(mission)
    made = handover(plan, mission.system)
    scout = dict(made.journeys())["scout-1"]
    assert (scout.state_at(0), scout.latest(0), scout.state_at(3)) == (None, "q1", "q2")
    assert scout.position_at(1, lambda _: (0.0, 0.0)) is None
