"""Pictures say what the data says: artists, texts, positions and colours, not only files."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.command_line import printed
from tests.legible import assert_legible
from tests.seeds import sampled
from tests.walks import walking, wandering
from tests.yards import YARD, bars, named, texts, yard
from tsplan import load_map, load_mission
from tsplan.draw.canvas import text_size
from tsplan.draw.layout import duration_words, places
from tsplan.draw.map import usual_duration
from tsplan.draw.matplotlib_loading import PlotUnavailableError
from tsplan.draw.palette import PLAIN, TRAVEL, Palette
from tsplan.draw.picture_files import save_picture
from tsplan.draw.requirement_chart import shown_rows
from tsplan.draw.row_chart import MOST_ROWS
from tsplan.draw.step_axes import DWELL, HALF
from tsplan.draw.strands import MOST_PATHS, strands_of
from tsplan.draw.swarm_bands import bands_of, draw_flows, flows_of, map_durations, row_order
from tsplan.draw.timeline import draw_timeline, keys_of
from tsplan.draw.timeline_rows import MOST_AGENTS, rows_of
from tsplan.draw.timeline_rows import MOST_PATHS as MOST_TIMELINES
from tsplan.draw.tracks import tracks
from tsplan.draw.views import VIEWS, draw_page, draw_view
from tsplan.errors import InputError, PlanError
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import grid

matplotlib = pytest.importorskip("matplotlib")
colors = pytest.importorskip("matplotlib.colors")
from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: E402  (after it is known to be there)
from matplotlib.figure import Figure  # noqa: E402

ENVIRONMENTS = Path(__file__).parents[1] / "environments"
MISSIONS = sorted(path.stem for path in ENVIRONMENTS.glob("*_*.yaml"))
QUICK = ("farm_harvest",)


def face(artist):
    return colors.to_hex(np.ravel(artist.get_facecolor())[:3])


def test_the_map_shows_states_edges_and_durations():
    figure, ax = YARD.plot()
    assert ax.figure is figure
    written = texts(ax)
    assert {"gate", "shed", "field", "hill", "in, way", "store", "crop", "1-3"} <= set(written)
    assert "2" not in written
    assert texts(ax, legend=True) == ["2 steps if not marked"]
    (shape,) = named(ax, "state:field")
    assert shape.get_path().vertices[:4].tolist() == [[6, -1], [8, -1], [8, 1], [6, 1]]
    assert face(shape) == Palette(YARD).states["field"].pale
    (both,) = named(ax, "edges")
    (single,) = named(ax, "one-way edges")
    assert len(both.get_segments()) == 2
    assert [line.tolist() for line in single.get_segments()] == [[[7, 0], [4, 3]]]
    (dots,) = named(ax, "states")
    assert dots.get_offsets().tolist() == [[0, 0], [4, 0], [4, 3]]
    assert [colors.to_hex(c) for c in dots.get_facecolors()] == [
        Palette(YARD).states[name].colour for name in ("gate", "shed", "hill")
    ]
    assert_legible(figure)


def test_given_axes_are_drawn_on():
    figure = Figure()
    ax = figure.add_subplot()
    assert YARD.plot(ax) == (figure, ax)
    mission, plan = yard()
    for view in VIEWS.keys() - {"policy", "stocks"}:  # it has neither
        ax = Figure(figsize=(8, 6)).add_subplot()
        assert plan.plot(mission, view=view, ax=ax) == (ax.figure, ax)


def test_durations_in_words():
    assert usual_duration(YARD) == "2"
    assert duration_words({"a": 1, "b": 4}, 2) == "1-4"
    assert usual_duration(TransitionSystem.build([State("p")], [])) == "1"


def test_starts_are_counted_where_they_are():
    mission, _ = yard()
    figure, ax = mission.plot()
    badges = named(ax, "start")
    painted = Palette.of(mission).classes
    assert [badge.get_color() for badge in badges] == [painted[n].colour for n in ("cart", "man")]
    assert texts(ax).count("1") == 1
    assert texts(ax).count("2") == 1
    assert texts(ax, legend=True)[:2] == ["1 cart (haul)", "2 man (look)"]
    assert_legible(figure)


def test_each_path_has_lanes_on_its_own_side():
    mission, plan = yard()
    figure, ax = plan.plot(mission)
    (cart,) = [c for c in named(ax, "path:cart-1") if c.get_zorder() == 4]
    (men,) = [c for c in named(ax, "path:man-1..2") if c.get_zorder() == 4]
    assert len(cart.get_segments()) == 3
    assert len(men.get_segments()) == 1
    (to_shed,) = men.get_segments()
    first = cart.get_segments()[0]
    # both go east from the gate: right of the way is below it, the second path further out
    assert 0 > first[0][1] > to_shed[0][1]
    assert 0 < first[0][0] < first[1][0] < 4
    assert men.get_linewidths()[0] > cart.get_linewidths()[0]
    assert colors.to_hex(cart.get_colors()[0]) != colors.to_hex(men.get_colors()[0])
    arrivals = sorted(text.get_text() for text in named(ax, "arrival"))
    assert arrivals == ["2", "3", "4", "7"]
    assert texts(ax, legend=True)[:3] == ["cart-1", "man-1..2", "agents that start there"]
    assert_legible(figure)


def test_opposite_directions_have_opposite_sides():
    mission, _ = yard()
    stays = ((0, 0, "gate"), (2, 2, "shed"), (4, 8, "gate"))
    agent = AgentPlan("cart-1", "cart", frozenset({"haul"}), stays)
    plan = Plan("feasible", MissionRef("", ""), 8, "gap", agents=(agent,))
    _, ax = plan.plot(mission)
    there, back = named(ax, "path:cart-1")[-1].get_segments()
    assert there[0][1] < 0 < back[0][1]


@pytest.mark.parametrize("agents", [MOST_PATHS, MOST_PATHS + 1])
def test_too_many_paths_become_one_strand_a_class(agents):
    system = grid(5, 5, labels={(0, 0): "base"})
    team = [("a", {"r0c0": agents // 2}, ["see"]), ("b", {"r2c2": agents - agents // 2}, [])]
    mission, plan = wandering(system, team, 30)
    strands, joined = strands_of(tracks(plan), plan.horizon, Palette.of(mission))
    assert len(plan.bundles) == agents
    assert joined == (agents > MOST_PATHS)
    assert len(strands) == (2 if joined else agents)
    _, ax = plan.plot(mission)
    if joined:
        assert texts(ax, legend=True)[0].endswith(f"a on {agents // 2} paths")
        assert not named(ax, "arrival")
        total = sum(p.agents for s in strands for p in s.passages.values())
        moves = sum(len(agent.stays) - 1 + (agent.heading is not None) for agent in plan.agents)
        assert total == moves


def test_the_timeline_has_a_bar_for_each_stay_and_way():
    mission, plan = yard()
    figure, ax = plan.plot(mission, view="timeline")
    found = bars(ax)
    for row, agent in enumerate(plan.agents):
        for first, last, state in agent.stays:
            begin = first - DWELL if first else -HALF
            end = last + DWELL if last < plan.horizon else last + HALF
            assert (state, begin, end, row) in found
    assert ("on the way", DWELL, 2 - DWELL, 0) in found
    assert ("on the way", 2 + DWELL, 4 - DWELL, 0) in found
    assert ("on the way", 6 + DWELL, 7 - DWELL, 0) in found  # from one step to the next
    assert sum(bar[0] == "on the way" for bar in found) == 5
    way = next(b for b in ax.patches if b.get_gid() == "on the way")
    assert (face(way), way.get_hatch()) == (TRAVEL.colour, TRAVEL.hatch)
    field = next(b for b in ax.patches if b.get_gid() == "field")
    assert face(field) == Palette(YARD).states["field"].soft.colour
    hill = next(b for b in ax.patches if b.get_gid() == "hill")
    assert face(hill) == PLAIN.colour
    assert [tick.get_text() for tick in ax.get_yticklabels()] == ["cart-1", "man-1", "man-2"]
    assert "field" in texts(ax)
    assert set(texts(ax, legend=True)) == {"crop", "in, way", "store", "no label", "on the way"}
    assert_legible(figure)


def test_the_timeline_works_without_a_mission():
    _, plan = yard()
    figure, ax = plan.plot()
    assert ax.get_xlabel() == "step"
    keys = keys_of(tracks(plan), plan.horizon, None)
    assert len({key.paint for key in keys.values()}) == 4
    assert set(texts(ax, legend=True)) == {*plan.states, "on the way"}
    assert_legible(figure)


def test_rows_are_agents_then_paths_then_classes():
    system = grid(4, 4, labels={(0, 0): "base"})

    def plan_of(agents, paths):
        mission, plan = wandering(system, [("a", {"r0c0": agents}, ["see"])], 40)
        shared = tuple(
            replace(plan.agents[n % paths], id=agent.id) for n, agent in enumerate(plan.agents)
        )
        return mission, Plan("feasible", plan.mission, 40, "gap", agents=shared)

    _, few = plan_of(MOST_AGENTS, 3)
    assert len(rows_of(few, tracks(few))) == MOST_AGENTS
    _, more = plan_of(MOST_AGENTS + 1, 3)
    some = rows_of(more, tracks(more))
    assert len(some) == 3
    assert some[0].name.endswith("(9)")
    mission, many = plan_of(200, MOST_TIMELINES + 1)
    assert rows_of(many, tracks(many)) == ()
    _, ax = many.plot(mission, view="timeline")
    assert ax.get_yticklabels()[0].get_text() == "a\n200 agents"
    # the band's parts are the shares of the agents at every step
    base = next(c for c in ax.collections if c.get_gid() == "a: base")
    share = many.counts(states=["r0c0"])[0] / 200
    points = base.get_paths()[0].vertices
    for step in range(41):
        near = np.abs(points[:, 0] - step) < HALF + 1e-9
        here = points[near & (np.abs(points[:, 0] - step) > DWELL - 1e-9)]
        thick = max(here[:, 1]) - min(here[:, 1])
        assert thick >= 0.82 * share[step] - 1e-9


def test_requirements_show_counts_needs_windows_and_witnesses():
    mission, plan = yard()
    figure, ax = plan.plot(mission, view="requirements")
    rows = plan.requirements(mission)
    assert [tick.get_text() for tick in ax.get_yticklabels()] == [row.title for row in rows]
    lines = named(ax, "count")
    needs = named(ax, "need")
    for place, (row, line, need) in enumerate(zip(rows, lines, needs, strict=True)):
        heights = place + 0.94 - line.get_ydata()
        most = max(row.counts.max(), row.bound, 1)
        assert np.allclose(heights / 0.78 * most, np.repeat(row.counts, 2))
        reach = np.stack([np.arange(9) - DWELL, np.arange(9) + DWELL], axis=1).ravel()
        assert np.allclose(line.get_xdata()[1:-1], reach[1:-1])
        assert need.get_ydata()[0] == pytest.approx(place + 0.94 - 0.78 * row.bound / most)
    spans = [(p.get_x() + 0.5, p.get_width(), int(p.get_y())) for p in named(ax, "window")]
    assert spans == [(0, 5, 0), (2, 6, 1), (0, 9, 2)]
    chosen = [(p.get_x() + 0.5, p.get_width(), int(p.get_y())) for p in named(ax, "chosen")]
    assert chosen == [(4, 1, 0), (3, 2, 1), (0, 9, 2)]
    assert [mark.get_xdata()[0] for mark in named(ax, "witness")] == [4, 3, 0]
    beside = [text.get_text() for text in ax.texts]
    assert beside == ["0 to spare", "peak 1", "0 to spare", "peak 2", "0 to spare", "peak 3"]
    assert_legible(figure)


def test_of_many_requirements_the_tight_ones_are_shown():
    mission, plan = yard()
    row = plan.requirements(mission)[2]
    assert len(shown_rows([row] * (MOST_ROWS + 5))) == MOST_ROWS
    tight = plan.requirements(mission)[0]
    loose = [_loosened(row) for _ in range(MOST_ROWS)]
    assert tight in shown_rows([*loose, tight])


def _loosened(row):
    return replace(row, margins=row.margins + 5)


def test_flows_are_the_moves_of_all_agents():
    _, plan = yard()
    flows = flows_of(plan)
    assert flows["man"] == (
        (0, "gate", "gate", 2),
        (1, "gate", "shed", 2),
        *((step, "shed", "shed", 2) for step in range(3, 8)),
    )
    bands = bands_of(flows, map_durations(YARD))
    cart = [b for b in bands if b.class_name == "cart" and b.source[0] != b.target[0]]
    assert [(b.source, b.target) for b in cart] == [
        (("gate", 0), ("shed", 2)),
        (("shed", 2), ("field", 4)),
        (("field", 6), ("hill", 7)),
    ]


@pytest.mark.parametrize("seed", range(6))
def test_stacks_are_as_high_as_agents_are_there_and_have_no_gaps(seed):
    system = grid(3, 4, labels={(0, 0): "base"}, duration=(1, 3))
    team = [("a", {"r0c0": 9, "r1c1": 4}, []), ("b", {"r0c0": 5}, [])]
    mission, _ = wandering(system, team)
    plan = walking(mission, seed)
    bands = bands_of(flows_of(plan), map_durations(mission.system))
    assert sorted(row_order(bands)) == sorted({*plan.states, *(b.target[0] for b in bands)})
    counts = plan.counts(states=plan.states)
    row = {state: number for number, state in enumerate(plan.states)}
    for near, offset in (("source", "leaves"), ("target", "arrives")):
        stacks = {}
        for band in bands:
            stacks.setdefault(getattr(band, near), []).append((getattr(band, offset), band.count))
        for (state, step), parts in stacks.items():
            foot = 0
            for begin, count in sorted(parts):
                assert begin == foot
                foot += count
            if step <= plan.horizon:
                assert foot == counts[row[state], step]


def test_the_flow_diagram_draws_each_band_as_thick_as_its_agents():
    mission, plan = yard()
    figure, ax = plan.plot(mission, view="flow")
    (stays,) = named(ax, "stays:man")
    (moves,) = named(ax, "moves:man")
    (ribbon,) = moves.get_paths()
    assert ribbon.vertices[[0, 1, 4, 5]][:, 0].tolist() == [1, 1 + DWELL, 3 - DWELL, 3]
    assert ribbon.vertices[11][1] - ribbon.vertices[0][1] == 2
    assert len(stays.get_paths()) == 6
    assert {tick.get_text() for tick in ax.get_yticklabels()} == {"gate", "shed", "field", "hill"}
    assert texts(ax, legend=True) == ["cart", "man"]
    assert "2" in texts(ax)
    assert_legible(figure)
    moves = [(0, "gate", "gate", 100), (1, "gate", "shed", 30), (1, "gate", "gate", 70)]
    _, ax = draw_flows({"swarm": [*moves, (2, "gate", "gate", 70)]}, YARD, 3)
    assert ax.get_legend() is None
    assert texts(ax) == ["100", "70", "30"]


def test_a_page_has_the_three_pictures_below_each_other():
    mission, plan = yard()
    figure, parts = draw_page(plan, mission)
    heights = [ax.get_position().y0 for ax in parts]
    assert len(parts) == 3
    assert named(parts[0], "path:cart-1")
    assert named(parts[1], "field")
    assert named(parts[2], "count")
    assert all(0 <= height < 1 for height in heights)
    assert_legible(figure)


@pytest.mark.parametrize("name", sampled(MISSIONS, QUICK))
def test_pictures_of_the_environments_are_legible(name):
    mission = load_mission(ENVIRONMENTS / f"{name}.yaml")
    plan = walking(mission, seed=3, still=0.6)
    for view in ("map", "paths", "timeline", "requirements"):
        figure, _ = draw_view(plan, mission, view)
        assert_legible(figure)


@pytest.mark.parametrize("name", ["office", "rescue"])
def test_every_name_and_label_is_written_on_the_maps(name):
    system = load_map(ENVIRONMENTS / f"{name}.yaml")
    figure, ax = system.plot()
    written = "\n".join(texts(ax)).replace("_\n", "_").split("\n")
    assert set(system.states) <= set(written)
    assert_legible(figure)


def test_names_without_room_are_left_out_and_labels_go_to_the_legend():
    system = grid(50, 50, labels={(3, 3): "depot", (40, 7): ["depot", "north"]})
    mission, plan = wandering(
        system, [("a", {f"r{n}c{m}": 2 for n in range(10) for m in range(10)}, [])]
    )
    figure, ax = plan.plot(mission)
    assert texts(ax) == []
    assert {"depot", "north"} <= set(texts(ax, legend=True))
    (ring,) = named(ax, "starts")
    assert len(ring.get_offsets()) == 100
    assert_legible(figure)
    # two states of a chain stay readable however small the page is
    names = [f"state number {n}" for n in range(40)]
    chain = TransitionSystem.build(
        [State(n, frozenset({"x"}), at=(i, 0)) for i, n in enumerate(names)], []
    )
    _, ax = chain.plot()
    assert not set(names) & set(texts(ax))


def test_strange_names_are_shown_as_they_are():
    names = ["$a_b$", "_hidden", "<script>alert(1)</script>", 'say "hi"', "Łódź поле", "$", "a\\b"]
    states = [
        State(name, frozenset({f"label {name}"}), at=(3.0 * n, 0)) for n, name in enumerate(names)
    ]
    edges = [Edge(a, b) for a in names for b in names]
    mission, plan = wandering(
        TransitionSystem.build(states, edges, name="$x$"), [("_class$", {"_hidden": 3}, [])]
    )
    figure, ax = mission.plot()
    figure.draw_without_rendering()
    assert texts(ax, legend=True)[0] == "3 _class\\$"
    written = [text.replace("\\$", "$") for text in texts(ax)]
    assert set(names) <= set(written)
    for view in VIEWS.keys() - {"policy", "stocks"}:  # it has neither
        figure, _ = plan.plot(mission, view=view)
        figure.draw_without_rendering()


def test_text_is_measured_as_it_is_drawn():
    figure = Figure(dpi=72)
    renderer = FigureCanvasAgg(figure).get_renderer()
    for words in ("wheat_west", "r10c11", "Łódź поле", "two\nlines of it"):
        text = figure.text(0.5, 0.5, words, fontsize=10)
        drawn = text.get_window_extent(renderer)
        width, height = text_size(words, 10)
        assert width == pytest.approx(drawn.width, rel=0.08, abs=2)
        assert height >= drawn.height - 3


def test_files_are_of_the_kind_they_are_named(tmp_path):
    figure, _ = YARD.plot()
    for name, begin in (("a.png", b"\x89PNG"), ("b.pdf", b"%PDF"), ("c", b"\x89PNG")):
        save_picture(figure, tmp_path / name)
        assert (tmp_path / name).read_bytes().startswith(begin)
    save_picture(figure, tmp_path / "d.svg")
    drawn = (tmp_path / "d.svg").read_text(encoding="utf-8")
    assert "<svg" in drawn
    assert "<image" not in drawn
    assert "dc:date" not in drawn
    with pytest.raises(InputError, match=r"use \.png, \.svg or \.pdf"):
        save_picture(figure, tmp_path / "e.bmp")


def test_the_global_state_of_matplotlib_is_left_alone():
    code = """
