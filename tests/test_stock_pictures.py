"""What lies where and what is carried, in pictures and on the page: the data behind them."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

import tsplan
from tests.deliveries import GARDEN, building, site
from tests.legible import assert_legible
from tsplan.checking.plan_check import certify
from tsplan.draw.palette import Palette
from tsplan.draw.path_map import load_texts
from tsplan.draw.row_chart import MOST_ROWS
from tsplan.draw.stock_chart import beside, shown_rows
from tsplan.draw.strands import strands_of
from tsplan.draw.tracks import tracks
from tsplan.draw.views import draw_page
from tsplan.errors import InputError
from tsplan.explanation.why.stock_lines import stock_lines
from tsplan.mission import Group, Resource
from tsplan.plans.cargo_rows import loads_of
from tsplan.plans.supplies import Cargo
from tsplan.viewer.page_data import page_data

matplotlib = pytest.importorskip("matplotlib")


def lines():
    mission, plan = building()
    return {line.title: line for line in stock_lines(plan, mission)}


def named(ax, name):
    return [artist for artist in ax.get_children() if artist.get_gid() == name]


def words(ax, name):
    return [text.get_text() for text in ax.texts if text.get_gid() == name]


def test_lines_say_what_lies_stays_and_is_needed():
    found = lines()
    assert list(found) == [
        "brick at yard",
        "brick at wall",
        "water at yard",
        "water at wall",
        "water at garden",
        "drill at yard",
        "drill at wall",
    ]
    bricks, drill, water = (
        found[name] for name in ("brick at wall", "drill at wall", "water at garden")
    )
    assert bricks.amounts.tolist() == [1, 1, 3, 3, 0, 0, 0, 0]
    assert bricks.staying.tolist() == [1, 1, 3, 0, 0, 0, 0, 0]
    assert bricks.needs.tolist() == [0, 0, 0, 3, 0, 0, 0, 0]
    assert [([*h.agents.names()], h.come, h.amount) for h in bricks.brought] == [
        (["man-1"], 2, 1),
        (["man-2"], 2, 1),
    ]
    assert drill.needs.tolist() == [0, 0, 0, 1, 1, 0, 0, 0]  # in use, and still there
    assert drill.staying.tolist() == [0, 0, 1, 1, 1, 1, 1, 1]
    assert water.needs.tolist() == [0, 0, 0, 0, 0.75, 0, 0.75, 0]
    assert water.begins == (4, 6)
    assert all(line.moves for line in found.values())


def test_lines_are_the_stocks_of_the_plan():
    told = certify(*building())
    assert told.verified
    for stock in told.stocks:
        line = lines()[f"{stock.resource} at {stock.state}"]
        assert [stock.at(step) for step in range(8)] == line.amounts.tolist()


def test_between_two_steps_nothing_lies_twice():
    mission, plan = building()
    found = stock_lines(plan, mission)
    for time in np.arange(0, 7.01, 0.25):
        there = sum(line.at(time) for line in found if line.resource.name == "brick")
        moved = 2 if 0 < time < 2 else 0  # on the way with the men
        assert there == 5 - moved - (3 if time > 3 else 0)


def test_what_neither_changes_nor_is_needed_has_no_row():
    mission, plan = building()
    more = replace(mission, resources=(*mission.resources, Resource.of("sand", {"garden": 3})))
    plan = replace(plan, mission=replace(plan.mission, sha256=more.digest))
    (sand,) = [line for line in stock_lines(plan, more) if line.resource.name == "sand"]
    assert not sand.moves
    _, ax = plan.plot(more, view="stocks")
    assert "sand at garden" not in [label.get_text() for label in ax.get_yticklabels()]


def test_the_chart_has_a_row_for_each_stock_with_what_is_taken():
    mission, plan = building()
    figure, ax = plan.plot(mission, view="stocks")
    assert [label.get_text() for label in ax.get_yticklabels()] == list(lines())
    assert len(named(ax, "stock")) == 7
    assert words(ax, "taking") == ["3", "0.75", "0.75", "1"]
    assert [line.get_xdata()[0] for line in named(ax, "begin")] == [3, 4, 6, 3]
    bands = [(shade.get_x(), shade.get_width()) for shade in named(ax, "execution")]
    assert bands == [(2.5, 1), (3.5, 1), (5.5, 1), (2.5, 2)]
    assert words(ax, "amount")[:4] == ["4", "2", "1", "3"]
    assert beside(lines()["water at garden"]) == ("1.5 used up", "peak 1.5, end 0")
    assert beside(lines()["drill at wall"]) == ("1 in use", "peak 1, end 1")
    assert beside(lines()["brick at yard"]) == ("", "peak 4, end 2")
    assert_legible(figure)


def test_the_dashed_line_is_as_high_as_the_need():
    mission, plan = building()
    _, ax = plan.plot(mission, view="stocks")
    taken = named(ax, "taken")
    assert [line.get_xdata().tolist() for line in taken][:2] == [[2.5, 3.5], [3.5, 4.5]]
    stock = named(ax, "stock")[1]  # brick at wall: all three are taken
    assert taken[0].get_ydata()[0] == pytest.approx(stock.get_ydata()[2 * 3])
    water = named(ax, "stock")[4]  # half of it is taken at step 4
    base = water.get_ydata()[0]
    assert base - taken[1].get_ydata()[0] == pytest.approx((base - water.get_ydata()[2 * 4]) / 2)


def test_what_is_not_there_is_seen_to_be_missing():
    mission, plan = building()
    late = replace(plan, cargo=tuple(item for item in plan.cargo if item.agent != "man-2"))
    _, ax = late.plot(mission, view="stocks")
    legend = [text.get_text() for text in ax.get_legend().get_texts()]
    assert "not enough there" in legend
    short, *_ = named(ax, "execution")
    other, *_ = named(plan.plot(mission, view="stocks")[1], "execution")
    assert short.get_facecolor() != other.get_facecolor()


def test_what_was_never_there_is_drawn_as_nothing():
    mission, plan = building()
    extra = Cargo("man-2", 0, "drill", 1.0)  # there is only one, and man-1 has it
    figure, ax = replace(plan, cargo=(*plan.cargo, extra)).plot(mission, view="stocks")
    shade, *_ = named(ax, "lacking")
    assert (shade.get_x(), shade.get_width()) == (0.5, 7)
    heights = [line.get_ydata() for line in named(ax, "stock")]
    assert all(np.ptp(np.floor(height)) == 0 for height in heights)  # each within its row
    assert_legible(figure)


def test_many_paths_say_what_is_carried_in_all():
    mission, plan = building()
    found = strands_of(
        [track for track in tracks(plan, mission) for _ in range(20)],
        7,
        Palette.of(mission),
        loads_of(plan.cargo),
    )
    assert found[1]
    man = found[0][0].passages["yard", "wall"]
    assert load_texts(man, joined=True)[0] == "40 brick, 20 drill"


def test_of_many_rows_those_that_are_needed_stay():
    line = lines()["drill at wall"]
    idle = replace(line, uses=())
    chosen = shown_rows([*(idle for _ in range(MOST_ROWS)), line])
    assert len(chosen) == MOST_ROWS
    assert chosen[-1] is line


def test_numbers_without_room_are_left_out():
    mission, plan = building()
    long = replace(mission, horizon=150)
    agents = tuple(
        replace(agent, stays=(*agent.stays[:-1], (agent.stays[-1][0], 150, agent.stays[-1][2])))
        for agent in plan.agents
    )
    ref = replace(plan.mission, sha256=long.digest)
    figure, ax = replace(plan, horizon=150, agents=agents, mission=ref).plot(long, view="stocks")
    assert len(named(ax, "begin")) == 4
    assert words(ax, "taking") == ["3", "1"]  # not those of the garden, side by side
    assert_legible(figure)


def test_missions_without_resources_have_no_such_view():
    _, plan = building()
    bare = [Group.of("man", {"yard": 2}), Group.of("cart", {"yard": 1})]
    other = tsplan.Mission.of(map=site(), team=bare, formula="true", horizon=7)
    with pytest.raises(InputError, match="the mission has no resources"):
        plan.plot(other, view="stocks")


def test_the_page_has_the_stocks_last():
    mission, plan = building()
    figure, parts = draw_page(plan, mission)
    assert len(parts) == 4
    assert named(parts[3], "stock")
    assert_legible(figure)


def test_what_is_carried_stands_beside_the_lanes():
    mission, plan = building()
    figure, ax = plan.plot(mission)
    assert sorted(words(ax, "load")) == [
        "1.5 water",
        "1.5 water",
        "2 brick, 1 drill",
    ]
    legend = [text.get_text() for text in ax.get_legend().get_texts()]
    assert "numbers with names: what is carried" in legend
    assert_legible(figure)
    joined, _ = strands_of(tracks(plan, mission), 7, Palette.of(mission), loads_of(plan.cargo))
    men, _ = joined
    assert men.passages["yard", "wall"].loads == {2: {"brick": 2.0, "drill": 1.0}}


def test_the_mission_is_drawn_with_what_lies_there_at_first():
    mission, _ = building()
    figure, ax = mission.plot()
    assert words(ax, "first stock") == ["4 brick\n2.5 water\n1 drill", "1 brick"]
    legend = [text.get_text() for text in ax.get_legend().get_texts()]
    assert legend[2:] == ["5 brick", "2.5 water", "1 drill (tool)"]
    assert_legible(figure)


def test_the_page_is_told_what_lies_and_what_is_carried():
    mission, plan = building()
    data = json.loads(json.dumps(page_data(mission, plan)))
    men, cart = data["tracks"]
    assert men["loads"] == [[0, "2 brick, 1 drill"]]
    assert cart["loads"] == [[1, "1.5 water"], [3, "1.5 water"]]
    assert data["freights"] == [
        [0, 1, 0, 2, "2 brick, 1 drill"],
        [0, 1, 1, 3, "1.5 water"],
        [1, 2, 3, 4, "1.5 water"],
    ]
    stocks = {(stock["name"], stock["state"]): stock["amounts"] for stock in data["stocks"]}
    assert stocks["brick", 0] == [[0, "4", "2"]]
    assert stocks["brick", 1] == [[0, "1", "1"], [2, "3", "3"], [3, "3", "0"]]
    assert stocks["water", 2] == [
        [0, "0", "0"],
        [4, "1.5", "0.75"],
        [6, "0.75", "0"],
    ]


def test_the_moving_picture_writes_loads_and_stocks():
    scenes = pytest.importorskip("tsplan.viewer.scene")
    mission, plan = building()
    scene = scenes.Scene(mission, plan, (640, 400))

    assert (scene.at(0) != scene.at(0.5)).any()
    said = {time: {words for words, _ in scene.supplied(time)} for time in (0, 0.5, 1.5, 5)}
    assert said[0] == {"4 brick\n2.5 water\n1 drill", "1 brick"}
    assert said[0.5] == {"2 brick\n2.5 water", "1 brick", "2 brick, 1 drill"}
    assert said[1.5] == {"2 brick\n1 water", "1 brick", "2 brick, 1 drill", "1.5 water"}
    assert said[5] == {"2 brick\n1 water", "1 drill", "0.75 water"}


def test_a_plan_found_shows_its_stocks():
    mission = tsplan.Mission.of(
        map=site(),
        team=[Group.of("cart", {"yard": 1}, carries=4)],
        resources=[Resource.of("water", {"yard": 2.5})],
        formula=f"F[0,4] {GARDEN}",
        objective=["haulage"],
    )
    plan = tsplan.plan(mission)
    figure, _ = plan.plot(mission, view="stocks")
    assert_legible(figure)
