"""The page of a trajectory: what it is told, and what a person sees of it."""

from __future__ import annotations

import io
import json

import numpy as np
import pytest

from tests.carts import REF, cart_mission, cart_run
from tests.viewing import HOSTILE
from tsplan.errors import InputError, PlanError
from tsplan.logic import parse
from tsplan.mission.mission_parts import Preference
from tsplan.plans.outcomes import MissionRef, ObjectiveValue
from tsplan.signals.linear_system import System
from tsplan.signals.region import Region
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.signals.trajectory_check import certify
from tsplan.viewer import page
from tsplan.viewer.signal_page import signal_page_data
from tsplan.viewer.webpage import embedded
from tsplan.words import visible

MISSION = cart_mission()
FOUND = certify(MISSION, cart_run(ObjectiveValue("robustness", 0.5, 0.5)))


def told(mission, trajectory):
    return json.loads(embedded(signal_page_data(mission, trajectory)))


def test_signals_regions_and_the_path_are_told():
    data = told(MISSION, FOUND)
    assert data["title"] == "cart"
    assert data["facts"][0]["text"] == "robustness 0.5 · proven"
    assert [row["name"] for row in data["signals"]] == ["x", "y", "vx", "vy", "ux", "uy"]
    assert [row["control"] for row in data["signals"]] == [False] * 4 + [True] * 2
    assert all(row["values"] == FOUND[row["name"]].tolist() for row in data["signals"])
    plane = data["plane"]
    assert plane["axes"] == ["x", "y"]
    assert plane["paths"] == [FOUND.states[:2].T.tolist()]
    wall, goal = plane["places"]
    assert (wall["name"], wall["sides"], wall["wanted"]) == ("wall", [1.5, 3.25, 2.5, 9], False)
    assert (goal["name"], goal["sides"], goal["wanted"]) == ("goal", [3, 2, 5, 3], True)


def test_parts_tick_off_when_they_are_certain():
    whole, arrival, *sides = told(MISSION, FOUND)["formula"]
    assert whole["heading"] == "all of"
    assert whole["states"] == [0, 1]
    assert arrival["states"] == [1]
    assert arrival["settled"] == [[4, 4]]  # in the goal at step 4, by its four sides
    assert sides[0]["text"] == "x >= 3"
    (chart,) = sides[0]["charts"]
    assert chart["smooth"]
    assert chart["counts"] == [[step, value] for step, value in enumerate(FOUND.signals["x"])]
    assert (chart["bound"], chart["possible"]) == (3, [[0, 5]])


def test_what_is_preferred_and_fails_says_so():
    far = parse("F[0,2] x >= 9", language="stl")
    data = told(cart_mission(prefer=(Preference(far, "go far"),)), FOUND)
    last = next(part for part in data["formula"] if part["text"].startswith("preferred"))
    assert last["text"] == "preferred: go far: F[0,2] (x >= 9)"
    assert last["failed"] == 2


def test_strips_have_no_ends_and_single_signals_no_plane():
    system = System({"x": (0, 9), "y": (0, 9)})
    strip = Region(x=(2, 4))
    mission = SignalMission(system, strip.inside(), 0, regions={"strip": strip})
    still = Trajectory("optimal", REF, 0, signals={"x": (3,), "y": (3,)})
    (place,) = told(mission, still)["plane"]["places"]
    assert place["sides"] == [2, None, 4, None]
    alone = SignalMission(System({"x": (0, 9)}), strip.inside(), 0)
    data = told(alone, Trajectory("optimal", REF, 0, signals={"x": (3,)}))
    assert data["plane"] is None
    with pytest.raises(PlanError, match="signal x has no values"):
        signal_page_data(alone, Trajectory("optimal", REF, 0, signals={"z": (3,)}))
    with pytest.raises(InputError, match="give the mission"):
        still.view()


# --- in a browser --------------------------------------------------------------------------------


@pytest.fixture
def shown(browser, tmp_path):
    """Open the page of a trajectory; afterwards nothing may have gone wrong on it."""

    def opened(mission, trajectory):
        browser.resize(1280, 800)
        browser.open(trajectory.view(mission, tmp_path / "page.html"))
        browser.frames()
        return browser

    yield opened
    assert browser.errors() == []
    assert browser.requests() == []


def at(browser, time):
    """Seek, and what the page then says."""
    browser.run(
        f"document.getElementById('scrub').value = '{time}';"
        "document.getElementById('scrub').dispatchEvent(new Event('input'))"
    )
    browser.frames()
    return browser.run("tsplanViewer.places()")


def test_the_point_is_where_the_signals_are(shown):
    opened = shown(MISSION, FOUND)
    for time in (0, 2, 2.5, 4.25, 5):
        said = at(opened, time)
        steps = np.arange(6)
        expected = [np.interp(time, steps, FOUND[name]) for name in ("x", "y")]
        assert said["points"][0]["point"] == pytest.approx(expected)
        values = dict(said["values"])
        assert values["vx"] == pytest.approx(np.interp(time, steps, FOUND["vx"]))
        assert values["ux"] == FOUND["ux"][min(4, int(time))]
    parts = opened.run("tsplanViewer.parts()")
    assert parts[0]["status"] == "done"


def test_the_point_is_drawn_and_moves(shown):
    image = pytest.importorskip("PIL.Image")
    opened = shown(MISSION, FOUND)
    places = []
    for time in (0, 5):
        x, y = at(opened, time)["points"][0]["at"]
        left, top = opened.run(
            "(({left, top}) => [left, top])"
            "(document.getElementById('map-canvas').getBoundingClientRect())"
        )
        picture = image.open(io.BytesIO(opened.screenshot())).convert("RGB")
        assert picture.getpixel((round(left + x), round(top + y))) == (0x77, 0x53, 0xBF)
        places.append((x, y))
    assert places[0] != places[1]


def test_keys_and_choices_work_on_signals(shown):
    opened = shown(MISSION, FOUND)
    opened.press("ArrowRight")
    assert opened.run("tsplanViewer.time()") == 1
    opened.press("ArrowDown")
    assert opened.run("tsplanViewer.chosen()")["track"] == 0
    opened.press("n")
    opened.press("n")
    assert opened.run("document.querySelectorAll('#charts figure').length") == 4
    opened.press("t")
    opened.press("0")
    assert opened.run("document.querySelector('#agents-heading').textContent") == "Signals"
    opened.run("(f => { f.value = 'vy'; f.dispatchEvent(new Event('input')) })"
               "(document.getElementById('filter'))")  # fmt: skip
    assert opened.run("document.querySelectorAll('#agents button').length") == 1


def test_one_signal_and_hostile_names(shown):
    name = HOSTILE[0]
    mission = SignalMission(System({name: (0, 9)}), parse("true", language="stl"), 1)
    found = Trajectory("optimal", MissionRef(HOSTILE[1], ""), 1, signals={name: (1, 2)})
    assert "<script>window" not in page(mission, found)
    opened = shown(mission, found)
    assert at(opened, 0.5) == {"values": [[visible(name), 1.5]], "points": []}
    assert opened.run("window.caught === undefined")
    assert opened.run("document.getElementById('map').clientHeight") == 0
