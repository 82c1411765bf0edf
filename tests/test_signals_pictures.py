"""Pictures of signals say what the evaluator says: windows, thresholds, regions and paths."""

from __future__ import annotations

import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.carts import ARRIVAL, CONTROLS, GOAL, REF, cart_mission, cart_run
from tsplan.draw.plane_map import Place, paths_of, places_of, plane_of
from tsplan.draw.signal_chart import MOST_PANELS, accepted, merged, panels_of, spread
from tsplan.draw.trajectory_views import TRAJECTORY_VIEWS, draw_trajectory
from tsplan.errors import InputError, PlanError
from tsplan.explanation.why.predicate_demands import predicate_demands
from tsplan.logic import TRUE, Or, linear
from tsplan.plans.outcomes import MissionRef, ObjectiveValue
from tsplan.signals.linear_system import Dynamics, System
from tsplan.signals.region import Region
from tsplan.signals.signal_files import load_signal_mission
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.synthesiser import synthesise
from tsplan.signals.trajectory import Trajectory
from tsplan.signals.trajectory_check import certify
from tsplan.viewer.trajectory_form import MOST_ROWS, signals_svg

pytest.importorskip("matplotlib")
from matplotlib.figure import Figure

MISSION = cart_mission()
FOUND = certify(MISSION, cart_run(ObjectiveValue("robustness", 0.5, 0.5)))
PAIR = SignalMission(
    System({f"{robot}_{axis}": (0, 10) for robot in "ab" for axis in "xy"}),
    Region(a_x=(2, 3), a_y=(2, 3)).inside().eventually(0, 2)
    & Region(b_x=(5, 6), b_y=(5, 6)).outside().always(0, 2),
    2,
    regions={
        "goal": Region(x=(2, 3), y=(2, 3)),
        "rock": Region(x=(5, 6), y=(5, 6)),
        "strip": Region(a_x=(8, 9)),
    },
    copies=("a", "b"),
)
WALKED = Trajectory(
    "optimal",
    REF,
    2,
    signals={"a_x": (1, 2, 2.5), "a_y": (1, 2, 2.5), "b_x": (9, 9, 9), "b_y": (0, 1, 2)},
)


def named(ax, name):
    return [artist for artist in ax.get_children() if artist.get_gid() == name]


def texts(ax):
    return [text.get_text() for text in ax.texts]


def test_predicates_are_asked_for_in_their_windows():
    first, *_, last = predicate_demands(MISSION, FOUND)
    assert str(first.atom) == "x >= 3"
    assert first.windows == ((0, 5),)
    assert first.witness_steps == ((5, 5),)
    assert first.spare == 0.5
    assert str(last.atom) == "y >= 9"
    assert last.witness_steps == ()
    assert last.spare is None
    assert all(d.witness_steps == () and d.windows for d in predicate_demands(MISSION))


def test_parts_of_a_formula_that_may_fail_are_looked_at_one_by_one():
    far = linear({"x": 1}, ">=", 9).eventually(0, 5)
    hard = cart_mission(far, ARRIVAL)
    assert [d.spare for d in predicate_demands(hard, FOUND)] == [-8, None, None, None, None]
    soft = replace(hard, satisfaction="weighted")
    assert [d.spare for d in predicate_demands(soft, FOUND)] == [-8, 0.5, 1.5, 0.5, 0.5]


def test_signals_have_panels_with_what_is_asked_of_them():
    mission = cart_mission(linear({"x": 1, "y": -2}, ">=", -4).always(1, 4), ARRIVAL)
    panels = panels_of(FOUND, mission)
    names = ["x", "y", "vx", "vy", "x - 2*y", "ux", "uy"]
    assert [panel.rows[0][0] for panel in panels] == names
    assert panels[0].bounds == (0, 10)
    assert [mark.words for mark in panels[0].marks] == ["≥ 3", "≤ 5"]
    x, y = np.array(FOUND["x"]), np.array(FOUND["y"])
    assert panels[4].rows[0][1].tolist() == (x - 2 * y).tolist()
    figure, axes = draw_trajectory(FOUND, mission)
    assert len(figure.axes) == len(axes) == 7
    line = named(axes[0], "x")[0]
    assert line.get_ydata().tolist() == list(FOUND.signals["x"])
    stairs = named(axes[5], "ux")[0]
    assert stairs.get_ydata().tolist() == [*CONTROLS["ux"], CONTROLS["ux"][-1]]
    chosen = named(axes[0], "chosen")[0].get_bbox()
    assert (chosen.x0, chosen.x1, chosen.y0, chosen.y1) == (4.5, 5.5, 3, 5)
    window = named(axes[4], "window")[0].get_bbox()
    assert (window.x0, window.x1) == (0.5, 4.5)
    assert named(axes[4], "threshold")[0].get_ydata().tolist() == [-4, -4]
    assert named(axes[2], "window") == []
    assert "x - 2*y" in [ax.get_ylabel() for ax in axes]


