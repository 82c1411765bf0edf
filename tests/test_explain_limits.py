"""Limits and interruption while explaining: what is known is kept, with the true reason."""

from __future__ import annotations

import io
import json
import signal
from dataclasses import replace

import pytest
from rich.console import Console

import tsplan
from tests.seeds import long
from tests.test_explain_conflicts import row
from tsplan.explanation import Change, Conflict, Explanation, Fact, Found, Status, explain
from tsplan.explanation.report import Report, print_explanation
from tsplan.explanation.whynot import fact_finders, team_subject
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.fact_finders import facts_of
from tsplan.explanation.whynot.oracle import EnoughError
from tsplan.plans.plan import Plan
from tsplan.process.interrupt import on_interrupt
from tsplan.stopping import StoppedBy

MISSION = row("F[0,2] sum(C) >= 1 && F[0,4] sum(C) >= 3 && G[0,4] max(B) <= 1")


def interrupting(monkeypatch: pytest.MonkeyPatch, number: int) -> list[object]:
    """Ctrl-C while the planner works on its question of that number; the questions asked."""
    asked: list[object] = []

    def plan(problem: object, **options: object) -> Plan:
        asked.append(problem)
        found = tsplan.plan(problem, **options)
        if len(asked) == number:
            signal.raise_signal(signal.SIGINT)  # too late for the planner to tell
        return found

    monkeypatch.setattr(team_subject, "plan", plan)
    return asked


def said(explanation: Explanation, mission: tsplan.Mission = MISSION) -> str:
    console = Console(width=100, record=True, file=io.StringIO())
    print_explanation(explanation, mission, console)
    return " ".join(console.export_text().split())


def test_ctrl_c_at_any_question_keeps_what_was_found_before(monkeypatch) -> None:
    whole = explain(MISSION)
    assert not whole.cut
    for number in range(1, 40):
        asked = interrupting(monkeypatch, number)
        made = explain(MISSION)
        if len(asked) < number:
            break
        assert len(asked) == number  # nothing more was asked
        assert made.facts == whole.facts
        assert made.status == "explained"
        assert set(made.cut.values()) == {"interrupt"}
        assert {change.text for change in made.changes} <= {c.text for c in whole.changes} | {
            c.text for c in made.changes if not c.proven
        }
        assert "it was interrupted" in said(made)
    assert number > 5
    assert made == replace(whole, timings=made.timings)


def test_ctrl_c_while_facts_are_looked_for(monkeypatch) -> None:
    finder = fact_finders.unreachable

    def interrupted(view: Context):
        signal.raise_signal(signal.SIGINT)
        yield from finder(view)

    asked = interrupting(monkeypatch, 0)
    monkeypatch.setattr(fact_finders, "unreachable", interrupted)
    made = explain(MISSION)
    assert not asked
    assert made.cut["facts"] == "interrupt"
    assert [fact.kind for fact in made.facts] == ["scarcity"]
    assert "it was interrupted: there may be more facts" in said(made)
    open_ = row("F[0,2] sum(B) >= 1")
    assert "stays open; it was interrupted" in said(explain(open_), open_)


def test_every_pause_of_the_facts_can_end_them() -> None:
    whole = list(facts_of(Context(MISSION)))
    for most in range(100):
        left = [most]

        def pause(left: list[int] = left) -> None:
            left[0] -= 1
            if left[0] < 0:
                raise EnoughError

        found = []
        try:
            found.extend(facts_of(Context(MISSION, pause)))
        except EnoughError:
            assert found == whole[: len(found)]
        else:
            assert found == whole
            assert most > 10
            return
    pytest.fail("the facts never came to their end")


def test_no_time_leaves_facts_and_says_so() -> None:
    made = explain(MISSION, time_limit=1e-9)
    assert made.facts
    assert not made.changes
    assert set(made.cut) == {"conflicts", "changes"}
    assert set(made.cut.values()) == {"time_limit"}
    text = said(made)
    assert "likely not all of them: not proven minimal" in text
    assert (
        "the time was up: there may be other conflicts, or smaller ones; there may be more" in text
    )
    assert json.loads(made.to_json())["cut_short"] == dict(made.cut)


