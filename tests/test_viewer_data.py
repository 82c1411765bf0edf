"""What the viewer's page is told: places, parts of the formula, and names that are only names."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser

import pytest
from hypothesis import given
from hypothesis import strategies as st

import tsplan
from tests.seeds import quick
from tests.viewing import HOSTILE, mission_on, plan_of, system
from tests.walks import walking
from tsplan.draw.tracks import tracks
from tsplan.plans.outcomes import Status
from tsplan.plans.plan import Plan
from tsplan.viewer import page
from tsplan.viewer.formula_rows import formula_parts
from tsplan.viewer.page_data import page_data
from tsplan.viewer.positions import with_slots
from tsplan.viewer.webpage import embedded
from tsplan.words import visible

NAMES = ("p", "q", "r", "s")


@pytest.fixture
def mission():
    team = [
        {"class": "scout", "count": 3, "at": "p", "capabilities": ["see"]},
        {"class": "heavy", "at": {"q": 1, "s": 1}, "capabilities": ["lift"]},
    ]
    formula = "F[0,9] G[0,1] (sum(q) >= 1) && G[0,12] (sum(r,lift) <= 2 || sum(s) >= 1)"
    return mission_on(system(NAMES, duration=3), team, formula, 14)


def places(data, step):
    """Where the page's data puts every agent at a step."""
    found = {}
    for track in data["tracks"]:
        stops = [track["stops"][i : i + 4] for i in range(0, len(track["stops"]), 4)]
        here = [data["map"]["states"][s]["name"] for a, b, s, _ in stops if a <= step <= b]
        found |= dict.fromkeys(track["ids"], here[0] if here else None)
    return found


@pytest.mark.parametrize("seed", range(20))
def test_everybody_is_where_the_plan_says(mission, seed):
    plan = walking(mission, seed)
    data = json.loads(json.dumps(page_data(mission, plan)))
    found = tracks(plan, mission, moving=True)
    for step in range(plan.horizon + 1):
        said = plan.state_at(step)
        assert places(data, step) == said
        for lane in found:
            where = lane.at(step)
            assert {said[name] for name in lane.ids} == {
                where.source.state if where.share == 0 else None
            }


def test_between_two_steps_an_agent_is_on_its_edge(mission):
    stays = [((0, 2, "p"), (5, 14, "q")), ((0, 14, "p"),), ((0, 13, "p"),)]
    rest = [((0, 14, "q"),), ((0, 14, "s"),)]
    plan = plan_of(
        mission,
        [(path, None) for path in stays[:2]] + [(stays[2], "q")] + [(p, None) for p in rest],
    )
    walker, idle, leaving, *_ = tracks(plan, mission, moving=True)
    assert walker.at(2).share == 0
    assert (walker.at(3.5).source.state, walker.at(3.5).target.state) == ("p", "q")
    assert walker.at(3.5).share == pytest.approx(0.5)
    assert (walker.at(5).source.state, walker.at(5).share) == ("q", 0)
    assert idle.at(7.3).source.state == "p"
    assert leaving.at(14).target.state == "q"  # still under way when the plan ends
    assert leaving.at(14).share == pytest.approx(1 / 3)


@pytest.mark.parametrize("seed", range(20))
def test_no_two_agents_share_a_slot(mission, seed):
    plan = walking(mission, seed)
    taken = set()
    for lane in with_slots(tracks(plan, mission, moving=True)):
        for stop in lane.stops:
            for step in range(stop.first, stop.last + 1):
                for slot in range(stop.slot, stop.slot + lane.count):
                    assert (step, stop.state, slot) not in taken
                    taken.add((step, stop.state, slot))


def test_a_plan_that_does_not_fit_the_map_is_refused(mission):
    paths = still(mission)
    paths[0] = (((0, 2, "p"), (4, 14, "q")), None)
    with pytest.raises(tsplan.PlanError, match="in 2 steps instead of 3"):
        page(mission, plan_of(mission, paths))
    paths[1] = (((0, 14, "nowhere"),), None)
    with pytest.raises(tsplan.PlanError, match="no state 'nowhere'"):
        page(mission, plan_of(mission, paths))


def test_a_plan_without_paths_is_refused(mission):
    plan = Plan(
        status=Status.INFEASIBLE, mission=plan_of(mission, still(mission)).mission, horizon=14
    )
    with pytest.raises(tsplan.PlanError, match="no paths"):
        page(mission, plan)


