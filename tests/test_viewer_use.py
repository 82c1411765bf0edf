"""The viewer's page in a headless browser: links, pictures, keys, fingers, dark, two maps."""

from __future__ import annotations

import base64
import io
import time
from dataclasses import replace
from itertools import pairwise

import pytest

from tests.viewing import HORIZON, mission_on, plan_of, scouts_and_heavies
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.viewer import page

FINGER = 44  # dots


@pytest.fixture(scope="module")
def planned():
    return scouts_and_heavies()


@pytest.fixture(scope="module")
def happened(planned):
    """What became of the plan: the first scout stays, all others do as was planned."""
    _, plan = planned
    stays = ((0, HORIZON, plan.agents[0].stays[0][2]),)
    return replace(
        plan, agents=(replace(plan.agents[0], stays=stays, heading=None), *plan.agents[1:])
    )


@pytest.fixture
def opened(browser, tmp_path):
    """Opens the page of a plan, at an address; afterwards nothing may have gone wrong on it."""

    def opening(mission, plan, executed=None, *, at=""):
        path = tmp_path / "plan.html"
        path.write_text(page(mission, plan, executed), encoding="utf-8")
        browser.open(path, at)
        return browser

    browser.resize(1280, 800)
    browser.prefer(prefers_color_scheme="light", prefers_reduced_motion="no-preference")
    yield opening
    assert browser.errors() == []
    assert browser.requests() == []


def now(browser):
    return browser.run("tsplanViewer.time()")


def chosen(browser):
    return browser.run("tsplanViewer.chosen().track")


def address(browser):
    return browser.run("location.hash")


def test_a_link_opens_the_page_at_its_step(opened, planned):
    shown = opened(*planned, at="#step=12")
    assert now(shown) == 12
    assert shown.run("document.getElementById('clock').textContent") == "step 12 of 14"
    shown.run("location.hash = '#step=2.5'")
    shown.frames()
    assert now(shown) == 2.5
    for wrong in ("#scrub", "#step=", "#step=x", "#step=-3", "#stepping=4"):
        shown.run(f"location.hash = {wrong!r}")
        shown.frames()
        assert now(shown) == 2.5, wrong
    shown.run("location.hash = '#step=400'")  # beyond the end is the end
    shown.frames()
    assert now(shown) == HORIZON


def test_the_address_names_the_step_at_which_it_stands(opened, planned):
    shown = opened(*planned)
    assert address(shown) == ""
    before = shown.run("history.length")
    for _ in range(3):
        shown.press("ArrowRight")
    _until(shown, "#step=3")
    shown.press("End")
    _until(shown, f"#step={HORIZON}")
    shown.press("Home")
    _until(shown, "#step=0")
    assert shown.run("history.length") == before  # going back leaves the page, not the step
    shown.press(" ")
    shown.frames(8)
    assert address(shown) == "#step=0"  # while it plays it is left alone
    shown.press(" ")
    _until(shown, f"#step={round(now(shown), 2):g}")


def test_a_page_without_an_address_of_its_own_stays_quiet(browser, planned, tmp_path):
    mission, plan = planned
    path = tmp_path / "notebook.html"
    path.write_text(plan.animate(mission=mission)._repr_html_(), encoding="utf-8")
    browser.open(path)
    browser.click(600, 200)  # into the frame
    browser.press("ArrowRight")
    browser.run("new Promise((done) => setTimeout(done, 400))")
    assert browser.errors() == []
    assert address(browser) == ""


def _until(browser, wanted):
    end = time.monotonic() + 20
    while address(browser) != wanted:
        assert time.monotonic() < end, (address(browser), wanted)
        browser.frames()


