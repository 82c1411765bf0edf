"""Pictures and pages of modular robots: who is in which structure, where, and what is rebuilt."""

from __future__ import annotations

import pytest

import tsplan
from tests.fence_missions import fence
from tests.legible import assert_legible
from tests.seeds import sampled
from tsplan.draw.palette import Palette, classes_of
from tsplan.draw.strands import strands_of
from tsplan.draw.swarm_bands import REBUILT, bands_of, durations_of, flows_of
from tsplan.draw.timeline_rows import rows_of
from tsplan.draw.tracks import tracks
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.viewer.freight import rebuildings
from tsplan.viewer.page_data import page_data


@pytest.fixture(scope="module")
def mission() -> Mission:
    return fence()


@pytest.fixture(scope="module")
def plan(mission: Mission) -> Plan:
    return tsplan.plan(mission)


def test_structures_are_drawn_once_with_their_modules(mission: Mission, plan: Plan) -> None:
    found = {track.ids[0]: track for track in tracks(plan, mission, moving=True)}
    assert {*found} == {each.id for each in plan.structures}
    line = found["line-1"]
    (body,) = (each for each in plan.structures if each.id == "line-1")
    assert (line.class_name, line.count, line.width) == ("line", 1, 3)
    assert line.modules == body.modules
    assert (line.stops[0].first, line.end) == (body.first, body.last + 1)
    assert not line.present(body.first - 0.5)


def test_the_ways_of_structures_are_as_wide_as_they_have_modules(
    mission: Mission, plan: Plan
) -> None:
    strands, joined = strands_of(tracks(plan, mission), plan.horizon, Palette.of(mission))
    assert not joined
    assert {strand.words: strand.agents for strand in strands} == {
        "line-1 (3)": 3,
        "single-2 (1)": 1,
    }


def test_the_timeline_has_modules_with_the_structures_they_are_part_of(
    mission: Mission, plan: Plan
) -> None:
    rows = {row.name: row for row in rows_of(plan, tracks(plan, mission, modules=True))}
    assert {*rows} == {agent.id for agent in mission.agents}
    (change,) = plan.rebuilt
    (line,) = (each for each in plan.structures if each.configuration == "line")
    for module in line.modules:
        lives = [(life.first, life.last, life.configuration) for life in rows[module].lives]
        assert lives == [(0, change.step, "single"), (line.first, line.last, "line")]
        journeys = [*rows[module].journeys(plan.horizon)]
        assert journeys
        assert all(left >= line.first for left, _ in journeys)  # none while they are rebuilt
    _, ax = plan.plot(mission, view="timeline")
    assert sum(bar.get_gid() == "line-1" for bar in ax.patches) == len(line.modules)


def test_where_structures_start_and_what_they_can_do(mission: Mission) -> None:
    kinds = classes_of(mission)
    assert {name: kind.words(name) for name, kind in kinds.items()} == {
        "single": "single of 1 module",
        "line": "line of 3 modules",
        "ring": "ring of 4 modules",
    }
    lines = fence(team="[{class: module, count: 6, at: dock, configuration: line}]")
    assert classes_of(lines)["line"].agents == 2
    _, ax = lines.plot()
    badges = [text.get_text() for text in ax.texts if text.get_text().isdigit()]
    assert badges.count("2") >= 1
    assert "6" not in badges


def test_requirements_count_structures(mission: Mission, plan: Plan) -> None:
    lift, look = plan.requirements(mission)
    assert max(lift.counts) == 1
    assert max(look.counts) == 1


def test_the_page_tells_what_is_rebuilt_where(mission: Mission, plan: Plan) -> None:
    data = page_data(mission, plan)
    assert [kind["name"] for kind in data["classes"]] == [
        "single of 1 module",
        "line of 3 modules",
        "ring of 4 modules",
    ]
    dock = list(mission.system.states).index("dock")
    (change,) = plan.rebuilt
    assert data["freights"] == [[dock, dock, change.step, change.step + 2, "3 single \u2192 line"]]
    named = {track["name"] for track in data["tracks"]}
    assert "line-1 (module-3..5)" in named


def test_what_is_not_done_in_time_is_told_too() -> None:
    mission = fence(
        formula="T(1, dock, {(look,1)}) && G[2,2] max(dock) <= 2",
        reconfigure="[{from: single, to: line, duration: 2, cost: 0}]",
        horizon="2",
    )
    plan = tsplan.plan(mission)
    assert plan.rebuilt
    for freight, change in zip(rebuildings(plan, mission), plan.rebuilt, strict=True):
        assert (freight.source, freight.left) == (change.state, change.step)
        assert freight.come > change.step
    plan.plot(mission, view="timeline")
    plan.plot(mission)
    page_data(mission, plan)


def test_the_flow_of_structures_counts_their_modules(mission: Mission, plan: Plan) -> None:
    flows = flows_of(plan, mission)
    (change,) = plan.rebuilt
    (made,) = (each for each in plan.structures if each.id in change.made)
    waits = [(step, "dock", "dock", 3) for step in range(change.step, made.first)]
    assert list(flows[REBUILT]) == waits
    assert list(flows) == ["single", "line", REBUILT]
    bands = bands_of(flows, durations_of(plan, mission.system))
    for step in range(plan.horizon):
        there = sum(b.count for b in bands if b.source[1] <= step < b.target[1])
        assert there == len(mission.agents)
    figure, ax = plan.plot(mission, view="flow")
    assert ax.get_title(loc="left").endswith("(modules)")
    drawn = {artist.get_gid() for artist in ax.collections}
    assert {"stays:line", "moves:line", f"stays:{REBUILT}"} <= drawn
    assert_legible(figure)


@pytest.mark.parametrize("named", sampled(["line-1", "line", "module-5"], ["line-1"]))
def test_structures_and_modules_can_be_looked_at(mission: Mission, plan: Plan, named: str) -> None:
    _, (mapped, timeline, _) = plan.plot(mission, view="page", agents=[named])
    rows = {tick.get_text() for tick in timeline.get_yticklabels()}
    (line,) = (each for each in plan.structures if each.id == "line-1")
    assert rows == ({"module-5"} if named == "module-5" else {*line.modules})
    assert any(artist.get_gid() == "path:line-1 (3)" for artist in mapped.collections)
    assert not any(artist.get_gid() == "path:single-2 (1)" for artist in mapped.collections)


def test_notebooks_show_modules(plan: Plan) -> None:
    shown = plan._repr_html_()
    assert "module-5" in shown
    assert "5 agents" in shown


def test_strips_of_structures_hide_nothing_of_what_was_planned(
    mission: Mission, plan: Plan
) -> None:
    _, ax = plan.plot(mission, view="timeline", executed=plan)
    strips = [bar for bar in ax.patches if bar.get_gid() == "line-1"]
    below = [bar for bar in ax.patches if str(bar.get_gid()).startswith("planned ")]
    assert strips
    assert below
    for bar in strips:
        row = round(bar.get_y() + bar.get_height() / 2)
        starts = [b.get_y() for b in below if round(b.get_y() + b.get_height() / 2) == row]
        assert bar.get_y() + bar.get_height() <= min(starts)


def test_who_is_being_rebuilt_at_the_start_is_not_on_the_way() -> None:
    team = (
        "[{class: module, count: 3, at: {from: dock, to: dock, arrives: 2}, configuration: line}]"
    )
    plan = tsplan.plan(fence(team=team))
    for row in rows_of(plan, tracks(plan, modules=True)):
        assert row.stops[0].first == 2
        assert all(left >= 2 for left, _ in row.journeys(plan.horizon))