def test_what_makes_a_formula_fail_is_red():
    mission = cart_mission(linear({"x": 1}, ">=", 9).eventually(0, 3))
    _, axes = draw_trajectory(FOUND, mission)
    assert named(axes[0], "chosen") == []
    missed = named(axes[0], "missed")[0].get_bbox()
    assert (missed.x0, missed.x1, missed.y0) == (-0.5, 3.5, 9)


def test_a_threshold_is_in_the_unit_of_its_panel():
    mission = cart_mission(linear({"x": -2}, ">=", -8).always(0, 5))
    mark = panels_of(FOUND, mission)[0].marks[0]
    assert (mark.threshold, mark.words) == (4, "≤ 4")


def test_the_values_that_all_predicates_accept():
    marks = panels_of(FOUND, MISSION)[1].marks
    assert accepted(marks, (0.0, 10.0)) == [((0, 4), (0.0, 3.25)), ((5, 5), (2.0, 3.0))]
    assert merged([]) == []
    assert spread([], 1.0, 5.0) == []
    assert spread([4.0, 4.1, 4.9], 1.0, 5.0) == [3.0, 4.0, 5.0]


def test_signals_may_be_chosen_and_drawn_together():
    ax = Figure().add_subplot()
    figure, (same,) = FOUND.plot("x", "y", ax=ax)
    assert same is ax
    assert figure is ax.figure
    assert named(ax, "x")
    assert named(ax, "y")
    assert named(ax, "threshold") == []
    (alone,) = FOUND.plot("y", mission=MISSION)[1]
    assert named(alone, "threshold")
    with pytest.raises(InputError, match="there is no signal 'z'"):
        FOUND.plot("z")


def test_many_signals_are_cut():
    rows = {f"s{number}": (0.0, 1.0) for number in range(30)}
    many = Trajectory("optimal", REF, 1, signals=rows)
    figure, axes = many.plot()
    assert len(axes) == MOST_PANELS
    assert figure.axes[0].get_title(loc="left") == "cart: signals over time (14 more)"
    assert f"and {30 - MOST_ROWS} more" in signals_svg(many)


def test_the_plane_has_regions_and_the_path():
    figure, ax = draw_trajectory(FOUND, MISSION, "plane")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x", "y")
    path = named(ax, "path:")[0]
    assert path.get_xydata().tolist() == FOUND.states[:2].T.tolist()
    goal = named(ax, "region:goal")[0]
    assert goal.get_bbox().bounds == (3, 2, 2, 1)
    assert goal.get_hatch() is None
    assert named(ax, "region:wall")[0].get_hatch()
    words = [text.get_text() for text in ax.get_legend().get_texts()]
    assert words == ["path", "start", "to be in", "to be out of", "numbers: steps"]
    assert {"goal", "wall", "5"} <= set(texts(ax))
    figure.canvas.draw()
    boxes = [text.get_window_extent() for text in named(ax, "text")]
    assert not any(a.overlaps(b) for n, a in enumerate(boxes) for b in boxes[:n])


def test_robots_of_one_kind_share_a_plane():
    assert plane_of(WALKED, PAIR) == plane_of(None, PAIR) == ("x", "y")
    assert plane_of(WALKED, None) == ("x", "y")
    paths = paths_of(WALKED, PAIR, ("x", "y"))
    assert {name: path.tolist() for name, path in paths.items()} == {
        "a": [[1, 2, 2.5], [1, 2, 2.5]],
        "b": [[9, 9, 9], [0, 1, 2]],
    }
    inf = np.inf
    assert places_of(PAIR, ("x", "y")) == (
        Place("strip", (8, -inf, 9, inf), None, ("strip",)),
        Place("goal", (2, 2, 3, 3), True, ("goal",)),
        Place("rock", (5, 5, 6, 6), False, ("rock",)),
    )
    _, ax = WALKED.plot_plane("x", "y", PAIR)
    assert named(ax, "path:a")
    assert named(ax, "path:b")
    _, ax = WALKED.plot_plane("a_x", "b_x", PAIR)
    assert named(ax, "path:")[0].get_ydata().tolist() == [9, 9, 9]
    with pytest.raises(InputError, match="there is no signal 'z'"):
        WALKED.plot_plane("z", "x")
    with pytest.raises(InputError, match="only 'p'"):
        Trajectory("optimal", REF, 0, signals={"p": (1,)}).plot(view="plane")


