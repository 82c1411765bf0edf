"""How maps, formulas and plans show themselves in notebooks: right, and harmless."""

from __future__ import annotations

from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.command_line import printed
from tests.seeds import quick
from tests.walks import wandering
from tsplan.draw.palette import Palette
from tsplan.draw.step_axes import DWELL, HALF
from tsplan.logic import parse
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef, ObjectiveValue
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import grid
from tsplan.viewer import svg
from tsplan.viewer.notebook import MOST_NODES, MOST_ROWS, MOST_STATES, formula_svg, plan_html
from tsplan.words import visible

NAMESPACE = "{http://www.w3.org/2000/svg}"
HOSTILE = [
    "<script>alert(1)</script>",
    '" onload="x',
    "a & b",
    "]]>",
    "Łódź \u0647\u0646\u0627",
    "\x01\x1f",
]


def elements(markup, name):
    root = ET.fromstring(markup)
    return [item for item in root.iter() if item.tag.removeprefix(NAMESPACE) == name]


def texts(markup):
    return [item.text for item in elements(markup, "text")]


def test_a_map_is_drawn_to_scale():
    states = [
        State("p", at=(0, 0)),
        State("q", at=(10, 0), labels=frozenset({"x"})),
        State("r", shape=((4, 4), (6, 4), (6, 6), (4, 6)), color="tan"),
    ]
    edges = [Edge("p", "q"), Edge("q", "p"), Edge("q", "r"), Edge("p", "p")]
    system = TransitionSystem.build(states, edges, name="yard")
    markup = system._repr_svg_()
    assert system._repr_mimebundle_() == {"text/plain": repr(system), "image/svg+xml": markup}
    p, q = elements(markup, "circle")
    assert float(q.get("cx")) - float(p.get("cx")) == pytest.approx(612, abs=0.2)
    assert p.get("cy") == q.get("cy")
    assert q.get("fill") == Palette(system).states["q"].colour
    shape, lines = elements(markup, "path")
    assert shape.get("fill") == Palette(system).states["r"].pale
    assert shape.get("d").count("M") == 1
    assert lines.get("d").count("M") == 2  # both ways are one line, waits are none
    assert texts(markup) == ["p", "q", "r"]
    top = min(float(part.split()[1]) for part in shape.get("d").strip("MZ").split("L"))
    assert top < float(p.get("cy"))  # upwards is upwards


def test_large_maps_lose_their_names_and_then_their_drawing():
    assert texts(grid(20, 20)._repr_svg_()) == []
    assert len(grid(20, 20)._repr_svg_()) < 60_000
    huge = grid(60, 60)
    assert len(huge.states) > MOST_STATES
    assert texts(huge._repr_svg_()) == ["grid: 3,600 states, 17,760 edges"]


def test_a_formula_is_a_tree_of_lines():
    formula = parse(
        "F[0,9] T(2, green, {(IR,2)}) && (G[0,3] L(red,{}) || !F[1,2] L(red,{(IR,1)}))",
        language="catl",
    )
    markup = formula._repr_svg_()
    assert formula._repr_mimebundle_()["image/svg+xml"] == markup
    assert texts(markup) == [
        "&&", "F[0,9]", "T(2,green,{(IR,2)})", "||", "G[0,3]", "L(red,{})",
        "!", "F[1,2]", "L(red,{(IR,1)})",
    ]  # fmt: skip
    dots = elements(markup, "circle")
    levels = [round((float(dot.get("cx")) - 10) / 18) for dot in dots]
    assert levels == [0, 1, 2, 1, 2, 3, 2, 3, 4]
    heights = [float(dot.get("cy")) for dot in dots]
    assert heights == sorted(set(heights))
    branches = [path.get("d") for path in elements(markup, "path")]
    assert len(branches) == len(dots) - 1
    # the branch to the second part of the conjunction begins at the conjunction
    assert branches[2].startswith(f"M10 {heights[0] + 4:.0f}V{heights[3]:.0f}")


