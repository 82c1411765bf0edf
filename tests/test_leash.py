"""What becomes of a child that does not answer: stuck, stopped, out of memory, or only slow."""

from __future__ import annotations

import faulthandler
import os
import signal
import sys
import threading
import time

import pytest

from tsplan.process.child_process import CrashError, LateError, Leash, OutOfMemoryError, run_guarded
from tsplan.process.grace_period import GracePeriod

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="needs processes made by fork")

SHORT = GracePeriod(0.1, 0.1, finishing=0.5, settling=0.1, poll=0.01)


def sleeps(seconds: float, send) -> None:
    time.sleep(seconds)


def stops_itself(told: str, send) -> None:
    """What a memory limit of some systems does, or a person with a debugger."""
    send(told)
    os.kill(os.getpid(), signal.SIGSTOP)


def deaf(seconds: float, send) -> str:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    send(os.getpid())
    time.sleep(seconds)
    return "done"


def sends_half_a_message(_: object, send) -> None:
    send(b"x" * 200_000)  # more than a pipe holds: it is stopped in the middle
    time.sleep(30)


def aborts(words: bytes, send) -> None:
    faulthandler.disable()  # the crash is meant, and need not be described
    os.write(2, words)
    os.kill(os.getpid(), signal.SIGABRT)


def test_a_stopped_child_is_ended_after_its_limit():
    heard: list[object] = []
    began = time.monotonic()
    with pytest.raises(LateError, match="did not stop in time"):
        run_guarded(stops_itself, "alive", heard.append, Leash(0.1, SHORT))
    assert heard == ["alive"]
    assert time.monotonic() - began >= 0.2


def test_a_message_that_stops_in_the_middle_is_not_waited_for():
    def slow(_: object) -> None:
        time.sleep(0.3)

    with pytest.raises(LateError):
        run_guarded(sends_half_a_message, None, slow, Leash(0.1, SHORT))


def test_who_is_asked_and_does_not_hear_is_ended():
    leash = Leash(None, GracePeriod(0.1, 0.1, poll=0.01))
    with pytest.raises(LateError):
        run_guarded(deaf, 30.0, lambda _: leash.ask(), leash)


def test_who_is_asked_twice_is_ended_at_once():
    leash = Leash(None, GracePeriod(60.0, 60.0, poll=0.01))

    def ask(_: object) -> None:
        leash.ask()
        leash.ask()

    with pytest.raises(KeyboardInterrupt):
        run_guarded(deaf, 30.0, ask, leash)


def test_who_makes_an_answer_ready_gets_more_time():
    leash = Leash(0.05, GracePeriod(0.05, 0.05, finishing=30.0, poll=0.01))

    def hear(_: object) -> None:
        leash.finishing = True

    assert run_guarded(deaf, 0.4, hear, leash) == "done"


def test_lack_of_memory_is_told_from_other_crashes():
    words = b"terminate called after throwing an instance of 'std::bad_alloc'\n"
    with pytest.raises(OutOfMemoryError, match="out of memory"):
        run_guarded(aborts, words)
    with pytest.raises(CrashError, match=r"SIGABRT\); its last words: no licence \\x1b") as caught:
        run_guarded(aborts, b"once upon a time\nno licence \x1b\n\n")
    assert not isinstance(caught.value, OutOfMemoryError)


def test_a_stop_that_comes_before_the_child_reaches_it():
    leash = Leash(None, GracePeriod(60.0, 60.0, poll=0.01))
    leash.ask()

    with pytest.raises(KeyboardInterrupt):
        run_guarded(sleeps, 30.0, None, leash)


def test_no_watch_is_left_behind():
    before = threading.active_count()
    for _ in range(3):
        with pytest.raises(LateError):
            run_guarded(stops_itself, "alive", None, Leash(0.1, SHORT))
    assert threading.active_count() == before
