"""Missions whose answers are known, here and in `environments`: through Python and as a command.

On the command line stderr is a pipe or a terminal, and progress is told on it.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import tsplan
from tests.command_line import MISTAKES, here, on_terminal, terminals
from tests.joint_plans import SENSE, best
from tsplan.errors import InputError
from tsplan.mission import load_mission
from tsplan.plans.plan import Plan
from tsplan.signals.signal_files import load_any_mission
from tsplan.signals.trajectory import Trajectory
from tsplan.testing import Expectation, expectations, run_corpus
from tsplan.testing.corpus import planned

CORPUS = Path(__file__).resolve().parent / "corpus"
ENVIRONMENTS = CORPUS.parents[1] / "environments"
SIGNALS = ENVIRONMENTS / "signals"
EXPECTED = expectations(CORPUS)
OWN = [item for item in EXPECTED if item.path.parent == CORPUS]
# what is run as a command by default: one of each kind, the rest under `long`
COMMANDS = (
    "team_availability",
    "tasks",
    "infeasible_edge",
    "swarms_together",
    "mixed_splits",
    "partial_depth",
    "partial_swarm",
    "preferences_team",
    "linear",
    "too_late",
)
ON_TERMINALS = ("swarm_splits",)
OBJECTIVES = (*SENSE, "satisfaction", "preferences")
# take half a second or more
SLOW = (
    "farm_shortage",
    "keys",
    "meeting",
    "office_delivery",
    "office_wishes",
    "partial",
    "rescue_evacuation",
    "site_haulage",
)
SEARCHED = ("either_or", "keys")  # take long without the search of the tight encoding
LARGE = "tasks"  # has too many joint plans to look at
MANY = (
    "swarms_together",
    "mixed_availability",
    "swarm_moves",
    "team_agents",
)  # joint plans, so that it takes long


def whole(item: Expectation) -> bool:
    """Whether the formula of a mission is to hold, and nothing else."""
    return not {"satisfaction", "preferences"} & set(item.values)


def of_signals(item: Expectation) -> bool:
    """Whether a mission is one over signals."""
    return item.path.parent.resolve() == SIGNALS


def parameters(*, commands: tuple[str, ...] | None = None) -> list[object]:
    """The corpus, with the mark of what takes long or is not among some commands."""
    return [
        pytest.param(
            item,
            id=item.name,
            marks=pytest.mark.long
            if item.long
            or item.name in SLOW
            or (commands is not None and item.name not in commands)
            else (),
        )
        for item in EXPECTED
    ]


@pytest.mark.parametrize("item", parameters())
def test_the_planner_gives_what_is_expected(item: Expectation) -> None:
    assert item.differences(planned(load_any_mission(item.path))) == ()


@pytest.mark.parametrize(
    "item",
    [
        pytest.param(item, id=item.name, marks=[pytest.mark.long] * (item.name in SLOW))
        for item in EXPECTED
        if of_signals(item) and item.name not in SEARCHED
    ],
)
def test_the_reference_says_the_same_of_signals(item: Expectation) -> None:
    mission = load_any_mission(item.path)
    assert item.differences(tsplan.synthesise(mission, encoding="reference")) == ()


def judge_command(item: Expectation, folder: Path, run) -> None:
    """The plan that a command writes and prints is what is expected, and so is its exit code."""
    arguments = ["plan", str(item.path), "-o", "plan.json", "--json"]
    code, out, err = run(*arguments, folder=folder)
    assert code == (3 if item.status == "infeasible" else 0), err
    assert not any(word in err for word in MISTAKES)
    plan = json.loads(out, parse_constant=pytest.fail)
    assert json.loads((folder / "plan.json").read_text(encoding="utf-8")) == plan
    result = Trajectory if of_signals(item) else Plan
    assert item.differences(result.from_json(out)) == ()
    if item.status != "infeasible" and of_signals(item):
        assert run("check", str(item.path), "plan.json", folder=folder)[0] == 0


@pytest.mark.parametrize("item", parameters(commands=COMMANDS))
def test_the_command_line_gives_what_is_expected(item: Expectation, tmp_path: Path) -> None:
    judge_command(item, tmp_path, here)


@terminals
@pytest.mark.parametrize("item", parameters(commands=ON_TERMINALS))
def test_the_command_line_gives_the_same_on_a_terminal(item: Expectation, tmp_path: Path) -> None:
    judge_command(item, tmp_path, on_terminal)


@pytest.mark.parametrize(
    "item",
    [
        pytest.param(item, id=item.name, marks=[pytest.mark.long] * (item.name in MANY))
        for item in OWN
        if whole(item) and item.name != LARGE
    ],
)
def test_all_joint_plans_say_the_same(item: Expectation) -> None:
    mission = load_mission(item.path)
    expected = best(mission)
    assert (expected is None) == (item.status == "infeasible")
    if expected is not None:
        values = [
            SENSE[name] * (float("inf") if value is None else value)
            for name, value in item.values.items()
        ]
        assert list(expected) == pytest.approx(values)


def test_every_objective_and_every_mission_is_there() -> None:
    named = {name for item in OWN for name in item.values}
    assert named == set(OBJECTIVES)
    shipped = {path.resolve() for path in [*ENVIRONMENTS.glob("*_*.yaml"), *SIGNALS.glob("*.yaml")]}
    assert shipped == {item.path.resolve() for item in EXPECTED if item not in OWN}
    maps = {"lane.yaml", "crossing.yaml", "expected.yaml"}
    assert {path.name for path in CORPUS.iterdir()} == maps | {item.path.name for item in OWN}


def test_the_runner_tells_every_difference() -> None:
    names = ["team_travel", "infeasible_time", "swarm_splits"]
    assert run_corpus(CORPUS, names=names) == ()
    other = tsplan.plan(load_mission(CORPUS / "team_travel.yaml"))
    found = run_corpus(CORPUS, names=[*names, "team_cost"], planner=lambda _: other)
    assert [(Path(item.source or "").stem, item.message) for item in found] == [
        ("infeasible_time", "planning ended with 'optimal' instead of 'infeasible'"),
        ("swarm_splits", "its objectives are ['travel'] instead of ['splits', 'travel']"),
        ("team_cost", "its objectives are ['travel'] instead of ['cost', 'makespan']"),
    ]


def test_what_takes_long_is_planned_on_request() -> None:
    seen: list[str] = []
    other = tsplan.plan(load_mission(CORPUS / "team_travel.yaml"))

    def plan(mission: tsplan.Mission) -> Plan:
        seen.append(mission.name)
        return other

    for long in (False, True):
        seen.clear()
        run_corpus(CORPUS, long=long, planner=plan)
        assert len(seen) == sum(long or not item.long for item in EXPECTED)
    assert 0 < sum(item.long for item in EXPECTED) < len(EXPECTED)


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ("missions: {}", "'format' is missing"),
        ("format: tsplan-corpus/1\nmissions: {}", "missions"),
        ("format: tsplan-corpus/1\nmissions: {a.yaml: {status: fine}}", "2:29: status"),
        ("format: tsplan-corpus/1\nmissions: {a.yaml: {status: optimal, value: {}}}", "'values'"),
        ("format: tsplan-corpus/1\nmissions: {a.yaml: {status: optimal}}", "there is no file"),
    ],
)
def test_a_mistake_in_the_table_is_found_at_its_place(tmp_path, table, words) -> None:
    (tmp_path / "expected.yaml").write_text(table)
    with pytest.raises(InputError, match=words):
        run_corpus(tmp_path)


def test_unknown_names_are_refused() -> None:
    with pytest.raises(InputError, match="there is no mission 'swarm_split'; did you mean"):
        run_corpus(CORPUS, names=["swarm_split"])
    with pytest.raises(InputError, match=r"expected\.yaml: there is no such file"):
        expectations(CORPUS.parent)
