"""Missions that hold in part: charts, reasons and the page show what became of all of it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.walks import walking
from tsplan import Mission, load_mission, plan, save_plan
from tsplan.cli import main
from tsplan.draw.palette import BAD, GOOD
from tsplan.draw.tracks import tracks
from tsplan.mission import Group
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.viewer.formula_rows import formula_parts
from tsplan.viewer.page_data import page_data

ENVIRONMENTS = Path(__file__).parents[1] / "environments"
MISSIONS = sorted(ENVIRONMENTS.glob("*_*.yaml"))
SYSTEM = TransitionSystem.build(
    [State("a", frozenset({"a"}), at=(0, 0)), State("b", frozenset({"b"}), at=(3, 0))],
    [Edge("a", "a"), Edge("b", "b"), Edge("a", "b"), Edge("b", "a")],
)


def made(**spec):
    """One agent that is at `a` up to step 2 and at `b` from step 3 on, and its mission."""
    mission = Mission.of(
        map=SYSTEM,
        team=[Group.of("one", {"a": 1}, [])],
        language="mtl",
        horizon=6,
        name="m",
        **spec,
    )
    agent = AgentPlan("one-1", "one", frozenset(), ((0, 2, "a"), (3, 6, "b")))
    return mission, Plan("feasible", MissionRef("m", ""), 6, "gap", agents=(agent,))


def wishful():
    return made(
        must="F[0,6] b",
        prefer=[
            {"name": "both", "formula": "G[0,4] a && F[0,4] b"},
            {"name": "late", "formula": "G[4,6] b", "weight": 2},
        ],
    )


def test_preferred_formulas_are_charted_by_their_names():
    mission, found = wishful()
    rows = found.requirements(mission)
    assert [(row.title, row.soft, row.slack) for row in rows] == [
        ("agents at b ≥ 1", None, 0),
        ("both: agents at a ≥ 1", "both", -1),
        ("both: agents at b ≥ 1", "both", None),
        ("late: agents at b ≥ 1", "late", 0),
    ]
    assert [row.witness_steps for row in rows] == [((3, 3),), ((3, 3),), (), ((4, 6),)]


def test_parts_that_hold_are_not_hidden_by_one_that_fails():
    formula = "G[0,6] a && F[2,4] b"
    whole = made(formula=formula)
    part = made(formula=formula, objective=[{"satisfaction": "weighted"}])
    assert [row.slack for row in whole[1].requirements(whole[0])] == [-1, None]
    assert [row.slack for row in part[1].requirements(part[0])] == [-1, 0]
    assert [row.windows for row in part[1].requirements(part[0])] == [((0, 6),), ((2, 4),)]


def test_what_fails_is_marked_in_the_chart():
    pytest.importorskip("matplotlib")
    mission, found = wishful()
    _, ax = found.plot(mission, view="requirements")

    def spans(name):
        shown = [patch for patch in ax.patches if patch.get_gid() == name]
        return [(p.get_x() + 0.5, p.get_width(), int(p.get_y())) for p in shown]

    assert spans("chosen") == [(3, 1, 0), (4, 3, 3)]
    assert spans("missed") == [(3, 1, 1)]
    said = {text.get_text(): text.get_color() for text in ax.texts}
    assert (said["1 missing"], said["0 to spare"]) == (BAD, GOOD)
    assert "not used" in said
    legend = [text.get_text() for text in ax.get_legend().get_texts()]
    assert legend[3:5] == ["satisfied here", "missed here"]
    mission, found = made(formula="F[0,6] b")
    _, ax = found.plot(mission, view="requirements")
    assert "missed here" not in [text.get_text() for text in ax.get_legend().get_texts()]


def test_the_page_ticks_off_preferred_formulas_too():
    mission, found = wishful()
    rows = formula_parts(mission, found)
    assert [(row.depth, row.text) for row in rows] == [
        (0, "F[0,6] b"),
        (0, "preferred: both: G[0,4] a && F[0,4] b"),
        (1, "G[0,4] a"),
        (1, "F[0,4] b"),
        (0, "preferred: late: G[4,6] b"),
    ]
    assert [row.failed for row in rows] == [None, 3, 3, None, None]
    assert rows[1].heading == "preferred: both: all of"
    assert rows[4].share(5) == pytest.approx(2 / 3)


def test_why_tells_of_preferred_formulas(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(ENVIRONMENTS)
    mission = load_mission("office_wishes.yaml")
    save_plan(walking(mission), tmp_path / "plan.json")
    assert (
        main(["show", str(tmp_path / "plan.json"), "--why", "--mission", "office_wishes.yaml"]) == 0
    )
    blocks = capsys.readouterr().out.split("\n\n")
    assert blocks[0].startswith("F[0,12]")
    named = [block.split("\n")[0] for block in blocks[1:]]
    assert named == [f"preferred: {wish.name}" for wish in mission.prefer]
    assert "\n  kitchen  fails" in blocks[-1]


@pytest.mark.long
@pytest.mark.parametrize("path", MISSIONS, ids=lambda path: path.stem)
def test_plans_of_the_environments_play(path, tmp_path):
    """Everybody is on the page and in the moving picture where the plan says."""
    mission = load_mission(path)
    found = plan(mission, time_limit=120)
    if not found.has_paths:
        assert found.status == "infeasible"
        return
    states = list(mission.system.states)
    counts = found.counts(states=states)
    for step in range(found.horizon + 1):
        there = dict.fromkeys(states, 0)
        for track in tracks(found, mission, moving=True):
            where = track.at(step)
            if track.present(step) and where.share == 0:
                there[where.source.state] += track.count
        assert list(there.values()) == counts[:, step].tolist()
    data = page_data(mission, found)
    assert [part["text"] for part in data["formula"]]
    failed = [part["failed"] for part in data["formula"] if part["depth"] == 0]
    assert (set(failed) == {None}) == (
        all(wish.met for wish in found.preferences)
        and (found.satisfaction is None or found.satisfaction.fraction == 1)
    )
    found.view(mission, tmp_path / "plan.html")
    assert "<canvas" in (tmp_path / "plan.html").read_text(encoding="utf-8")
