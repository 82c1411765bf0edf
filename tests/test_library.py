"""The library as it is used from Python: what it offers, and what results say of themselves."""

from __future__ import annotations

import ast
import importlib.util
import pickle
import re
import sys
from html import unescape
from io import StringIO
from pathlib import Path
from types import SimpleNamespace

import pytest

import tsplan
from tests.command_line import here
from tsplan.errors import InputError, PlanError
from tsplan.plans.plan_frame import FrameUnavailableError
from tsplan.public_names import GROUPS, public_names

PAGE = (Path(__file__).parents[1] / "docs" / "library.md").read_text(encoding="utf-8")
SECTIONS = dict(re.findall(r"^## (\w+)\n(.*?)(?=^## |\Z)", PAGE, re.MULTILINE | re.DOTALL))
MISSION = """\
format: tsplan-mission/1
name: ferry
map:
  waiting: true
  states: {yard: {labels: [home]}, dock: {labels: [shore]}}
  edges: [{from: yard, to: dock, duration: 2, both_ways: true}]
team: [{class: crew, count: 3, at: yard}]
spec: {language: mtl, formula: "F[0,6] sum(shore) >= 1 && G[6,6] sum(shore) <= 2"}
objective: [travel]
"""
SIGNALS = """\
format: tsplan-signals/1
name: ramp
signals: {x: [0, 9]}
spec: F[0,3] x >= 5
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder to work in, with a mission of each kind."""
    (tmp_path / "mission.yaml").write_text(MISSION, encoding="utf-8")
    (tmp_path / "signals.yaml").write_text(SIGNALS, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def timeless(text: str) -> list[str]:
    """The lines of a summary without the seconds that something took."""
    return [line for line in text.splitlines() if not re.match(r"  \d+\.\d\d s", line)]


def test_every_name_is_in_one_group_and_on_the_page_there():
    assert len(set(tsplan.__all__)) == len(tsplan.__all__)
    for title, homes in GROUPS.items():
        for name in (name for names in homes.values() for name in names):
            assert re.search(rf"\b{name}\b", SECTIONS[title]), f"{name} is missing in {title}"
    assert set(SECTIONS) == set(GROUPS)


def test_type_checkers_see_every_name_at_its_module():
    tree = ast.parse(Path(tsplan.__file__).read_text(encoding="utf-8"))
    seen = {
        (node.module, alias.name, alias.asname)
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
        if alias.asname is not None
    }
    homes = {f"tsplan.{home}": names for home, names in public_names().items()}
    assert seen == {(home, name, name) for home, names in homes.items() for name in names}


def test_files_are_planned_checked_and_explained_by_their_paths(folder):
    plan = tsplan.plan("mission.yaml")
    assert (plan.status, plan.verified) == ("optimal", True)
    assert isinstance(tsplan.plan(Path("signals.yaml")), tsplan.Trajectory)
    tsplan.save_plan(plan, "plan.json")
    report = tsplan.check("mission.yaml", "plan.json")
    assert report.ok
    assert str(report) == here("check", "mission.yaml", "plan.json").out.rstrip("\n")
    assert tsplan.explain("mission.yaml").status == "feasible"
    with pytest.raises(PlanError, match=r"this is a plan, and the mission is one over signals"):
        tsplan.check("signals.yaml", "plan.json")
    with pytest.raises(PlanError, match=r"this is a plan, and the mission is one over signals"):
        tsplan.simulate("signals.yaml", "plan.json")
    with pytest.raises(InputError, match="no such file"):
        tsplan.plan("none.yaml")


def test_results_are_told_as_the_command_line_tells_them(folder):
    for name in ("mission.yaml", "signals.yaml"):
        assert timeless(str(tsplan.plan(name))) == timeless(here("plan", name).out)
        told = str(tsplan.explain(name))
        assert timeless(told) == timeless(here("explain", name).out)
        assert tsplan.explain(name)._repr_html_().startswith("<pre>")
    report = tsplan.check("mission.yaml", tsplan.plan("mission.yaml"))
    assert unescape(report._repr_html_()) == f"<pre>{report}</pre>"
    assert str(tsplan.Explanation(tsplan.explain("mission.yaml").status, "x")).startswith("Expl")


def test_a_refused_plan_is_told_with_all_findings(folder):
    (folder / "other.yaml").write_text(MISSION.replace("F[0,6]", "G[0,6]"), encoding="utf-8")
    report = tsplan.check("other.yaml", tsplan.plan("mission.yaml"))
    assert str(report).splitlines() == [*map(str, report.findings), "the plan is refused"]
    assert report.findings


def test_names_act_on_nothing_where_they_are_told():
    hostile = "<b>\x1b[31m&"
    report = tsplan.Report((tsplan.Finding(hostile, source="plan"),), ())
    assert str(report) == "plan: <b>\\x1b[31m&\nthe plan is refused"
    assert report._repr_html_().startswith("<pre>plan: &lt;b&gt;\\x1b[31m&amp;\n")
    assert report._repr_mimebundle_()["text/plain"] == str(report)


def test_a_plan_knows_its_mission_and_keeps_it_to_itself(folder):
    mission = tsplan.load_mission("mission.yaml")
    plan = tsplan.plan(mission)
    stranger = tsplan.Plan.from_json(plan.to_json())
    assert plan.known_mission() is mission
    assert stranger.known_mission() is None
    assert stranger == plan == stranger.with_mission(mission)
    assert pickle.loads(pickle.dumps(plan)).known_mission() is None
    assert str(plan.explain()) == str(stranger.explain(mission))
    assert repr(plan.requirements()) == repr(stranger.requirements(mission))
    for method in ("explain", "requirements", "view", "animate", "simulate"):
        with pytest.raises(InputError, match=rf"give the mission: plan\.{method}\(mission\)"):
            getattr(stranger, method)()


def test_values_are_told_and_others_measured(folder):
    plan = tsplan.plan("mission.yaml")
    stranger = tsplan.Plan.from_json(plan.to_json())
    assert plan.value("travel") == stranger.value("travel") == 2
    assert plan.value("availability") == stranger.value("availability") == plan.availability
    assert plan.value("agents") == 1
    with pytest.raises(InputError, match=r"no value 'agents'.*plan\.value\(name, mission\)"):
        stranger.value("agents")
    assert stranger.value("agents", tsplan.load_mission("mission.yaml")) == 1
    with pytest.raises(InputError, match="did you mean 'travel'"):
        plan.value("travvel")
    for name in (None, 3, ["travel"]):
        for asked in (plan, stranger):
            with pytest.raises(InputError, match="is not the name of a value"):
                asked.value(name)
    none = tsplan.Plan("infeasible", plan.mission, 3)
    with pytest.raises(PlanError, match="infeasible has no values"):
        none.value("travel")


def test_a_movie_plays_in_a_notebook_and_is_saved(folder):
    plan = tsplan.plan("mission.yaml")
    movie = plan.animate("plan.html", fps=5)
    page = Path("plan.html").read_text(encoding="utf-8")
    assert "<title" in page
    shown = movie._repr_html_()
    assert shown.startswith("<iframe")
    assert shown.count("<") == 2  # what is in the frame is escaped as a whole
    assert repr(movie) == "<Movie of 'ferry': 6 steps>"
    with pytest.raises(InputError, match="moving pictures cannot be written"):
        movie.save("plan.bmp")


def test_the_page_is_a_view_of_a_plan(folder):
    pytest.importorskip("matplotlib")
    plan = tsplan.plan("mission.yaml")
    figure, axes = plan.plot(view="page")
    assert len(axes) == 3
    with pytest.raises(InputError, match="axes of its own"):
        plan.plot(view="page", ax=axes[0])
    with pytest.raises(InputError, match=r"no view 'pagee'.*page"):
        plan.plot(view="pagee")
    assert figure is not None


def test_a_table_has_a_row_for_each_agent_and_step(folder):
    plan = tsplan.plan("mission.yaml")
    if importlib.util.find_spec("pandas") is None:
        with pytest.raises(FrameUnavailableError, match="pip install pandas"):
            plan.to_frame()
    else:
        table = plan.to_frame()
        assert list(table.columns) == ["agent", "class", "step", "state"]
        for step in (0, 1, 6):
            rows = table[table.step == step]
            there = {
                a: s if isinstance(s, str) else None
                for a, s in zip(rows.agent, rows.state, strict=True)
            }
            assert there == plan.state_at(step)
    with pytest.raises(PlanError, match="no paths of agents"):
        tsplan.Plan("infeasible", plan.mission, 3).to_frame()


@pytest.mark.parametrize(
    "team",
    [
        {"cart": {"at": {"r0c0": 2, "r0c1": 1}, "capabilities": ["lift"]}, "scout": {"r0c2": 1}},
        [("cart", {"r0c0": 2, "r0c1": 1}, ["lift"]), ("scout", {"r0c2": 1})],
        [
            tsplan.Group.of("cart", {"r0c0": 2, "r0c1": 1}, {"lift"}),
            {"class": "scout", "at": {"r0c2": 1}},
        ],
        {"cart": ({"r0c0": 2, "r0c1": 1}, ["lift"]), "scout": {"count": 1, "at": "r0c2"}},
    ],
)
def test_a_team_may_be_said_in_short(team):
    """All of these say the same."""
    wanted = (
        tsplan.Group.of("cart", {"r0c0": 2, "r0c1": 1}, ["lift"]),
        tsplan.Group.of("scout", {"r0c2": 1}),
    )
    yard = tsplan.grid(1, 3)
    made = tsplan.Mission.of(map=yard, team=team, formula="true", language="mtl")
    assert made.team == wanted
    assert made == tsplan.mission_from_text(made.to_yaml())


@pytest.mark.parametrize(
    ("team", "words"),
    [
        ({"cart": 3}, "robots of class 'cart'.*3"),
        ([("cart",)], "robots of class 'cart'"),
        ([("cart", {"r0c0": 1}, [], {}, None, 7)], "robots of class 'cart'"),
        ([5], "5"),
        ({"cart": {"class": "van", "at": {"r0c0": 1}}}, "'van'"),
        ({"cart": {"r0c9": 1}}, "r0c9"),
        ("cart", "cart"),
        ([()], "team"),
    ],
)
def test_what_is_no_team_is_refused(team, words):
    with pytest.raises(tsplan.MissionError, match=words):
        tsplan.Mission.of(map=tsplan.grid(1, 3), team=team, formula="true", language="mtl")


class Handle:
    """What a notebook gives for something that it shows: the texts that were shown."""

    def __init__(self) -> None:
        self.texts: list[str] = []

    def update(self, data, raw):
        """Show something else there."""
        assert raw
        self.texts.append(data["text/plain"])


def test_progress_is_one_line_below_the_cell_of_a_notebook(folder, monkeypatch, capsys):
    handle = Handle()
    shell = SimpleNamespace(kernel=object())
    display = SimpleNamespace(display=lambda *_, **__: handle)
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    heard: list[tsplan.Event] = []
    assert tsplan.plan("mission.yaml", progress=True, on_event=heard.append).verified
    assert handle.texts[-1] == ""  # nothing is left of it
    assert any(text.startswith("paths and check") for text in handle.texts)
    assert heard
    assert capsys.readouterr().err == ""


def test_progress_is_lines_on_stderr_elsewhere(folder, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "IPython", None)
    stopped = tsplan.plan("mission.yaml", progress=True, on_event=lambda _event: True)
    lines = capsys.readouterr().err.splitlines()
    assert lines
    assert all(line.endswith(" s") for line in lines)
    assert stopped.stopped_by == "interrupt" or stopped.status == "optimal"
    tsplan.plan("signals.yaml", progress=True)
    assert "paths and check" in capsys.readouterr().err
    tsplan.plan("mission.yaml")
    assert capsys.readouterr() == ("", "")


def test_progress_is_written_over_on_a_terminal(folder, monkeypatch):
    monkeypatch.setitem(sys.modules, "IPython", None)
    terminal = StringIO()
    monkeypatch.setattr(terminal, "isatty", lambda: True)
    monkeypatch.setattr(sys, "stderr", terminal)
    tsplan.plan("mission.yaml", progress=True)
    said = terminal.getvalue()
    assert "\n" not in said
    assert said.endswith("\r\x1b[K")
    assert "paths and check" in said


def test_what_the_solver_says_is_heard(folder):
    heard: list[str] = []
    tsplan.plan("mission.yaml", encoding="reference", on_log=heard.append)
    assert "Solving report" in "".join(heard)
    spoken: list[str] = []
    tsplan.plan("signals.yaml", on_log=spoken.append)
    assert spoken
    silent = here("plan", "mission.yaml", "--encoding", "reference", "--json")
    told = here("plan", "mission.yaml", "--encoding", "reference", "--json", "--log-solver")
    assert "Solving report" in told.err
    assert "Solving report" not in silent.err
    assert tsplan.Plan.from_json(told.out).objective == tsplan.Plan.from_json(silent.out).objective
