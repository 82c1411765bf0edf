"""The least shortage of agents, whom nothing is asked of, and smaller missions tried first."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

import tsplan
from tests.explaining import REFERENCE, everything, plain, possible
from tests.seeds import seed_blocks
from tests.test_explain_conflicts import row
from tsplan.clock import Clock
from tsplan.explanation import SoftConstraint, explain
from tsplan.explanation.whynot.changes import applied, fewest
from tsplan.explanation.whynot.conflicts import Finder
from tsplan.explanation.whynot.least_shortage import least_shortage
from tsplan.explanation.whynot.mission_numbers import Edit
from tsplan.explanation.whynot.oracle import Oracle
from tsplan.explanation.whynot.relaxing import can_idle, needless, relaxed
from tsplan.explanation.whynot.team_subject import Teams
from tsplan.mission import Group, Mission
from tsplan.testing import random_task_mission
from tsplan.ts import Edge, State, TransitionSystem

KINDS = ("lower_need", "add_agents")


def edits(mission: Mission, kind: str) -> list[Edit]:
    """All edits of a kind; of more agents those where others like them start."""
    subject = Teams(mission)
    every = subject.candidates(everything(mission))
    return [edit for edit in every if edit.kind == kind and not subject.rank(edit.number)]


@pytest.mark.parametrize("seeds", seed_blocks(range(300, 303), range(300, 500), 5))
def test_the_mission_can_be_met_by_the_least_shortage(seeds: list[int]) -> None:
    short = 0
    for seed in seeds:
        mission = random_task_mission(seed)
        if tsplan.plan(plain(mission)).has_paths:
            continue
        for kind in KINDS:
            problem = least_shortage(mission, edits(mission, kind))
            if problem is None:
                continue
            plan = tsplan.plan(problem.problem)
            if not plan.has_paths:
                continue
            steps = problem.steps(plan)
            assert steps
            assert possible(plain(applied(mission, steps)))
            short += 1
            # no single edit of the kind does with less than the least total
            total = sum(amount for _, amount in steps)
            one = [label for label in mission.system.labels.values() if len(label) > 1]
            for edit in edits(mission, kind) if kind == "add_agents" or not one else []:
                for amount in range(1, min(total, edit.most + 1)):
                    assert not possible(plain(applied(mission, [(edit, amount)])))
    assert short


def test_the_least_shortage_says_who_and_what() -> None:
    team = [Group.of("a", {"p": 1}, ["see"]), Group.of("b", {"p": 1}, ["fly"])]
    mission = row("F[0,4] (T(1, C, {(see,2)}) && T(1, B, {(fly,2)}))", team=team, language="catl")
    oracle = Oracle(Teams(mission), Clock())
    found = {
        kind: {edit.words(amount) for edit, amount in fewest(oracle, edits(mission, kind)) or ()}
        for kind in KINDS
    }
    assert found["add_agents"] == {
        "add 1 agent of class a at 'p'",
        "add 1 agent of class b at 'p'",
    }
    assert {text[:17] for text in found["lower_need"]} == {"lower the need at"}
    assert len(found["lower_need"]) == 2
    made = explain(mission)
    texts = [change.text for change in made.changes if "; and " in change.text]
    assert "add 1 agent of class a at 'p'; and add 1 agent of class b at 'p'" in texts


def test_helpers_of_a_need_do_not_count_for_limits_or_anybody_else() -> None:
    mission = row("F[0,1] sum(C) >= 2 && G[0,9] max(C) <= 0 && F[0,9] sum(B) >= 3")
    problem = least_shortage(mission, edits(mission, "lower_need"))
    assert problem is not None
    steps = problem.steps(tsplan.plan(problem.problem))
    # what is at C is forbidden, so all of the need goes, and one of the need at B
    assert sorted(amount for _, amount in steps) == [1, 2]


def test_missions_whose_helpers_cannot_be_told_apart_have_no_such_problem() -> None:
    mission = row("F[0,9] T(1, C, {(see,3)})", language="catl", booking="exclusive")
    assert edits(mission, "add_agents")
    assert least_shortage(mission, edits(mission, "add_agents")) is None
    assert least_shortage(row("F[0,1] sum(C) >= 1"), []) is None


@pytest.mark.parametrize("seeds", seed_blocks([7], [*range(8, 400), 3, 7], 28))
def test_nothing_depends_on_those_of_whom_nothing_is_asked(seeds: list[int]) -> None:
    told = 0
    for seed in seeds:
        mission = random_task_mission(seed)
        states = [replace(state, capacity=None) for state in mission.system.states.values()]
        waits = [Edge(state.name, state.name) for state in states]
        edges = [
            replace(edge, capacity=None)
            for edge in mission.system.edges.values()
            if edge.source != edge.target
        ]
        open_ = TransitionSystem.build(states, [*waits, *edges])
        mission = replace(mission, system=open_, warnings=())
        if not can_idle(mission):
            continue
        random = Random(seed)
        parts = sorted(everything(mission), key=repr)
        gone = frozenset(item for item in parts if random.random() < 0.6)
        left = needless(mission, gone)
        if left:
            told += 1
            answers = {
                possible(relaxed(mission, dropped, REFERENCE)) for dropped in (gone, gone - left)
            }
            assert len(answers) == 1
    assert told


def test_a_class_of_which_nothing_is_asked_is_asked_about_once() -> None:
    team = [Group.of("a", {"p": 1}, ["see"]), Group.of("b", {"p": 1}, ["fly"])]
    mission = row("F[0,2] sum(C, see) >= 1", team=team)
    oracle = Oracle(Teams(mission), Clock())
    finder = Finder(oracle)
    assert oracle.without(()) is False
    before = oracle.solves
    fly = {SoftConstraint("team", (1,)), SoftConstraint("start", (1,))}
    assert oracle.without(fly) is False
    assert oracle.solves == before
    core = finder.within(finder.everything)
    assert core is not None
    assert not core.constraints & fly


def test_states_that_few_may_enter_have_no_helpers() -> None:
    states = [State("p"), State("q", labels={"Q"}, needs=frozenset({"dive"}))]
    edges = [Edge("p", "p"), Edge("q", "q"), Edge("p", "q")]
    mission = Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("a", {"p": 1}, ["dive"])],
        formula="F[0,3] sum(Q, dive) >= 2",
        language="mtl",
    )
    assert {change.kind for change in explain(mission).changes} >= {"lower_need", "add_agents"}
