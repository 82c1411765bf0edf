"""`tsplan explain` where the child that explains is asked to stop, stuck, or killed."""

from __future__ import annotations

import os
import signal
import time

import pytest

from tests.command_line import linux
from tsplan.cli import main
from tsplan.cli import told_explanation as explain
from tsplan.explanation.explanation import Explanation, Fact, Status
from tsplan.process import child_process
from tsplan.process.grace_period import GracePeriod

pytestmark = linux

TEXT = """format: tsplan-mission/1
name: far away
map: {waiting: true, states: {p: {}, q: {labels: [Q]}}, edges: [[p, q, 5]]}
team: [{class: a, count: 1, at: p}]
spec: {language: mtl, formula: "F[0,3] Q"}
"""
SHORT = GracePeriod(0.2, 0.2, finishing=25.0, settling=1.0)


@pytest.fixture
def mission(tmp_path) -> str:
    (tmp_path / "m.yaml").write_text(TEXT)
    return str(tmp_path / "m.yaml")


def ending(monkeypatch: pytest.MonkeyPatch, how) -> None:
    """The child says what it knows, then something becomes of it."""

    def job(order: object, send) -> Explanation:
        send("facts")
        send(Status.EXPLAINED)
        send(Fact("reach", "it is too far"))
        send("conflicts")
        how()
        time.sleep(60)
        raise AssertionError

    monkeypatch.setattr(explain, "_job", job)
    monkeypatch.setattr(child_process, "CHILD", SHORT)


def deaf() -> None:
    """A child that does not hear that it is to stop; its parent is asked to."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.kill(os.getppid(), signal.SIGTERM)


@pytest.mark.parametrize(
    ("how", "words"),
    [
        (lambda: None, "the time was up: there may be other conflicts"),
        (deaf, "it was interrupted: there may be other conflicts"),
        (lambda: os.kill(os.getpid(), signal.SIGSTOP), "the time was up"),
        (lambda: os.kill(os.getpid(), signal.SIGKILL), "memory was short"),
        (lambda: os.kill(os.getppid(), signal.SIGTERM), "it was interrupted"),
    ],
)
def test_what_the_child_knew_is_printed_with_the_true_reason(
    mission, how, words, monkeypatch, capsys
) -> None:
    ending(monkeypatch, how)
    assert main(["explain", mission, "--time-limit", "1"]) == 0
    out, err = capsys.readouterr()
    assert "far away: there is no plan" in out
    assert "it is too far" in out
    assert words in " ".join(out.split())
    assert "this is what was known" in err


def test_nothing_known_is_no_answer(mission, monkeypatch, capsys) -> None:
    monkeypatch.setattr(explain, "_job", lambda *_: time.sleep(60))
    monkeypatch.setattr(child_process, "CHILD", SHORT)
    assert main(["explain", mission, "--time-limit", "0.1"]) == 4
    assert "stays open; try a longer time limit" in capsys.readouterr().out
