"""Own constraints and objective terms from Python, events, interruption and the native model."""

from __future__ import annotations

import pytest

import tsplan
from tsplan.errors import MissionError
from tsplan.mission import Group
from tsplan.run.events import Incumbent, Stage
from tsplan.run.problem import Problem, Tuning
from tsplan.ts import Edge, State, TransitionSystem


def mission(objective=("travel",), text="F[0,4] sum(goal) >= 1") -> tsplan.Mission:
    states = [State("home"), State("way"), State("end", labels=frozenset({"goal"}))]
    edges = [Edge(s.name, s.name) for s in states]
    edges += [Edge("home", "way"), Edge("way", "end"), Edge("end", "way"), Edge("way", "home")]
    return tsplan.Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("scout", {"home": 3}, ["see"])],
        formula=text,
        language="mtl",
        objective=objective,
    )


@pytest.mark.parametrize("encoding", ["tight", "reference"])
def test_an_own_constraint_changes_the_plan(encoding: str) -> None:
    problem = Problem(mission(), Tuning.named(encoding))
    problem.add(problem.count("way", step=3) >= 2)
    plan = tsplan.plan(problem)
    assert plan.status == "optimal"
    assert sum(state == "way" for state in plan.state_at(3).values()) >= 2
    assert tsplan.plan(mission()).objective[0].value == 2
    # one is on its way to the end at step 3, the other one only there
    assert plan.objective[0].value == 3


@pytest.mark.parametrize("encoding", ["tight", "reference"])
def test_an_own_objective_comes_first(encoding: str) -> None:
    problem = Problem(mission(), Tuning.named(encoding))
    problem.minimise(-1 * problem.count("goal", "see", step=4))
    plan = tsplan.plan(problem)
    assert plan.status == "optimal"
    assert sum(state == "end" for state in plan.state_at(4).values()) == 3
    assert {item.name: item.value for item in plan.objective} == {"travel": 6}
    assert plan.notes == ("own objective -3 (bound -3)",)


def test_contradicting_constraints_are_infeasible() -> None:
    problem = Problem(mission())
    problem.add(problem.count("home", step=1) + problem.count("way", step=1) <= 2)
    assert tsplan.plan(problem).status == "infeasible"


def test_unknown_places_steps_and_words_are_named() -> None:
    problem = Problem(mission())
    with pytest.raises(MissionError, match="did you mean 'home'"):
        problem.count("hom", step=1)
    with pytest.raises(MissionError, match="outside"):
        problem.count("home", step=9)
    with pytest.raises(MissionError, match="visits"):
        tsplan.plan(mission(), without=("visit",))
    with pytest.raises(MissionError, match="tight"):
        tsplan.plan(mission(), encoding="tigt")


def test_events_tell_of_stages_and_verified_plans() -> None:
    events = []
    tsplan.plan(mission(("availability", "travel")), on_event=events.append)
    assert isinstance(events[0], Stage)
    plans = [event.plan() for event in events if isinstance(event, Incumbent)]
    assert plans
    assert all(plan.verified for plan in plans)


def test_a_listener_may_stop_the_search_and_keep_the_plan() -> None:
    chosen = mission(("availability", "travel"))
    plan = tsplan.plan(chosen, on_event=lambda event: isinstance(event, Incumbent))
    assert (plan.status, plan.stopped_by, plan.verified) == ("feasible", "interrupt", True)


def test_the_native_model_has_the_model_s_size() -> None:
    problem = Problem(mission())
    assert problem.native("highs").getNumCol() == problem.model.size.columns


def test_no_objective_asks_for_any_plan() -> None:
    plan = tsplan.plan(mission(()))
    assert (plan.status, plan.verified, plan.objective) == ("optimal", True, ())