@pytest.mark.parametrize(
    ("why", "words"),
    [
        long(StoppedBy.TIME_LIMIT, "some questions took too long"),
        (StoppedBy.MEMORY, "memory was short"),
        long(StoppedBy.PRECISION, "the solver was not precise enough"),
    ],
)
def test_questions_without_an_answer_say_why(monkeypatch, why: StoppedBy, words: str) -> None:
    def plan(problem: object, **options: object) -> Plan:
        found = tsplan.plan(problem, **options)
        return replace(found, status="no_plan_found", stopped_by=why, agents=(), verified=False)

    monkeypatch.setattr(team_subject, "plan", plan)
    made = explain(MISSION)
    assert words in said(made)
    assert not any(item.minimal for item in made.conflicts)


def test_what_is_found_is_heard_on_the_way() -> None:
    heard: list[Found] = []
    made = explain(MISSION, on_found=heard.append)
    kinds = [type(item) for item in heard]
    assert kinds == sorted(kinds, key=[Status, Fact, Conflict, Change].index)
    assert set(kinds) == {Status, Fact, Conflict, Change}
    assert [item.fix for item in heard if isinstance(item, Change)] == [
        number + 1 for number in range(len(made.changes))
    ]
    known = Explanation(Status.NO_ANSWER, made.name)
    for item in heard:
        known = known.with_found(item)
    assert known == replace(made, timings={})


def test_a_fact_is_heard_before_anything_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = interrupting(monkeypatch, 0)
    before: list[int] = []

    def heard(item: Found) -> None:
        if isinstance(item, Fact):
            before.append(len(asked))

    explain(MISSION, on_found=heard)
    assert before
    assert set(before) == {0}


def test_what_is_printed_on_the_way_is_what_is_printed_in_the_end() -> None:
    console = Console(width=100, record=True, file=io.StringIO())
    report = Report(MISSION, console)
    made = explain(MISSION, on_found=report.tell)
    report.finish(made)
    assert " ".join(console.export_text().split()) == said(made)


@pytest.mark.parametrize("language", ["mtl", "catl"])
def test_what_was_not_proven_in_time_is_listed_as_likely(language: str) -> None:
    atom = {"mtl": "sum(C, see) >= 1", "catl": "T(0, C, {(see, 1)})"}[language]
    mission = row(f"F[0,9] {atom} && G[0,9] F[0,3] {atom.replace('C', 'B')}", language=language)
    made = explain(mission, time_limit=1e-9)
    assert made.status == "no_answer"
    assert {item.kind for item in made.likely} == {"conflict"}
    assert "1 agent with see at 'C' by step 9" in made.likely[0].text + made.likely[1].text
    text = said(made, mission)
    assert "whether there is a plan stays open; try a longer time limit" in text
    assert "likely in the way, not proven:" in text
    assert json.loads(made.to_json())["likely"][0]["kind"] == "conflict"


def test_changes_that_could_not_be_tried_are_listed_as_likely() -> None:
    made = explain(MISSION, time_limit=1e-9)
    assert made.conflicts
    assert {item.kind for item in made.likely} == {"change"}
    assert "likely to help, not proven:" in said(made)
    assert not explain(MISSION).likely


def test_an_interrupted_search_lists_what_is_likely(monkeypatch: pytest.MonkeyPatch) -> None:
    mission = row("F[0,4] (sum(A) >= 1 && sum(B) >= 1 && F[0,2] sum(C) >= 2) && G[0,0] sum(A) >= 2")
    whole = explain(mission)
    assert whole.status == "explained"
    assert not whole.facts
    interrupting(monkeypatch, 1)
    made = explain(mission)
    assert made.likely or made.conflicts
    assert made.cut


def test_a_conflict_is_given_up_as_it_is_when_interrupted() -> None:
    made = Explanation(
        Status.EXPLAINED, "m", conflicts=(Conflict((), False),), cut={"conflicts": "interrupt"}
    )
    assert "not proven minimal" in said(made)
    assert "it was interrupted: there may be other conflicts" in said(made)


def test_ctrl_c_asks_every_run_that_is_under_way() -> None:
    heard: list[str] = []
    with on_interrupt(lambda: heard.append("outer")):
        with on_interrupt(lambda: heard.append("inner")):
            signal.raise_signal(signal.SIGINT)
            assert heard == ["inner", "outer"]
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert heard == ["inner", "outer"]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
