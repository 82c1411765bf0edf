"""Carrying out plans: by chance, with robots of another process, and where either is killed."""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

import tsplan
from tests.command_line import ROOT, here, posix, started
from tests.seeds import sampled, seed_blocks
from tests.watched_fleet import Watched, slack
from tsplan import Mission, Plan
from tsplan.draw.trial_chart import draw_trial
from tsplan.errors import InputError, MissionError
from tsplan.logic import parse
from tsplan.mission import Preference
from tsplan.plans.worlds import OnEdge
from tsplan.replanning.execution import Execution
from tsplan.replanning.execution_journal import ExecutionJournal, seen_from
from tsplan.replanning.robot_fleet import Seen, difference
from tsplan.replanning.robot_process import RobotProcess, RobotsError
from tsplan.replanning.simulated_fleet import Chances, SimulatedFleet
from tsplan.testing import random_mission

SIMULATOR = ROOT / "environments" / "robots" / "simulator.py"
MISSION = """\
format: tsplan-mission/1
name: rounds
map:
  waiting: true
  states: {base: {}, hall: {}, north: {labels: [rooms]}, south: {labels: [rooms]}}
  edges:
    - {from: base, to: hall, duration: 1, both_ways: true}
    - {from: hall, to: north, duration: 2, both_ways: true}
    - {from: hall, to: south, duration: 2, both_ways: true}
    - {from: north, to: south, duration: 5, both_ways: true}
team: [{class: cart, count: 3, at: base}]
spec: {language: mtl, formula: "F[0,12] min(rooms) >= 1 && F[14,24] sum(base) >= 2"}
objective: [availability, travel]
"""


def executable(seed: int) -> tuple[Mission, Plan] | None:
    mission = random_mission(seed, states=5, most_agents=5, steps=8)
    if mission.delay or "delay" in mission.objective or mission.partial or mission.prefer:
        return None
    plan = tsplan.plan(mission)
    return (mission, plan) if plan.has_paths else None


@pytest.mark.parametrize("seeds", seed_blocks(range(15), range(1500), 30))
def test_what_happened_is_what_robots_did_and_planning_again_helps(seeds: list[int]) -> None:
    met = {False: 0, True: 0}
    for seed in seeds:
        made = executable(seed)
        if made is None:
            continue
        mission, plan = made
        for replanning in met:
            fleet = Watched(mission, Chances(0.2, 0.02, 0.05), seed)
            done = Execution(mission, plan, fleet, tsplan.plan if replanning else None).run()
            for step, places in enumerate(fleet.states):
                told = {name: state for name, state in done.plan.state_at(step).items() if state}
                assert told == {name: state for name, state in places.items() if state}, seed
            assert done.availability == slack(mission, fleet), seed
            if done.met and replanning:
                assert tsplan.check(mission, done.plan).ok, seed
            met[replanning] += done.met
    assert met[True] >= met[False]


def test_where_nothing_happens_the_plan_is_carried_out() -> None:
    mission = tsplan.mission_from_text(MISSION)
    plan = tsplan.plan(mission)
    done = Execution(mission, plan, SimulatedFleet(mission, Chances(), 0), tsplan.plan).run()
    assert (done.plan, done.adapted, done.replanned) == (plan, 0, ())


@pytest.mark.parametrize("seed", [129, 324])
def test_where_nobody_is_left_the_rest_happens_without(seed: int) -> None:
    made = executable(seed)
    assert made is not None
    mission, plan = made
    for planner in (None, tsplan.plan):
        fleet = Watched(mission, Chances(0.2, 0.02, 0.05), seed)
        done = Execution(mission, plan, fleet, planner).run()
        assert not any(fleet.states[-1].values())
        assert not any(done.plan.state_at(mission.horizon).values())
        assert done.availability == slack(mission, fleet)
        assert tsplan.check(mission, done.plan).ok == done.met
        assert not tsplan.check(mission, replace(done.plan, availability=17.0)).ok


