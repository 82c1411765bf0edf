"""What pictures show of a plan: one moment, some agents, what happened; and on which paper."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import tsplan
from tests.deliveries import building
from tests.legible import assert_legible
from tests.seeds import long
from tests.walks import walking, wandering, write_walks
from tests.yards import bars, named, texts, yard
from tsplan import InputError, load_mission, save_picture
from tsplan.cli import main
from tsplan.draw.canvas import DARK, WHITE
from tsplan.draw.colours import NAMED, lightness, rgb
from tsplan.draw.focus import Focus
from tsplan.draw.moment_map import moment_of
from tsplan.draw.night import GROUND, darkened, mirrored
from tsplan.draw.palette import HUES, Paint, pale
from tsplan.draw.requirement_chart import planned_counts
from tsplan.draw.tracks import tracks
from tsplan.draw.views import draw_page
from tsplan.plans.cargo_rows import loads_of
from tsplan.ts.builders import grid

matplotlib = pytest.importorskip("matplotlib")
from matplotlib import colors  # noqa: E402  (after it is known to be there)
from matplotlib.text import Text  # noqa: E402

ENVIRONMENTS = Path(__file__).parents[1] / "environments"


def numbers(ax):
    """The numbers on the badges of a map."""
    return [int(text.get_text()) for text in ax.texts if text.get_weight() == "bold"]


def test_at_a_step_everybody_is_where_the_plan_has_them():
    system = grid(3, 4, labels={(0, 0): "base"}, duration=(1, 3))
    mission, _ = wandering(system, [("a", {"r0c0": 5, "r1c1": 4}, []), ("b", {"r0c0": 3}, [])])
    plan = walking(mission, 1)
    found = tracks(plan, mission)
    for step in range(plan.horizon + 1):
        moment = moment_of(found, step, lambda _: Paint("#000000"), {})
        there = {state: count.total() for state, count in moment.staying.items()}
        counts = plan.counts(states=list(system.states))[:, step]
        assert there == {s: n for s, n in zip(system.states, counts, strict=True) if n}
        assert sum(there.values()) + moment.travelling.total() == len(plan.agents)
    figure, ax = plan.plot(mission, step=3)
    assert ax.get_title(loc="left") == "walks: paths, step 3"
    if named(ax, "agents"):  # else rings, where a row of badges has no room
        assert sum(numbers(ax)) == len(plan.agents)
    assert_legible(figure)


def test_a_moment_is_the_same_in_all_pictures_of_a_page():
    mission, plan = yard()
    figure, (mapped, *charts) = plan.plot(mission, view="page", step=1)
    (badge,) = named(mapped, "on the way")
    assert sum(numbers(mapped)) == 3
    gate, shed = mission.system.states["gate"].at, mission.system.states["shed"].at
    assert badge.get_xdata()[0] == pytest.approx((gate[0] + shed[0]) / 2)
    for ax in charts:
        (line,) = named(ax, "now")
        assert list(line.get_xdata()) == [1, 1]
    (bar,) = (b for b in bars(charts[0]) if b[3] == 0 and b[1] <= 1 < b[2])
    assert bar[0] == "on the way"
    assert_legible(figure)


def test_a_moment_between_two_steps_may_be_looked_at():
    mission, plan = yard()
    _, ax = plan.plot(mission, step=6.5)
    (badge,) = named(ax, "on the way")
    assert badge.get_xdata()[0] < 7  # on its way from the field to the hill, half of it
    assert "agents there at step 6.5" in texts(ax, legend=True)
    for step in (-1, 9, float("nan")):
        with pytest.raises(InputError, match="steps 0 to 8"):
            plan.plot(mission, step=step)
        with pytest.raises(InputError, match="steps 0 to 8"):
            plan.plot(step=step)


def test_what_lies_and_is_carried_is_told_at_a_step():
    mission, plan = building()
    loads = loads_of(plan.cargo)
    found = tracks(plan, mission)
    steps = [track.stops[0].last for track in found if track.load(track.stops[0].last, loads)]

    def told(step):
        figure, ax = plan.plot(mission, step=step)
        assert_legible(figure)
        return [
            sorted(text.get_text() for text in ax.texts if text.get_gid() == kind)
            for kind in ("load", "stock")
        ]

    loads_before, stocks_before = told(min(steps))
    loads_after, stocks_after = told(min(steps) + 0.5)
    assert not loads_before
    assert loads_after
    assert stocks_before != stocks_after
    assert told(min(steps) + 0.2) == [loads_before, stocks_before]  # nobody has set out yet


def test_some_agents_alone_are_drawn():
    mission, plan = yard()
    _, ax = plan.plot(mission, agents="man-2")
    assert named(ax, "path:man-2")
    assert not named(ax, "path:cart-1")
    _, ax = plan.plot(mission, view="timeline", agents=["man-2", "cart"])
    assert [tick.get_text() for tick in ax.get_yticklabels()] == ["cart-1", "man-2"]
    _, (_, chart, _) = plan.plot(mission, view="page", agents=["cart-1"])
    assert [tick.get_text() for tick in chart.get_yticklabels()] == ["cart-1"]
    _, ax = plan.plot(mission, view="flow", agents=["man-1"])
    assert "2" not in texts(ax)
    for view in ("paths", "timeline", "flow", "page"):
        with pytest.raises(InputError, match=r"no agent or class 'man-3'.*man-2"):
            plan.plot(mission, view=view, agents=["man-3"])


def happened(plan):
    """The plan as it went: the cart waits at the shed, and comes to the field late."""
    late = ((0, 0, "gate"), (2, 3, "shed"), (5, 8, "field"))
    return replace(plan, agents=(replace(plan.agents[0], stays=late), *plan.agents[1:]))


def test_what_happened_is_drawn_full_and_what_was_planned_pale():
    mission, plan = yard()
    figure, ax = plan.plot(mission, executed=happened(plan))
    (full,), (dashed,) = named(ax, "path:cart-1"), named(ax, "planned:cart-1")
    assert full.get_linestyle()[0][1] is None
    assert dashed.get_linestyle()[0][1] is not None
    given = colors.to_hex(full.get_edgecolor()[0])
    assert colors.to_hex(dashed.get_edgecolor()[0]) == pale(given)
    assert len(full.get_segments()) == 2  # it was never on its way to the hill
    assert len(dashed.get_segments()) == 3
    assert "planned" in texts(ax, legend=True)
    assert_legible(figure)


def test_the_timeline_has_what_was_planned_below_what_happened():
    mission, plan = yard()
    figure, ax = plan.plot(mission, view="timeline", executed=happened(plan))
    found = [(bar.get_gid(), bar.get_y(), bar.get_height(), bar.get_alpha()) for bar in ax.patches]
    real = [bar for bar in found if bar[0] == "field"]
    planned = [bar for bar in found if bar[0] == "planned field"]
    assert len(real) == len(planned) == 1
    assert real[0][1] + real[0][2] <= planned[0][1] + 1e-9  # the axis goes down
    assert planned[0][3] < 1
    (long,) = (bar for bar in ax.patches if bar.get_gid() == "field")
    assert long.get_x() > 4  # not at step 4, as was planned
    assert_legible(figure)


def test_of_what_happened_it_is_seen_what_it_misses():
    mission, plan = yard()
    figure, ax = plan.plot(mission, view="requirements", executed=happened(plan))
    rows = plan.requirements(mission)
    crop = next(n for n, row in enumerate(rows) if row.label == "crop")
    assert len(named(ax, "planned count")) == len(rows)
    line = named(ax, "planned count")[crop]
    heights = (crop + 0.94 - line.get_ydata()) / 0.78
    assert np.allclose(heights, np.repeat(rows[crop].counts, 2))
    assert planned_counts(plan, mission, rows[crop]).tolist() == rows[crop].counts.tolist()
    assert [shade.get_y() // 1 for shade in named(ax, "missed")] == [crop]
    assert "1 missing" in texts(ax)
    assert_legible(figure)


def test_stocks_and_flows_of_what_happened():
    mission, plan = building()
    figure, parts = draw_page(plan, mission, None, Focus(executed=plan))
    stocks = parts[-1]
    for full, dashed in zip(named(stocks, "stock"), named(stocks, "planned stock"), strict=True):
        assert np.allclose(full.get_ydata(), dashed.get_ydata())
    assert_legible(figure)
    _, ax = plan.plot(mission, view="flow", executed=plan)
    assert "what happened" in ax.get_title(loc="left")


def test_many_agents_have_bands_of_both():
    system = grid(4, 4, labels={(0, 0): "base"})
    mission, plan = wandering(system, [("a", {"r0c0": 120}, ["see"])], 40)
    figure, ax = plan.plot(mission, view="timeline", executed=walking(mission, 9))
    spans = {
        collection.get_alpha(): collection.get_paths()[0].vertices[:, 1]
        for collection in ax.collections
    }
    assert None in spans
    assert len(spans) == 2
    assert max(spans.pop(None)) <= min(next(iter(spans.values()))) + 1e-9
    assert_legible(figure)
    _, ax = plan.plot(mission, executed=walking(mission, 9))
    assert [artist for artist in ax.collections if str(artist.get_gid()).startswith("planned:120")]


def test_a_picture_can_be_dark_and_still_be_read():
    mission, plan = yard()
    figure, parts = plan.plot(mission, view="page", step=3, dark=True)
    ground = colors.to_hex(figure.get_facecolor())
    assert lightness(ground) == pytest.approx(GROUND, abs=1)
    written = [text for text in figure.findobj(Text) if text.get_text() and text.get_visible()]
    assert len(written) > 30
    plain = [text for text in written if text.axes in parts[1:] and text not in parts[1].texts]
    for text in plain:
        assert contrast(colors.to_hex(text.get_color()), ground) >= 4.5, text.get_text()
    for text in parts[1].texts:  # on the bars
        x, y = text.get_position()
        (bar,) = (b for b in parts[1].patches if b.get_bbox().contains(x, y))
        under = colors.to_hex(bar.get_facecolor())
        assert contrast(colors.to_hex(text.get_color()), under) >= 3, text.get_text()
    assert_legible(figure)
    light, _ = plan.plot(mission, view="page", step=3)
    assert colors.to_hex(light.get_facecolor()) == "#ffffff"


def test_a_policy_says_how_many_are_expected_where():
    mission = load_mission(ENVIRONMENTS / "ice_crossing.yaml")
    made = tsplan.plan(mission)
    figure, ax = made.plot(mission)
    written = [float(text.get_text()) for text in ax.texts if text.get_gid() == "expected"]
    states = [state for policy in made.policies for state in policy.expected]
    counts = made.counts(states=states)[:, -1]
    assert sorted(written) == sorted(round(n, 2) for n in counts if n >= 0.01)
    assert_legible(figure)


def contrast(one, other):
    """The ratio of WCAG 2 of two colours."""
    lights = []
    for colour in (one, other):
        parts = np.array(colors.to_rgb(colour))
        linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
        lights.append(linear @ (0.2126, 0.7152, 0.0722))
    return (max(lights) + 0.05) / (min(lights) + 0.05)


def test_words_on_all_colours_can_be_read_by_day_and_night():
    def night(colour):
        return colors.to_hex(mirrored(*(part / 255 for part in rgb(colour))))

    for colour in (*NAMED.values(), *HUES):
        bar, area = Paint(colour).soft, Paint(colour).pale
        assert contrast(bar.ink, bar.colour) >= 4.5, colour
        assert contrast(night(bar.ink), night(bar.colour)) >= 3.8, colour
        assert contrast(night(DARK), night(area)) >= 4.5, colour
        full = max(rgb(colour)) - min(rgb(colour)) > 150
        assert contrast(night(bar.colour), night(WHITE)) >= (1.4 if full else 1), colour


def test_mirrored_colours_keep_order_and_hue():
    greys = [mirrored(part, part, part)[0] for part in np.linspace(0, 1, 11)]
    assert greys == sorted(greys, reverse=True)
    red, green, blue = mirrored(1.0, 1.0, 0.6)  # a pale yellow area
    assert red > blue + 0.1
    assert green > blue + 0.1
    figure = matplotlib.figure.Figure()
    text = figure.text(0, 0, "x", color="#000000", bbox={"edgecolor": "none", "alpha": 0.85})
    darkened(figure)
    assert text.get_bbox_patch().get_edgecolor()[3] == 0  # what had no border has none


@pytest.mark.parametrize(
    ("view", "size"),
    [long("page", (5.0, 4.0)), ("timeline", (12.0, 2.0)), ("requirements", (4.0, 2.0))],
)
def test_pictures_of_a_given_size_are_legible(view, size):
    mission = load_mission(ENVIRONMENTS / "farm_harvest.yaml")
    plan = walking(mission, seed=2, still=0.5)
    figure, _ = plan.plot(mission, view=view, size=size)
    assert tuple(figure.get_size_inches()) == size
    assert_legible(figure)


def test_dark_and_size_are_of_whole_figures():
    mission, plan = yard()
    ax = matplotlib.figure.Figure().add_subplot()
    for look in ({"dark": True}, {"size": (4, 4)}):
        with pytest.raises(InputError, match="leave out ax"):
            plan.plot(mission, ax=ax, **look)


def test_what_plot_returns_can_be_saved(tmp_path):
    mission, plan = yard()
    save_picture(plan.plot(mission, size=(4, 3)), tmp_path / "a.png", dpi=50)
    header = (tmp_path / "a.png").read_bytes()[16:24]
    assert np.frombuffer(header, ">u4").tolist() == [200, 150]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_walks(tmp_path)
    return tmp_path


def test_the_command_line_has_the_same(folder):
    asked = ["--step", "5", "--agents", "drone", "--executed", "trace.json", "--dark"]
    asked += ["--size", "9x12"]
    assert main(["show", "plan.json", "-o", "a.svg", *asked, "--view", "paths"]) == 0
    drawn = (folder / "a.svg").read_text(encoding="utf-8")
    assert 'id="planned:drone' in drawn
    assert "harvester-1" not in drawn
    assert 'width="648pt" height="864pt"' in drawn
    assert main(["show", "plan.json", "-o", "a.png", *asked, "--dpi", "20"]) == 0
    header = (folder / "a.png").read_bytes()[16:24]
    assert np.frombuffer(header, ">u4").tolist() == [180, 240]


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        (["--step", "400"], "there is no step 400"),
        (["--step", "-1"], "--step"),
        (["--agents", "drone-99"], "drone-9"),
        (["--size", "9"], "WIDTHxHEIGHT"),
        (["--size", "9x1"], "--size"),
        (["--dpi", "0"], "--dpi"),
        (["--executed", "none.json"], "none.json"),
        (["--executed", "farm_harvest.yaml"], "farm_harvest.yaml"),
    ],
)
def test_what_cannot_be_shown_is_refused(folder, capsys, asked, words):
    assert main(["show", "plan.json", "-o", "a.svg", *asked]) == 2
    assert words in capsys.readouterr().err
    assert not (folder / "a.svg").exists()


def test_a_map_has_no_moment(folder, capsys):
    assert main(["show", "farm_harvest.yaml", "-o", "a.svg", "--step", "3"]) == 2
    assert "--step is about a plan" in capsys.readouterr().err
    assert main(["show", "farm_harvest.yaml", "-o", "a.svg", "--dark", "--size", "6x6"]) == 0
    assert main(["show", "plan.json", "-o", "trace.json", "--executed", "trace.json"]) == 2