def still(mission):
    return [(((0, mission.horizon, agent.start),), None) for agent in mission.agents]


def test_parts_tick_off_when_their_counts_are_there(mission):
    paths = still(mission)
    paths[0] = (((0, 2, "p"), (5, 14, "q")), None)
    plan = plan_of(mission, paths)
    root, eventually, always, *rest = formula_parts(mission, plan)
    assert root.heading == "all of"
    assert (eventually.text, eventually.depth) == ("F[0,9] G[0,1] q", 1)
    assert eventually.needed == ((0, 1),)  # a heavy one is there from the start
    assert eventually.charts[0].possible == ((0, 10),)
    assert eventually.charts[0].counts == ((0, 1), (5, 2))
    assert [eventually.share(time) for time in (0, 0.9, 1, 9)] == [0.5, 0.5, 1, 1]
    assert always.heading == "at each step of [0,12] any of"
    assert always.needed == ((0, 12),)
    assert [part.text for part in rest] == ["sum(r,lift) <= 2", "s"]
    assert rest[0].duties == 13
    assert rest[1].duties == 0  # the other one is enough
    assert all(part.failed is None for part in (root, eventually, always, *rest))


def test_what_fails_says_when(mission):
    bare = mission_on(mission.system, [{"class": "a", "at": "p"}], "G[0,9] p && F[0,4] r", 9)
    plan = plan_of(bare, [(((0, 5, "p"), (8, 9, "q")), None)])
    root, always, eventually = formula_parts(bare, plan)
    assert (always.failed, eventually.failed, root.failed) == (6, 4, 4)


def test_negation_shows_what_must_not_be(mission):
    bare = mission_on(mission.system, [{"class": "a", "at": "p"}], "!F[0,9] (sum(r) >= 2)", 9)
    (part,) = formula_parts(bare, plan_of(bare, [(((0, 9, "p"),), None)]))
    assert part.charts[0].text == "sum(r) < 2"
    assert part.needed == ((0, 9),)
    assert part.failed is None


def test_long_formulas_are_cut(mission):
    formula = " && ".join(f"F[0,{n % 9}] (p || q)" for n in range(200))
    bare = mission_on(mission.system, [{"class": "a", "at": "p"}], formula, 9)
    parts = formula_parts(bare, plan_of(bare, [(((0, 9, "p"),), None)]))
    assert len(parts) <= 2 * 300
    assert all(len(part.text) <= 403 for part in parts)


class Scripts(HTMLParser):
    """Collects the scripts of a page, as a browser would find them."""

    def __init__(self):
        super().__init__()
        self.found = []
        self.inside = False
        self.tags = set()

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        self.inside = tag == "script"
        if self.inside:
            self.found.append([dict(attrs), ""])

    def handle_endtag(self, tag):
        self.inside = False

    def handle_data(self, data):
        if self.inside:
            self.found[-1][1] += data


def test_hostile_names_stay_data():
    ring = system(HOSTILE)
    bare = mission_on(ring, [{"class": name, "at": name} for name in HOSTILE], "true", 3)
    text = page(bare, plan_of(bare, still(bare)))
    parser = Scripts()
    parser.feed(text)
    assert len(parser.found) == 2
    assert "img" not in parser.tags
    (attributes, content), _ = parser.found
    assert attributes == {"type": "application/json", "id": "data"}
    data = json.loads(content)
    shown = [visible(name) for name in HOSTILE]
    assert [state["name"] for state in data["map"]["states"]] == shown
    assert [kind["name"] for kind in data["classes"]] == shown


@quick
@given(st.recursive(st.text() | st.integers() | st.none(), st.lists))
def test_embedded_data_reads_back_and_ends_nothing(value):
    text = embedded({"value": value})
    assert json.loads(text) == {"value": value}
    assert not re.search("[<>&\u2028\u2029]", text)


def test_the_page_allows_only_itself(mission):
    text = page(mission, plan_of(mission, still(mission)))
    policy = re.search('Content-Security-Policy" content="([^"]*)"', text)[1]
    assert policy.startswith("default-src 'none'; script-src 'sha256-")
    assert "unsafe" not in policy
    assert not re.search(r"https?://", text)
    assert "innerHTML" not in text
