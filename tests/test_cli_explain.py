"""`tsplan explain` from one end to the other: output, exit codes, files, misuse."""

from __future__ import annotations

import json
import os
import signal
from pathlib import Path

import pytest

import tsplan
from tests.command_line import linux, started
from tests.seeds import long
from tsplan.cli import main
from tsplan.mission import load_mission

FOLDER = Path(__file__).parents[1] / "environments"
MAP = """\
waiting: true
states: {p: {labels: [A]}, q: {labels: [B]}, r: {labels: [C]}}
edges:
  - {from: p, to: q, duration: 1, both_ways: true}
  - {from: q, to: r, duration: 2, both_ways: true}
"""
MISSION = """\
format: tsplan-mission/1
name: far away
map: map.yaml
team: [{class: a, count: 2, at: p, capabilities: [see]}]
spec:
  language: mtl
  formula: F[0,2] sum(C, see) >= 1 && F[0,9] A
objective: [travel]
"""
KINDS = {
    "fact": {
        "scarcity",
        "swarm",
        "reach",
        "capacity",
        "contradiction",
        "room",
        "timing",
        "delivery",
    },
    "tight": {"tight", "slack"},
    "part": {"formula", "team", "start", "carries", "stock", "capacity", "swarm"},
    "change": {
        "add_agents",
        "add_stock",
        "carry_more",
        "extend_deadline",
        "shorten_task",
        "lower_need",
        "loosen_limit",
        "more_subswarms",
        "edge",
    },
}


FILES = {"map.yaml": MAP, "mission.yaml": MISSION}


def asked(capsys, *words: str) -> tuple[int, str, str]:
    code = main(["explain", *words])
    out, err = capsys.readouterr()
    assert "Traceback" not in out + err
    return code, out, err


def test_an_explanation_is_printed(folder, capsys):
    code, out, err = asked(capsys, "mission.yaml")
    assert code == 0
    stages = [line.split()[0] for line in err.splitlines()]
    assert list(dict.fromkeys(stages)) == ["facts", "conflicts", "changes"]
    assert asked(capsys, "mission.yaml", "--quiet")[2] == ""
    lines = out.splitlines()
    assert lines[0] == "far away: there is no plan"
    assert "facts that forbid every plan:" in lines
    marked = lines.index("  7 |   formula: F[0,2] sum(C, see) >= 1 && F[0,9] A")
    assert lines[marked + 1] == "    |            " + "^" * len("F[0,2] sum(C, see) >= 1")
    assert "  4:33: the agents of class a start at 'p'" in lines
    assert any("extend the deadline 2 to 3 (1 step later)" in line for line in lines)
    assert any(line.split()[-2:] == ["1", "proven"] for line in lines)
    titles = ["facts that", "conflict:", "changes after"]
    places = [next(n for n, line in enumerate(lines) if line.startswith(t)) for t in titles]
    assert places == sorted(places)


def valid(text: str) -> dict:
    """The document, after a look at each of its fields."""
    data = json.loads(text)
    assert list(data) == [
        "format",
        "status",
        "facts",
        "conflicts",
        "changes",
        "likely",
        "cut_short",
        "timings",
    ]
    assert data["format"] == "tsplan-explanation/1"
    assert data["status"] in ("explained", "feasible", "no_answer")
    kinds = KINDS["tight" if data["status"] == "feasible" else "fact"]
    for fact in data["facts"]:
        located(fact, kinds)
    for conflict in data["conflicts"]:
        assert list(conflict) == ["minimal", "parts"]
        assert isinstance(conflict["minimal"], bool)
        assert conflict["parts"]
        for part in conflict["parts"]:
            located(part, KINDS["part"])
    for change in data["changes"]:
        assert list(change) == ["kind", "text", "amount", "proven", "within", "fix"]
        assert change["kind"] in KINDS["change"]
        assert change["text"]
        assert change["amount"] >= 1
        assert isinstance(change["proven"], bool)
    for likely in data["likely"]:
        located(likely, {"conflict", "change"})
    assert all(seconds >= 0 for seconds in data["timings"].values())
    return data


def located(item: dict, kinds: set[str]) -> None:
    assert list(item) == ["kind", "text", "line", "column"]
    assert item["kind"] in kinds
    assert item["text"]
    assert all(item[key] is None or item[key] >= 1 for key in ("line", "column"))


def test_json(folder, capsys):
    code, out, _ = asked(capsys, "mission.yaml", "--json")
    data = valid(out)
    assert code == 0
    assert data["status"] == "explained"
    assert data["conflicts"][0]["minimal"]
    assert data["conflicts"][0]["parts"][0] == {
        "kind": "formula",
        "text": "F[0,2] sum(C, see) >= 1",
        "line": 7,
        "column": 12,
    }
    assert {"facts", "conflicts", "changes", "total"} <= set(data["timings"])


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        long("farm_overbooked", "scarcity"),
        long("office_closed", "contradiction"),
        long("office_double", "timing"),
        long("office_lift", None),
        long("reef_thin", "swarm"),
        long("rescue_late", "reach"),
        ("site_late", "delivery"),
    ],
)
def test_the_environments_name_their_cause(name, kind, capsys):
    code, out, _ = asked(capsys, str(FOLDER / f"{name}.yaml"), "--json")
    data = valid(out)
    assert code == 0
    assert data["status"] == "explained"
    assert {fact["kind"] for fact in data["facts"]} == ({kind} if kind else set())
    assert all(conflict["minimal"] for conflict in data["conflicts"])
    assert data["changes"]
    assert all(change["proven"] for change in data["changes"])
    if name == "office_lift":
        assert data["conflicts"][0]["parts"][-1]["kind"] == "capacity"