import sys, matplotlib
def settings():  # reading the backend would choose one
    return {key: matplotlib.rcParams[key] for key in matplotlib.rcParams if key != "backend"}
before = settings()
from tests.test_draw_pictures import yard
from tsplan.draw.views import draw_page
from tsplan.draw.picture_files import content
mission, plan = yard()
figure, _ = draw_page(plan, mission)
content(figure, "png", 50)
assert settings() == before
print("matplotlib.pyplot" in sys.modules)
"""
    assert printed(code) == "False\n"


def test_wrong_requests_are_refused():
    mission, plan = yard()
    with pytest.raises(InputError, match="did you mean 'timeline'"):
        plan.plot(mission, view="timline")
    with pytest.raises(InputError, match="needs the map"):
        plan.plot(view="paths")
    nothing = Plan("infeasible", MissionRef("m", ""), 8)
    with pytest.raises(PlanError, match="no paths"):
        nothing.plot(mission)
    with pytest.raises(PlanError, match="no paths"):
        draw_timeline(nothing)


def test_without_matplotlib_the_remedy_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(PlotUnavailableError, match=r"tsplan\[plot\]"):
        YARD.plot()


def test_places_come_from_the_layout():
    figure, ax = YARD.plot()
    where = places(YARD)
    for state, text in (("gate", "gate"), ("hill", "hill")):
        written = next(t for t in ax.texts if t.get_text() == text)
        x, y = written.get_position()
        assert abs(x - where[state][0]) < 0.6
        assert abs(y - where[state][1]) < 0.6
    assert figure is ax.figure
