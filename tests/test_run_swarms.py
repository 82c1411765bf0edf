"""The way of a swarm mission from its encoder's answer to plan, events, files and commands."""

from __future__ import annotations

import json
import re
from itertools import chain

import pytest

import tsplan
from tests.seeds import long, sampled
from tests.swarm_lane import MOVES, SYSTEM, VALUES, mission
from tsplan.cli import main
from tsplan.errors import SolverError, TsplanError
from tsplan.mission import Mission
from tsplan.plans.bundles import Agents
from tsplan.plans.decomposition import paths_of
from tsplan.plans.outcomes import ObjectiveValue
from tsplan.run import mission_run, paths, point_reading
from tsplan.run.events import FINISHING, Bound, Incumbent, Stage
from tsplan.search.lexicographic import Outcome
from tsplan.stopping import StoppedBy
from tsplan.ts import Edge, State, TransitionSystem

MAP = """\
name: lane
waiting: true
states: {dock: {labels: [dock]}, aisle: {labels: [aisle]}, gate: {labels: [gate]}}
edges: [[dock, aisle, 2], [aisle, gate, 1], [dock, gate, 3]]
"""
MISSION = """\
format: tsplan-mission/1
name: half way
map: map.yaml
swarm: {size: 120, at: dock, max_subswarms: %s, min_subswarm: 10}
spec: {language: mtl, formula: "F[0,6] (sum(aisle) >= 50%% && sum(gate) >= 50%%)"}
"""


def answers(monkeypatch, told=(), **changes):
    """Let the encoder of swarms answer so, after telling something first."""
    answer = {
        "point": {"swarm": MOVES},
        "reached": tuple(ObjectiveValue(name, value, value) for name, value in VALUES.items()),
        "proven": True,
        "infeasible": False,
        "stopped_by": None,
        "size": (9, 8, 7, 6),
        "levels": (),
        "notes": (),
    } | changes

    def solve(problem, effort, clock, tell):
        assert effort.solver.name == "highs"
        for item in told:
            tell(*item)
        answer["stop"] = clock.over
        return Outcome(**{key: value for key, value in answer.items() if key != "stop"})

    def ways(setting, moves, seed):
        few = setting.mission.size <= paths.MOST_AGENTS
        ranks = setting.mission.ranks
        made = paths_of(setting.mission, ranks, moves["swarm"]) if few else ()
        return {"moves": moves, "agents": Agents.along(chain.from_iterable(made))}

    monkeypatch.setattr(tsplan.Problem, "solve", solve)
    for reader in (mission_run, point_reading):
        monkeypatch.setattr(reader, "ways_of", ways)
    return answer


def test_an_answer_becomes_a_verified_plan(monkeypatch):
    answers(monkeypatch)
    plan = tsplan.plan(mission())
    assert (plan.status, plan.verified, plan.stopped_by) == ("optimal", True, None)
    assert plan.moves == {"swarm": MOVES}
    assert len(plan.groups) == 7
    assert len(plan.agents) == 12
    assert {item.name: item.bound for item in plan.objective} == VALUES
    assert (plan.size.columns, plan.size.nonzeros, plan.size.states) == (9, 6, 3)
    assert plan.solver.name == "highs"
    assert plan.timings.total > 0


def test_many_agents_get_no_paths_of_their_own(monkeypatch):
    answers(monkeypatch, reached=())
    monkeypatch.setattr(paths, "MOST_AGENTS", 11)
    given = mission(objective=[])
    plan = tsplan.plan(given)
    assert plan.agents == ()
    assert "agents" not in vars(given)
    assert tsplan.assign(given, plan).agents


def test_other_ends(monkeypatch):
    nothing = {"point": None, "reached": (), "proven": False}
    answers(monkeypatch, **nothing, infeasible=True)
    assert tsplan.plan(mission()).status == "infeasible"
    answers(monkeypatch, **nothing, stopped_by=StoppedBy.TIME_LIMIT)
    plan = tsplan.plan(mission())
    assert (plan.status, plan.stopped_by) == ("no_plan_found", "time_limit")
    answers(
        monkeypatch,
        proven=False,
        stopped_by=StoppedBy.GAP,
        reached=(ObjectiveValue("splits", 2, 1),),
    )
    plan = tsplan.plan(mission(objective=["splits"]))
    assert (plan.status, plan.stopped_by, plan.objective[0].bound) == ("feasible", "gap", 1)


def test_a_wrong_answer_is_never_shown(monkeypatch):
    answers(monkeypatch, point={"swarm": MOVES[:-1]})
    with pytest.raises(TsplanError, match="not conserved"):  # already on the way to paths
        tsplan.plan(mission())
    monkeypatch.setattr(paths, "MOST_AGENTS", 0)
    with pytest.raises(SolverError, match="does not stand up to the check"):
        tsplan.plan(mission())
    answers(monkeypatch, reached=(ObjectiveValue("splits", 1, 1),))
    with pytest.raises(SolverError, match="called optimal at 2 with the bound 1"):
        tsplan.plan(mission(objective=["splits"]))


def test_events_tell_of_plans_on_the_way(monkeypatch):
    told = [
        ("first plan", None, None, None),
        ("splits", {"swarm": MOVES}, 2.0, 0.0),
        ("splits", None, 2.0, 1.0),
    ]
    answer = answers(monkeypatch, told)
    heard = []

    def listen(event):
        heard.append(event)
        return isinstance(event, Bound)

    tsplan.plan(mission(), on_event=listen)
    assert [type(event) for event in heard] == [Stage, Incumbent, Bound, Stage]
    assert heard[-1].name == FINISHING
    plan = heard[1].plan()
    assert plan.verified
    assert plan.moves == {"swarm": MOVES}
    assert answer["stop"]  # the listener asked for it