def test_deep_and_long_formulas_are_cut():
    formula = parse("a")
    for _ in range(5000):
        formula = ~formula
    markup = formula_svg(formula)
    assert len(texts(markup)) == MOST_NODES + 1
    assert texts(markup)[-1] == "... and more"


def test_a_plan_is_a_table_and_a_timeline():
    stays = ((0, 2, "home"), (5, 9, "field"))
    agents = tuple(AgentPlan(f"a-{n}", "a", frozenset(), stays) for n in (1, 2))
    plan = Plan(
        "optimal", MissionRef("m", ""), 9, agents=agents, verified=True, availability=1.0,
        objective=(ObjectiveValue("travel", 4, 4),), notes=("a note",),
    )  # fmt: skip
    markup = plan._repr_html_()
    assert plan._repr_mimebundle_()["text/html"] == markup
    facts = [(row[0].text, row[1].text) for row in elements(markup, "tr")]
    assert ("outcome", "optimal plan (accepted by the independent check)") in facts
    assert ("objective", "travel 4 (proven: no plan does better)") in facts
    assert ("availability", "1") in facts
    assert ("note", "a note") in facts
    bars = [bar for bar in elements(markup, "rect") if bar.find(f"{NAMESPACE}title") is not None]
    widths = [float(bar.get("width")) for bar in bars]
    assert [bar.find(f"{NAMESPACE}title").text for bar in bars] == ["home", "field"] * 2
    first, second = 2 + HALF + DWELL, 4 + HALF + DWELL
    assert widths[1] / widths[0] == pytest.approx(second / first, rel=0.01)
    ways = [bar for bar in elements(markup, "rect") if bar.get("fill") == "url(#tsplan-way)"]
    assert [float(way.get("width")) / widths[0] for way in ways] == pytest.approx(
        [(3 - 2 * DWELL) / first] * 2, rel=0.01
    )
    assert {"a-1", "a-2", "home", "field", "0", "9"} <= set(texts(markup))


def test_plans_without_paths_and_with_many_agents():
    nothing = Plan("infeasible", MissionRef("m", ""), 3)
    assert "proven that no plan" in plan_html(nothing)
    assert elements(plan_html(nothing), "rect") == []
    _, plan = wandering(grid(4, 4, labels={(0, 0): "x"}), [("a", {"r0c0": 90}, [])], 40)
    assert len(plan.bundles) == 90
    assert f"... and {90 - MOST_ROWS} agents on {90 - MOST_ROWS} more paths" in texts(
        plan_html(plan)
    )


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_are_text(name):
    shown = svg._UNFIT.sub("\ufffd", visible(name))
    system = TransitionSystem.build([State(name, at=(0, 0), color=name)], [], name=name)
    assert texts(system._repr_svg_()) == [shown]
    formula = parse("a").always(0, 2)
    assert texts(formula._repr_svg_())
    agent = AgentPlan(name, name, frozenset(), ((0, 30, name),))
    plan = Plan("feasible", MissionRef(name, ""), 30, "gap", agents=(agent,), notes=(name,))
    markup = plan._repr_html_()
    assert shown in texts(markup)
    assert next(row[1].text for row in elements(markup, "tr")) == shown
    for item in ET.fromstring(markup).iter():
        assert item.tag.removeprefix(NAMESPACE) != "script"
        assert not any(key.startswith("on") for key in item.attrib)


@quick
@given(st.text())
def test_any_text_is_content_and_nothing_else(text):
    root = ET.fromstring(svg.element("text", svg.words(text) or "x", gid=text))
    assert list(root) == []
    kept = svg._UNFIT.sub("\ufffd", visible(text))
    assert (root.text or "") == (kept or "x")


def test_notebooks_need_no_matplotlib():
    code = (
        "import sys\n"
        "sys.modules['matplotlib'] = None\n"
        "from tsplan.ts.builders import grid\n"
        "from tsplan.logic import parse\n"
        "assert grid(2, 2)._repr_svg_().startswith('<svg')\n"
        "assert parse('a')._repr_svg_().startswith('<svg')\n"
    )
    assert printed(code) == ""
