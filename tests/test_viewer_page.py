"""The viewer's page as a person uses it, in a headless browser."""

from __future__ import annotations

import io
import time
from itertools import pairwise

import pytest

from tests.deliveries import building
from tests.seeds import sampled
from tests.viewing import (
    HORIZON,
    HOSTILE,
    NAMES,
    mission_on,
    plan_of,
    scouts_and_heavies,
    system,
)
from tests.walks import walking
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.viewer import page
from tsplan.viewer.page_data import page_data
from tsplan.words import visible


@pytest.fixture(scope="module")
def planned():
    return scouts_and_heavies()


@pytest.fixture
def shown(browser, planned, tmp_path):
    """The page of a plan, freshly loaded; afterwards nothing may have gone wrong on it."""
    browser.resize(1280, 800)
    browser.prefer(prefers_color_scheme="light", prefers_reduced_motion="no-preference")
    path = tmp_path / "plan.html"
    path.write_text(page(*planned), encoding="utf-8")
    browser.open(path)
    yield browser
    assert browser.errors() == []
    assert browser.requests() == []


def places(browser):
    said = browser.run("tsplanViewer.places()")
    return {name: entry["state"] for entry in said for name in entry["ids"]}


def now(browser):
    return browser.run("tsplanViewer.time()")


def chosen(browser):
    return browser.run("tsplanViewer.chosen()")


def text(browser, selector):
    return browser.run(f"document.querySelector({selector!r}).textContent")


def pixels(browser):
    image = pytest.importorskip("PIL.Image")
    return image.open(io.BytesIO(browser.screenshot())).convert("RGB")


def test_it_loads_from_disk_and_shows_something(shown):
    assert shown.run("location.protocol") == "file:"
    assert text(shown, "#title") == "test"
    picture = pixels(shown)
    assert picture.size == (1280, 800)
    assert len(picture.crop((0, 60, 900, 560)).getcolors(100_000)) > 30


def test_every_agent_is_where_the_plan_says_at_every_step(shown, planned):
    _, plan = planned
    for step in range(HORIZON + 1):
        assert now(shown) == step
        assert text(shown, "#clock") == f"step {step} of {HORIZON}"
        assert places(shown) == plan.state_at(step)
        shown.press("ArrowRight")
    assert now(shown) == HORIZON


def test_agents_are_drawn_at_their_states(shown, planned):
    shown.press("End")
    picture = pixels(shown)
    box = shown.run(
        "(b => [b.left, b.top])(document.getElementById('map').getBoundingClientRect())"
    )
    colours = {kind["name"]: kind["color"] for kind in page_data(*planned)["classes"]}
    centres = {name: shown.run(f"tsplanViewer.stateAt({name!r})") for name in NAMES}
    for entry in shown.run("tsplanViewer.places()"):
        x, y = entry["at"]
        if entry["state"] is None:
            continue  # on the way, marks may pass each other
        middle = centres[entry["state"]]
        assert abs(middle[0] - x) + abs(middle[1] - y) < 60
        colour = picture.getpixel((round(box[0] + x), round(box[1] + y)))
        wanted = colours[entry["name"].partition("-")[0]]
        assert colour == tuple(bytes.fromhex(wanted[1:]))


def test_space_plays_and_pauses(shown):
    shown.press(" ")
    assert shown.run("tsplanViewer.playing()")
    end = time.monotonic() + 5
    while now(shown) < 0.2 and time.monotonic() < end:
        shown.frames(3)
    shown.press(" ")
    assert not shown.run("tsplanViewer.playing()")
    stopped = now(shown)
    assert 0.2 <= stopped < HORIZON
    shown.frames(5)
    assert now(shown) == stopped
    shown.press("ArrowRight")
    assert now(shown) == int(stopped) + 1


