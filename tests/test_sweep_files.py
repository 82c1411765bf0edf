"""Sweep files: the runs that they make, and everything that is wrong with them at its place."""

from __future__ import annotations

import pytest

from tests.command_line import here
from tests.missions import FILES as MISSION_FILES
from tests.missions import findings
from tsplan.document import parse_document
from tsplan.document.patchwork import Patchwork
from tsplan.errors import MissionError
from tsplan.sweeps.mission_folder import runs_of_folder
from tsplan.sweeps.sweep_draft import load_sweep

SIGNALS = """\
format: tsplan-signals/1
signals: {x: [0, 9]}
spec: "F[0,3] x >= 5"
"""
HEAD = "format: tsplan-sweep/1\nmission: mission.yaml\n"
FILES = {
    **MISSION_FILES,
    "signals.yaml": SIGNALS,
    "sweep.yaml": HEAD
    + """\
axes:
  parameters:
    team.0.count: [1, 2, 3]
    map.edges.0.2: [1, 2]
  seeds: [1, 2]
  formulas: {near: "F[0,3] B", both: ["F[0,3] B", "F[4,6] A"]}
  solvers:
    - {label: quick, time_limit: 5}
    - {name: highs, threads: 1, encoding: reference, without: [dive]}
repeat: 2
""",
}


def runs_of(folder, text):
    (folder / "sweep.yaml").write_text(text)
    return load_sweep(folder / "sweep.yaml")


def wrong(folder, text):
    (folder / "sweep.yaml").write_text(text)
    lines = findings(load_sweep, folder / "sweep.yaml")
    return [line.replace(f"{folder}/", "") for line in lines]


def test_the_runs_are_the_product_in_the_order_of_the_axes(folder):
    runs = load_sweep(folder / "sweep.yaml")
    assert len(runs) == 3 * 2 * 2 * 2 * 2 * 2
    first, last = runs[0], runs[-1]
    assert dict(first.axes) == {
        "team.0.count": 1,
        "map.edges.0.2": 1,
        "seed": 1,
        "formula": "near",
        "solver": "quick",
        "repeat": 1,
    }
    assert last.axes["solver"] == "highs, threads 1, reference, without dive"
    assert [run.axes["repeat"] for run in runs[:2]] == [1, 2]
    assert [run.axes["team.0.count"] for run in runs[::32]] == [1, 2, 3]
    assert (last.choice.name, last.choice.threads, last.choice.seed) == ("highs", 1, 2)
    assert (last.encoding, last.without) == ("reference", ("dive",))
    mission = last.mission
    assert (mission.size, mission.text) == (3, "(F[0,3] B) && (F[4,6] A)")
    assert mission.system.edges["p", "q"].duration == 2
    assert len({run.id for run in runs}) == len({run.id[:6] for run in runs}) == len(runs)


def test_ids_follow_the_values_and_contents_what_is_planned(folder):
    axes = "axes: {parameters: {team.0.count: [%s]}, seeds: [7]}\n"
    before = {run.axes["team.0.count"]: run for run in runs_of(folder, HEAD + axes % "1, 2")}
    after = {run.axes["team.0.count"]: run for run in runs_of(folder, HEAD + axes % "3, 2, 1")}
    for count, run in before.items():
        assert (after[count].id, after[count].content) == (run.id, run.content)
    text = MISSION_FILES["mission.yaml"].replace("there and back", "elsewhere")
    (folder / "mission.yaml").write_text(text)
    [other] = [run for run in load_sweep(folder / "sweep.yaml") if run.axes["team.0.count"] == 1]
    assert other.id == before[1].id
    assert other.content != before[1].content
    (folder / "mission.yaml").write_text(MISSION_FILES["mission.yaml"])
    (folder / "map.yaml").write_text(MISSION_FILES["map.yaml"].replace("q, 1", "q, 2"))
    [other] = [run for run in load_sweep(folder / "sweep.yaml") if run.axes["team.0.count"] == 1]
    assert other.content != before[1].content


def test_keys_that_a_mission_does_without_may_be_varied(folder):
    axes = "axes: {parameters: {horizon: [6, 9], objective: [[travel], [availability, travel]]}}\n"
    runs = runs_of(folder, HEAD + axes)
    assert [run.mission.horizon for run in runs] == [6, 6, 9, 9]
    assert [len(run.mission.objective) for run in runs] == [1, 2, 1, 2]