def test_the_page_saves_a_picture_of_what_it_shows(opened, planned, tmp_path):
    image = pytest.importorskip("PIL.Image")
    shown = opened(*planned, at="#step=4")
    shown.ask("Page.setDownloadBehavior", behavior="allow", downloadPath=str(tmp_path))
    for action in (lambda: shown.click_on("#save"), lambda: shown.press("s")):
        action()
        saved = tmp_path / "test-step-4.png"
        end = time.monotonic() + 20
        while not saved.exists():
            assert time.monotonic() < end
            shown.frames()
        picture = image.open(io.BytesIO(saved.read_bytes())).convert("RGB")
        colours = {colour for _, colour in picture.getcolors(1 << 24)}
        assert (0x77, 0x53, 0xBF) in colours  # the scouts
        assert (0xED, 0x69, 0x15) in colours  # the heavy ones
        assert picture.width > 800
        saved.unlink()


def test_every_key_of_the_help_acts(opened, planned):
    shown = opened(*planned)
    state = (
        "JSON.stringify([tsplanViewer.time(), tsplanViewer.chosen(), tsplanViewer.speed(),"
        " tsplanViewer.stateAt('p'), document.getElementById('loop').checked,"
        " document.documentElement.dataset.theme, document.getElementById('help').open])"
    )
    keys = ("ArrowRight", "End", "Home", "+", "-", "ArrowDown", "ArrowUp", "n", "p", "i", "o")
    for key in (*keys, "l", "t", "Escape", "?"):
        before = shown.run(state)
        if key == "Home":
            assert now(shown) == HORIZON
        shown.press(key)
        assert shown.run(state) != before, key
    shown.press("Escape")
    listed = shown.run("[...document.querySelectorAll('#help kbd')].map((key) => key.textContent)")
    assert {"space", "Home", "End", "n", "p", "i", "o", "0", "l", "t", "s", "Esc", "?"} <= {*listed}


def test_everything_can_be_reached_by_the_keyboard(opened, planned):
    shown = opened(*planned)
    wanted = {"theme", "save", "help-open", "zoom-in", "play", "scrub", "speed", "loop", "filter"}
    wanted |= {"map-canvas", "rows"}
    reached, outlined = set(), True
    for _ in range(42):
        shown.press("Tab")
        name, outline = shown.run(
            "[document.activeElement.id, getComputedStyle(document.activeElement).outlineStyle]"
        )
        outlined &= name in ("", "loop") or outline != "none"
        reached.add(name)
    assert wanted <= reached
    assert outlined  # and it is seen where one is