def test_it_moves_smoothly_between_states(shown, planned):
    """While an agent travels its mark is drawn between the two states."""
    lane, leave, arrive = next(
        (number, a[1], b[0])
        for number, bundle in enumerate(planned[1].bundles)
        for a, b in pairwise(bundle.stays)
        if b[0] - a[1] == 3
    )
    at = []
    for step in range(leave, arrive + 1):
        shown.press("Home")
        for _ in range(step):
            shown.press("ArrowRight")
        at.append(shown.run(f"tsplanViewer.places()[{lane}].at"))
    steps = [((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5 for (x0, y0), (x1, y1) in pairwise(at)]
    assert min(steps) > 0.5 * max(steps) > 5


def test_playing_ends_at_the_end_or_starts_again(shown):
    for _ in range(4):
        shown.press("+")
    assert shown.run("tsplanViewer.speed()") == 16
    shown.press(" ")
    end = time.monotonic() + 20
    while shown.run("tsplanViewer.playing()") and time.monotonic() < end:
        shown.frames(3)
    assert now(shown) == HORIZON
    shown.press("l")
    assert shown.run("document.getElementById('loop').checked")
    shown.press(" ")  # from the start
    before = now(shown)
    end = time.monotonic() + 20
    while now(shown) >= before and time.monotonic() < end:
        before = now(shown)
        shown.frames(2)
    assert shown.run("tsplanViewer.playing()")
    shown.press(" ")


def test_clicking_the_scrub_bar_goes_to_a_whole_step(shown, planned):
    shown.click_on("#scrub")
    assert now(shown) == HORIZON / 2
    assert places(shown) == planned[1].state_at(HORIZON // 2)


def test_clicking_the_timeline_seeks_and_chooses(shown):
    box = shown.run(
        "(b => [b.left, b.top, b.width])(document.getElementById('rows').getBoundingClientRect())"
    )
    shown.click(box[0] + 150 + (box[2] - 164) * 4 / HORIZON, box[1] + 30)
    assert abs(now(shown) - 4) <= 1
    assert chosen(shown)["track"] == 1


def test_clicking_an_agent_shows_its_path(shown, planned):
    _, plan = planned
    box = shown.run(
        "(b => [b.left, b.top])(document.getElementById('map').getBoundingClientRect())"
    )
    first = shown.run("tsplanViewer.places()[0]")
    before = shown.screenshot()
    shown.click(box[0] + first["at"][0], box[1] + first["at"][1])
    assert chosen(shown)["track"] == 0
    assert shown.screenshot() != before
    assert text(shown, "#chosen h3") == first["name"]
    listed = shown.run("[...document.querySelectorAll('#chosen li')].map(item => item.textContent)")
    stays = plan.agent[first["ids"][0]].stays
    words = [f"{state} {a}" if a == b else f"{state} {a}\u2013{b}" for a, b, state in stays]
    assert listed[: len(words)] == words
    shown.click_on("#chosen li button", len(words) - 1)
    assert now(shown) == stays[-1][0]
    shown.press("Escape")
    assert chosen(shown) == {"track": -1, "state": -1, "node": -1}
    assert shown.run("document.getElementById('chosen').hidden")


def test_clicking_a_state_lists_who_is_there(shown, planned):
    box = shown.run(
        "(b => [b.left, b.top])(document.getElementById('map').getBoundingClientRect())"
    )
    x, y = shown.run("tsplanViewer.stateAt('s')")
    shown.click(box[0] + x, box[1] + y)
    assert chosen(shown)["state"] == NAMES.index("s")
    assert text(shown, "#agents") == "nobody is at s at step 0"
    for step in range(1, HORIZON + 1):
        shown.press("ArrowRight")
        there = sum(state == "s" for state in planned[1].state_at(step).values())
        rows = shown.run("document.querySelectorAll('#agents button').length")
        assert bool(rows) == bool(there)


def test_clicking_a_part_of_the_formula_shows_its_need(shown):
    assert shown.run("document.getElementById('charts').hidden")
    shown.click_on("#formula button", 1)
    assert chosen(shown)["node"] == 1
    assert text(shown, "#formula [aria-pressed=true] .text") == "F[0,9] q"
    assert text(shown, "#charts figcaption span") == "q"
    assert text(shown, "#charts .now") == "3 at step 0"
    assert shown.run("document.querySelector('#charts canvas').getBoundingClientRect().height") > 60
    shown.press("n")
    assert chosen(shown)["node"] == 2
    shown.press("Escape")
    assert shown.run("document.getElementById('charts').hidden")


def test_parts_tick_off(shown):
    first = [part["status"] for part in shown.run("tsplanViewer.parts()")]
    assert first == ["running", "done", "running"]
    shown.press("End")
    last = [part["status"] for part in shown.run("tsplanViewer.parts()")]
    assert last == ["done", "done", "done"]
    assert shown.run("document.querySelectorAll('.mark.done').length") == 3


def test_arrows_choose_agents_and_the_help_opens_and_closes(shown):
    shown.press("ArrowDown")
    shown.press("ArrowDown")
    assert chosen(shown)["track"] == 1
    shown.press("ArrowUp")
    assert chosen(shown)["track"] == 0
    shown.press("?")
    assert shown.run("document.getElementById('help').open")
    shown.press("ArrowRight")
    assert now(shown) == 0
    shown.press("Escape")
    assert not shown.run("document.getElementById('help').open")
    assert chosen(shown)["track"] == 0


def test_typing_in_the_filter_is_typing(shown):
    shown.click_on("#filter")
    for key in "heavy-1":
        shown.press(key)
    assert shown.run("document.getElementById('filter').value") == "heavy-1"
    names = shown.run("[...document.querySelectorAll('#agents .name')].map(e => e.textContent)")
    assert len(names) == 1
    assert names[0].startswith("heavy-1")
    assert not shown.run("document.getElementById('loop').checked")
    assert now(shown) == 0


def test_light_and_dark(shown):
    light = pixels(shown).getpixel((12, 70))
    assert min(light) > 200
    shown.prefer(prefers_color_scheme="dark")
    dark = pixels(shown).getpixel((12, 70))
    assert max(dark) < 60
    shown.press("t")
    assert pixels(shown).getpixel((12, 70)) == light


def test_little_motion_where_the_reader_wants_it(shown):
    shown.prefer(prefers_reduced_motion="reduce")
    shown.press(" ")
    for _ in range(10):
        shown.frames(3)
        assert "." not in text(shown, "#clock")
    shown.press(" ")


@pytest.mark.parametrize("width", sampled([320, 420, 760], [320]))
def test_narrow_windows_need_no_sideways_scrolling(shown, width):
    shown.resize(width, 700)
    shown.frames(3)
    assert shown.run("document.documentElement.scrollWidth") <= width
    for part in ("map-canvas", "rows", "scrub", "formula"):
        box = shown.run(f"document.getElementById({part!r}).getBoundingClientRect().toJSON()")
        assert box["width"] > 90
        assert box["right"] <= width + 0.5


def test_the_map_can_be_moved_and_zoomed(shown):
    before = shown.run("tsplanViewer.stateAt('p')")
    shown.press("i")
    nearer = shown.run("tsplanViewer.stateAt('p')")
    assert abs(nearer[0] - before[0]) > 20
    mouse = {"x": 450, "y": 300, "button": "left"}
    for kind, x in (("mousePressed", 450), ("mouseMoved", 500), ("mouseReleased", 500)):
        pressed = {"buttons": 1, "clickCount": 1} if kind != "mouseMoved" else {"buttons": 1}
        shown.ask("Input.dispatchMouseEvent", type=kind, **(mouse | {"x": x}), **pressed)
    shown.frames()
    moved = shown.run("tsplanViewer.stateAt('p')")
    assert moved[0] - nearer[0] == pytest.approx(50)
    assert chosen(shown)["track"] == -1  # a drag is no click
    shown.press("0")
    assert shown.run("tsplanViewer.stateAt('p')") == before


def test_hostile_names_are_text_and_never_run(browser, tmp_path):
    ring = system(HOSTILE)
    mission = mission_on(ring, [{"class": name, "at": name} for name in HOSTILE], "true", 3)
    paths = [(((0, 3, agent.start),), None) for agent in mission.agents]
    path = tmp_path / "hostile.html"
    path.write_text(page(mission, plan_of(mission, paths)), encoding="utf-8")
    browser.resize(1280, 800)
    browser.open(path)
    names = browser.run("[...document.querySelectorAll('#agents .name')].map(e => e.textContent)")
    assert names == [f"{visible(name)}-1" for name in HOSTILE]
    where = browser.run("[...document.querySelectorAll('#agents .where')].map(e => e.textContent)")
    assert where == [visible(name) for name in HOSTILE]
    for number in range(len(HOSTILE)):
        browser.press("ArrowDown")
        assert text(browser, "#chosen h3") == names[number]
    assert browser.run("typeof window.caught") == "undefined"
    assert browser.run("document.querySelectorAll('img, iframe, object').length") == 0
    assert browser.run("document.scripts.length") == 2
    assert browser.errors() == []
    assert browser.requests() == []


def test_scripts_put_into_the_page_are_refused(shown):
    shown.run(
        "(() => { const made = document.createElement('script');"
        " made.textContent = 'window.caught = 1'; document.body.append(made); })()"
    )
    shown.run("fetch('data:text/plain,x').then(() => { window.caught = 2; }, () => {})")
    assert shown.run("typeof window.caught") == "undefined"
    assert any("Content Security Policy" in str(event) for event in shown.events)
    shown.events.clear()


def test_a_thousand_agents_are_counted_where_they_crowd(browser, tmp_path):
    names = [f"s{n}" for n in range(40)]
    mission = mission_on(system(names), [{"class": "a", "at": {"s0": 980, "s1": 20}}], "true", 6)
    plan = walking(mission, 2)
    path = tmp_path / "crowd.html"
    path.write_text(page(mission, plan), encoding="utf-8")
    browser.resize(1280, 800)
    browser.open(path)
    for step in (0, 3, 6):
        browser.press("Home")
        for _ in range(step):
            browser.press("ArrowRight")
        assert places(browser) == plan.state_at(step)
    drawn = browser.run("tsplanViewer.places().filter(entry => entry.at !== null).length")
    assert drawn < len(plan.bundles)
    assert browser.errors() == []


def test_the_smallest_plan_there_can_be(browser, tmp_path):
    alone = TransitionSystem.build([State("here", frozenset({"here"}))], [Edge("here", "here")])
    mission = mission_on(alone, [{"class": "a", "at": "here"}], "here", 0)
    path = tmp_path / "alone.html"
    path.write_text(page(mission, plan_of(mission, [(((0, 0, "here"),), None)])), encoding="utf-8")
    browser.resize(1280, 800)
    browser.open(path)
    assert places(browser) == {"a-1": "here"}
    assert [part["status"] for part in browser.run("tsplanViewer.parts()")] == ["done"]
    for key in (" ", "ArrowRight", "End", "l", " ", "ArrowDown", "n"):
        browser.press(key)
    assert now(browser) == 0
    assert text(browser, "#chosen h3") == "a-1"
    assert browser.errors() == []


def test_loads_and_stocks_are_told(browser, tmp_path):
    path = tmp_path / "building.html"
    path.write_text(page(*building()), encoding="utf-8")
    browser.open(path)
    browser.run(
        "(bar => { bar.value = '1.5'; bar.dispatchEvent(new Event('input')); })"
        "(document.getElementById('scrub'))"
    )
    browser.frames(2)
    assert "yard \u2192 wall with 2 brick, 1 drill" in text(browser, "#agents")
    told = {}
    for state in ("yard", "wall", "garden"):
        x, y = browser.run(f"tsplanViewer.stateAt({state!r})")
        browser.run(
            f"(([x, y]) => {{ const map = document.getElementById('map-canvas'); "
            "const { left, top } = map.getBoundingClientRect(); map.dispatchEvent("
            "new PointerEvent('pointermove', { clientX: left + x, clientY: top + y })); })"
            f"([{x}, {y + 12}])"
        )
        told[state] = text(browser, "#tip").split("\n")
    assert told["wall"] == ["wall", "wall", "1 brick"]
    assert told["garden"] == ["garden", "garden"]
    assert told["yard"] == ["yard", "yard", "2 brick", "1 water"]
    assert browser.errors() == []