def test_runs_may_be_listed_and_missions_stand_inside(folder):
    inline = "\n".join(f"  {line}" for line in MISSION_FILES["mission.yaml"].splitlines())
    text = (
        f"format: tsplan-sweep/1\nmission:\n{inline}\n"
        """\
runs:
  - {seed: 3}
  - {parameters: {team.0.count: 5}, formula: "F[0,2] B", solver: {gap: 0.5}}
repeat: 2
"""
    )
    runs = runs_of(folder, text)
    assert [dict(run.axes) for run in runs[::2]] == [
        {"seed": 3, "repeat": 1},
        {"team.0.count": 5, "formula": "F[0,2] B", "solver": "default, gap 0.5", "repeat": 1},
    ]
    assert (runs[2].mission.size, runs[2].mission.horizon, runs[2].choice.gap) == (5, 2, 0.5)


def test_missions_over_signals_are_varied_too(folder):
    text = """\
format: tsplan-sweep/1
mission: signals.yaml
axes: {parameters: {signals.x.1: [6, 9], horizon: [3, 4]}, formulas: {late: "F[2,3] x >= 4"}}
"""
    runs = runs_of(folder, text)
    assert [run.mission.horizon for run in runs] == [3, 4, 3, 4]
    assert all("[2,3]" in run.mission.text for run in runs)


def test_a_map_may_be_varied(folder):
    (folder / "far.yaml").write_text(MISSION_FILES["map.yaml"].replace("q, 1", "q, 3"))
    text = HEAD + "axes: {parameters: {map: [map.yaml, far.yaml], map.edges.1.2: [1, 2]}}\n"
    systems = [run.mission.system for run in runs_of(folder, text)]
    durations = [
        [system.edges[pair].duration for pair in (("p", "q"), ("q", "p"))] for system in systems
    ]
    assert durations == [[1, 1], [1, 2], [3, 1], [3, 2]]


def test_findings_of_a_run_are_in_the_file_that_they_are_about(folder):
    text = (
        HEAD
        + """\
axes:
  parameters: {team.0.count: [1, 0], map.edges.0.1: [q, r]}
  formulas:
    good: F[0,3] B
    bad: |
      F[0,3] B &&
      F[0,3] sum(B, see >= 2
"""
    )
    told = set()
    for run in runs_of(folder, text):
        try:
            run.mission  # noqa: B018 - it is read
        except MissionError as error:
            told |= {str(item).replace(f"{folder}/", "") for item in error.findings}
    places = sorted(line.split(": ")[0] for line in told)
    assert places == ["map.yaml:1:1", "sweep.yaml:4:34", "sweep.yaml:4:57", "sweep.yaml:9:17"]


def test_a_path_that_goes_with_no_other_value_is_told_in_its_run(folder):
    axes = """\
axes:
  parameters:
    spec: [{language: mtl, formula: "F[0,3] B"}, {language: mtl, must: "F[0,3] B"}, "F[0,3] B"]
    spec.formula: ["F[0,2] B"]
"""
    first, both, text = runs_of(folder, HEAD + axes)
    assert first.mission.horizon == 2
    [finding] = findings(lambda: both.mission)
    assert "the formula is there twice" in finding
    [finding] = findings(lambda: text.mission)
    assert finding.startswith(f"{folder}/sweep.yaml:6:20: 'spec.formula' names nothing in the miss")
    assert first.content != both.content != text.content


WRONG = (
    HEAD
    + """\
axes:
  parameters:
    team.0.cont: [1]
    horizn: [2, 3]
    map.states.p.labels.3: [A]
    team..count: [1]
    objective.0: [travel, cost, travel]
  seeds: [1, 1]
  solvers: [{name: higs}, {without: [dyve]}]
"""
)


ALIKE = "leave one out, or use 'repeat' for several of a kind"
TOLD = f"""\
sweep.yaml:5:5: 'team.0.cont' names nothing in the mission: there is no 'cont' in 'team.0'; \
did you mean 'count'?
sweep.yaml:6:5: 'horizn' names nothing in the mission: there is no 'horizn'; \
did you mean 'horizon'?
sweep.yaml:7:5: 'map.states.p.labels.3' names nothing in the mission: there is no '3' in \
'map.states.p.labels'; known: 0
sweep.yaml:8:5: 'team..count' is no path; write it as in team.0.count
sweep.yaml:9:33: this makes the same runs as line 9 does; {ALIKE}
sweep.yaml:10:14: this makes the same runs as line 10 does; {ALIKE}
sweep.yaml:11:20: there is no solver 'higs'; did you mean 'highs'?
sweep.yaml:11:38: there is no idea 'dyve' to switch off; did you mean 'dive'?
"""