def test_several_conflicts(folder, capsys):
    text = MISSION.replace("F[0,9] A", "F[0,9] sum(A) >= 3")
    (folder / "mission.yaml").write_text(text)
    _, out, _ = asked(capsys, "mission.yaml")
    assert "conflict: these cannot hold together" in out
    _, out, _ = asked(capsys, "mission.yaml", "--all")
    assert "conflict 1: " in out
    assert "conflict 2: " in out


def test_a_mission_that_can_be_met(folder, capsys):
    (folder / "mission.yaml").write_text(MISSION.replace("F[0,2]", "F[0,5]"))
    code, out, _ = asked(capsys, "mission.yaml", "--slack")
    assert code == 0
    assert out.splitlines()[0] == "far away: there is a plan"
    assert "the deadline 5 could be 2 steps sooner, at 3" in " ".join(out.split())
    _, out, _ = asked(capsys, "mission.yaml", "--json")
    assert valid(out)["status"] == "feasible"


def test_no_time(folder, capsys):
    code, out, _ = asked(
        capsys, str(FOLDER / "warehouse_orders.yaml"), "--time-limit", "0.01", "--json"
    )
    assert code == 4
    assert valid(out)["status"] == "no_answer"
    code, out, _ = asked(capsys, str(FOLDER / "warehouse_orders.yaml"), "--time-limit", "0.01")
    assert code == 4
    assert "try a longer time limit" in out


def test_facts_are_an_answer_without_time(capsys):
    code, out, _ = asked(
        capsys, str(FOLDER / "office_double.yaml"), "--time-limit", "0.0001", "--json"
    )
    assert code == 0
    data = valid(out)
    assert data["status"] == "explained"
    assert data["facts"]


def test_a_fix_is_written_and_can_be_planned(folder, capsys):
    code, out, err = asked(capsys, "mission.yaml", "--fix", "1", "-o", "fixed.yaml", "--quiet")
    assert code == 0
    assert err == ""
    first = next(line for line in out.splitlines() if line.lstrip().startswith("1 "))
    assert first.rstrip().endswith("proven")
    assert main(["plan", "fixed.yaml", "--quiet"]) == 0
    assert tsplan.plan(load_mission(folder / "fixed.yaml")).verified


def test_a_fix_in_another_folder_still_finds_the_map(folder, capsys):
    (folder / "elsewhere").mkdir()
    assert asked(capsys, "mission.yaml", "--fix", "1", "-o", "elsewhere/fixed.yaml")[0] == 0
    assert load_mission(folder / "elsewhere" / "fixed.yaml").system.states


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (["--fix", "1"], "--fix and -o need each other"),
        (["-o", "x.yaml"], "--fix and -o need each other"),
        (["--fix", "99", "-o", "x.yaml"], "there is no change 99; there are"),
        (["--fix", "1", "-o", "nowhere/x.yaml"], "nowhere"),
        (["--solver", "abacus"], "abacus"),
    ],
)
def test_misuse(folder, capsys, words, complaint):
    code, _, err = asked(capsys, "mission.yaml", *words)
    assert code == 2
    assert complaint in err
    assert not (folder / "x.yaml").exists()


@pytest.mark.parametrize("words", [["--fix", "0"], ["--time-limit", "-1"], ["--fix", "one"]])
def test_values_that_make_no_sense(folder, capsys, words):
    code, _, err = asked(capsys, "mission.yaml", *words)
    assert code == 2
    assert words[0] in err


def test_a_label_that_no_state_carries(folder, capsys):
    (folder / "mission.yaml").write_text(MISSION.replace("sum(C, see)", "sum(Cc, see)"))
    code, _, err = asked(capsys, "mission.yaml")
    assert code == 2
    assert "mission.yaml:7:" in err
    assert "'Cc'" in err


def test_a_capability_that_nobody_has(folder, capsys):
    (folder / "mission.yaml").write_text(MISSION.replace("sum(C, see)", "sum(C, lift)"))
    code, out, _ = asked(capsys, "mission.yaml")
    assert code == 0
    assert "1 agent with lift is needed at 'C'; the team has none" in " ".join(out.split())


def test_a_state_without_a_way(folder, capsys):
    (folder / "map.yaml").write_text(MAP.replace("  - {from: q, to: r", "  - {from: r, to: q"))
    (folder / "map.yaml").write_text(
        (folder / "map.yaml").read_text().replace("duration: 2, both_ways: true", "duration: 2")
    )
    code, out, _ = asked(capsys, "mission.yaml")
    assert code == 0
    assert "there is no way for class a from 'p'" in " ".join(out.split())


def test_plans_that_fail_point_here(folder, capsys):
    assert main(["plan", "mission.yaml"]) == 3
    assert "tsplan explain mission.yaml" in capsys.readouterr().err


@linux
def test_interruption_keeps_what_is_known():
    code = (
        "import sys; from tsplan.cli import main; "
        f"sys.exit(main(['explain', {str(FOLDER / 'warehouse_orders.yaml')!r}]))"
    )
    with started(code) as child:
        assert child.stderr.readline().startswith("facts  ")  # the search has begun
        os.killpg(child.pid, signal.SIGINT)
        out, err = child.communicate(timeout=60)
    assert "Traceback" not in err
    assert child.returncode in (0, 4)
    assert "orders: " in out
