"""Why missions over signals cannot be met: known answers, and random ones asked part by part."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path
from typing import Any

import pytest

import tsplan
from tests.seeds import long, seed_blocks
from tsplan import SignalMission
from tsplan.explanation import Change, Conflict, Explanation, SoftConstraint, Status, explain
from tsplan.explanation.report import lines_of
from tsplan.explanation.whynot import signal_subject
from tsplan.explanation.whynot.changes import applied
from tsplan.explanation.whynot.rewriting import rewritten
from tsplan.explanation.whynot.signal_subject import Signals
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.outcomes import Status as PlanStatus
from tsplan.signals.signal_files import signal_mission_from_text
from tsplan.signals.trajectory import Trajectory
from tsplan.stopping import StoppedBy
from tsplan.testing.random_signals import random_signal_mission

NEAR = 1e-4
"""Of the range of a number: what the planner cannot tell from a border."""

CART = {
    "signals": {"x": {"min": 0, "max": 10, "initial": 1}},
    "controls": {"u": [-1, 1]},
    "dynamics": {"A": [[1]], "B": [[1]]},
}
FREE = {"signals": {"x": [0, 5], "y": [0, 5]}}


def cart(formula: str, **others: Any) -> SignalMission:
    """A cart that starts at 1 of 0..10 and moves by at most 1 in a step."""
    return SignalMission.of(formula=formula, **{**CART, **others})


def free(formula: str, **others: Any) -> SignalMission:
    return SignalMission.of(formula=formula, **{**FREE, **others})


def possible(mission: SignalMission) -> bool | None:
    """Whether there is a trajectory, by the reference encoding; None on a border."""
    found = tsplan.synthesise(mission, encoding="reference", time_limit=60)
    return True if found.has_signals else False if found.status == "infeasible" else None


def everything(mission: SignalMission) -> frozenset[SoftConstraint]:
    subject = Signals(mission)
    return frozenset(subject.bounds).union(*subject.groups)


def holds_with(mission: SignalMission, kept: frozenset[SoftConstraint]) -> bool | None:
    """Whether some constraints of a mission, alone, can hold together."""
    return possible(Signals(mission).without(everything(mission) - kept))


def elements(conflict: Conflict) -> frozenset[SoftConstraint]:
    return frozenset().union(*(part.constraints for part in conflict.parts))


def texts(made: Explanation) -> list[list[str]]:
    return [[part.text for part in conflict.parts] for conflict in made.conflicts]


def said(made: Explanation, kind: str) -> list[str]:
    return [fact.text for fact in made.facts if fact.kind == kind]


def change(made: Explanation, begin: str) -> Change:
    (found,) = [item for item in made.changes if item.text.startswith(begin)]
    return found


def check_change(mission: SignalMission, item: Change) -> None:
    """There is a trajectory after the change, and none after a little less of it."""
    assert item.proven, item.text
    assert isinstance(item.mission, SignalMission)
    assert possible(Signals(item.mission).plain()) is not False, item.text
    for place, (edit, amount) in enumerate(item.steps):
        gap = 1 if edit.unit == 1 else round(NEAR * edit.most)
        less = [*item.steps]
        less[place] = (edit, max(amount - gap, 0))
        smaller = applied(mission, [step for step in less if step[1]])
        assert possible(Signals(smaller).plain()) is not True, item.text


def check_explanation(mission: SignalMission, *, conflicts: int = 1) -> Explanation:
    """Everything that an explanation says is so; `mission` may have a trajectory or not."""
    made = explain(mission, conflicts=conflicts)
    answer = possible(Signals(mission).plain())
    if made.status == "feasible":
        assert answer is not False
        assert not made.conflicts
        assert not made.changes
        return made
    assert answer is not True
    for conflict in made.conflicts:
        core = elements(conflict)
        assert holds_with(mission, core) is not True, texts(made)
        assert conflict.minimal
        for element in core:
            assert holds_with(mission, core - {element}) is not False, (texts(made), element)
    for fact in made.facts:
        own = frozenset().union(*(part.constraints for part in fact.parts))
        assert holds_with(mission, own) is not True, fact.text
    for item in made.changes:
        if item.proven:
            check_change(mission, item)
    return made


# --- known answers -------------------------------------------------------------------------------


def test_a_goal_that_is_too_far() -> None:
    made = check_explanation(cart("F[0,5] x >= 8 && G[0,5] x <= 9"), conflicts=5)
    assert made.status == "explained"
    assert texts(made) == [["F[0,5] x >= 8", "x begins at 1", "u is at most 1"]]
    assert said(made, "reach") == [
        "x >= 8 cannot hold at any of the steps 0..5: x is at most 6, at step 5"
    ]
    assert said(made, "robustness") == [
        "at best the formula is missed by 2: the greatest robustness of all trajectories is -2"
    ]
    amounts = {item.kind: item.amount for item in made.changes}
    assert amounts == pytest.approx(
        {"loosen_bound": 0.4, "extend_deadline": 2, "move_threshold": 2, "widen_start": 2},
        abs=10 * NEAR,
    )
    assert change(made, "extend").text == (
        "extend the deadline 5 to 7 (2 steps later) in F[0,5] x >= 8"
    )


@pytest.mark.long
def test_two_places_exclude_each_other() -> None:
    made = check_explanation(free("G[0,3] x + y >= 12 && F[0,2] x <= 1"), conflicts=9)
    parts = [set(item) for item in texts(made)]
    assert {"G[0,3] x + y >= 12", "x is at most 5", "y is at most 5"} in parts
    assert {"G[0,3] x + y >= 12", "F[0,2] x <= 1", "y is at most 5"} in parts
    assert len(parts) == 2
    assert change(made, "raise the max of y").amount == pytest.approx(6, abs=10 * NEAR)
    assert change(made, "ask for x + y >= 6 instead of 12").amount == pytest.approx(6)


def test_comparisons_that_exclude_each_other() -> None:
    made = check_explanation(free("F[0,3] (x >= 3 && x <= 2)"))
    assert said(made, "reach") == [
        "x >= 3 && x <= 2 cannot hold at any of the steps 0..3: its comparisons exclude each other"
    ]
    assert texts(made) == [["F[0,3] (x >= 3 && x <= 2)"]]
    assert [item.kind for item in made.changes] == ["move_threshold"] * 2
    assert [item.amount for item in made.changes] == pytest.approx([1, 1], abs=NEAR)
    assert "missed by 0.5" in said(made, "robustness")[0]


def test_dynamics_force_a_signal_out_of_its_bounds() -> None:
    """Whatever is asked for: at 9, with 2 a step, the next is 11."""
    mission = SignalMission.of(
        signals={
            "x": {"min": 0, "max": 10, "initial": 9},
            "v": {"min": -3, "max": 3, "initial": 2},
        },
        controls={"u": [-0.25, 0.25]},
        dynamics={"A": [[1, 1], [0, 1]], "B": [[0], [1]]},
        formula="F[0,6] x >= 1",
    )
    made = check_explanation(mission, conflicts=3)
    assert said(made, "bounds") == [
        "at step 1 x is at least 11, whatever is done before, and it may be at most 10"
    ]
    assert ["v begins at 2", "x begins at 9", "x is at most 10"] in texts(made)
    assert not said(made, "robustness")  # there is no trajectory at all to miss it by anything


def test_a_limit_is_named_and_loosened() -> None:
    both = {
        "signals": {name: {"min": 0, "max": 10, "initial": 0} for name in ("x", "y")},
        "controls": {"ux": [-1, 1], "uy": [-1, 1]},
        "dynamics": {"A": [[1, 0], [0, 1]], "B": [[1, 0], [0, 1]]},
        "limits": ["|ux| + |uy| <= 1"],
    }
    mission = SignalMission.of(formula="F[0,4] (x >= 3 && y >= 3)", **both)
    made = check_explanation(mission)
    assert "the limit |ux| + |uy| <= 1" in texts(made)[0]
    found = change(made, "raise the end of the limit |ux| + |uy| <= 1")
    assert found.kind == "loosen_limit"
    assert found.amount == pytest.approx(0.5, abs=10 * NEAR)


def test_a_mission_that_lasts_too_long_may_end_sooner() -> None:
    """A cart that is pushed on cannot stay in its bounds, but long enough for the formula."""
    pushed = {"dynamics": {"A": [[1]], "B": [[1]], "D": [2]}, "horizon": 12}
    made = check_explanation(cart("F[0,3] x >= 3", **pushed))
    found = change(made, "end the mission at step 9 instead of 12")
    assert (found.kind, found.amount, found.proven) == ("shorten_mission", 3, True)


def test_windows_move_at_both_ends() -> None:
    made = check_explanation(cart("G[0,4] x >= 3 && F[6,6] x <= 1.5"))
    assert change(made, "begin the window at 2 instead of 0 (2 steps later)").proven
    made = check_explanation(cart("F[6,9] x >= 6 && G[5,9] x <= 4"))
    assert change(made, "end the window at ").kind == "shorten_window"


def test_what_can_hold_in_part_is_explained_as_a_whole() -> None:
    mission = cart("F[0,5] x >= 8 && G[0,5] x <= 9", objective=["satisfaction"])
    made = explain(mission)
    assert texts(made) == [["F[0,5] x >= 8", "x begins at 1", "u is at most 1"]]
    assert any("`tsplan plan` does as much" in line for line in lines_of(made, mission, 100))


def test_weights_change_by_how_much_and_not_what_conflicts() -> None:
    text = "&&^[0.5, 2] (F[0,5] x >= 8, G[0,5] x <= 9)"
    made = check_explanation(cart(text, language="wstl"))
    assert texts(made)[0][1:] == ["x begins at 1", "u is at most 1"]
    assert "missed by 1" in said(made, "robustness")[0]
    assert change(made, "ask for x >= 6").amount == pytest.approx(2)


def test_several_robots_share_their_bounds() -> None:
    mission = cart("F[0,3] a_x >= 9", copies={"a": {}, "b": {"initial": {"x": 2}}})
    made = check_explanation(mission)
    assert texts(made) == [["F[0,3] a_x >= 9", "a_x begins at 1", "a_u, b_u are at most 1"]]
    found = change(made, "raise the max of a_u, b_u from 1").mission
    assert isinstance(found, SignalMission)
    assert signal_mission_from_text(found.to_yaml()).system == found.system


def test_what_is_tight() -> None:
    made = explain(cart("F[0,4] x >= 3 && G[6,8] x <= 2"), slack=True)
    assert made.status == "feasible"
    first, *others = [fact.text for fact in made.facts if fact.kind == "tight"]
    assert first.startswith("the most robust trajectories have robustness 1; with 0.001 more")
    assert "F[0,4] x >= 3" in first
    assert any(text.startswith("x >= 3 in F[0,4] x >= 3: x is 4 at step 3") for text in others)
    assert [fact.text for fact in made.facts if fact.kind == "slack"] == [
        "the deadline 4 could be 2 steps sooner, at 2, in F[0,4] x >= 3"
    ]


# --- files and words -----------------------------------------------------------------------------

FILE = """format: tsplan-signals/1
name: too far    # and too slow
signals:
  x: {min: 0, max: 10, initial: 1}
