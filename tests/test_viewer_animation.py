"""Moving pictures: how many, how large, and agents where the plan has them."""

from __future__ import annotations

import io
import json
import shutil
from itertools import pairwise

import numpy as np
import pytest

from tests.viewing import HOSTILE, mission_on, plan_of, system
from tests.walks import walking
from tsplan.cli import main
from tsplan.draw.palette import Palette
from tsplan.draw.tracks import tracks
from tsplan.errors import InputError
from tsplan.plans.plan_file import save_plan
from tsplan.viewer.animation import FfmpegUnavailableError, Pace, animate, gif
from tsplan.viewer.markers import Ground, markers

Image = pytest.importorskip("PIL.Image", reason="needs Pillow, which comes with matplotlib")
pytest.importorskip("matplotlib", reason="needs matplotlib: pip install 'tsplan[plot]'")

from tsplan.viewer.scene import Scene  # noqa: E402  (needs matplotlib)

SIZE = (480, 300)


@pytest.fixture(scope="module")
def mission():
    team = [{"class": "scout", "at": "p"}, {"class": "heavy", "at": "r"}]
    return mission_on(system(("p", "q", "r"), duration=2), team, "F[0,6] q", 6)


@pytest.fixture(scope="module")
def plan(mission):
    stays = ((0, 1, "p"), (3, 6, "q")), ((0, 6, "r"),)
    return plan_of(mission, [(path, None) for path in stays])


@pytest.fixture(scope="module")
def scene(mission, plan):
    return Scene(mission, plan, SIZE)


def frames(content):
    with Image.open(io.BytesIO(content)) as film:
        for number in range(film.n_frames):
            film.seek(number)
            yield film.info["duration"], np.asarray(film.convert("RGB")).astype(int)


def near(pixels, at, colour, reach=4):
    """Whether a colour is close to a place, given in dots from the lower left corner."""
    x, y = round(at[0]), pixels.shape[0] - 1 - round(at[1])
    around = pixels[max(0, y - reach) : y + reach + 1, max(0, x - reach) : x + reach + 1]
    wanted = np.array(list(bytes.fromhex(colour[1:])))
    return bool((abs(around - wanted).sum(axis=-1) < 60).any())


def test_a_gif_has_every_picture_and_ends_with_a_rest(scene):
    pace = Pace(fps=4, seconds_per_step=0.5, size=SIZE)
    times = pace.times(6)
    assert len(times) == 6 * 2 + 1
    shown = list(frames(gif(scene, times, 4)))
    assert len(shown) == 13
    assert {pixels.shape for _, pixels in shown} == {(300, 480, 3)}
    assert {duration for duration, _ in shown[:-1]} == {250}
    assert shown[-1][0] == 1250
    for (_, one), (_, other) in pairwise(shown):
        assert (one != other).any()


def test_marks_are_where_the_plan_has_the_agents(scene, mission):
    colours = {name: paint.colour for name, paint in Palette.of(mission).classes.items()}
    places = scene.ground.places
    start, end = scene.at(0).astype(int), scene.at(6).astype(int)
    assert near(start, places["p"], colours["scout"])
    assert not near(start, places["q"], colours["scout"])
    assert near(end, places["q"], colours["scout"])
    assert not near(end, places["p"], colours["scout"])
    for pixels in (start, end):
        assert near(pixels, places["r"], colours["heavy"])
    halfway = np.mean([places["p"], places["q"]], axis=0)
    assert near(scene.at(2).astype(int), halfway, colours["scout"], reach=12)


def test_only_what_moves_changes(scene):
    """While all agents wait, nothing on the map changes but the time."""
    one, other = scene.at(4.0).astype(int), scene.at(4.4).astype(int)
    changed = np.argwhere((one != other).any(axis=-1))
    assert len(changed)
    assert changed[:, 0].min() > 270  # the bar at the bottom