def test_a_mission_is_drawn_before_there_is_a_trajectory():
    _, axes = draw_trajectory(None, MISSION)
    assert named(axes[0], "window")
    assert named(axes[0], "chosen") == []
    _, ax = draw_trajectory(None, MISSION, "plane")
    assert named(ax, "start")[0].get_xydata().tolist() == [[1, 2]]
    assert paths_of(None, PAIR, ("x", "y")) == {}


@pytest.mark.parametrize("view", TRAJECTORY_VIEWS)
@pytest.mark.parametrize("mission", [None, MISSION])
def test_every_view_is_drawn(view, mission):
    figure, _ = FOUND.plot(view=view, mission=mission)
    figure.canvas.draw()
    assert figure.get_axes() if view == "page" else figure.axes


def test_a_trajectory_knows_its_mission_until_it_is_changed_or_sent():
    known = FOUND.with_mission(MISSION)
    assert known == FOUND
    assert known.known_mission() is MISSION
    assert named(known.plot("x")[1][0], "window")
    assert named(FOUND.plot("x")[1][0], "window") == []
    for other in (pickle.loads(pickle.dumps(known)), replace(known), FOUND):
        assert other == known
        with pytest.raises(InputError, match="give the mission: trajectory"):
            other.explain()


def test_what_cannot_be_drawn_is_said():
    with pytest.raises(InputError, match="there is no view 'plan' of signals"):
        FOUND.plot(view="plan")
    none = Trajectory("infeasible", MissionRef("cart", ""), 5)
    with pytest.raises(PlanError, match="a trajectory of status infeasible has no signals"):
        none.plot()
    other = SignalMission(System({"p": (0, 1)}), TRUE, 5)
    with pytest.raises(PlanError, match="signal p has no values"):
        FOUND.plot(mission=other)


def test_notebooks_show_a_trajectory():
    shown = FOUND._repr_mimebundle_()
    assert shown["text/plain"] == "<Trajectory of 'cart': optimal, x, y, vx, vy>"
    assert "optimal trajectory (accepted by the independent check)" in shown["text/html"]
    assert shown["text/html"].count("<path") == 2 * 6
    assert "<svg" not in Trajectory("infeasible", REF, 3)._repr_html_()
    hostile = Trajectory("optimal", REF, 0, signals={"<b>": (1.0,)})
    assert "<b>" not in hostile._repr_html_()


def test_flat_and_short_signals_are_drawn():
    still = Trajectory("optimal", REF, 0, signals={"x": (3.0,), "y": (2.0,)}, controls={"u": ()})
    system = System(
        {"x": (0, 9), "y": (-np.inf, np.inf)},
        {"u": (0, 1)},
        Dynamics(((1, 0), (0, 1)), ((1,), (0,)), (0, 0)),
    )
    mission = SignalMission(system, GOAL.inside(), 0)
    for view in TRAJECTORY_VIEWS:
        still.plot(view=view, mission=mission)[0].canvas.draw()
    assert signals_svg(still).count("<path") == 4


def test_what_was_just_found_knows_its_mission():
    found = synthesise(GOAL.inside(), System({"x": (0, 10), "y": (0, 10)}))
    assert found.explain().worst == pytest.approx(0.5)
    assert named(found.plot("x")[1][0], "threshold")
    _, ax = found.plot_plane("x", "y")
    assert named(ax, "path:")


def test_what_is_preferred_by_weight_is_what_the_formula_rests_on():
    x, y = linear({"x": 1}, ">=", 3), linear({"y": 1, "x": -1}, ">=", 2)
    formula = Or((x.always(0, 1, [0.3, 0.7]), y.always(0, 1, [0.7, 0.1])), (0.2, 0.9))
    mission = SignalMission(
        System({"x": (0, 9), "y": (0, 9)}), formula, 1, weighting="product", language="wstl"
    )
    found = Trajectory("feasible", REF, 1, "gap", signals={"x": (4, 4), "y": (9, 9)})
    demands = predicate_demands(mission, found)
    assert {demand.atom for demand in demands} == {x, y}
    rests = {(demand.atom, demand.witness_steps) for demand in demands if demand.witness_steps}
    assert rests == {(y, ((0, 0),)), (y, ((1, 1),))}
    assert min(d.spare for d in demands if d.spare is not None) == pytest.approx(0.9 * 0.1 * 3)


def test_a_region_is_one_to_be_out_of_whose_ends_another_one_shares():
    mission = load_signal_mission(Path(__file__).parents[1] / "environments/signals/keys.yaml")
    wanted = {place.name: place.wanted for place in places_of(mission, ("x", "y"))}
    assert {name for name, inside in wanted.items() if inside} == {
        "first key",
        "second key",
        "goal",
    }
    assert not any(wanted[name] for name in ("above", "below", "west", "north", "first door"))
    assert None not in wanted.values()
