"""Plans in words."""

from __future__ import annotations

import io
import sys
from dataclasses import replace

import pytest
from rich.console import Console

from tsplan.draw.canvas import figure_class
from tsplan.draw.matplotlib_loading import PlotUnavailableError
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef, ObjectiveValue, SolverUse, Timings
from tsplan.plans.plan import Plan
from tsplan.plans.summary import MOST_PATHS, names, objective_line, outcome, print_summary


def printed(plan, width=100):
    stream = io.StringIO()
    print_summary(plan, Console(file=stream, width=width))
    return stream.getvalue()


def team(count, length=1):
    return tuple(
        AgentPlan(f"a-{n}", "a", frozenset(), ((0, 0, "p"), (n // length, 90, "q")))
        for n in range(1, count + 1)
    )


PLAN = Plan(
    "optimal",
    MissionRef("demo [x]", ""),
    90,
    objective=(ObjectiveValue("travel", 48, 48), ObjectiveValue("availability", 1, 3)),
    availability=1,
    verified=True,
    agents=team(5),
    solver=SolverUse("highs", "1.2"),
    timings=Timings(solve=1.25, total=2.5),
)


def test_the_summary_says_what_is_known():
    text = printed(PLAN)
    assert "demo [x]: optimal plan (accepted by the independent check)" in text
    assert "travel 48 (proven: no plan does better)" in text
    assert "availability 1 (any plan has at most 3; gap 200.0%)" in text
    assert "a-3     a      p:0, q:3-90" in text
    assert "2.50 s (solve 1.25)" in text
    assert all(len(line) <= 100 for line in text.splitlines())


def test_agents_on_one_path_share_a_row_and_long_teams_are_cut():
    same = replace(PLAN, agents=tuple(replace(a, stays=((0, 90, "p"),)) for a in team(5)))
    assert "a-1..5" in printed(same)
    many = printed(replace(PLAN, agents=team(MOST_PATHS * 2)))
    assert f"{MOST_PATHS} agents on {MOST_PATHS} more paths" in many


@pytest.mark.parametrize(
    ("status", "stopped_by", "words"),
    [
        ("infeasible", None, "proven that no plan"),
        ("no_plan_found", "time_limit", "no plan found, search ended at the time limit"),
        ("error", None, "failed"),
    ],
)
def test_outcomes_without_paths_in_words(status, stopped_by, words):
    plan = Plan(status, MissionRef("m", ""), 3, stopped_by=stopped_by, notes=("a note",))
    assert words in outcome(plan)
    assert "a note" in printed(plan)


def test_names_of_agents_are_joined_and_never_changed():
    assert names(["a-0", "a-1", "a-2", "b"]) == "a-0..2, b"
    assert names(["a-0", "b-07"]) == "a-0, b-07"
    assert names(["x-9", "x-10", "x-12", "y-1", "z-1"], most=2) == "x-9..10, x-12, 2 more"


def test_unbounded_and_open_objectives():
    assert objective_line(ObjectiveValue("availability", None)) == "availability unbounded"
    assert objective_line(ObjectiveValue("cost", 2.5)) == "cost 2.5"
    assert "at least 2" in objective_line(ObjectiveValue("cost", 2.5, 2))


def test_without_matplotlib_the_remedy_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(PlotUnavailableError, match=r"tsplan\[plot\]"):
        figure_class()