def test_a_trial_says_how_often_the_formula_held() -> None:
    mission = tsplan.mission_from_text(MISSION)
    plan = tsplan.plan(mission)
    trial = tsplan.execute(mission, plan, runs=6, delay=0.4, loss=0.02)
    assert trial.replanned is not None
    assert trial.replanned.times >= trial.kept.times
    assert trial.replanned.runs == trial.kept.runs == len(trial.runs) == 6
    assert str(trial).splitlines()[0].startswith("6 runs (seeds 0..5)")
    assert [run["seed"] for run in json.loads(trial.to_json())["runs"]] == list(range(6))
    alone = tsplan.execute(mission, plan, runs=6, delay=0.4, loss=0.02, replanning=False)
    assert (alone.kept, alone.replanned) == (trial.kept, None)
    with pytest.raises(InputError, match="delay: "):
        tsplan.execute(mission, plan, delay=1.5)


def in_part(seed: int) -> tuple[Mission, Plan] | None:
    """A mission whose formula, or what is preferred, may hold in part."""
    mission = random_mission(seed, states=5, most_agents=5, steps=8)
    if mission.delay or "delay" in mission.objective:
        return None
    wish = Preference(mission.formula, name="wish")
    if seed % 2:
        mission = replace(mission, objective=("satisfaction", "travel"), prefer=())
    else:
        soft = {"formula": parse("sum(a) >= 0"), "text": "", "objective": ("preferences", "travel")}
        mission = replace(mission, prefer=(wish,), **soft)
    plan = tsplan.plan(mission)
    return (mission, plan) if plan.has_paths else None


@pytest.mark.parametrize("seeds", seed_blocks(range(20), range(20, 600), 20))
def test_what_holds_in_part_is_told_as_it_was(seeds: list[int]) -> None:
    for seed in seeds:
        mission, plan = in_part(seed) or (None, None)
        for planner in (None, tsplan.plan) if mission else ():
            fleet = Watched(mission, Chances(0.4, 0.02, 0.1), seed)
            done = Execution(mission, plan, fleet, planner).run()
            assert done.availability == slack(mission, fleet), seed
            assert tsplan.check(mission, Plan.from_json(done.plan.to_json())).ok, seed
            soft = done.plan.satisfaction
            if soft is not None:
                assert done.satisfaction == soft.fraction
            if done.plan.preferences:
                said = tuple(wish.fraction for wish in done.plan.preferences)
                assert done.preferences == said
            if mission.partial:
                assert (done.satisfaction == 1) == done.met


def test_more_holds_in_part_where_it_is_planned_again() -> None:
    text = MISSION.replace("[availability, travel]", "[satisfaction, travel]")
    wishes = MISSION.replace("[availability, travel]", "[preferences, travel]").replace(
        'formula: "F[0,12] min(rooms) >= 1 && F[14,24] sum(base) >= 2"',
        "formula: 'sum(base) >= 0', prefer: [{formula: 'F[0,12] min(rooms) >= 1'},"
        " {formula: 'F[14,24] sum(base) >= 2', level: 1}]",
    )
    for written in (text, wishes):
        mission = tsplan.mission_from_text(written)
        trial = tsplan.execute(mission, tsplan.plan(mission), runs=12, delay=0.3, loss=0.02)
        kept, again = [], []
        for run in trial.runs:
            assert run.replanned is not None
            kept.append(run.kept.satisfaction or sum(run.kept.preferences))
            again.append(run.replanned.satisfaction or sum(run.replanned.preferences))
        assert sum(again) > sum(kept)
        assert trial.seconds
        assert "on average" in str(trial) or "of what is preferred held" in str(trial)
        told = json.loads(trial.to_json())["runs"][0]
        assert {"kept_satisfaction", "kept_preferences"} & told.keys()


def test_what_cannot_be_carried_out_is_refused() -> None:
    text = MISSION.replace("availability, travel", "{satisfaction: depth}, travel")
    mission = tsplan.mission_from_text(text.replace("F[14,24]", "G[0,2] F[14,24]"))
    with pytest.raises(MissionError, match="windows in windows"):
        tsplan.execute(mission, tsplan.plan(mission), runs=1)
    with pytest.raises(MissionError, match="planned in pieces"):
        tsplan.plan_in_pieces(mission, 8, 4)


def test_what_is_seen_becomes_a_world() -> None:
    planned = {"a": "q1", "b": OnEdge("q1", "q2", 5), "c": "q2", "d": "q1", "e": "q3"}
    seen = Seen(
        4, {"a": "q1", "b": ("q1", "q2"), "c": ("q1", "q2"), "d": None, "e": "q4", "x": "q1"}
    )
    world = difference(4, planned, seen)
    assert world is not None
    assert (world.step, world.lost, world.late, world.moved) == (4, ("d",), {"c": 1}, {"e": "q4"})
    assert difference(4, planned, Seen(4, {"a": "q1"})) is None
    failed = difference(4, planned, Seen(4, {"b": "q1"}))
    assert failed is not None
    assert failed.moved == {"b": "q1"}