controls: {u: [-1, 1]}
dynamics: {A: [[1]], B: [[1]]}
regions: {goal: {x: [8, 9]}}
spec:
  - F[0,5] in(goal)  # at last
  - G[0,5] x <= 9.5
"""


def test_parts_stand_where_they_were_written() -> None:
    mission = signal_mission_from_text(FILE)
    made = explain(mission)
    ((goal, begin, push),) = [conflict.parts for conflict in made.conflicts]
    assert goal.text == "x >= 8 in F[0,5] in(goal)"
    assert (goal.place.line, goal.place.column) == (9, 12)
    assert (begin.text, begin.place.line) == ("x begins at 1", 4)
    assert (push.text, push.place.line, push.place.column) == ("u is at most 1", 5, 20)
    lines = list(lines_of(made, mission, 100))
    assert "  9 |   - F[0,5] in(goal)  # at last" in lines


def test_changes_are_written_into_the_file() -> None:
    mission = signal_mission_from_text(FILE)
    folder = Path()
    for item in explain(mission).changes:
        written = rewritten(mission, item.mission, folder, folder)
        assert not written.comments_lost
        assert "# and too slow" in written.text
        read = signal_mission_from_text(written.text)
        assert (read.formula, read.system) == (item.mission.formula, item.mission.system)
        assert tsplan.synthesise(read).has_signals


def test_time_that_is_too_short_is_admitted() -> None:
    made = explain(cart("F[0,5] x >= 8"), time_limit=0.001)
    assert made.status in ("explained", "no_answer")
    assert made.cut or made.changes


@pytest.mark.parametrize("number", [0, 2, 5, 9])
def test_an_interrupted_question_ends_the_search(monkeypatch: Any, number: int) -> None:
    asked: list[object] = []
    plan = signal_subject.synthesise_mission

    def stopped(question: Any, **options: Any) -> Trajectory:
        asked.append(question)
        if len(asked) <= number:
            return plan(question, **options)
        ref = MissionRef("", "")
        return Trajectory(PlanStatus.NO_PLAN_FOUND, ref, mission.horizon, StoppedBy.INTERRUPT)

    mission = cart("F[0,5] x >= 8 && G[0,5] x <= 9")
    monkeypatch.setattr(signal_subject, "synthesise_mission", stopped)
    made = explain(mission)
    assert len(asked) == number + 1
    assert "interrupt" in made.cut.values()
    assert said(made, "reach")
    assert made.status == "explained"


def test_borders_that_solvers_cannot_tell_are_admitted() -> None:
    made = Explanation(Status.NO_ANSWER, "a border", cut={"conflicts": "precision"})
    first, _ = lines_of(made, cart("x >= 1"), 100)
    assert first.endswith("stays open; the solver was not precise enough")


# --- random missions -----------------------------------------------------------------------------


@pytest.mark.parametrize("language", ["stl", "wstl"])
@pytest.mark.parametrize(
    "seeds", seed_blocks(range(15, 16), [*range(15, 27), *range(1000, 1400)], 6)
)
def test_random_missions(language: Any, seeds: list[int]) -> None:
    for seed in seeds:
        check_explanation(random_signal_mission(seed, language=language), conflicts=2)


@pytest.mark.parametrize(("language", "seed"), [long("stl", 260), long("wstl", 248)])
def test_random_missions_that_went_wrong(language: Any, seed: int) -> None:
    """Both ends of a window move together, past each other."""
    check_explanation(random_signal_mission(seed, language=language), conflicts=2)


@pytest.mark.parametrize("seeds", seed_blocks([15], [*range(100, 160), 7], 2))
def test_all_conflicts_of_random_missions_are_found(seeds: list[int]) -> None:
    """Every subset of the constraints of small missions is asked."""
    for seed in seeds:
        mission = random_signal_mission(seed)
        whole = everything(mission)
        made = explain(mission, conflicts=50)
        if len(whole) > 8 or made.status != "explained":
            continue
        least: list[frozenset[SoftConstraint]] = []
        for size in range(len(whole) + 1):
            for chosen in map(frozenset, combinations(sorted(whole, key=repr), size)):
                if not any(core <= chosen for core in least):
                    answer = holds_with(mission, chosen)
                    least += [] if answer is not False else [chosen]
        assert {elements(conflict) for conflict in made.conflicts} == set(least), seed