def test_everything_wrong_is_told_at_once(folder):
    assert "".join(f"{line}\n" for line in wrong(folder, WRONG)) == TOLD


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (HEAD, ["1:1: no axis is named"]),
        (HEAD + "axes: {}\n", ["3:7: no axis is named"]),
        (HEAD + "axes: {seeds: []}\n", ["3:15: seeds: 0 entries are too few"]),
        (HEAD + "axes: {parameters: {horizon: []}}\n", ["3:30: horizon: 0 entries are too few"]),
        (HEAD + "axes: {seads: [1]}\n", ["3:8: unknown key 'seads'; did you mean 'seeds'?"]),
        (HEAD + "runs: [{seed: 1}, {seed: 1}]\n", ["3:19: this makes the same runs as line 3"]),
        (HEAD + "runs: [{seed: 1}]\naxes: {seeds: [1]}\n", ["3:1: the runs are there twice"]),
        (HEAD + "repeat: 100001\n", ["3:9: 100,001 runs are more than 100,000"]),
        (HEAD + "repeat: 0\naxes: {seeds: [x]}\n", ["3:9: repeat: '0'", "4:16: seeds: 'x'"]),
        (
            "format: tsplan-sweep/1\nmission: misson.yaml\naxes: {seeds: []}\n",
            ["2:10: mission 'misson.yaml': there is no such file; did you mean", "3:15: seeds"],
        ),
        ("format: tsplan-sweep/1\nmission: 3\nrepeat: 2\n", ["2:10: the mission is neither"]),
        ("format: tsplan-sweep/1\naxes: {seeds: [1]}\n", ["1:1: 'mission' is missing"]),
    ],
)
def test_each_mistake_is_told_at_its_place(folder, text, told):
    lines = wrong(folder, text)
    assert len(lines) == len(told)
    for line, words in zip(lines, told, strict=True):
        assert line.removeprefix("sweep.yaml:").startswith(words)


def test_files_of_other_kinds_are_told_apart(folder):
    [line] = wrong(folder, MISSION_FILES["mission.yaml"])
    assert "this is a mission; name it as the 'mission' of a sweep" in line
    [line] = wrong(folder, HEAD.replace("mission.yaml", "map.yaml") + "repeat: 2\n")
    assert line.startswith("map.yaml:1:1: this is a map")
    (folder / "map.yaml").unlink()
    [line] = wrong(folder, HEAD + "repeat: 2\n")
    assert line == "mission.yaml:3:6: the map 'map.yaml' cannot be read; correct it first"
    done = here("plan", "sweep.yaml", folder=folder)
    assert (done.code, done.err.count("\n")) == (2, 1)
    assert "this is a sweep of missions; run all its missions by 'tsplan sweep'" in done.err


def test_a_folder_is_a_run_for_each_mission(folder):
    (folder / "torn.yaml").write_text("team: [")
    runs = runs_of_folder(folder)
    names = [run.axes["mission"] for run in runs]
    assert names == ["mission.yaml", "signals.yaml", "torn.yaml"]
    assert [run.mission.horizon for run in runs[:2]] == [6, 3]
    with pytest.raises(MissionError):
        runs[2].mission  # noqa: B018 - it is read
    # a mission as it stands has the digest of its file, by which plans find it
    text = (folder / "mission.yaml").read_text()
    assert runs[0].mission.digest == parse_document(text, "").digest
    (folder / "empty").mkdir()
    assert "there is no mission" in findings(runs_of_folder, folder / "empty")[0]


def test_parts_of_other_documents_keep_their_places():
    base = parse_document("a: {b: [1, 2]}\nc: text", "base")
    other = parse_document("x:\n- y: |\n    one\n    two\n", "other")
    patched = (
        Patchwork.of(base)
        .with_part(("a", "b", 1), other, ("x", 0))
        .with_part(("d",), other, ("x", 0, "y"))
    )
    document = patched.document
    assert document.data == {"a": {"b": [1, {"y": "one\ntwo\n"}]}, "c": "text", "d": "one\ntwo\n"}
    for path, place in [(("a", "b", 1, "y"), "other:4:5"), (("d",), "other:4:5"), (("c",), None)]:
        finding = document.finding(path, "wrong")
        if place is not None:  # the second letter of the second line of the text
            line, column = document.inside(path, 2, 1)
            finding = type(finding)("wrong", "", "base", line, column)
        assert str(patched.placed([finding])[0]) == f"{place or 'base:2:4'}: wrong"
    assert base.data == {"a": {"b": [1, 2]}, "c": "text"}
    with pytest.raises(KeyError):
        patched.with_part(("a", "nothing", "more"), other, ())