def test_the_formula_ticks_off(scene):
    def green(pixels):
        panel = pixels[:, 320:].astype(int)
        return int((abs(panel - [0x11, 0x7A, 0x43]).sum(axis=-1) < 30).sum())

    assert green(scene.at(2.9)) == 0
    assert green(scene.at(3)) > 40


@pytest.mark.parametrize("seed", range(5))
def test_pictures_count_as_the_plan_does(mission, seed):
    crowd = mission_on(mission.system, [{"class": "a", "at": {"p": 5, "q": 3}}], "true", 9)
    plan = walking(crowd, seed)
    found = tracks(plan, crowd, moving=True)
    ground = Ground(dict.fromkeys("pqr", (0.0, 0.0)), radius=2.0, most=4)
    for step in range(10):
        shown = markers(found, ground, step)
        states = [state for state in plan.state_at(step).values() if state is not None]
        assert shown.counts == {state: states.count(state) for state in set(states)}
        drawn = sum(map(len, shown.marks.values())) + sum(n for _, n, _ in shown.numbers)
        assert drawn == 8


def test_a_thousand_in_one_place_are_a_number():
    crowd = mission_on(system(("p", "q", "r")), [{"class": "a", "at": {"p": 1000}}], "true", 2)
    plan = plan_of(crowd, [(((0, 0, "p"), (1, 2, "q")), None)] * 1000)
    ground = Ground({"p": (0.0, 0.0), "q": (9.0, 0.0)}, radius=2.0, most=19)
    found = tracks(plan, crowd, moving=True)
    assert markers(found, ground, 0).numbers == [("a", 1000, (0.0, 0.0))]
    ((_, agents, (x, y)),) = markers(found, ground, 0.5).numbers
    assert (agents, x) == (1000, 4.5)
    assert y < 0  # on the right of its way
    assert not markers(found, ground, 0.5).marks


def test_names_of_any_kind_can_be_drawn():
    odd = mission_on(system(HOSTILE), [{"class": n, "at": n} for n in HOSTILE], "true", 2)
    plan = plan_of(odd, [(((0, 2, agent.start),), None) for agent in odd.agents])
    assert Scene(odd, plan, SIZE).at(1).shape == (300, 480, 3)


def test_the_pace_keeps_long_plans_short():
    assert Pace.of(10) == Pace(10, 0.6, (960, 600))
    assert Pace.of(300).seconds_per_step == pytest.approx(0.1)
    assert Pace.of(300, seconds_per_step=1.0).seconds_per_step == 1.0
    assert len(Pace.of(300).times(300)) == 301
    assert Pace.of(0).times(0) == (0.0,)


def test_other_kinds_are_refused(mission, plan, tmp_path):
    with pytest.raises(InputError, match=r"'\.avi'; use \.gif, \.mp4 or \.html"):
        animate(mission, plan, tmp_path / "plan.avi")
    assert list(tmp_path.iterdir()) == []


def test_mp4_says_what_is_missing(mission, plan, tmp_path, monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda _: None)
    with pytest.raises(FfmpegUnavailableError, match="needs the program ffmpeg"):
        animate(mission, plan, tmp_path / "plan.mp4")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="needs the program ffmpeg")
def test_mp4_is_written_where_ffmpeg_is(mission, plan, tmp_path):
    path = tmp_path / "plan.mp4"
    animate(mission, plan, path, Pace(fps=5, seconds_per_step=0.4, size=(321, 241)))
    assert path.read_bytes()[4:8] == b"ftyp"
    assert [entry.name for entry in tmp_path.iterdir()] == ["plan.mp4"]