def test_a_trial_is_drawn(tmp_path) -> None:
    mission = tsplan.mission_from_text(MISSION)
    plan = tsplan.plan(mission)
    trial = tsplan.execute(mission, plan, runs=4, delay=0.6)
    _, (shares, _) = draw_trial(trial)
    assert trial.replanned is not None
    heights = [bar.get_height() for bar in shares.patches]
    assert heights == [trial.kept.rate, trial.replanned.rate]
    with pytest.raises(InputError, match="no run to draw"):
        draw_trial(tsplan.Trial(trial.chances))
    files = [tmp_path / name for name in ("mission.yaml", "plan.json", "trial.png")]
    files[0].write_text(MISSION, encoding="utf-8")
    tsplan.save_plan(plan, files[1])
    given = [*map(str, files[:2]), "--runs", "2", "--quiet", "--plot", str(files[2])]
    assert here("execute", *given).code == 0
    assert files[2].read_bytes().startswith(b"\x89PNG")


# --- robots of another process --------------------------------------------------------------------


@pytest.fixture
def rounds(tmp_path) -> tuple[Path, Path]:
    """The files of a mission and of its plan."""
    mission, plan = tmp_path / "mission.yaml", tmp_path / "plan.json"
    mission.write_text(MISSION, encoding="utf-8")
    tsplan.save_plan(tsplan.plan(str(mission)), plan)
    return mission, plan


def robots(*options: str) -> str:
    return " ".join([sys.executable, str(SIMULATOR), *options])


def test_robots_carry_out_a_plan(rounds, tmp_path) -> None:
    mission, plan = rounds
    out, journal = tmp_path / "executed.json", tmp_path / "journal.jsonl"
    done = here(
        *("execute", str(mission), str(plan), "--robots", robots("--late", "0")),
        *("--journal", str(journal), "-o", str(out), "--quiet"),
    )
    assert (done.code, done.err) == (0, "")
    assert done.out.startswith("the formula held")
    executed, planned = tsplan.load_plan(out), tsplan.load_plan(plan)
    assert executed.agents == planned.agents
    steps = [json.loads(line)["seen"]["step"] for line in journal.read_text().splitlines()[1:]]
    assert steps == list(range(1, planned.horizon + 1))


def test_robots_may_all_be_lost(rounds, tmp_path) -> None:
    mission, plan = rounds
    out = tmp_path / "executed.json"
    done = here(
        *("execute", str(mission), str(plan), "--robots", robots("--late", "0", "--lost", "1")),
        *("--journal", str(tmp_path / "journal.jsonl"), "-o", str(out), "--quiet"),
    )
    assert done.code == 1
    assert done.out.startswith("the formula did not hold")
    assert not any(tsplan.load_plan(out).state_at(1).values())
    told = here("check", str(mission), str(out)).out.splitlines()
    assert told == [f"{out}: the formula does not hold (its availability is -2)"]
    trial = tsplan.execute(mission, plan, runs=2, loss=0.999)
    assert str(trial).endswith("it was never planned again: it worked, or nobody was left")