@pytest.fixture
def fingers(browser):
    """A screen that is touched."""
    browser.ask("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
    yield browser
    browser.ask("Emulation.setTouchEmulationEnabled", enabled=False)


@pytest.mark.parametrize("size", [(400, 860), (1280, 800)])
def test_what_is_touched_is_as_large_as_a_finger(fingers, opened, planned, size):
    shown = opened(*planned)
    assert shown.run("matchMedia('(pointer: coarse)').matches")
    shown.resize(*size)
    shown.frames()
    shown.run("document.querySelectorAll('#agents button')[0].click()")
    sizes = shown.run(
        "[...document.querySelectorAll('button, select, input:not([type=checkbox]), .choice')]"
        ".map((one) => [one.id || one.textContent, one.getBoundingClientRect()])"
        ".filter(([, box]) => box.width > 0)"
        ".map(([name, box]) => [name, box.width, box.height])"
    )
    assert len(sizes) > 20
    small = [entry for entry in sizes if min(entry[1:]) < FINGER]
    assert small == []
    assert shown.run("document.documentElement.scrollWidth <= innerWidth")


def test_a_finger_finds_agents_and_rows_near_to_it(fingers, opened, planned):
    shown = opened(*planned)
    x, y = shown.run(
        "(() => { const box = document.getElementById('map-canvas').getBoundingClientRect();"
        " const [x, y] = tsplanViewer.places()[0].at; return [box.left + x, box.top + y]; })()"
    )
    shown.click(x - 17, y - 4)  # left of the mark
    assert chosen(shown) >= 0
    shown.press("Escape")
    left, top, rows = shown.run(
        "(() => { const box = document.getElementById('rows').getBoundingClientRect();"
        " return [box.left, box.top, document.getElementById('rows-height').clientHeight]; })()"
    )
    count = len(shown.run("tsplanViewer.places()"))
    assert rows >= FINGER * count
    shown.click(left + 30, top + FINGER * 1.5)
    assert chosen(shown) == 1


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_words_can_be_read_by_day_and_night(opened, planned, browser, scheme):
    browser.prefer(prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
    shown = opened(*planned)
    assert shown.run("document.documentElement.dataset.theme") == scheme
    shown.run("document.querySelectorAll('#formula button')[1].click()")
    worst = shown.run(
        """(() => {
          const parts = (colour) => colour.match(/[\\d.]+/g).map(Number);
          const light = (colour) => {
            const [r, g, b] = parts(colour).map((part) => part / 255)
              .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
            return 0.2126 * r + 0.7152 * g + 0.0722 * b;
          };
          const ground = (one) => {
            const own = parts(getComputedStyle(one).backgroundColor);
            const clear = own.length > 3 && own[3] < 0.5;
            return clear ? ground(one.parentElement) : getComputedStyle(one).backgroundColor;
          };
          const found = [];
          for (const one of document.querySelectorAll("body *")) {
            const own = [...one.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
            if (!own || !one.getClientRects().length || one.tagName === "OPTION") continue;
            const [a, b] = [light(getComputedStyle(one).color), light(ground(one))];
            found.push([(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), one.textContent]);
          }
          return [found.length, found.sort((a, b) => a[0] - b[0])[0]];
        })()"""
    )
    assert worst[0] > 20
    assert worst[1][0] >= 4.5, worst


def test_what_was_planned_and_what_happened_stand_side_by_side(opened, planned, happened):
    mission, plan = planned
    shown = opened(mission, plan, happened, at="#step=13")
    boxes = shown.run(
        "['planned-canvas', 'map-canvas'].map((name) => {"
        " const box = document.getElementById(name).getBoundingClientRect();"
        " return [box.left, box.right, box.top, box.bottom]; })"
    )
    assert boxes[0][1] <= boxes[1][0] + 1  # the plan on the left
    assert boxes[0][2:] == boxes[1][2:]
    for step in (0, 4, 7, 10, 13):
        shown.run(f"location.hash = '#step={step}'")
        shown.frames()
        for which, each in (("planned", plan), ("places", happened)):
            said = shown.run(f"tsplanViewer.{which}()")
            there = {name: entry["state"] for entry in said for name in entry["ids"]}
            assert there == each.state_at(step), (which, step)
    late = plan.agents[0].id
    words = shown.run(
        "[...document.querySelectorAll('#agents button')].map((one) => one.textContent)"
    )
    differing = [word for word in words if "(planned: " in word]
    assert len(differing) == 1
    assert late in differing[0]


def test_two_maps_have_one_camera_and_one_choice(opened, planned, happened):
    mission, plan = planned
    shown = opened(mission, plan, happened)
    shown.press("i")
    shown.press("i")
    ours, theirs = (
        {name: one["at"] for one in shown.run(f"tsplanViewer.{which}()") for name in one["ids"]}
        for which in ("places", "planned")
    )
    still = [name for name in ours if plan.state_at(0)[name] == "r"]
    assert still
    for name in still:
        assert ours[name] == pytest.approx(theirs[name], abs=1)
    shown.press("0")
    shown.press("ArrowDown")
    assert chosen(shown) == 0
    x, y = shown.run(
        "(() => { const box = document.getElementById('planned-canvas').getBoundingClientRect();"
        " const [x, y] = tsplanViewer.planned()[2].at; return [box.left + x, box.top + y]; })()"
    )
    shown.click(x, y)
    assert chosen(shown) == 2  # by its mark on the map of the plan


def test_a_plan_alone_has_one_map(opened, planned):
    shown = opened(*planned)
    assert shown.run("tsplanViewer.planned()") is None
    assert shown.run("document.getElementById('planned-canvas').clientWidth") == 0


def test_between_two_steps_all_parts_of_the_page_say_the_same(opened, planned):
    _, plan = planned
    shown = opened(*planned)
    shown.run("document.querySelectorAll('#formula button')[1].click()")
    for step in range(HORIZON):
        shown.run(f"location.hash = '#step={step + 0.5}'")
        shown.frames()
        places = shown.run("tsplanViewer.places()")
        rows = dict(
            shown.run(
                "[...document.querySelectorAll('#agents button')].map((one) =>"
                " [one.querySelector('.name').textContent,"
                " one.querySelector('.where').textContent])"
            )
        )
        for entry in places:
            assert ("\u2192" in rows[entry["name"]]) == (entry["state"] is None), entry
        counts = plan.counts(states=["q"])[0]
        words = shown.run("document.querySelector('#charts .now').textContent")
        before, after = counts[step], counts[step + 1]
        both = f"{before}" if before == after else f"{before} \u2192 {after}"
        assert words == f"{both} from step {step} to {step + 1}"


def crowd():
    """Thirty agents on a map whose places are close together, of which twelve move."""
    names = [f"a_rather_long_name_{n}" for n in range(8)]
    states = [
        State(name, frozenset({name}), at=(1.2 * n, 0.4 * (n % 2))) for n, name in enumerate(names)
    ]
    moves = [Edge(a, b, 2) for a, b in pairwise(names)]
    edges = [*(Edge(name, name) for name in names), *moves, Edge(names[-1], names[0], 5)]
    team = [{"class": "ant", "count": 30, "at": {names[0]: 12, names[2]: 10, names[4]: 8}}]
    mission = mission_on(
        TransitionSystem.build(states, edges, "row"), team, f"F[0,9] sum({names[1]}) >= 1", 9
    )
    walks = [
        (((0, n % 4, names[0]), (n % 4 + 2, 9, names[1])), None)
        if agent.start == names[0]
        else (((0, 9, agent.start),), None)
        for n, agent in enumerate(mission.agents)
    ]
    return mission, plan_of(mission, walks)


def test_of_many_agents_those_who_never_move_are_folded(opened):
    shown = opened(*crowd())
    listed = "[...document.querySelectorAll('#agents button .name')].map((one) => one.textContent)"
    assert len(shown.run(listed)) == 4
    button = "document.querySelector('#agents .fold')"
    assert shown.run(f"{button}.textContent") == "18 never move"
    assert shown.run(f"{button}.getAttribute('aria-expanded')") == "false"
    shown.click_on("#agents .fold")
    assert len(shown.run(listed)) == 6
    assert shown.run(f"{button}.getAttribute('aria-expanded')") == "true"
    shown.click_on("#agents .fold")
    for _ in range(5):
        shown.press("ArrowDown")  # on from those who move to those who do not
    assert shown.run(f"{button}.getAttribute('aria-expanded')") == "true"
    moving = shown.run("tsplanViewer.places()[tsplanViewer.chosen().track].state")
    assert moving in ("a_rather_long_name_2", "a_rather_long_name_4")


@pytest.mark.parametrize("size", [(1280, 800), (700, 600), (400, 860)])
def test_words_on_the_map_hide_no_others(opened, size):
    shown = opened(*crowd())
    shown.resize(*size)
    for zoom in ("0", "i", "i", "i"):
        shown.press(zoom)
        boxes = shown.run("tsplanViewer.labels()")
        assert boxes
        for n, one in enumerate(boxes):
            for other in boxes[:n]:
                apart = one["left"] >= other["right"] or other["left"] >= one["right"]
                apart |= one["top"] >= other["bottom"] or other["top"] >= one["bottom"]
                assert apart, (one, other)
    legend = shown.run("document.getElementById('legend').textContent")
    assert "2 steps if not marked" in legend
    durations = [box["words"] for box in boxes if box["words"].isdigit()]
    assert {*durations} <= {"5"}


def test_the_picture_is_as_the_page_is(opened, planned, happened):
    image = pytest.importorskip("PIL.Image")
    mission, plan = planned
    alone = _picture(image, opened(mission, plan, at="#step=3"))
    both = _picture(image, opened(mission, plan, happened, at="#step=3"))
    assert alone != both


def _picture(image, browser):
    data = browser.run("tsplanViewer.picture()").partition(",")[2]
    return image.open(io.BytesIO(base64.b64decode(data))).convert("RGB").tobytes()