MAP = "waiting: true\nstates: {p: {labels: [A]}, q: {labels: [B]}}\nedges: [[p, q, 1], [q, p, 1]]\n"
MISSION = """\
format: tsplan-mission/1
name: there
map: map.yaml
team: [{class: a, count: 2, at: p}]
spec: {language: mtl, formula: "F[0,3] B"}
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    from tsplan.mission import load_mission  # noqa: PLC0415  (the files are written first)

    (tmp_path / "map.yaml").write_text(MAP)
    (tmp_path / "mission.yaml").write_text(MISSION)
    planned = load_mission(tmp_path / "mission.yaml")
    paths = [(((0, 0, "p"), (1, 3, "q")), None)] * 2
    save_plan(plan_of(planned, paths), tmp_path / "plan.json")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_animate_writes_what_the_name_says(folder, capsys):
    options = ["--fps", "5", "--seconds-per-step", "0.4", "--size", "400x260"]
    assert main(["animate", "plan.json", "-o", "plan.gif", *options]) == 0
    with Image.open(folder / "plan.gif") as film:
        assert (film.size, film.n_frames) == ((400, 260), 7)
    assert main(["animate", "plan.json", "-o", "plan.html"]) == 0
    assert main(["view", "plan.json", "-o", "view.html"]) == 0
    assert (folder / "plan.html").read_bytes() == (folder / "view.html").read_bytes()
    assert capsys.readouterr() == ("", "")


def test_view_opens_a_temporary_file(folder, capsys, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda url: opened.append(url) or True)
    monkeypatch.setattr("tempfile.tempdir", str(folder))
    assert main(["view", "plan.json", "--mission", "mission.yaml"]) == 0
    out = capsys.readouterr().out.split()
    assert out[0] == "opened"
    assert opened == [f"file://{out[1]}"]
    assert out[1].startswith(str(folder / "tsplan-there-"))
    monkeypatch.setattr("webbrowser.open", lambda _url: False)
    assert main(["view", "plan.json"]) == 0
    assert capsys.readouterr().out.startswith("no browser was found; open this file in one: /")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["view", "none.json"], "none.json: cannot read the plan"),
        (["view", "plan.json", "--mission", "none.yaml"], "none.yaml: there is no such file"),
        (["view", "plan.json", "-o", "none/view.html"], "none/view.html"),
        (["animate", "plan.json"], "-o"),
        (["animate", "plan.json", "-o", "plan.mov"], "use .gif, .mp4 or .html"),
        (["animate", "plan.json", "-o", "a.gif", "--fps", "0"], "below 1"),
        (["animate", "plan.json", "-o", "a.gif", "--fps", "99"], "above 50"),
        (["animate", "plan.json", "-o", "a.gif", "--size", "640"], "not WIDTHxHEIGHT"),
        (["animate", "plan.json", "-o", "a.gif", "--size", "9x9"], "below 200"),
        (["animate", "plan.json", "-o", "a.gif", "--size", "9000x900"], "larger than"),
        (["animate", "plan.json", "-o", "a.gif", "--seconds-per-step", "0"], "not above 0"),
    ],
)
def test_bad_usage_is_two(folder, capsys, arguments, words):
    assert main(arguments) == 2
    err = capsys.readouterr().err
    assert words in err
    assert "Traceback" not in err


def test_without_its_mission_a_plan_says_what_to_do(folder, capsys):
    (folder / "mission.yaml").unlink()
    assert main(["view", "plan.json"]) == 2
    err = capsys.readouterr().err
    assert "the mission of the plan ('there') is in no YAML file beside it" in err
    assert "--mission MISSION" in err


def test_plans_without_paths_and_of_other_missions_are_refused(folder, capsys):
    data = json.loads((folder / "plan.json").read_text())
    without = {k: v for k, v in data.items() if k not in {"agents", "stopped_by"}}
    (folder / "none.json").write_text(json.dumps(without | {"status": "infeasible"}))
    assert main(["view", "none.json"]) == 2
    assert "no paths" in capsys.readouterr().err
    (folder / "mission.yaml").write_text(MISSION.replace("count: 2, at: p", "count: 2, at: r"))
    (folder / "map.yaml").write_text(MAP.replace("q", "r"))
    assert main(["view", "plan.json", "--mission", "mission.yaml"]) == 2
    assert "no state 'q'" in capsys.readouterr().err