@posix
@pytest.mark.parametrize("killed", sampled(["robots", "planner"], ["planner"]))
def test_no_step_is_lost_where_a_process_is_killed(rounds, tmp_path, killed: str) -> None:
    mission, plan = rounds
    slow = tmp_path / "slow.py"
    slow.write_text(
        "import os, runpy, sys, time\n"
        f"sys.argv[0] = {str(SIMULATOR)!r}\n"
        "lines, count = sys.stdin, 0\n"
        "class Slow:\n"
        "    def __iter__(self):\n"
        "        for count, line in enumerate(lines):\n"
        "            time.sleep(0.1)\n"
        f"            if count == 6 and {killed == 'robots'} and not os.path.exists('again'):\n"
        "                open('again', 'w').close()\n"
        "                os.kill(os.getpid(), 9)\n"
        "            yield line\n"
        "sys.stdin = Slow()\n"
        f"runpy.run_path({str(SIMULATOR)!r}, run_name='__main__')\n"
    )
    journal = tmp_path / "journal.jsonl"
    given = ["execute", str(mission), str(plan), "--quiet", "--journal", str(journal)]
    given += ["--robots", f"{sys.executable} {slow} --late 0.3"]
    code = (
        "import os, sys\n"
        f"os.chdir({str(tmp_path)!r})\n"
        "from tsplan.cli import main\n"
        "sys.exit(main(sys.argv[1:]))\n"
    )
    with started(code, *given) as process:
        if killed == "planner":
            until = time.monotonic() + 60
            while time.monotonic() < until and len(_seen(journal)) < 4:
                time.sleep(0.05)
            os.kill(process.pid, signal.SIGKILL)
        _, err = process.communicate(timeout=60)
    before = _seen(journal)
    assert len(before) >= 4
    if killed == "robots":
        assert process.returncode == 5
        assert "the robots have ended" in err
        assert "the same command goes on from there" in err
    with started(code, *given) as process:
        out, err = process.communicate(timeout=60)
    assert process.returncode in (0, 1), err
    after = _seen(journal)
    assert after[: len(before)] == before
    assert [seen["step"] for seen in after] == list(range(1, tsplan.load_plan(plan).horizon + 1))
    assert "the formula" in out


def _seen(journal: Path) -> list[dict]:
    """What the journal has seen, in whole lines."""
    text = journal.read_text() if journal.exists() else ""
    entries = [json.loads(line) for line in text.split("\n")[:-1]]
    return [entry["seen"] for entry in entries if "seen" in entry]


@pytest.mark.parametrize(
    ("program", "words"),
    [
        ("print('hello')", "no JSON object"),
        ("print('{}')", "should say that they are ready"),
        ("input()", "have ended after begin"),
        ("import time; time.sleep(9)", "have said nothing for 0.5 s"),
        (
            """print('{"type": "ready"}'); input(); input(); print('{"step": 7}')""",
            "tell what is seen",
        ),
        (
            """print('{"type": "ready"}'); input(); input(); print('{"agents": {}}')""",
            "'step' is missing",
        ),
    ],
)
def test_what_robots_say_wrong_is_told(program: str, words: str) -> None:
    fleet = RobotProcess(
        f'{sys.executable} -u -c "{_quoted(program)}"',
        patience=0.5 if "sleep" in program else 20,
        grace=0.1,
    )
    try:
        with pytest.raises(RobotsError, match=words):
            _asked(fleet)
    finally:
        fleet.end()


def _asked(fleet: RobotProcess) -> None:
    fleet.begin(0, {"a": "q1"})
    fleet.advance(0, [])


def _quoted(program: str) -> str:
    return program.replace('"', '\\"')


def test_a_command_that_is_none_is_told() -> None:
    with pytest.raises(RobotsError, match="cannot be started"):
        RobotProcess("/there/is/no/such/program").begin(0, {})


def test_a_journal_of_something_else_is_refused(rounds, tmp_path) -> None:
    mission, plan = rounds
    journal = tmp_path / "journal.jsonl"
    journal.write_text('{"plan": 3}\n')
    with pytest.raises(InputError, match="no journal of an execution"):
        ExecutionJournal(journal).read("")
    other = ExecutionJournal(tmp_path / "other.jsonl")
    other.begin(tsplan.load_plan(plan))
    with pytest.raises(InputError, match="of another mission"):
        other.read("0")
    assert ExecutionJournal(tmp_path / "none.jsonl").read("") is None
    alone = here("execute", str(mission), str(plan), "--journal", str(journal))
    assert (alone.code, "--robots" in alone.err) == (2, True)


@pytest.mark.parametrize(
    "data",
    [
        3,
        {},
        {"step": True},
        {"step": 1, "agents": []},
        {"step": 1, "agents": {"a": 3}},
        {"step": 1, "closed": [3]},
    ],
)
def test_what_nobody_can_have_seen_is_refused(data) -> None:
    with pytest.raises(ValueError, match=r"\w"):
        seen_from(data)


def test_a_plan_that_nobody_has_judged_is_carried_out() -> None:
    mission = tsplan.mission_from_text(MISSION)
    plan = replace(tsplan.plan(mission), verified=False)
    done = Execution(mission, plan, SimulatedFleet(mission, Chances(), 0)).run()
    assert (done.met, done.plan.verified) == (True, True)
    assert done.plan.value("travel") == plan.value("travel")
