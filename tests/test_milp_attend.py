"""Native work in its own thread: news, errors, limits, and work that does not listen."""

from __future__ import annotations

import os
import signal
import threading
import time

import pytest

from tsplan.process.grace_period import GracePeriod
from tsplan.process.watchdog import Watchdog
from tsplan.stopping import StoppedBy


def until(watchdog: Watchdog, *, most: float = 5.0) -> None:
    """Work that ends when it is asked to, or after most so many seconds."""
    for _ in range(int(most / 0.005)):
        if watchdog.stopping:
            return
        time.sleep(0.005)


def test_news_are_heard_in_order_and_in_this_thread() -> None:
    heard: list[tuple[object, bool]] = []
    here = threading.current_thread()

    def hear(news: object) -> bool:
        heard.append((news, threading.current_thread() is here))
        return False

    watchdog = Watchdog(hear=hear)
    assert watchdog.run(lambda: [watchdog.tell(number) for number in range(5)] and None)
    assert heard == [(number, True) for number in range(5)]
    assert watchdog.stopped_by is None


def test_short_work_is_not_waited_for() -> None:
    asked: list[int] = []
    patient = GracePeriod(1.0, 1.0, poll=60.0)
    for _ in range(20):
        assert Watchdog(asked=lambda: bool(asked.append(1)), grace=patient).run(lambda: None)
    assert asked == []  # what is asked where no news came in time


def test_errors_come_out_where_the_work_was_asked_for() -> None:
    def work() -> None:
        raise MemoryError

    with pytest.raises(MemoryError):
        Watchdog().run(work)


@pytest.mark.parametrize("how", ["asked", "hear"])
def test_a_listener_may_stop_the_work(how: str) -> None:
    stops: list[int] = []
    watchdog = Watchdog(**{how: lambda *_: True}, stop=lambda: stops.append(1))

    def work() -> None:
        watchdog.tell("news")
        until(watchdog)

    assert watchdog.run(work)
    assert (watchdog.stopped_by, stops) == (StoppedBy.INTERRUPT, [1])


def test_a_deadline_stops_the_work() -> None:
    watchdog = Watchdog(deadline=time.perf_counter() + 0.1)
    assert watchdog.run(lambda: until(watchdog))
    assert watchdog.stopped_by is StoppedBy.TIME_LIMIT


def test_a_flood_of_news_hides_no_deadline() -> None:
    watchdog = Watchdog(deadline=time.perf_counter() + 0.1)

    def work() -> None:
        for _ in range(10**7):
            if watchdog.stopping:
                return
            watchdog.tell("news")

    watchdog.run(work)
    assert watchdog.stopped_by is StoppedBy.TIME_LIMIT


def test_work_that_does_not_listen_is_left_behind() -> None:
    free = threading.Event()
    watchdog = Watchdog(deadline=time.perf_counter() + 0.1, grace=GracePeriod(0.1, 1.0))
    assert not watchdog.run(lambda: free.wait(10) and None)
    free.set()


def test_an_error_of_the_listener_stops_the_work() -> None:
    def hear(_: object) -> bool:
        raise LookupError("mine")

    watchdog = Watchdog(hear=hear)
    done = threading.Event()

    def work() -> None:
        watchdog.tell("news")
        until(watchdog)
        done.set()

    with pytest.raises(LookupError, match="mine"):
        watchdog.run(work)
    assert done.wait(1.0)


def test_ctrl_c_asks_once_and_raises_the_second_time() -> None:
    watched, free = threading.Event(), threading.Event()

    def press() -> None:
        watched.wait(5)
        os.kill(os.getpid(), signal.SIGINT)

    def work() -> None:
        press()
        until(watchdog)

    watchdog = Watchdog(asked=watched.set)
    assert watchdog.run(work)
    assert watchdog.stopped_by is StoppedBy.INTERRUPT
    stubborn = Watchdog(asked=watched.set, grace=GracePeriod(0.2, 10.0))

    def stay() -> None:
        press()
        until(stubborn)
        press()
        free.wait(5)

    watched.clear()
    with pytest.raises(KeyboardInterrupt):
        stubborn.run(stay)
    free.set()


def test_ctrl_c_while_the_thread_begins_stops_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    begin, stops = threading.Thread.start, []

    def start(thread: threading.Thread) -> None:
        begin(thread)
        raise KeyboardInterrupt

    watchdog = Watchdog(stop=lambda: stops.append(1))
    monkeypatch.setattr(threading.Thread, "start", start)
    with pytest.raises(KeyboardInterrupt):
        watchdog.run(lambda: until(watchdog))
    assert (watchdog.stopped_by, stops) == (StoppedBy.INTERRUPT, [1])