def test_a_swarm_may_be_planned_without_ideas_and_by_the_reference():
    given = mission()
    best = tsplan.plan(given)
    for options in ({"encoding": "reference"}, {"without": ("tokens", "places", "visits")}):
        plan = tsplan.plan(given, **options)
        assert [item.value for item in plan.objective] == [item.value for item in best.objective]


def test_a_swarm_may_be_planned_with_own_constraints():
    problem = tsplan.Problem(mission(objective=["splits"]))
    place = next(iter(SYSTEM.states))
    problem.add(problem.count(place, step=1) == 5)
    plan = tsplan.plan(problem)
    assert plan.verified
    assert plan.counts(states=[place])[0, 1] == 5


def yard(**changes):
    states = [State("a", labels=frozenset("A")), State("b", labels=frozenset("B"))]
    edges = [Edge("a", "a"), Edge("b", "b"), Edge("a", "b", 2), Edge("b", "a", 2)]
    given = {
        "swarm": {"size": 8, "at": "a"},
        "formula": "F[0,5] (sum(B) >= 3 && sum(A) >= 2)",
        "language": "mtl",
    }
    return Mission.of(map=TransitionSystem.build(states, edges), **(given | changes))


@pytest.mark.parametrize("encoding", sampled(["tight", "reference"], ["tight"]))
@pytest.mark.parametrize(
    ("margin", "status"), [(0, "optimal"), long(1, "optimal"), (2, "infeasible")]
)
def test_availability_is_told_of_the_formula_as_written(encoding, margin, status):
    for objective in (["availability"], ["splits", "availability"]):
        plan = tsplan.plan(yard(margin=margin, objective=objective), encoding=encoding)
        assert plan.status == status
        if status == "optimal":
            # of 8 agents 4 are at B and 4 at A, or 5 and 3: one more than is wanted at either
            assert (plan.objective[-1].value, plan.availability) == (1, 1)


def test_evening_the_shares_loses_no_availability():
    team = [{"class": "cart", "at": {"a": 2}, "capabilities": ["lift"]}]
    given = yard(
        team=team,
        swarm={"size": 6, "at": "b", "max_subswarms": 2},
        formula="F[0,5] (sum(B,lift) >= 1 && sum(A,swarm) >= 2)",
        objective=["availability"],
    )
    plan = tsplan.plan(given)
    assert (plan.status, plan.objective[0].value) == ("optimal", 1)


def test_a_team_has_no_moves_of_swarms():
    team = Mission.of(map=SYSTEM, team=[{"class": "a", "at": "p"}], formula="true", horizon=2)
    assert tsplan.plan(team).moves == {}


FILES = {
    "map.yaml": MAP,
    "mission.yaml": MISSION % 3,
    "tight.yaml": MISSION % 1,
    "large.yaml": (MISSION % 3).replace("120", "1200"),
}


def test_the_commands(folder, capsys):
    assert main(["plan", "mission.yaml", "-o", "plan.json"]) == 0
    out, _ = capsys.readouterr()
    assert "half way: optimal plan (accepted by the independent check)" in out
    assert "splits 1 (proven: no plan does better)" in out
    assert "split: 60 " in out
    assert main(["check", "mission.yaml", "plan.json"]) == 0
    out, _ = capsys.readouterr()
    assert "swarm keeps its 120 agents" in out
    assert "paths of 120 agents say the same as the moves" in out
    assert "the plan is accepted" in out
    assert main(["check", "tight.yaml", "plan.json"]) == 1
    out, _ = capsys.readouterr()
    assert "swarm is in 2 sub-swarms at step" in out
    assert main(["plan", "tight.yaml"]) == 3
    assert "infeasible: it is proven" in capsys.readouterr().out


def test_agents_on_request(folder, capsys):
    assert main(["plan", "large.yaml", "--json", "--quiet"]) == 0
    assert "agents" not in json.loads(capsys.readouterr().out)
    assert main(["plan", "large.yaml", "--json", "--quiet", "--agents"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert len(data["agents"]) == 1200
    assert data["verified"] is True


def test_simulating_from_the_command_line(folder, capsys):
    assert main(["plan", "mission.yaml", "--quiet", "-o", "plan.json"]) == 0
    command = ["simulate", "mission.yaml", "plan.json", "--runs", "500", "--seed", "3"]
    assert main(command) == 0
    out, _ = capsys.readouterr()
    # half of 120 at either place is one split among many: the binomial gives it 7.3 %
    held = re.search(r"the formula held in ([0-9]+) of them", out)
    assert 20 < int(held[1]) < 55
    assert "500 runs (seed 3)" in out
    assert "95 % interval" in out
    margin = re.search(r"with 'margin: ([0-9]+)' \(or more\)", out)
    assert int(margin[1]) == tsplan.margin_for(tsplan.load_mission("mission.yaml"))
    assert main([*command, "--probability", "1"]) == 2
    assert main(["simulate", "tight.yaml", "plan.json"]) == 2
    assert "plan.json: swarm is in 2 sub-swarms" in capsys.readouterr().err
    assert main(["simulate", "none.yaml", "none.json"]) == 2
    assert capsys.readouterr().err.count("\n") == 2
