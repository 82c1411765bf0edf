"""Crosses on maps where nobody may go for some steps, or from a step on."""

from __future__ import annotations

import tsplan
from tests.command_line import here
from tests.legible import assert_legible

MAP = """\
waiting: true
states: {a: {at: [0, 0]}, b: {at: [1, 0], closed: [[4, 9]]}, c: {at: [1, 1]}}
edges:
  - {from: a, to: b, duration: 1, both_ways: true, closed: [[2, 3], [5, 5]]}
  - {from: b, to: c, duration: 2, both_ways: true}
  - {from: a, to: c, duration: 1, both_ways: true}
"""
MISSION = """\
format: tsplan-mission/1
map: map.yaml
team: [{class: cart, count: 2, at: a}]
spec: {language: mtl, formula: "F[0,12] sum(c) >= 2"}
objective: [travel]
"""


def crosses(ax) -> list[str]:
    return sorted(text.get_text() for text in ax.texts if text.get_gid() == "closed")


def test_what_the_map_says_is_closed_is_crossed_out(tmp_path) -> None:
    (tmp_path / "map.yaml").write_text(MAP)
    figure, ax = tsplan.load_map(tmp_path / "map.yaml").plot()
    assert crosses(ax) == ["\u00d7 2-3, 5", "\u00d7 4-9"]  # both directions have one
    assert "closed, at these steps" in [t.get_text() for t in ax.get_legend().get_texts()]
    assert_legible(figure)


def test_what_was_closed_when_it_was_planned_again_is_crossed_out(tmp_path) -> None:
    mission, plan, new = (tmp_path / name for name in ("mission.yaml", "plan.json", "new.json"))
    (tmp_path / "map.yaml").write_text(MAP)
    mission.write_text(MISSION)
    tsplan.save_plan(tsplan.plan(mission), plan)
    given = ["replan", str(mission), str(plan), "--at", "0", "-o", str(new)]
    done = here(*given, "--closed", "a-c,b-c@3", "--late", "", "--quiet")
    assert done.code == 2
    assert here(*given, "--closed", "a-c@2,b-c@3", "--quiet").code == 0
    again = tsplan.load_plan(new)
    figure, ax = again.plot(tsplan.load_mission(mission), view="paths")
    assert crosses(ax) == ["\u00d7 0-2", "\u00d7 0-3", "\u00d7 2-3, 5", "\u00d7 4-9"]
    assert_legible(figure)
    words = here(*given, "--closed", "a-c@soon", "--quiet").err
    assert words.startswith("until: 'soon' is not a whole number")
